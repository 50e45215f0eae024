"""A small garden to draw: two anemones made by hand, grass and a stem, before an eye near the origin."""

import numpy as np

from components.arrays import Float32s, Float64s
from components.fibre import Carriers, Tuft
from components.field import pack
from components.flora import Disc, Growth, Look
from components.ground import Terrain, ground_height
from components.singularity import SingularityKind, SingularityTable

LOOKS = (
    Look("foot", (0.30, 0.05, 0.03), (0.5, 0.1, 0.05), (0.9, 0.7, 0.3), "mottle", 6.0, 0.1),
    Look("tentacle", (0.40, 0.05, 0.05), (0.9, 0.5, 0.3), (0.1, 0.02, 0.02), "bands", 5.0, 0.5),
    Look("blade", (0.05, 0.13, 0.02), (0.24, 0.42, 0.07), (0.5, 0.5, 0.3), "plain", 6.0, 0.6),
    Look("branch", (0.30, 0.05, 0.26), (0.6, 0.2, 0.5), (1.0, 1.0, 1.0), "stripes", 6.0, 0.2),
    Look("disc", (0.7, 0.2, 0.1), (0.5, 0.1, 0.05), (0.9, 0.6, 0.3), "spots", 4.0, 0.2),
)


def ground_at(seabed: Terrain, x: float, y: float) -> Float64s:
    """Return the point of the ground [m] at (x, y)."""
    z = ground_height(seabed.height, seabed.extent, seabed.cell, x, y)
    return np.array([x, y, float(z)])


def chain(roots: Float64s, ways: Float64s, length: float, nodes: int) -> Float64s:
    """Return straight fibres from roots (F, 3) along unit ways (F, 3), (F, nodes, 3)."""
    along = np.linspace(0.0, length, nodes)
    return np.asarray(roots[:, None] + along[None, :, None] * ways[:, None])


def anemone(at: Float64s, plant: int, first: int, tentacles: int = 24) -> list[Tuft]:
    """Return a foot and the tentacles it carries; `first` is the index of its foot among the tufts."""
    foot = chain(at[None], np.array([[0.0, 0.0, 1.0]]), 0.2, 6)
    turn = 2.399963 * np.arange(tentacles)
    out = np.sqrt((np.arange(tentacles) + 0.5) / tentacles)
    ways = np.stack((np.cos(turn) * out, np.sin(turn) * out, np.ones(tentacles)), axis=1)
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    zeros = np.zeros(tentacles, np.int32)
    roots = foot[0, -1] + 0.2 * ways * (1.0, 1.0, 0.0)
    thin = 0.02 * 0.92 ** np.arange(8.0)
    carriers = Carriers(first, zeros, zeros + 5)
    return [
        Tuft(foot, np.full(6, 0.2), modulus=30.0, plant=plant, look=0),
        Tuft(chain(roots, ways, 0.35, 8), thin, 20.0, plant=plant, look=1, carriers=carriers),
    ]


def growth(seabed: Terrain) -> Growth:
    """Return two anemones, a patch of grass and a stem on the ground."""
    tufts = anemone(ground_at(seabed, 2.2, 0.5), 0, 0)
    tufts += anemone(ground_at(seabed, 3.4, -0.6), 1, 2)
    chance = np.random.default_rng(5)
    spots = chance.uniform((2.3, -1.2), (2.9, -0.6), (14, 2))
    roots = np.array([ground_at(seabed, *spot) for spot in spots])
    up = np.tile((0.0, 0.0, 1.0), (14, 1))
    tufts.append(Tuft(chain(roots, up, 0.6, 7), np.full(7, 0.02), 8.0, plant=2, look=2))
    stem = chain(ground_at(seabed, 3.0, 1.3)[None], up[:1], 0.7, 6)
    tufts.append(Tuft(stem, np.full(6, 0.04), 50.0, plant=3, look=3))
    return Growth(tufts, LOOKS, (Disc(0, 0, 0.24, 0.1, 4), Disc(2, 0, 0.24, 0.1, 4)))


def current(speed: float = 0.4) -> Float32s:
    """Return a current along y, packed."""
    table = SingularityTable(1)
    table.kind[0], table.reach[0] = SingularityKind.DIRECTIONAL, np.inf
    table.axis[0], table.intensity[0] = (0.0, 1.0, 0.0), speed
    return pack(table, 0)
