"""Escaping: away from all predators, the more from the nearer, in zig-zag, to shelter or to the school (papers/004).

A fast start where one is upon it. Close by, neighbours scatter and every one dodges to a side of its own, so that
the predator must choose among crossing fishes (confusion: Pitcher and Parrish 1993); farther off they close ranks.
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s, Int64s
from components.chance import PANIC, uniform
from components.ground import Terrain
from components.kernels import inlined, row
from systems.mind.behave.school import attraction
from systems.mind.crowd import Crowd

ZIGZAG_TICKS: Final = 40
"""[ticks] from one dodge to the next."""

START: Final = 0.95
"""Urgency with a predator upon it: control may play a fast start."""

_FLEE: Final = 0.75
_UPON: Final = 1.0
_UPON_SECONDS: Final = 0.35
_DODGE_WITHIN: Final = 3.0
_DODGE: Final = 0.6
_JINK: Final = 1.4
_DOUBLE_BACK: Final = -1.0
_SHELTER: Final = 0.9
_JOIN: Final = 0.6
_SCATTER: Final = 0.7
_OUTRUN: Final = 1.2
_STRAIGHT: Final = 0.15
_HIDDEN: Final = 0.6
_BEHIND: Final = 0.4
_LIFTED: Final = 0.3
_FLAT: Final = 0.5


@row
def _nearest_home(
    terrain: Terrain, kind: int, x: float, y: float, z: float, reach: float, out: Float64s
) -> bool:
    """Write the offset to the nearest home point of the species within `reach` [m], (3,); say if there is one."""
    best = reach * reach
    for k in range(len(terrain.home)):
        dx, dy, dz = terrain.home[k, 0] - x, terrain.home[k, 1] - y, terrain.home[k, 2] - z
        square = dx * dx + dy * dy + dz * dz
        if terrain.home_species[k] == kind and square < best:
            best = square
            out[0], out[1], out[2] = dx, dy, dz
    return best < reach * reach


@row
def find_shelter(
    terrain: Terrain,
    kind: int,
    x: float,
    y: float,
    z: float,
    dx: float,
    dy: float,
    reach: float,
    out: Float64s,
) -> bool:
    """Write the offset [m] from (x, y, z) to shelter within `reach` [m], (3,); return whether there is any.

    That is the nearest home point of the species, else the far side of the nearest rock, as seen from the
    predator at the offset (dx, dy).
    """
    if _nearest_home(terrain, kind, x, y, z, reach, out):
        return True
    best, rock = reach * reach, -1
    for k in range(len(terrain.rock_centre)):
        u, v = terrain.rock_centre[k, 0] - x, terrain.rock_centre[k, 1] - y
        if u * u + v * v < best and u * dx + v * dy <= 0.5 * (dx * dx + dy * dy):
            best, rock = u * u + v * v, k
    if rock < 0:
        return False
    centre, radii = terrain.rock_centre[rock], terrain.rock_radii[rock]
    u, v = centre[0] - x - dx, centre[1] - y - dy
    room = (max(radii[0], radii[1]) + _BEHIND) / (sqrt(u * u + v * v) + 1e-9)
    out[0], out[1] = centre[0] - x + room * u, centre[1] - y + room * v
    out[2] = centre[2] + _LIFTED * radii[2] - z
    return True


@inlined
def _flee(
    crowd: Crowd, me: int, predators: Int64s, found: int, out: Float64s
) -> tuple[float, float, float]:
    """Write the sum of the ways out, weighted by nearness, (3,); return room, side and speed of the nearest.

    The room is in its own lengths, less the way that it comes in a moment; the side, left positive, is that of
    its path on which the fish is: 0 where it comes straight on; the speed [m/s] that with which it comes.
    """
    room, side, speed = 1e9, 0.0, 0.0
    out[0], out[1], out[2] = 0.0, 0.0, 0.0
    for k in range(found):
        other = predators[k]
        dx, dy, dz = (
            crowd.x[me] - crowd.x[other],
            crowd.y[me] - crowd.y[other],
            crowd.z[me] - crowd.z[other],
        )
        square = dx * dx + dy * dy + dz * dz + 1e-9
        far = sqrt(square)
        weight = crowd.length[other] / square
        out[0], out[1], out[2] = out[0] + weight * dx, out[1] + weight * dy, out[2] + weight * dz
        come = dx * crowd.hx[other] + dy * crowd.hy[other] + dz * crowd.hz[other]
        come = max(come / far, 0.0) * crowd.speed[other]
        rest = (far - _UPON_SECONDS * come) / crowd.length[other]
        if rest < room:
            room, speed = rest, come
            side = (crowd.hx[other] * dy - crowd.hy[other] * dx) / far
    return room, side, speed


@inlined
def _pull(share: float, x: float, y: float, z: float, out: Float64s) -> None:
    scale = share / (sqrt(x * x + y * y + z * z) + 1e-6)
    out[0], out[1], out[2] = out[0] + scale * x, out[1] + scale * y, out[2] + scale * z


@inlined
def _side(
    crowd: Crowd, me: int, x: float, y: float, charged: bool, aside: float, seed: int, now: int
) -> float:
    """Return the side, 1 left of (x, y) or -1, to which it dodges now: by chance, in turns of its own.

    Charged at, it turns on to where it turns already, else out of the other's path.
    """
    turned = x * crowd.hy[me] - y * crowd.hx[me]
    if charged and abs(turned) > _STRAIGHT:
        aside = turned
    elif not charged or abs(aside) < _STRAIGHT:
        slot = (now + (crowd.id[me] & 31)) // ZIGZAG_TICKS
        aside = uniform(seed, PANIC, slot, crowd.id[me]) - 0.5
    return 1.0 if aside >= 0.0 else -1.0


@row
def escape(
    crowd: Crowd,
    me: int,
    predators: Int64s,
    found: int,
    away: Float64s,
    scare: float,
    shelter: Float64s,
    sheltered: bool,
    shoal: Float64s,
    number: float,
    seed: int,
    now: int,
    out: Float64s,
) -> tuple[int, float, float]:
    """Write the wanted direction, (3,), of a fish that flees; return gear, urgency, throttle.

    `predators`: places in the crowd of the `found` seen; `away` [m], (3,): its offset from the submarine, of
    which it is afraid by `scare`, 0 to 1; `shelter` [m], (3,): the offset to a hiding-place, if `sheltered`;
    `shoal` [m], (6,), and `number`: its kind, as `see_shoal` says.
    """
    room, aside, speed = _flee(crowd, me, predators, found, out)
    if scare > 0.0:
        far = sqrt(away[0] * away[0] + away[1] * away[1] + away[2] * away[2]) + 1e-9
        _pull(scare / far, away[0], away[1], away[2], out)
        room = min(room, 2.0 * (1.0 - scare) + 0.5)
    size = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2])
    if size < 1e-6:
        out[0], out[1], out[2], size = crowd.hx[me], crowd.hy[me], crowd.hz[me], 1.0
    x, y, z = out[0] / size, out[1] / size, _FLAT * out[2] / size
    near = min(max(1.0 - (room - _UPON) / _DODGE_WITHIN, 0.0), 1.0)
    charged = room < _UPON and speed > _OUTRUN * crowd.speed[me]
    side = _side(crowd, me, x, y, charged, aside, seed, now) * (_JINK if charged else _DODGE * near)
    onward = _DOUBLE_BACK if charged else 1.0
    out[0], out[1], out[2] = onward * x - side * y, onward * y + side * x, z
    if sheltered:
        hidden = sqrt(shelter[0] * shelter[0] + shelter[1] * shelter[1] + shelter[2] * shelter[2])
        _pull(_SHELTER * (1.0 - near), shelter[0], shelter[1], shelter[2], out)
        if hidden < _HIDDEN and room > _UPON:
            out[0], out[1], out[2] = (
                shelter[0] + 0.2 * crowd.hx[me],
                shelter[1] + 0.2 * crowd.hy[me],
                shelter[2],
            )
            return 0, 0.5, 0.2
    elif number > 0.0:
        share = _JOIN * attraction(number) * (1.0 - near) - _SCATTER * max(near - 0.4, 0.0)
        _pull(share, shoal[0], shoal[1], shoal[2], out)
    if room < _UPON:
        return 2, START, 1.2
    return 2, _FLEE, 1.1
