"""Chasing a target: steer to where it will be, the more carefully the nearer, and never past it.

Papers/004 has the fish attend increasingly carefully to the target; papers/000, 6.2 has careful steering begin
farther off, to make up for a coarser motor system.
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s
from components.kernels import inlined, row
from systems.mind.behave.pace import pace
from systems.mind.crowd import Crowd

_LONGEST_LEAD: Final = 1.5
_CLOSING: Final = 1.2
_CAREFUL_WITHIN: Final = 8.0
_TURN_AHEAD: Final = 0.5
_FINE_COSINE: Final = 0.766
_RIGHT_BEHIND: Final = 0.04
_FINE_SINE: Final = 0.6428


@inlined
def turn_finely(crowd: Crowd, me: int, out: Float64s) -> None:
    """Bring the wanted direction, (3,), within what fine steering reaches: near its goal a fish pivots.

    A turn segment would carry it past.
    """
    hx, hy, hz = crowd.hx[me], crowd.hy[me], crowd.hz[me]
    size = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]) + 1e-9
    x, y, z = out[0] / size, out[1] / size, out[2] / size
    along = x * hx + y * hy + z * hz
    if along >= _FINE_COSINE:
        return
    x, y, z = x - along * hx, y - along * hy, z - along * hz
    if along < 0.0 and x * x + y * y < _RIGHT_BEHIND:
        x, y, z = -hy, hx, 0.0
    aside = sqrt(x * x + y * y + z * z) + 1e-9
    sine = _FINE_SINE / aside
    out[0] = _FINE_COSINE * hx + sine * x
    out[1] = _FINE_COSINE * hy + sine * y
    out[2] = _FINE_COSINE * hz + sine * z


@row
def chase_target(
    crowd: Crowd,
    me: int,
    speeds: Float64s,
    dx: float,
    dy: float,
    dz: float,
    vx: float,
    vy: float,
    vz: float,
    eagerness: float,
    out: Float64s,
) -> tuple[int, float, float]:
    """Write the wanted direction, (3,), after a target at the offset d [m] that moves with v [m/s].

    `speeds`: the species' in its gears [BL/s], (3,). `eagerness`, 0 to 1: from trailing it to running it down.
    Return gear, urgency, throttle. The speed falls with the distance, to the target's own at its side.
    """
    length = crowd.length[me]
    far = sqrt(dx * dx + dy * dy + dz * dz) + 1e-9
    lead = min(far / (length * speeds[1 + int(eagerness > 0.5)] + 1e-9), _LONGEST_LEAD)
    x, y, z = dx + lead * vx, dy + lead * vy, dz + lead * vz
    out[0], out[1], out[2] = x, y, z
    aim = sqrt(x * x + y * y + z * z) + 1e-9
    facing = (x * crowd.hx[me] + y * crowd.hy[me] + z * crowd.hz[me]) / aim
    drift = max((vx * x + vy * y + vz * z) / aim, 0.0)
    wanted = drift + (_CLOSING * (0.5 + eagerness)) * max(far - 0.5 * length, -0.25 * length)
    wanted = min(wanted, 1.2 * length * speeds[1 + int(eagerness > 0.5)])
    if facing < _TURN_AHEAD and far < 3.0 * length:
        wanted *= max(facing, 0.0)
        turn_finely(crowd, me, out)
    gear, throttle = pace(speeds, length, wanted)
    careful = min(_CAREFUL_WITHIN * length / (far + _CAREFUL_WITHIN * length), 1.0)
    return gear, 0.25 + 0.25 * eagerness * careful, throttle
