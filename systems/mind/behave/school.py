"""Schooling: keep a distance, swim as the neighbours swim, stay with the shoal, travel together.

Papers/004 after Reynolds 1987: separation, alignment, cohesion over the nearest neighbours. A school also has
somewhere to go: its cohort roams from place to place, each for a minute, so that it tours the
reef. Who falls behind shifts up a gear, who runs ahead shifts down.
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s, Int64s
from components.chance import PLACE_IN_SCHOOL, WANDER, uniform
from components.kernels import inlined, row
from systems.mind.grid import Crowd

ROAM_TICKS: Final = 3600
"""[ticks] for which a cohort keeps to one place before the next."""

_NEAREST: Final = 0.25
_FARTHEST: Final = 0.6
_LOW: Final = 0.15
_HIGH: Final = 0.7
_ROAM_FADES: Final = 8.0
_RISE_FADES: Final = 3.0
_SEPARATION: Final = 2.2
_ELBOW: Final = 1.4
_ALIGNMENT: Final = 1.0
_COHESION: Final = 0.45
_SHOAL: Final = 0.45
_SHOAL_HEADING: Final = 0.3
_ROAM: Final = 0.3
_BEHIND: Final = 0.4
_AHEAD: Final = -0.35
_SETTLED: Final = 0.15
_LENGTHEN: Final = 1.5
"""Half the length of a school over spacing and the fourth root of its number."""
_FLATTEN: Final = 0.8
"""How much less fishes shun each other above and below than beside."""


@row
def roam(seed: int, cohort: int, now: int, radius: float) -> tuple[float, float, float]:
    """Return the place to which a cohort travels in the tick `now`: x and y [m], and its height.

    Places follow each other a quarter turn on around the reef; chance says how far out, and how high
    between the lowest, 0, and the highest, 1, water that the species likes.
    """
    turn = (now + 997 * cohort) // ROAM_TICKS
    way = 1 if uniform(seed, WANDER, 0, -1 - cohort) < 0.5 else -1
    corner = (way * turn + cohort) & 3
    u = uniform(seed, WANDER, 2 * turn, -1 - cohort)
    v = uniform(seed, WANDER, 2 * turn + 1, -1 - cohort)
    out = radius * (_NEAREST + (_FARTHEST - _NEAREST) * u)
    aside = radius * _NEAREST * (2.0 * v - 1.0)
    if corner & 1:
        out, aside = aside, out
    up = _LOW + (_HIGH - _LOW) * uniform(seed, WANDER, -turn, -1 - cohort)
    return (out, aside, up) if corner < 2 else (-out, -aside, up)


@inlined
def _gear(previous: int, along: float) -> int:
    """Return the gear of a fish whose neighbours lie `along` [BL] ahead of it on average."""
    if along > _BEHIND or (previous == 2 and along > _SETTLED):
        return 2
    if along < _AHEAD or (previous == 0 and along < -_SETTLED):
        return 0
    return 1


@inlined
def _behind(crowd: Crowd, me: int, shoal: Float64s, number: float, spacing: float) -> float:
    """Return how far a fish lags behind its place in the school [BL], negative where it runs ahead.

    Each keeps to a place of its own between front and rear: a school is longer than wide (Pitcher
    and Partridge 1979), and gears alone would draw it up in one rank.
    """
    place = 2.0 * uniform(0, PLACE_IN_SCHOOL, 0, crowd.id[me]) - 1.0
    half = _LENGTHEN * spacing * sqrt(sqrt(number + 1.0))
    ahead = shoal[0] * crowd.hx[me] + shoal[1] * crowd.hy[me] + shoal[2] * crowd.hz[me]
    return (ahead + place * half) / crowd.length[me]


@inlined
def school(
    crowd: Crowd,
    me: int,
    near: Int64s,
    distance: Float64s,
    found: int,
    shoal: Float64s,
    number: float,
    spacing: float,
    place_x: float,
    place_y: float,
    place_z: float,
    previous_gear: int,
    out: Float64s,
) -> tuple[int, float]:
    """Write the wanted direction, not of unit length, (3,); return gear and urgency.

    `spacing` [m] is the distance kept; `shoal`, (6,), and `number` come from `see_shoal`.
    """
    ax, ay, az = crowd.hx[me], crowd.hy[me], crowd.hz[me]
    sx = sy = sz = cx = cy = cz = 0.0
    for k in range(found):
        other = near[k]
        d = sqrt(distance[k]) + 1e-9
        dx, dy, dz = (
            crowd.x[other] - crowd.x[me],
            crowd.y[other] - crowd.y[me],
            crowd.z[other] - crowd.z[me],
        )
        cx, cy, cz = cx + dx, cy + dy, cz + dz
        ax, ay, az = ax + crowd.hx[other], ay + crowd.hy[other], az + crowd.hz[other]
        push = max(1.0 - d / (_ELBOW * spacing), 0.0) / d
        sx, sy, sz = sx - push * dx, sy - push * dy, sz - push * dz
    sz *= _FLATTEN
    cz /= _FLATTEN
    share = 1.0 / (found + 1.0)
    along = (cx * crowd.hx[me] + cy * crowd.hy[me] + cz * crowd.hz[me]) * share / crowd.length[me]
    pull = share / spacing
    x = _ALIGNMENT * share * ax + _SEPARATION * sx + _COHESION * pull * cx
    y = _ALIGNMENT * share * ay + _SEPARATION * sy + _COHESION * pull * cy
    z = _ALIGNMENT * share * az + _SEPARATION * sz + _COHESION * pull * cz
    if number > 0.0:
        far = sqrt(shoal[0] * shoal[0] + shoal[1] * shoal[1] + shoal[2] * shoal[2]) + 1e-9
        pull = _SHOAL * min(far / (8.0 * spacing), 1.0) / far
        x += pull * shoal[0] + _SHOAL_HEADING * shoal[3]
        y += pull * shoal[1] + _SHOAL_HEADING * shoal[4]
        z += pull * shoal[2] + _SHOAL_HEADING * shoal[5]
        along = _behind(crowd, me, shoal, number, spacing) if found > 0 else 1.0
    dx, dy = place_x - crowd.x[me], place_y - crowd.y[me]
    far = sqrt(dx * dx + dy * dy) + 1e-9
    pull = _ROAM * min(far / _ROAM_FADES, 1.0) / far
    rise = _ROAM * min(max((place_z - crowd.z[me]) / _RISE_FADES, -1.0), 1.0)
    out[0], out[1], out[2] = x + pull * dx, y + pull * dy, z + rise
    crowding = sqrt(sx * sx + sy * sy + sz * sz)
    return _gear(previous_gear, along), min(0.15 + 0.5 * crowding, 0.8)
