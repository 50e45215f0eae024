"""The water's velocity: the sum of what every singularity does to it (papers/002, eqs. 1-5, as FINDINGS 9 mends them).

One evaluator for fish, plankton and particles, `flow`, float64 and under the bit rule; and `pack`, the same
singularities as fibres read them, float32. Three changes to the paper's equations: a^2 = |Phi| / Phi_max, so that a
source may be key-framed into a hole; a softening e, so that the direction has no jump in the centre; and a window that
is 1 up to .71 R and 0 from R on, so that what lies beyond R may be left out without a trace.
"""

from math import floor, sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float32s, Float64s, Int8s, Int32s
from components.clock import TICK_SECONDS
from components.kernels import inlined, row
from components.singularity import SingularityKind, SingularityTable
from components.sphere_grid import SphereGrid, square_at
from components.trigonometry import sine

PACKED: Final = 16
"""Numbers a singularity has in what `pack` returns."""

REACH_AT: Final = 3
KIND_AT: Final = 7

_HOLE: Final = int(SingularityKind.HOLE)
_WHIRLWIND: Final = int(SingularityKind.WHIRLWIND)
_DIRECTIONAL: Final = int(SingularityKind.DIRECTIONAL)
_TURN: Final = 6.283185307179586
_STRONGEST: Final = 1e6
_FASTEST: Final = 1e4
_FINEST: Final = 1e-3


class Field(NamedTuple):
    """The living rows of a `SingularityTable`, as kernels read them; units and shapes stand there."""

    kind: Int32s
    position: Float64s
    axis: Float64s
    intensity: Float64s
    most: Float64s
    reach: Float64s
    softening: Float64s
    wave_number: Float64s
    frequency: Float64s
    amplitude: Float64s
    phase: Float64s
    there: Int8s


def field_of(table: SingularityTable) -> Field:
    """Return views of the living rows; they go stale when the table grows or shrinks."""
    return Field(*(getattr(table, name)[: table.count] for name in Field._fields))


@inlined
def window(d2: float, reach: float) -> float:
    """Return 1 up to a squared distance [m^2] of reach^2 / 2, 0 from reach^2 on, smooth between; 0 for no reach."""
    if not d2 < reach * reach:
        return 0.0
    inside = min(2.0 - 2.0 * (d2 / (reach * reach)), 1.0)
    return inside * inside * (3.0 - 2.0 * inside)


@inlined
def flow_of(
    field: Field, k: int, tick: int, x: float, y: float, z: float
) -> tuple[float, float, float]:
    """Return the velocity [m/s] that singularity k alone gives the water at a point [m]."""
    qx, qy, qz = x - field.position[k, 0], y - field.position[k, 1], z - field.position[k, 2]
    d2 = qx * qx + qy * qy + qz * qz
    push = field.intensity[k] * window(d2, field.reach[k])
    if push == 0.0 or field.there[k] == 0:
        return 0.0, 0.0, 0.0
    ax, ay, az = field.axis[k, 0], field.axis[k, 1], field.axis[k, 2]
    if field.kind[k] == _DIRECTIONAL:
        turns = field.wave_number[k] * (x * ax + y * ay + z * az) + field.phase[k]
        turns -= field.frequency[k] * (tick * TICK_SECONDS)
        turns -= floor(turns)
        push *= 1.0 + field.amplitude[k] * sine(_TURN * turns)
        return push * ax, push * ay, push * az
    if not field.most[k] > 0.0:
        return 0.0, 0.0, 0.0
    if field.kind[k] == _WHIRLWIND:
        qx, qy, qz = qy * az - qz * ay, qz * ax - qx * az, qx * ay - qy * ax
    elif field.kind[k] == _HOLE:
        push = -push
    size = sqrt(qx * qx + qy * qy + qz * qz + field.softening[k] * field.softening[k])
    spread = abs(field.intensity[k]) / field.most[k] + d2
    if not (size > 0.0 and spread > 0.0):
        return 0.0, 0.0, 0.0
    push /= spread
    return push * (qx / size), push * (qy / size), push * (qz / size)


@row
def flow(field: Field, tick: int, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Return the water's velocity [m/s] at a point [m] (papers/002, eq. 1), at a tick."""
    u, v, w = 0.0, 0.0, 0.0
    for k in range(len(field.kind)):
        du, dv, dw = flow_of(field, k, tick, x, y, z)
        u, v, w = u + du, v + dv, w + dw
    return u, v, w


@row
def flow_near(
    field: Field, grid: SphereGrid, tick: int, x: float, y: float, z: float
) -> tuple[float, float, float]:
    """Return what `flow` returns, to the bit, asking only the singularities that `grid` lists near the point."""
    u, v, w = 0.0, 0.0, 0.0
    square = square_at(grid, x, y)
    for at in range(grid.first[square], grid.first[square + 1]):
        du, dv, dw = flow_of(field, grid.listed[at], tick, x, y, z)
        u, v, w = u + du, v + dv, w + dw
    return u, v, w


def pack(table: SingularityTable, tick: float) -> Float32s:
    """Return the singularities as fibres read them at a tick, float32, (n, 16).

    Each row is x y z [m], R [m] | axis (3), kind | Phi (a hole's is negative), a^2, e^2, amplitude | wave number
    [turns/m], phase now [turns], 2 / R^2, unused. What is not finite or has no reach is switched off, what is huge is
    bounded (|Phi| <= 1e6, Phi_max <= 1e4 m/s, e >= 1 mm), so that no fibre can turn NaN.
    """
    field = field_of(table)
    out = np.zeros((len(field.kind), PACKED), np.float64)
    with np.errstate(all="ignore"):
        phi = np.clip(field.intensity, -_STRONGEST, _STRONGEST)
        most = np.clip(field.most, _FINEST, _FASTEST)
        out[:, :3], out[:, REACH_AT] = field.position, field.reach
        out[:, 4:7], out[:, KIND_AT] = np.clip(field.axis, -1.0, 1.0), field.kind
        out[:, 8] = np.where(field.kind == _HOLE, -phi, phi)
        out[:, 9] = np.abs(phi) / most
        out[:, 10] = np.clip(field.softening, _FINEST, _STRONGEST) ** 2
        out[:, 11] = np.clip(field.amplitude, -_FASTEST, _FASTEST)
        out[:, 12] = np.clip(field.wave_number, -_FASTEST, _FASTEST)
        turns = field.phase - field.frequency * (tick * TICK_SECONDS)
        out[:, 13] = turns - np.floor(turns)
        out[:, 14] = 2.0 / (field.reach * field.reach)
        off = ~(np.isfinite(np.delete(out, REACH_AT, 1)).all(1) & (field.reach > _FINEST))
        off |= np.abs(out[:, :3]).max(1, initial=0.0) > _STRONGEST
        off |= field.there == 0
        off |= (field.kind != _DIRECTIONAL) & ~(field.most > 0.0)
        out[off] = 0.0
        return out.astype(np.float32)
