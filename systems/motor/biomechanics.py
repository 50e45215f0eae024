"""The implicit step of the biomechanical fish in water (papers/000, 3.1; papers/004; FINDINGS 1).

Each substep of 1/240 s solves (M + dt C + dt^2 K + dt D) v' = M v + dt f for the 23 nodal velocities, then moves the
nodes: 69 equations, symmetric and positive definite, half-bandwidth 23 in natural order. C and K are the springs'
dampers and tangents, D the water's drag. The band holds the upper triangle: entry (i, j) at 24 i + j of a flat array.

Only + - * / sqrt on the caller's arrays, so every machine computes the same bits, and a fish costs no allocation.
"""

from math import sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int64s
from components.body import NODES
from components.kernels import row
from systems.motor.contract import Stroke, contract
from systems.motor.muscle_model import (
    FACE,
    FACE_SEGMENT,
    FACE_WEIGHT,
    FACES,
    SEGMENTS,
    SPRING,
    SPRINGS,
    BodyModel,
)
from systems.motor.pectorals import press

SUBSTEPS: Final = 4
"""Substeps a tick; dt is part of the model."""

SUBSTEP_SECONDS: Final = 1.0 / 240.0
UNKNOWNS: Final = 3 * NODES
BAND_SIZE: Final = 25 * UNKNOWNS
"""Length of the flat band. A stride of 24 leaves the places just below the diagonal free to be written over."""


class Workspace(NamedTuple):
    """Scratch of one fish in live physics; only `rest` means anything between substeps."""

    rest: Float64s
    "[BL] lengths that the springs strive for, the first 12 the muscles', (91,)"
    axes: Float64s
    "the centre line's directions, (6, 3)"
    band: Float64s
    "(BAND_SIZE,)"
    right: Float64s
    "right side, then the new velocities, (69,)"


def workspace(model: BodyModel) -> Workspace:
    """Return scratch for a relaxed fish."""
    return Workspace(
        model.length.copy(), np.zeros((SEGMENTS, 3)), np.zeros(BAND_SIZE), np.zeros(UNKNOWNS)
    )


def _row_ends() -> Int64s:
    """Return one past the last column that elimination fills in each node's rows: the end of the next ring."""
    ring_ends = np.array([1, *range(5, 22, 4), 23])
    after = np.searchsorted(ring_ends, np.arange(NODES), side="right")
    return (3 * ring_ends[np.minimum(after + 1, len(ring_ends) - 1)]).astype(np.int64)


ROW_END: Final = _row_ends()
"""One past the last unknown coupled with each node's, (23,)."""


@row
def _add_diagonal(
    band: Float64s, node: int, xx: float, xy: float, xz: float, yy: float, yz: float, zz: float
) -> None:
    at = 75 * node
    band[at] += xx
    band[at + 1] += xy
    band[at + 2] += xz
    band[at + 25] += yy
    band[at + 26] += yz
    band[at + 50] += zz


@row
def _add_coupling(
    band: Float64s, at: int, xx: float, xy: float, xz: float, yy: float, yz: float, zz: float
) -> None:
    band[at] += xx
    band[at + 1] += xy
    band[at + 2] += xz
    band[at + 24] += xy
    band[at + 25] += yy
    band[at + 26] += yz
    band[at + 48] += xz
    band[at + 49] += yz
    band[at + 50] += zz


@row
def _add_inertia(mass: Float64s, velocity: Float64s, band: Float64s, momentum: Float64s) -> None:
    for i in range(BAND_SIZE):
        band[i] = 0.0
    for node in range(NODES):
        for axis in range(3):
            band[25 * (3 * node + axis)] = mass[node]
            momentum[3 * node + axis] = mass[node] * velocity[node, axis]


@row
def _add_springs(
    model: BodyModel, rest: Float64s, position: Float64s, band: Float64s, momentum: Float64s
) -> None:
    dt = SUBSTEP_SECONDS
    for s in range(SPRINGS):
        a, b = SPRING[s, 0], SPRING[s, 1]
        x = position[b, 0] - position[a, 0]
        y = position[b, 1] - position[a, 1]
        z = position[b, 2] - position[a, 2]
        length = sqrt(x * x + y * y + z * z)
        inverse = 1.0 / length
        x, y, z = x * inverse, y * inverse, z * inverse
        k = model.stiffness[s]
        pull = dt * k * (length - rest[s])
        momentum[3 * a] += pull * x
        momentum[3 * a + 1] += pull * y
        momentum[3 * a + 2] += pull * z
        momentum[3 * b] -= pull * x
        momentum[3 * b + 1] -= pull * y
        momentum[3 * b + 2] -= pull * z
        across = dt * dt * k * max(0.0, 1.0 - rest[s] * inverse)
        along = dt * (model.damping[s] + dt * k) - across
        xx, yy, zz = along * x * x + across, along * y * y + across, along * z * z + across
        xy, xz, yz = along * x * y, along * x * z, along * y * z
        _add_diagonal(band, a, xx, xy, xz, yy, yz, zz)
        _add_diagonal(band, b, xx, xy, xz, yy, yz, zz)
        _add_coupling(band, 72 * a + 3 * b, -xx, -xy, -xz, -yy, -yz, -zz)


