"""The fish as masses, springs and faces: the biomechanical model of papers/000, 3.1 (FINDINGS 1 and 1b).

23 nodes and 91 springs, of which 12 are muscles in three segments of four; 24 faces feel the water. Masses and
stiffnesses follow from the body's stations by one rule for all species. Units: body lengths, seconds; a mass is in
units of the reference body's.
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int64s
from components.body import NODE_HEIGHT, NODES, RINGS, Body, Swim, rest_nodes

SPRINGS: Final = 91
MUSCLES: Final = 12
FACES: Final = 24
SEGMENTS: Final = RINGS + 1
"""Parts of the centre line: nose to R1, R1 to R2, ..., R5 to the caudal fin."""

_DENSITY: Final = 100.4
_NOSE_SHARE: Final = 0.15
_FIN_DENSITY: Final = 0.219
_REFERENCE_STIFFNESS: Final = 24.0
_REFERENCE_FREQUENCY: Final = 2.0
_DAMPING: Final = 0.0095
_MUSCLE, _PASSIVE, _REAR, _TAIL = 1050.0, 1000.0, 800.0, 500.0
_AROUND: Final = ((0, 1), (1, 2), (2, 3), (3, 0))
"""Neighbours around a ring: top, right, bottom, left edge."""


LAWS: Final[dict[str, Float64s]] = {
    "streamlined": np.array([400.0, 0.5, 0.25]),
    "published": np.array([400.0, 0.0, 1.0]),
    "firm": np.array([800.0, 0.5, 0.25]),
}
"""The water's laws: drag on a face that moves outwards c_l, drag along a face c_t, and how much of a normal's
part along the centre line the water feels s. "streamlined" is the game's, "published" the paper's, and "firm"
the one of fast starts, whose quick wide strokes take more water along than a quasi-steady drag knows."""


class BodyModel(NamedTuple):
    """The numbers of one body; springs in the order of `SPRING`, nodes as components/body.py numbers them."""

    mass: Float64s
    "of each node, (23,)"
    length: Float64s
    "[BL] at rest, (91,)"
    stiffness: Float64s
    "k, (91,)"
    damping: Float64s
    "c, (91,)"
    start: Float64s
    "[BL] nodes at rest, world axes: x ahead, y left, z up, (23, 3)"
    water: Float64s
    "how the water acts, one of `LAWS`, (3,)"


def _springs() -> list[tuple[int, int, float]]:
    """Return (node, node, base stiffness) of each spring, lower node first, the 12 muscles first."""
    muscles = [(i, i + 4, _MUSCLE) for i in range(1, 1 + MUSCLES)]
    rear = [(i, i + 4, _REAR) for i in range(13, 17)]
    nose = [(0, i, _PASSIVE) for i in range(1, 5)]
    rings, diagonals = [], []
    for first in range(1, 1 + 4 * RINGS, 4):
        pairs = [*_AROUND, (0, 2), (1, 3)]
        rings += [(first + min(a, b), first + max(a, b), _PASSIVE) for a, b in pairs]
    for first in range(1, 1 + 4 * (RINGS - 1), 4):
        for a, b in _AROUND:
            diagonals += [
                (first + a, first + 4 + b, _PASSIVE),
                (first + b, first + 4 + a, _PASSIVE),
            ]
    tail = [(i, tip, _TAIL) for i in range(17, 21) for tip in (21, 22)]
    return [*muscles, *rear, *nose, *rings, *diagonals, *tail, (21, 22, _TAIL)]


def _faces() -> list[tuple[int, int, int, int, int]]:
    """Return four nodes, outward normal by the cross product of the diagonals, and segment of each face.

    A triangle names its last node twice. Body sides are quads: cut into triangles they would break symmetry.
    """
    faces = [(1 + b, 0, 1 + a, 1 + a, 0) for a, b in _AROUND]
    for ring in range(RINGS - 1):
        first = 1 + 4 * ring
        faces += [
            (first + 4 + b, first + b, first + a, first + 4 + a, ring + 1) for a, b in _AROUND
        ]
    fin = SEGMENTS - 1
    faces += [(21, 17, 20, 22, fin), (22, 19, 18, 21, fin)]
    return [*faces, (21, 18, 17, 17, fin), (22, 20, 19, 19, fin)]


SPRING: Final[Int64s] = np.array([s[:2] for s in _springs()], np.int64)
"""The two nodes of each spring, lower first; 0-3 are the muscles of S1, 4-7 of S2, 8-11 of S3, (91, 2)."""

FACE: Final[Int64s] = np.array([f[:4] for f in _faces()], np.int64)
"""The nodes of each face; a triangle names its last node twice, (24, 4)."""

FACE_SEGMENT: Final[Int64s] = np.array([f[4] for f in _faces()], np.int64)
"""The part of the centre line that each face surrounds, (24,)."""

FACE_WEIGHT: Final[Float64s] = np.array(
    [(1 / 3, 1 / 3, 1 / 3, 0.0) if f[2] == f[3] else (0.25,) * 4 for f in _faces()]
)
"""Each node's share of its face's velocity and force, (24, 4)."""

LEFT: Final[Int64s] = np.array([1, 0, 0, 1], np.int64)
"""1 where a muscle of a segment is on the left: top-left and bottom-left, (4,)."""


def body_model(body: Body, swim: Swim, law: str = "streamlined") -> BodyModel:
    """Return the model of `body`, tuned for `swim`, by the rule from geometry (FINDINGS 1b), in water of `law`.

    Raise KeyError for a law that `LAWS` does not hold.
    """
    mass, firmness = _masses(body)
    nodes = rest_nodes(body)
    ends = nodes[SPRING[:, 1]] - nodes[SPRING[:, 0]]
    base = np.array([s[2] for s in _springs()])
    pace = swim.frequency_hz / _REFERENCE_FREQUENCY
    firm = 0.5 * (firmness[SPRING[:, 0]] + firmness[SPRING[:, 1]])
    stiffness = base * firm / _REFERENCE_STIFFNESS * (pace * pace) * body.stiffness
    length = np.sqrt(ends[:, 0] * ends[:, 0] + ends[:, 1] * ends[:, 1] + ends[:, 2] * ends[:, 2])
    start = np.stack((nodes[:, 0], -nodes[:, 2], nodes[:, 1]), axis=1)
    return BodyModel(
        mass,
        length,
        stiffness,
        _DAMPING * stiffness,
        np.ascontiguousarray(start),
        LAWS[law].copy(),
    )


def _masses(body: Body) -> tuple[Float64s, Float64s]:
    """Return each node's mass and m / w^2 at its ring; nose and fin take their neighbouring ring's."""
    mass, firmness = np.zeros(NODES), np.zeros(NODES)
    at = (0.0, *body.station, 1.0)
    for ring in range(RINGS):
        width, height = body.half_width[ring], NODE_HEIGHT * body.half_height[ring]
        ring_mass = _DENSITY * 4 * width * height * (at[ring + 2] - at[ring]) / 2
        if ring == 0:
            mass[0] = _NOSE_SHARE * ring_mass
            ring_mass *= 1 - _NOSE_SHARE
        nodes = slice(1 + 4 * ring, 5 + 4 * ring)
        mass[nodes] = ring_mass / 4
        firmness[nodes] = ring_mass / 4 / (width * width)
    root = NODE_HEIGHT * body.half_height[-1]
    mass[21:] = _FIN_DENSITY * (at[-1] - at[-2]) * (root + body.tail_span)
    firmness[0], firmness[21:] = firmness[1], firmness[20]
    return mass, firmness
