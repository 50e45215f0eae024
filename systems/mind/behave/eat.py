"""Eating: come near, slow down, open the mouth at the last lengths and let the meal be sucked in (papers/004)."""

from math import sqrt
from typing import Final

from components.arrays import Float64s
from components.kernels import inlined, row
from systems.mind.behave.chase_target import chase_target, turn_finely
from systems.mind.behave.pace import BRISKEST, SLOWEST, pace
from systems.mind.crowd import Crowd

DASH_TICKS: Final = 90
"""[ticks] for which a hunter can dash ..."""

BREATH_TICKS: Final = 480
"""... of so many."""

_STALK: Final = 0.4
_STRIKE: Final = 2.5
_CREEP_UP: Final = 4.0
_HEADLONG: Final = 0.2
_SWEEP: Final = 0.8
_BEFORE: Final = 0.9
_LAST: Final = 2.0
_GAPE_FROM: Final = 3.0
_AFTER: Final = 1.6
_LEAST: Final = 0.25
_FACING: Final = 0.5
_BESIDE: Final = 0.1
_PIVOT: Final = 0.8


@inlined
def _hunt(
    crowd: Crowd,
    me: int,
    speeds: Float64s,
    dx: float,
    dy: float,
    dz: float,
    vx: float,
    vy: float,
    vz: float,
    near: float,
    facing: float,
    now: int,
    out: Float64s,
) -> tuple[int, float, float, float]:
    """Stalk prey, then dash at it: at speed a fish turns badly, and its breath is short, which is prey's chance."""
    length = crowd.length[me]
    gear, urgency, throttle = chase_target(crowd, me, speeds, dx, dy, dz, vx, vy, vz, _STALK, out)
    breath = (now + 97 * crowd.id[me]) % BREATH_TICKS
    far = sqrt(dx * dx + dy * dy + dz * dz) / length
    if far < _STRIKE and facing > _FACING and breath < DASH_TICKS:
        out[0], out[1], out[2] = dx, dy, dz
        gear, urgency, throttle = 2, _HEADLONG, BRISKEST
    elif facing < _FACING:
        gear, urgency, throttle = 1, _HEADLONG, _SWEEP
    elif far < _CREEP_UP and gear > 0:
        gear, throttle = 0, BRISKEST
    gape = min(max(_GAPE_FROM - near, 0.0), 1.0) if facing > _BEFORE else 0.0
    return gear, urgency, throttle, gape


@row
def eat(
    crowd: Crowd,
    me: int,
    speeds: Float64s,
    dx: float,
    dy: float,
    dz: float,
    vx: float,
    vy: float,
    vz: float,
    nose: float,
    mouth: float,
    hunger: float,
    hunts: bool,
    now: int,
    out: Float64s,
) -> tuple[int, float, float, float]:
    """Write the wanted direction, (3,), to a meal at the offset d [m] that moves with v [m/s].

    `speeds`: the species' in its gears [BL/s], (3,); `nose` [BL]: how far it lies ahead of the origin; `mouth`
    [BL]: how far from there it sucks in. Return gear, urgency, throttle and gape, 0 to 1. Prey is dashed at, if
    it `hunts`; what drifts is stopped at, and backed off from where it has come to lie beside the mouth.
    """
    length = crowd.length[me]
    hx, hy, hz = crowd.hx[me], crowd.hy[me], crowd.hz[me]
    tip = nose * length
    x, y, z = dx - tip * hx, dy - tip * hy, dz - tip * hz
    gap = sqrt(x * x + y * y + z * z) + 1e-9
    facing = (dx * hx + dy * hy + dz * hz) / (sqrt(dx * dx + dy * dy + dz * dz) + 1e-9)
    near = gap / (length * mouth)
    gape = min(max(_GAPE_FROM - near, 0.0), 1.0) if facing > _FACING else 0.0
    if hunts:
        return _hunt(crowd, me, speeds, dx, dy, dz, vx, vy, vz, near, facing, now, out)
    if gap > _LAST * length:
        gear, urgency, throttle = chase_target(
            crowd, me, speeds, dx, dy, dz, vx, vy, vz, 0.4 + 0.6 * hunger, out
        )
        return gear, urgency, throttle, gape
    out[0], out[1], out[2] = dx + 0.3 * vx, dy + 0.3 * vy, dz + 0.3 * vz
    if facing < _FACING:
        turn_finely(crowd, me, out)
        throttle = SLOWEST if gap < length else _BESIDE
        return 0, _PIVOT, throttle, 0.0
    drift = vx * hx + vy * hy + vz * hz
    turn_finely(crowd, me, out)
    gear, throttle = pace(speeds, length, drift + max(_AFTER * gap, _LEAST * length) * facing)
    return gear, 0.5, throttle, gape
