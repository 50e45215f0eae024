"""Small beds of fibres and the water over them, for tests; run as a program it prints what a backend makes of one.

`python bed.py opencl 7 culled` bends with work-groups of seven; `python bed.py numba 1 all` with numba, nothing culled.
"""

import hashlib
import sys
from collections.abc import Sequence

import numpy as np

from components.arrays import Float32s, Float64s
from components.fibre import Carriers, Tuft
from components.field import pack
from components.garden import Garden
from components.singularity import SingularityKind, SingularityTable
from systems.sea.bend import Bender, NumbaBender

FRAME = 1.0 / 60.0
NODES = 22
SEGMENT = 5.0
RADII = 4.0 * 0.94 ** np.arange(NODES, dtype=np.float64)
NOTHING = np.zeros((0, 16), np.float32)
ROCKS = (
    np.array([[0.3, 0.1, 0.2], [-0.3, -0.2, 0.1]]),
    np.array([[0.15, 0.2, 0.1], [0.1, 0.1, 0.3]]),
    np.array([[0.6, 0.8], [1.0, 0.0]]),
)
"Two rocks among the tentacles of `anemone`."


def straight(roots: Sequence[Sequence[float]] = ((0.0, 0.0, 0.0),), nodes: int = NODES) -> Float64s:
    """Return upright fibres of papers/002, section 5.1: segments of 5 units, (F, nodes, 3)."""
    points = np.repeat(np.asarray(roots, np.float64)[:, None], nodes, axis=1)
    points[..., 2] += SEGMENT * np.arange(nodes)
    return points


def paper_fibre(exponent: float = 2.0, modulus: float = 1.0) -> Garden:
    """Return one fibre of the paper's figure 12."""
    return Garden([Tuft(straight(), RADII, modulus=modulus, exponent=exponent)])


def anemone(fibres: int = 13, nodes: int = 10, seed: int = 0) -> list[Tuft]:
    """Return a foot, curved tentacles that it carries, and as many interpolated from them."""
    chance = np.random.default_rng(seed)
    lean = np.concatenate([chance.uniform(-0.4, 0.4, (fibres, 2)), np.ones((fibres, 1))], axis=1)
    lean /= np.linalg.norm(lean, axis=1, keepdims=True)
    along = 0.05 * np.arange(nodes)
    roots = chance.uniform(-0.3, 0.3, (fibres, 3)) * (1.0, 1.0, 0.0)
    points = roots[:, None] + along[:, None] * lean[:, None]
    points[..., 0] += 0.5 * along**2
    foot = np.zeros((1, 4, 3))
    foot[0, :, 2] = np.linspace(-0.3, 0.0, 4)
    every = np.zeros(fibres, np.int32)
    thin = 0.02 * 0.94 ** np.arange(nodes, dtype=np.float64)
    return [
        Tuft(foot, np.full(4, 0.05), modulus=1.0),
        Tuft(points, thin, carriers=Carriers(0, every, every + 3), ground=(0.0, 0.0, 1.0, -0.3)),
        Tuft(points + np.array([0.02, 0.0, 0.0]), thin, guides=1),
    ]


def singularity(
    kind: SingularityKind,
    position: Sequence[float] = (0.0, 0.0, 0.0),
    intensity: float = 1e4,
    most: float = 20.0,
    reach: float = np.inf,
    softening: float = 5.0,
    axis: Sequence[float] = (0.0, 0.0, 1.0),
) -> SingularityTable:
    """Return a table of one singularity."""
    table = SingularityTable(1)
    table.kind[0], table.position[0], table.axis[0] = kind, position, axis
    table.intensity[0], table.most[0] = intensity, most
    table.reach[0], table.softening[0] = reach, softening
    return table


def water(number: int = 12, seed: int = 1, across: float = 1.2) -> SingularityTable:
    """Return singularities of every kind in and around `anemone`; one is a current with waves."""
    chance = np.random.default_rng(seed)
    table = SingularityTable(number)
    table.kind[:number] = np.arange(number) % 4
    table.position[:number] = chance.uniform(-0.5, 0.5, (number, 3)) * across
    table.axis[:number] = (0.6, 0.0, 0.8)
    table.intensity[:number], table.most[:number] = chance.uniform(-0.3, 1.0, number), 4.0
    table.reach[:number], table.softening[:number] = chance.uniform(0.2, 2.0, number), 0.05
    table.amplitude[:number], table.wave_number[:number] = 2.0, 0.7
    table.frequency[:number] = 0.3
    table.reach[: min(number, 4) : 3] = np.inf
    return table


def bend(garden: Garden, bender: Bender, table: SingularityTable, steps: int) -> Float32s:
    """Bend for a number of frames, waves and all; return the nodes [m], (rows, 3, 8)."""
    for tick in range(steps):
        bender.step(garden, pack(table, tick), FRAME)
    return garden.position


def rod_errors(garden: Garden) -> Float64s:
    """Return how far each segment's length is from its own, as a part of it."""
    directions = garden.strands.direction.astype(np.float64)
    return np.asarray(np.abs(np.sqrt((directions**2).sum(1)) - 1.0))


def bender_of(backend: str, local_size: int, culled: bool) -> Bender:
    """Return a bender of the kind that is named."""
    if backend == "numba":
        return NumbaBender(parallel=local_size > 1, culled=culled)
    from systems.sea.fibres_opencl import OpenCLBender

    return OpenCLBender(local_size, culled, least_nodes=0)


def bits_of(backend: str, local_size: int = 1, culled: bool = True, steps: int = 40) -> str:
    """Return a hash of where all nodes are after a while."""
    garden = Garden(anemone(60), ROCKS)
    bend(garden, bender_of(backend, local_size, culled), water(), steps)
    return hashlib.sha256(garden.position.tobytes()).hexdigest()


if __name__ == "__main__":
    print(bits_of(sys.argv[1], int(sys.argv[2]), sys.argv[3] == "culled"))
