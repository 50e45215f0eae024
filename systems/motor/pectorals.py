"""The pectoral fins of the biomechanical fish: reaction surfaces that right, pitch, brake and back (papers/000, 3.2).

Held flat they give couples on the first three rings, stiff against the angle that is wrong and damped by its rate
(FINDINGS 1); set broadside they feel the water as the body's faces do, with the speed of their own stroke added: a fin
that stands brakes, and one that rows forwards broadside and comes back edgewise drives the fish backwards.
"""

from math import sqrt
from typing import Final, NamedTuple

from components.arrays import Float64s
from components.kernels import row
from components.trigonometry import arc, sine

TWO_PI: Final = 6.283185307179586
NODES_HELD: Final = 13
"""Nodes 1 to 12, of the first three rings, take what the fins feel."""

RIGHTING: Final = 1.5
"""Couple about the body's axis over the roll [1/rad], for a fish of mass 1."""

ROLL_DAMPING: Final = 0.5
"""... and over the rate of roll [s/rad]."""

PITCHING: Final = 3.0
"""Couple about the level axis across the body over the pitch that is missing [1/rad]."""

PITCH_DAMPING: Final = 1.5
"""... and over the rate of pitch [s/rad]."""

EDGEWISE: Final = 0.1
"""Share of a fin's area that the water feels while it comes back."""


class Pectorals(NamedTuple):
    """What a pair of pectoral fins is told."""

    righting: float
    "1 where they keep the body upright, 0 where not"
    pitching: float
    "1 where they hold the body at `pitch`, 0 where not"
    pitch: float
    "[rad] nose up"
    area: float
    "[BL^2] that both set against the stream, 0 where they lie flat"
    rowing: float
    "[BL/s] fastest of their own stroke forwards, 0 where they stand"
    period: int
    "[substeps] of a stroke to and fro"


FOLDED: Final = Pectorals(0.0, 0.0, 0.0, 0.0, 0.0, 1)
"""Fins laid to the body, which the water does not feel."""


@row
def press(
    fins: Pectorals,
    drag: float,
    mass: Float64s,
    position: Float64s,
    velocity: Float64s,
    substep: int,
    seconds: float,
    right: Float64s,
) -> None:
    """Add what the fins push in a substep of `seconds` to the right side (69,); `drag` is the water's c_l."""
    if fins.righting == 0.0 and fins.pitching == 0.0 and fins.area == 0.0:
        return
    x, y, z = _ahead(position)
    if fins.righting != 0.0:
        couple = RIGHTING * arc(_upward(position, 1), _upward(position, 0))
        _twist(couple, ROLL_DAMPING, mass, position, velocity, x, y, z, seconds, right)
    if fins.pitching != 0.0:
        level = sqrt(x * x + y * y)
        couple = PITCHING * (fins.pitch - arc(level, z))
        u, v = y / level, -x / level
        _twist(couple, PITCH_DAMPING, mass, position, velocity, u, v, 0.0, seconds, right)
    if fins.area > 0.0:
        stroke = sine(TWO_PI * ((substep % fins.period) / fins.period))
        area = fins.area if fins.rowing == 0.0 or stroke > 0.0 else EDGEWISE * fins.area
        _stem(drag * area, fins.rowing * stroke, mass, velocity, x, y, z, seconds, right)


@row
def _ahead(position: Float64s) -> tuple[float, float, float]:
    """Return the unit vector from the third ring to the first."""
    x = y = z = 0.0
    for node in range(1, 5):
        x += position[node, 0] - position[node + 8, 0]
        y += position[node, 1] - position[node + 8, 1]
        z += position[node, 2] - position[node + 8, 2]
    size = sqrt(x * x + y * y + z * z)
    return x / size, y / size, z / size


@row
def _upward(position: Float64s, axis: int) -> float:
    """Return the upward part of the rings' width, from left to right (axis 0), or height (axis 1), as unit vectors."""
    x = y = z = 0.0
    for ring in range(3):
        a, b, c, d = 4 * ring + 1, 4 * ring + 2, 4 * ring + 3, 4 * ring + 4
        if axis == 1:
            b, d = d, b
        x += position[b, 0] + position[c, 0] - position[a, 0] - position[d, 0]
        y += position[b, 1] + position[c, 1] - position[a, 1] - position[d, 1]
        z += position[b, 2] + position[c, 2] - position[a, 2] - position[d, 2]
    if axis == 1:
        x, y, z = -x, -y, -z
    return z / sqrt(x * x + y * y + z * z)


@row
def _twist(
    couple: float,
    damping: float,
    mass: Float64s,
    position: Float64s,
    velocity: Float64s,
    x: float,
    y: float,
    z: float,
    seconds: float,
    right: Float64s,
) -> None:
    """Add a couple less `damping` times the rate about the unit axis (x, y, z), as in a turn of a stiff body."""
    total = cx = cy = cz = 0.0
    for node in range(1, NODES_HELD):
        total += mass[node]
        cx += mass[node] * position[node, 0]
        cy += mass[node] * position[node, 1]
        cz += mass[node] * position[node, 2]
    cx, cy, cz = cx / total, cy / total, cz / total
    spin = inertia = whole = 0.0
    for node in range(len(mass)):
        whole += mass[node]
    for node in range(1, NODES_HELD):
        px, py, pz = position[node, 0] - cx, position[node, 1] - cy, position[node, 2] - cz
        u, v, w = y * pz - z * py, z * px - x * pz, x * py - y * px
        spin += mass[node] * (u * velocity[node, 0] + v * velocity[node, 1] + w * velocity[node, 2])
        inertia += mass[node] * (u * u + v * v + w * w)
    push = seconds * whole * (couple - damping * spin / inertia) / inertia
    for node in range(1, NODES_HELD):
        px, py, pz = position[node, 0] - cx, position[node, 1] - cy, position[node, 2] - cz
        right[3 * node] += push * mass[node] * (y * pz - z * py)
        right[3 * node + 1] += push * mass[node] * (z * px - x * pz)
        right[3 * node + 2] += push * mass[node] * (x * py - y * px)


@row
def _stem(
    drag: float,
    stroke: float,
    mass: Float64s,
    velocity: Float64s,
    x: float,
    y: float,
    z: float,
    seconds: float,
    right: Float64s,
) -> None:
    """Add the drag of fins that move at `stroke` [BL/s] along the unit vector (x, y, z) beside the body's own speed."""
    total = speed = 0.0
    for node in range(1, NODES_HELD):
        total += mass[node]
        along = x * velocity[node, 0] + y * velocity[node, 1] + z * velocity[node, 2]
        speed += mass[node] * along
    push = -seconds * drag * (speed / total + stroke) / total
    for node in range(1, NODES_HELD):
        right[3 * node] += push * mass[node] * x
        right[3 * node + 1] += push * mass[node] * y
        right[3 * node + 2] += push * mass[node] * z
