"""Schooling: keep a distance, swim as the neighbours swim, stay with the shoal, travel together.

Papers/004 after Reynolds 1987: separation, alignment, cohesion over the nearest neighbours. A school also has
somewhere to go: its cohort roams from place to place, each for a minute, so that it tours the
reef. Who falls behind shifts up a gear, who runs ahead shifts down.

A school splits round a predator that comes through (the fountain of Pitcher and Parrish 1993): each fish swims to its
own side of the predator's path, then back along it, and joins the others behind its tail. Round an obstacle it splits
in the same way, by what each fish's antenna feels. Afraid, fishes close ranks.
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s, Int64s
from components.chance import PLACE_IN_SCHOOL, WANDER, uniform
from components.kernels import inlined, row
from systems.mind.crowd import Crowd

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
_ENOUGH: Final = 100.0
_ROAM: Final = 0.3
_BEHIND: Final = 0.4
_AHEAD: Final = -0.35
_SETTLED: Final = 0.15
_LENGTHEN: Final = 1.5
"""Half the length of a school over spacing and the fourth root of its number."""
_FLATTEN: Final = 0.8
"""How much less fishes shun each other above and below than beside."""
_CLOSE_RANKS: Final = 0.3
_SPLIT: Final = 4.0
_BACK: Final = 0.9
_FLAT: Final = 0.6
_DEAF: Final = 1.0
"""How much less a fish heeds its neighbours with a predator upon it, so that the school parts."""
_BERTH: Final = 1.5
_BERTH_ROOM: Final = 0.8
_STANDING: Final = 0.1
_PART: Final = 1.2


@row
def roam(seed: int, cohort: int, now: int, radius: float) -> tuple[float, float, float]:
    """Return the place to which a cohort travels in the tick `now`: x and y [m] from the middle, and its height.

    Places follow each other a quarter turn on around a reef of `radius` [m]; chance says how far out, and how high
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
def attraction(number: float) -> float:
    """Return how strongly a shoal of `number`, at least 1, draws its members, 0 to 1.

    A hundred are enough: where every fish more drew too, all schools of a sea would fall into one.
    """
    return min(_ENOUGH / number, 1.0)


@inlined
def _behind(crowd: Crowd, me: int, shoal: Float64s, number: float, spacing: float) -> float:
    """Return how far a fish lags behind its place in the school [BL], negative where it runs ahead.

    Each keeps to a place of its own between front and rear: a school is longer than wide (Pitcher
    and Partridge 1979), and gears alone would draw it up in one rank.
    """
    place = 2.0 * uniform(0, PLACE_IN_SCHOOL, 0, crowd.id[me]) - 1.0
    half = _LENGTHEN * spacing * sqrt(sqrt(number + 1.0))
    ahead = shoal[0] * crowd.hx[me] + shoal[1] * crowd.hy[me] + shoal[2] * crowd.hz[me]
    lag: float = (ahead + place * half) / crowd.length[me]
    return lag


@row
def heed(
    dx: float,
    dy: float,
    dz: float,
    vx: float,
    vy: float,
    vz: float,
    length: float,
    danger: Float64s,
) -> None:
    """Write `danger`, (7,): the offset [m] of a predator `length` [m] long, its velocity [m/s], its berth [m]."""
    danger[0], danger[1], danger[2] = dx, dy, dz
    danger[3], danger[4], danger[5] = vx, vy, vz
    danger[6] = _BERTH * length + _BERTH_ROOM + 0.5 * sqrt(vx * vx + vy * vy + vz * vz)


@row
def split(crowd: Crowd, me: int, danger: Float64s, out: Float64s) -> float:
    """Lean the wanted direction, (3,), out of a predator's way; return how near it is, 0 to 1.

    Before the predator to the fish's own side of its path, beside it and behind back along it.
    """
    x, y, z = -danger[0], -danger[1], -danger[2]
    far = sqrt(x * x + y * y + z * z) + 1e-9
    near: float = 1.0 - far / (danger[6] + 1e-9)
    if near <= 0.0:
        return 0.0
    size = sqrt(danger[3] * danger[3] + danger[4] * danger[4] + danger[5] * danger[5]) + 1e-9
    u, v, w = danger[3] / size, danger[4] / size, danger[5] / size
    along = x * u + y * v + z * w
    if size < _STANDING:
        u = v = w = along = 0.0
    a, b, c = x - along * u, y - along * v, _FLAT * (z - along * w)
    aside = sqrt(a * a + b * b + c * c)
    if aside < 0.05 * far:
        side = 1.0 if crowd.id[me] & 1 else -1.0
        a, b, aside = a - side * 0.1 * far * v - 1e-6, b + side * 0.1 * far * u, 0.1 * far + 1e-6
    ahead = max(along / far, 0.0)
    push = _SPLIT * near * (1.0 if along > 0.0 else max(1.0 + along / far, 0.0)) / aside
    back = _SPLIT * _BACK * near * (1.0 - ahead)
    heard = 1.0 - _DEAF * near
    out[0] = heard * out[0] + push * a - back * u
    out[1] = heard * out[1] + push * b - back * v
    out[2] = heard * out[2] + push * c - back * w
    return near