@row
def _centre(position: Float64s, place: int, axis: int) -> float:
    """Return a coordinate of the centre line: 0 the nose, 1-5 the rings, 6 the middle of the caudal fin's tips."""
    first, nodes = 4 * place - 3, 4
    if place == 0:
        first, nodes = 0, 1
    if place == 6:
        first, nodes = 21, 2
    total = 0.0
    for node in range(first, first + nodes):
        total += position[node, axis]
    return total / nodes


@row
def _add_water(
    water: Float64s, position: Float64s, velocity: Float64s, axes: Float64s, band: Float64s
) -> None:
    """Add the water's drag: -c_l A (v.n~) n~ where v.n~ > 0, and -c_t A v_tangential on every face."""
    for segment in range(SEGMENTS):
        x = _centre(position, segment, 0) - _centre(position, segment + 1, 0)
        y = _centre(position, segment, 1) - _centre(position, segment + 1, 1)
        z = _centre(position, segment, 2) - _centre(position, segment + 1, 2)
        inverse = 1.0 / sqrt(x * x + y * y + z * z)
        axes[segment, 0], axes[segment, 1], axes[segment, 2] = x * inverse, y * inverse, z * inverse
    for face in range(FACES):
        _add_face(face, water, position, velocity, axes, band)


@row
def _add_face(
    face: int,
    water: Float64s,
    position: Float64s,
    velocity: Float64s,
    axes: Float64s,
    band: Float64s,
) -> None:
    a, b, c, d = FACE[face, 0], FACE[face, 1], FACE[face, 2], FACE[face, 3]
    px, py, pz = (
        position[c, 0] - position[a, 0],
        position[c, 1] - position[a, 1],
        position[c, 2] - position[a, 2],
    )
    qx, qy, qz = (
        position[d, 0] - position[b, 0],
        position[d, 1] - position[b, 1],
        position[d, 2] - position[b, 2],
    )
    x, y, z = py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx
    size = sqrt(x * x + y * y + z * z)
    inverse = 1.0 / (size + 1e-30)
    x, y, z = x * inverse, y * inverse, z * inverse
    segment = FACE_SEGMENT[face]
    lx, ly, lz = axes[segment, 0], axes[segment, 1], axes[segment, 2]
    part = (1.0 - water[2]) * (x * lx + y * ly + z * lz)
    lx, ly, lz = x - part * lx, y - part * ly, z - part * lz
    u = v = w = 0.0
    for i in range(4):
        weight, node = FACE_WEIGHT[face, i], FACE[face, i]
        u += weight * velocity[node, 0]
        v += weight * velocity[node, 1]
        w += weight * velocity[node, 2]
    scale = 0.5 * size * SUBSTEP_SECONDS
    friction = water[1] * scale
    lift = water[0] * scale if u * lx + v * ly + w * lz > 0.0 else 0.0
    xx = friction * (1.0 - x * x) + lift * lx * lx
    yy = friction * (1.0 - y * y) + lift * ly * ly
    zz = friction * (1.0 - z * z) + lift * lz * lz
    xy = lift * lx * ly - friction * x * y
    xz = lift * lx * lz - friction * x * z
    yz = lift * ly * lz - friction * y * z
    corners = 4 if c != d else 3
    for i in range(corners):
        m, own = FACE[face, i], FACE_WEIGHT[face, i] * FACE_WEIGHT[face, i]
        _add_diagonal(band, m, own * xx, own * xy, own * xz, own * yy, own * yz, own * zz)
        for j in range(i + 1, corners):
            n = FACE[face, j]
            at = 72 * min(m, n) + 3 * max(m, n)
            _add_coupling(band, at, own * xx, own * xy, own * xz, own * yy, own * yz, own * zz)


@row
def _factor_node(band: Float64s, right: Float64s, first: int, end: int) -> None:
    """Turn the three rows from `first` on into rows of U, their diagonal into inverses."""
    one, two, three = 24 * first, 24 * first + 24, 24 * first + 48
    a = 1.0 / sqrt(band[one + first])
    for j in range(first + 1, end):
        band[one + j] *= a
    f, g = band[one + first + 1], band[one + first + 2]
    b = 1.0 / sqrt(band[two + first + 1] - f * f)
    for j in range(first + 2, end):
        band[two + j] = (band[two + j] - f * band[one + j]) * b
    h = band[two + first + 2]
    c = 1.0 / sqrt(band[three + first + 2] - (g * g + h * h))
    for j in range(first + 3, end):
        band[three + j] = (band[three + j] - (g * band[one + j] + h * band[two + j])) * c
    band[one + first], band[two + first + 1], band[three + first + 2] = a, b, c
    right[first] *= a
    right[first + 1] = (right[first + 1] - f * right[first]) * b
    right[first + 2] = (right[first + 2] - (g * right[first] + h * right[first + 1])) * c


