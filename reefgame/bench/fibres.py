"""bench fibres: milliseconds to bend the scene of papers/002, Fig. 13, and a million nodes, on each backend.

A Strawberry anemone is a foot of 10 nodes that carries 40 tentacles of 10; 36 of them are the paper's 14,760 nodes.
Singularities are fishes above them: sources and holes with a reach of 1.5 m, and one current for all.
"""

import os
from collections.abc import Callable, Iterator
from typing import Final

import numpy as np

from components.arrays import Float32s
from components.fibre import Carriers, Tuft
from components.field import pack
from components.garden import Garden
from components.singularity import SingularityKind, SingularityTable
from reefgame.bench.case import Case, in_turn
from systems.sea.bend import Bender, NumbaBender
from systems.sea.gather import gather

_NODES: Final = 10
_TENTACLES: Final = 40
_SPACING: Final = 1.2
_FRAME: Final = 1.0 / 60.0
_FEW: Final = 410
_PAPER: Final = 14_760
_MILLION: Final = 1_000_000


def _anemone(x: float, y: float, plant: int) -> list[Tuft]:
    """Return a foot .2 m high and its tentacles, .3 m long."""
    height = np.linspace(0.0, 0.2, _NODES)
    foot = np.empty((1, _NODES, 3))
    foot[0, :, 0], foot[0, :, 1], foot[0, :, 2] = x, y, height - 10.0
    turn = 2.399963 * np.arange(_TENTACLES)
    out = np.sqrt((np.arange(_TENTACLES) + 0.5) / _TENTACLES)
    lean = np.stack([np.cos(turn) * out, np.sin(turn) * out, np.ones(_TENTACLES)], axis=1)
    lean[:, :2] *= 0.8
    lean /= np.linalg.norm(lean, axis=1, keepdims=True)
    roots = foot[0, -1] + lean * (0.15, 0.15, 0.0)
    along = np.linspace(0.0, 0.3, _NODES)
    points = roots[:, None] + along[None, :, None] * lean[:, None]
    zeros = np.zeros(_TENTACLES, np.int32)
    carriers = Carriers(2 * plant, zeros, zeros + _NODES - 1)
    thin = 0.012 * 0.94 ** np.arange(_NODES, dtype=np.float64)
    return [
        Tuft(foot, np.full(_NODES, 0.12), modulus=20.0, plant=plant),
        Tuft(points, thin, modulus=20.0, plant=plant, carriers=carriers),
    ]


def anemones(nodes: int) -> Garden:
    """Return a square bed of anemones with at least so many nodes in all."""
    number = -(-nodes // (_NODES * (_TENTACLES + 1)))
    side = int(np.ceil(np.sqrt(number)))
    tufts: list[Tuft] = []
    for plant in range(number):
        x, y = (plant % side - 0.5 * side) * _SPACING, (plant // side - 0.5 * side) * _SPACING
        tufts += _anemone(x, y, plant)
    return Garden(tufts)


def shoal(number: int, across: float) -> Float32s:
    """Return fishes over a bed `across` [m] wide, and a current, packed."""
    table = SingularityTable(number)
    last = number - 1
    turn, out = 2.399963 * np.arange(number), np.sqrt((np.arange(number) + 0.5) / number)
    table.position[:number, 0] = 0.5 * across * out * np.cos(turn)
    table.position[:number, 1] = 0.5 * across * out * np.sin(turn)
    table.position[:number, 2] = -9.6
    table.kind[:number] = np.arange(number) % 2
    table.intensity[:number], table.most[:number] = 0.2, 2.0
    table.reach[:number], table.softening[:number] = 1.5, 0.05
    table.kind[last], table.reach[last] = SingularityKind.DIRECTIONAL, np.inf
    table.axis[last, 0], table.intensity[last] = 1.0, 0.3
    table.amplitude[last], table.wave_number[last], table.frequency[last] = 0.5, 0.2, 0.2
    return pack(table, 0)


def _stepping(bender: Bender, garden: Garden, flow: Float32s) -> Callable[[], None]:
    """Return a step of a garden that all backends bend in turn: whoever did the last, its bits are the same."""
    return lambda: bender.step(garden, flow, _FRAME)


def _benders(culled: bool) -> dict[str, Bender]:
    """Return the backends. Raise FaultError where this machine has no OpenCL."""
    from systems.sea.fibres_opencl import OpenCLBender

    return {
        "opencl": OpenCLBender(culled=culled),
        "parallel": NumbaBender(parallel=True, culled=culled),
        "scalar": NumbaBender(parallel=False, culled=culled),
    }


def _compare(
    nodes: int, singularities: int, culled: bool, held: dict[str, float]
) -> Iterator[Case]:
    """Yield a case for each backend that `held` names: the ratio that OpenCL is to reach against it."""
    flow = shoal(singularities, _SPACING * np.sqrt(nodes / (_NODES * (_TENTACLES + 1))))
    benders, garden = _benders(culled), anemones(nodes)
    names = ("opencl", *held)
    sides = tuple(_stepping(benders[name], garden, flow) for name in names)
    opencl, *others = in_turn(sides, 41 if nodes < _MILLION else 5)
    for (name, least), other in zip(held.items(), others, strict=True):
        case = f"nodes={nodes} singularities={singularities}{'' if culled else ' culled=no'}"
        bound = f"ratio >= {least:g}" if least else ""
        yield Case(
            f"{case} backend=opencl against={name}",
            opencl * 1e3,
            "ms a step",
            other * 1e3,
            other / opencl,
            bound,
        )


def _memory() -> Case:
    """Return the bytes a node of everything that lasts: garden, lists and flow; the device shares our arrays."""
    garden = anemones(_MILLION)
    lists = gather(garden.clump_sphere, shoal(60, 60.0))
    fibres = [garden.first_row, garden.lane, garden.nodes, garden.tuft_sphere, garden.clump_sphere]
    planes = [garden.position, garden.radius, *garden.strands[:-1], *garden.followers, *lists]
    size = sum(np.asarray(plane).nbytes for plane in (*planes, *fibres))
    return Case(
        f"nodes={_MILLION} part=memory",
        size / int(garden.nodes.sum()),
        "bytes a node",
        bound="value <= 120",
    )


def measure() -> Iterator[Case]:
    """Yield each backend's time against the others', and the memory that a node takes."""
    # numba's idle threads spin by default, on the cores that the other side is measured on.
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    yield from _compare(_PAPER, 60, True, {"scalar": 2.2, "parallel": 0.9})
    yield from _compare(_PAPER, 1, True, {"scalar": 0.0, "parallel": 0.9})
    yield from _compare(_FEW, 60, True, {"parallel": 0.9})
    yield from _compare(10 * _FEW, 60, True, {"parallel": 0.9})
    yield from _compare(_MILLION, 60, False, {"parallel": 1.5})
    yield from _compare(_MILLION, 60, True, {"parallel": 0.9})
    yield _memory()