@row
def part(hx: float, hy: float, hz: float, normal: Float64s, near: float, out: Float64s) -> None:
    """Lean the wanted direction, (3,), along an obstacle with the unit way out `normal`, `near` 0 to 1."""
    into = min(out[0] * normal[0] + out[1] * normal[1] + out[2] * normal[2], 0.0)
    push = near * (_PART - into)
    out[0] += push * normal[0] + near * hx
    out[1] += push * normal[1] + near * hy
    out[2] += push * normal[2] + near * hz


@inlined
def keep_company(
    crowd: Crowd, me: int, near: Int64s, distance: Float64s, found: int, spacing: float
) -> tuple[float, float, float, float, float]:
    """Return the rule of Reynolds: the direction that separation, alignment and cohesion want, not of unit length.

    Return also how far ahead [BL] the neighbours are on average, and how strongly they push. `near` are places in the
    crowd, `distance` squares [m^2], (NEIGHBOURS,) each; `spacing` [m] is kept.
    """
    ax, ay, az = crowd.hx[me], crowd.hy[me], crowd.hz[me]
    sx = sy = sz = cx = cy = cz = 0.0
    elbow = 1.0 / (_ELBOW * spacing)
    for k in range(found):
        other = near[k]
        dx, dy, dz = (
            crowd.x[other] - crowd.x[me],
            crowd.y[other] - crowd.y[me],
            crowd.z[other] - crowd.z[me],
        )
        cx, cy, cz = cx + dx, cy + dy, cz + dz
        ax, ay, az = ax + crowd.hx[other], ay + crowd.hy[other], az + crowd.hz[other]
        push = max(1.0 / (sqrt(distance[k]) + 1e-9) - elbow, 0.0)
        sx, sy, sz = sx - push * dx, sy - push * dy, sz - push * dz
    sz *= _FLATTEN
    cz /= _FLATTEN
    share = 1.0 / (found + 1.0)
    along = (cx * crowd.hx[me] + cy * crowd.hy[me] + cz * crowd.hz[me]) * share / crowd.length[me]
    pull = share / spacing
    x = _ALIGNMENT * share * ax + _SEPARATION * sx + _COHESION * pull * cx
    y = _ALIGNMENT * share * ay + _SEPARATION * sy + _COHESION * pull * cy
    z = _ALIGNMENT * share * az + _SEPARATION * sz + _COHESION * pull * cz
    return x, y, z, along, sqrt(sx * sx + sy * sy + sz * sz)


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
    alarm: float,
    danger: Float64s,
    normal: Float64s,
    blocked: float,
    out: Float64s,
) -> tuple[int, float, float]:
    """Write the wanted direction, not of unit length, (3,); return gear, urgency, throttle.

    `spacing` [m] is the distance kept, less where `alarm`, 0 to 1, is felt; `shoal`, (6,), and `number` come
    from `see_shoal`; `danger`, (7,), from `heed`, its last 0 for none; `blocked`, 0 to 1: how near the obstacle
    is whose unit way out is `normal`, (3,).
    """
    spacing *= 1.0 - _CLOSE_RANKS * alarm
    x, y, z, along, crowding = keep_company(crowd, me, near, distance, found, spacing)
    if number > 0.0:
        far = sqrt(shoal[0] * shoal[0] + shoal[1] * shoal[1] + shoal[2] * shoal[2]) + 1e-9
        drawn = attraction(number)
        pull, turn = _SHOAL * drawn * min(far / (8.0 * spacing), 1.0) / far, _SHOAL_HEADING * drawn
        x += pull * shoal[0] + turn * shoal[3]
        y += pull * shoal[1] + turn * shoal[4]
        z += pull * shoal[2] + turn * shoal[5]
        along = _behind(crowd, me, shoal, number, spacing)
        if found == 0:
            along = 1.0 if along > 0.0 else -1.0
    dx, dy = place_x - crowd.x[me], place_y - crowd.y[me]
    far = sqrt(dx * dx + dy * dy) + 1e-9
    pull = _ROAM * min(far / _ROAM_FADES, 1.0) / far
    rise = _ROAM * min(max((place_z - crowd.z[me]) / _RISE_FADES, -1.0), 1.0)
    out[0], out[1], out[2] = x + pull * dx, y + pull * dy, z + rise
    gear = _gear(previous_gear, along)
    urgency: float = min(0.15 + 0.5 * crowding + 0.2 * alarm, 0.8)
    if blocked > 0.0:
        part(crowd.hx[me], crowd.hy[me], crowd.hz[me], normal, blocked, out)
    if danger[6] > 0.0:
        close = split(crowd, me, danger, out)
        if close > 0.0:
            gear, urgency = 2, max(urgency, 0.45 + 0.4 * close)
    return gear, urgency, 1.0