@row
def _reduce_node(band: Float64s, right: Float64s, first: int, q: int, end: int) -> None:
    """Take the outer product of the three rows at `first` from the three rows at `q`."""
    one, two, three = 24 * first, 24 * first + 24, 24 * first + 48
    f0, f1, f2 = band[one + q], band[two + q], band[three + q]
    g0, g1, g2 = band[one + q + 1], band[two + q + 1], band[three + q + 1]
    h0, h1, h2 = band[one + q + 2], band[two + q + 2], band[three + q + 2]
    r0, r1, r2 = right[first], right[first + 1], right[first + 2]
    right[q] -= f0 * r0 + f1 * r1 + f2 * r2
    right[q + 1] -= g0 * r0 + g1 * r1 + g2 * r2
    right[q + 2] -= h0 * r0 + h1 * r1 + h2 * r2
    t0, t1, t2 = 24 * q, 24 * q + 24, 24 * q + 48
    for j in range(q, end):
        p0, p1, p2 = band[one + j], band[two + j], band[three + j]
        band[t0 + j] -= f0 * p0 + f1 * p1 + f2 * p2
        band[t1 + j] -= g0 * p0 + g1 * p1 + g2 * p2
        band[t2 + j] -= h0 * p0 + h1 * p1 + h2 * p2


@row
def solve(band: Float64s, right: Float64s) -> None:
    """Solve for `right` (69,) in place by banded Cholesky, a node's three unknowns at a time; `band` is used up."""
    for node in range(NODES):
        first, end = 3 * node, ROW_END[node]
        _factor_node(band, right, first, end)
        for q in range(first + 3, end, 3):
            _reduce_node(band, right, first, q, end)
    for node in range(NODES - 1, -1, -1):
        first = 3 * node
        one, two, three = 24 * first, 24 * first + 24, 24 * first + 48
        a, b, c = right[first], right[first + 1], right[first + 2]
        for j in range(first + 3, ROW_END[node]):
            a -= band[one + j] * right[j]
            b -= band[two + j] * right[j]
            c -= band[three + j] * right[j]
        c *= band[three + first + 2]
        b = (b - band[two + first + 2] * c) * band[two + first + 1]
        a = (a - (band[one + first + 1] * b + band[one + first + 2] * c)) * band[one + first]
        right[first], right[first + 1], right[first + 2] = a, b, c


@row
def assemble(model: BodyModel, position: Float64s, velocity: Float64s, work: Workspace) -> None:
    """Write the band and right side of one substep from `work.rest`; `position` and `velocity` are (23, 3)."""
    _add_inertia(model.mass, velocity, work.band, work.right)
    _add_springs(model, work.rest, position, work.band, work.right)
    _add_water(model.water, position, velocity, work.axes, work.band)


@row
def drive(
    model: BodyModel,
    stroke: Stroke,
    step: int,
    position: Float64s,
    velocity: Float64s,
    work: Workspace,
) -> None:
    """Write the band and right side of substep `step` of `stroke`: muscles, water and fins."""
    contract(stroke, model.length, step, SUBSTEP_SECONDS, work.rest)
    assemble(model, position, velocity, work)
    fins, drag = stroke.fins, model.water[0]
    press(fins, drag, model.mass, position, velocity, step, SUBSTEP_SECONDS, work.right)


@row
def move_nodes(position: Float64s, velocity: Float64s, right: Float64s) -> None:
    """Take over the new velocities [BL/s] in `right` (69,) and move the nodes [BL] for 1/240 s."""
    for node in range(NODES):
        for axis in range(3):
            speed = right[3 * node + axis]
            velocity[node, axis] = speed
            position[node, axis] += SUBSTEP_SECONDS * speed


@row
def substep(model: BodyModel, position: Float64s, velocity: Float64s, work: Workspace) -> None:
    """Advance `position` [BL] and `velocity` [BL/s], (23, 3) each, in place by 1/240 s."""
    assemble(model, position, velocity, work)
    solve(work.band, work.right)
    move_nodes(position, velocity, work.right)


@row
def advance(
    model: BodyModel,
    stroke: Stroke,
    frame: int,
    position: Float64s,
    velocity: Float64s,
    work: Workspace,
) -> None:
    """Advance one frame of 1/60 s of `stroke`; `frame` counts from the stroke's start."""
    for step in range(SUBSTEPS * frame, SUBSTEPS * (frame + 1)):
        drive(model, stroke, step, position, velocity, work)
        solve(work.band, work.right)
        move_nodes(position, velocity, work.right)
