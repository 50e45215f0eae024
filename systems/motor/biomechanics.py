"""The implicit step of the biomechanical fish in water (papers/000, 3.1; papers/004; FINDINGS 1).

Each substep of 1/240 s solves (M + dt C + dt^2 K + dt D) v' = M v + dt f for the 23 nodal velocities, then moves the
nodes: 69 equations, symmetric and positive definite, half-bandwidth 23 in natural order. C and K are the springs'
dampers and tangents, D the water's drag. The band holds the upper triangle: entry (i, j) at 23 i + j of a flat array.

Only + - * / sqrt on the caller's arrays, so every machine computes the same bits, and a fish costs no allocation.
"""

from math import sqrt
from typing import Final

import numpy as np

from components.arrays import Float64s, Int64s
from components.body import NODES
from components.kernels import row
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

SUBSTEPS: Final = 4
"""Substeps a tick; dt is part of the model."""

SUBSTEP_SECONDS: Final = 1.0 / 240.0
UNKNOWNS: Final = 3 * NODES
BAND_SIZE: Final = 23 * UNKNOWNS + UNKNOWNS
"""Length of the flat band."""

LIFT: Final = 400.0
"""Water's drag on a face that moves outwards, c_l."""

SKIN_FRICTION: Final = 0.5
"""Drag along a face, c_t."""

STREAMLINING: Final = 0.25
"""How much of a normal's part along the centre line the water feels, s."""


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
    at = 72 * node
    band[at] += xx
    band[at + 1] += xy
    band[at + 2] += xz
    band[at + 24] += yy
    band[at + 25] += yz
    band[at + 48] += zz


@row
def _add_coupling(
    band: Float64s, at: int, xx: float, xy: float, xz: float, yy: float, yz: float, zz: float
) -> None:
    band[at] += xx
    band[at + 1] += xy
    band[at + 2] += xz
    band[at + 23] += xy
    band[at + 24] += yy
    band[at + 25] += yz
    band[at + 46] += xz
    band[at + 47] += yz
    band[at + 48] += zz


@row
def _add_inertia(mass: Float64s, velocity: Float64s, band: Float64s, momentum: Float64s) -> None:
    for i in range(BAND_SIZE):
        band[i] = 0.0
    for node in range(NODES):
        for axis in range(3):
            band[24 * (3 * node + axis)] = mass[node]
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
        _add_coupling(band, 69 * a + 3 * b, -xx, -xy, -xz, -yy, -yz, -zz)


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
def _add_water(position: Float64s, velocity: Float64s, axes: Float64s, band: Float64s) -> None:
    """Add the water's drag: -LIFT A (v.n~) n~ where v.n~ > 0, and -SKIN_FRICTION A v_tangential on every face."""
    for segment in range(SEGMENTS):
        x = _centre(position, segment, 0) - _centre(position, segment + 1, 0)
        y = _centre(position, segment, 1) - _centre(position, segment + 1, 1)
        z = _centre(position, segment, 2) - _centre(position, segment + 1, 2)
        inverse = 1.0 / sqrt(x * x + y * y + z * z)
        axes[segment, 0], axes[segment, 1], axes[segment, 2] = x * inverse, y * inverse, z * inverse
    for face in range(FACES):
        _add_face(face, position, velocity, axes, band)


@row
def _add_face(
    face: int, position: Float64s, velocity: Float64s, axes: Float64s, band: Float64s
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
    part = (1.0 - STREAMLINING) * (x * lx + y * ly + z * lz)
    lx, ly, lz = x - part * lx, y - part * ly, z - part * lz
    u = v = w = 0.0
    for i in range(4):
        weight, node = FACE_WEIGHT[face, i], FACE[face, i]
        u += weight * velocity[node, 0]
        v += weight * velocity[node, 1]
        w += weight * velocity[node, 2]
    scale = 0.5 * size * SUBSTEP_SECONDS
    friction = SKIN_FRICTION * scale
    lift = LIFT * scale if u * lx + v * ly + w * lz > 0.0 else 0.0
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
            at = 69 * min(m, n) + 3 * max(m, n)
            _add_coupling(band, at, own * xx, own * xy, own * xz, own * yy, own * yz, own * zz)


@row
def _eliminate(band: Float64s, right: Float64s) -> None:
    """Turn the band into U of U^T U and the right side into U^-T times itself, three unknowns of a node at a time."""
    for node in range(NODES):
        end = ROW_END[node]
        for axis in range(3):
            i = 3 * node + axis
            base = 23 * i
            inverse = 1.0 / sqrt(band[base + i])
            band[base + i] = inverse
            right[i] *= inverse
            for j in range(i + 1, end):
                band[base + j] *= inverse
            for r in range(i + 1, 3 * node + 3):
                factor = band[base + r]
                right[r] -= factor * right[i]
                for j in range(r, end):
                    band[23 * r + j] -= factor * band[base + j]
        first = 3 * node
        one, two, three = 23 * first, 23 * first + 23, 23 * first + 46
        for r in range(first + 3, end):
            f, g, h = band[one + r], band[two + r], band[three + r]
            right[r] -= f * right[first] + g * right[first + 1] + h * right[first + 2]
            for j in range(r, end):
                band[23 * r + j] -= f * band[one + j] + g * band[two + j] + h * band[three + j]


@row
def _substitute(band: Float64s, right: Float64s) -> None:
    """Solve U v = right in place; U's diagonal holds inverses."""
    for i in range(UNKNOWNS - 1, -1, -1):
        base = 23 * i
        total = right[i]
        for j in range(i + 1, ROW_END[i // 3]):
            total -= band[base + j] * right[j]
        right[i] = total * band[base + i]


@row
def assemble(
    model: BodyModel,
    rest: Float64s,
    position: Float64s,
    velocity: Float64s,
    axes: Float64s,
    band: Float64s,
    right: Float64s,
) -> None:
    """Write the band (1656,) and right side (69,) of one substep; `rest` [BL] (91,) are the springs' lengths now.

    `position` [BL] and `velocity` [BL/s] are (23, 3); `axes` (6, 3) is scratch.
    """
    _add_inertia(model.mass, velocity, band, right)
    _add_springs(model, rest, position, band, right)
    _add_water(position, velocity, axes, band)


@row
def substep(
    model: BodyModel,
    rest: Float64s,
    position: Float64s,
    velocity: Float64s,
    axes: Float64s,
    band: Float64s,
    right: Float64s,
) -> None:
    """Advance `position` and `velocity` in place by 1/240 s; arguments as in `assemble`."""
    assemble(model, rest, position, velocity, axes, band, right)
    _eliminate(band, right)
    _substitute(band, right)
    for node in range(NODES):
        for axis in range(3):
            speed = right[3 * node + axis]
            velocity[node, axis] = speed
            position[node, axis] += SUBSTEP_SECONDS * speed
