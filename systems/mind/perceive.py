"""What a fish perceives near by: neighbours, fishes on a collision course, obstacles, the submarine.

Papers/000 section 3.2: a view cone of 300 degrees out to the visibility; papers/004: an antenna of one body length for
obstacles, lengthened with speed as papers/000 section 6.2 asks. At close range the lateral line feels what the eyes do
not see. What was perceived lives in scratch and is forgotten.
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s, Int8s
from components.ground import Terrain, clearance
from components.kernels import inlined
from systems.mind.attention import NO_DANGER, Attention
from systems.mind.crowd import Crowd

LATERAL_LINE: Final = 0.7
"""[BL] within which a fish feels others that it does not see."""

HORIZON: Final = 1.2
"""[s] ahead in which a collision with another fish is foreseen."""

BLIND: Final = 0.75
"""Squared cosine of 30 degrees: half the cone behind a fish in which it sees nothing."""

_ROOM: Final = 0.4
"""Room kept from a fish that crosses, over the sum of both lengths; enlarged as 6.2 asks."""

_SUBMARINE_ROOM: Final = 2.5
"""[m] kept from the submarine's middle."""


@inlined
def in_view(dx: float, dy: float, dz: float, hx: float, hy: float, hz: float) -> bool:
    """Return whether what lies at the offset (dx, dy, dz) is within the 300 degree cone around h."""
    along = dx * hx + dy * hy + dz * hz
    return bool(along >= 0.0 or along * along < BLIND * (dx * dx + dy * dy + dz * dz))


@inlined
def see_around(
    crowd: Crowd,
    me: int,
    reach: float,
    schooling: bool,
    wary: bool,
    number: int,
    attention: Attention,
    piece: int,
) -> tuple[int, int]:
    """List who is seen or felt within `reach` [m] of the `number` around; return how many of each there are.

    They are those of its kind, and, for who is `wary`, those who may cross its way: a schooler keeps clear of its own
    kind by separation alone. Vector units mark them, a byte each, and who is marked is listed without a branch: of a
    dozen branches each would be guessed wrong.
    """
    xs, ys, zs = attention.around_x[piece], attention.around_y[piece], attention.around_z[piece]
    around, kinds, square = attention.around[piece], attention.kinds[piece], attention.square[piece]
    company, others = attention.company[piece], attention.others[piece]
    seen = attention.seen[piece]
    x, y, z = crowd.x[me], crowd.y[me], crowd.z[me]
    hx, hy, hz = crowd.hx[me], crowd.hy[me], crowd.hz[me]
    limit = reach * reach
    felt = LATERAL_LINE * LATERAL_LINE * crowd.length[me] * crowd.length[me]
    for k in range(number):
        dx, dy, dz = xs[k] - x, ys[k] - y, zs[k] - z
        s = dx * dx + dy * dy + dz * dz
        along = dx * hx + dy * hy + dz * hz
        in_sight = (along >= 0.0) | (along * along < BLIND * s) | (s < felt)
        square[k] = s
        seen[k] = in_sight & (s <= limit) & (around[k] != me)
    kind, loner, same, crossing = crowd.species[me], not schooling, 0, 0
    for k in range(number):
        alike = kinds[k] == kind
        company[same], others[crossing] = k, k
        same += seen[k] & alike
        crossing += seen[k] & wary & (loner | (not alike))
    return same, crossing


@inlined
def collision(crowd: Crowd, me: int, other: int) -> float:
    """Return the time [s] in which two fishes come too near each other, or NO_DANGER."""
    dx, dy, dz = (
        crowd.x[other] - crowd.x[me],
        crowd.y[other] - crowd.y[me],
        crowd.z[other] - crowd.z[me],
    )
    s, t = crowd.speed[other], crowd.speed[me]
    vx = s * crowd.hx[other] - t * crowd.hx[me]
    vy = s * crowd.hy[other] - t * crowd.hy[me]
    vz = s * crowd.hz[other] - t * crowd.hz[me]
    closing = dx * vx + dy * vy + dz * vz
    if closing >= 0.0:
        return NO_DANGER
    when = min(-closing / (vx * vx + vy * vy + vz * vz), HORIZON)
    dx, dy, dz = dx + when * vx, dy + when * vy, dz + when * vz
    room = _ROOM * (crowd.length[me] + crowd.length[other])
    return when if dx * dx + dy * dy + dz * dz < room * room else NO_DANGER


@inlined
def first_to_collide(
    crowd: Crowd, me: int, target: int, eats: Int8s, many: int, attention: Attention, piece: int
) -> tuple[int, float]:
    """Return the place of the first to collide of the `many` that may, -1 for none, and the time to it [s].

    Nobody is of its `target`'s place; who `eats`, (S, S), its kind it fears instead.
    """
    around, kinds, others = attention.around[piece], attention.kinds[piece], attention.others[piece]
    threat, soonest, kind = -1, NO_DANGER, crowd.species[me]
    for at in range(many):
        k = int(around[others[at]])
        if k == target or eats[kinds[others[at]], kind] != 0:
            continue
        when = collision(crowd, me, k)
        if when < soonest:
            threat, soonest = k, when
    return threat, soonest


@inlined
def feel_ahead(terrain: Terrain, crowd: Crowd, me: int, within: float, out: Float64s) -> float:
    """Write the unit way out of the nearest obstacle at the antenna, (3,); return its distance [m].

    The antenna ends one body length ahead and 0.8 s of travel beyond; its middle is felt too. What
    is farther than `within` [m] from both may be missed.
    """
    reach = crowd.length[me] + 0.8 * crowd.speed[me]
    best = NO_DANGER
    for half in range(1, 3):
        ahead = 0.5 * half * reach
        d, nx, ny, nz = clearance(
            terrain,
            crowd.x[me] + ahead * crowd.hx[me],
            crowd.y[me] + ahead * crowd.hy[me],
            crowd.z[me] + ahead * crowd.hz[me],
            within,
        )
        if d < best:
            best = d
            out[0], out[1], out[2] = nx, ny, nz
    return best


@inlined
def meet_submarine(
    crowd: Crowd, me: int, position: Float64s, velocity: Float64s, number: int, away: Float64s
) -> float:
    """Write the offset [m] from the nearest submarine, (3,); return the time [s] until it is too near.

    A submarine is a large fish of radius 2.5 m; 0 where it is too near already, NO_DANGER for none.
    """
    best, soonest = NO_DANGER, NO_DANGER
    for k in range(number):
        dx, dy, dz = (
            crowd.x[me] - position[k, 0],
            crowd.y[me] - position[k, 1],
            crowd.z[me] - position[k, 2],
        )
        square = dx * dx + dy * dy + dz * dz
        if square < best:
            best = square
            away[0], away[1], away[2] = dx, dy, dz
            room = _SUBMARINE_ROOM + 0.5 * crowd.length[me]
            vx = crowd.speed[me] * crowd.hx[me] - velocity[k, 0]
            vy = crowd.speed[me] * crowd.hy[me] - velocity[k, 1]
            vz = crowd.speed[me] * crowd.hz[me] - velocity[k, 2]
            closing = -(dx * vx + dy * vy + dz * vz) / sqrt(square + 1e-9)
            gap = sqrt(square) - room
            soonest = 0.0 if gap <= 0.0 else NO_DANGER
            if closing > 0.0 and gap > 0.0 and gap < closing * HORIZON:
                soonest = gap / closing
    return soonest
