"""What a fish perceives: neighbours, shoals, fishes on a collision course, obstacles, the submarine.

Papers/000 section 3.2: a view cone of 300 degrees out to the visibility; papers/004: an antenna of one body length for
obstacles, lengthened with speed as papers/000 section 6.2 asks. What was perceived lives in scratch and is forgotten.
"""

from math import sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int32s, Int64s
from components.ground import Terrain, clearance
from components.kernels import inlined
from systems.mind.grid import FIXED, PIECES, Crowd, Plan

NEIGHBOURS: Final = 8
"""The nearest fishes of its own species that a fish attends to (FINDINGS 5)."""

HORIZON: Final = 1.2
"""[s] ahead in which a collision with another fish is foreseen."""

NO_DANGER: Final = 1e9

_BLIND: Final = 0.75
"""Squared cosine of 30 degrees: half the cone behind a fish in which it sees nothing."""

_ROOM: Final = 0.4
"""Room kept from a fish that crosses, over the sum of both lengths; enlarged as 6.2 asks."""

_SUBMARINE_ROOM: Final = 2.5
"""[m] kept from the submarine's middle."""


class Attention(NamedTuple):
    """Scratch of the minds that a piece of the loop runs, one after another: (PIECES, ...) each."""

    runs: Int64s
    "begin and end of the runs of fishes around the cell, (PIECES, 18)"
    near: Int64s
    "places in the crowd of the nearest of one's kind, (PIECES, NEIGHBOURS)"
    distance: Float64s
    "squared distances [m^2] to them, (PIECES, NEIGHBOURS)"
    shoal: Float64s
    "offset [m] and mean heading of one's kind farther off, (PIECES, 6)"
    normal: Float64s
    "unit way out of the nearest obstacle ahead, (PIECES, 3)"
    away: Float64s
    "offset [m] from the submarine, (PIECES, 3)"
    out: Float64s
    "wanted direction, (PIECES, 3)"


def make_attention() -> Attention:
    """Return scratch for all pieces; rows are padded so that threads share no cache line."""
    return Attention(
        runs=np.zeros((PIECES, 24), np.int64),
        near=np.zeros((PIECES, NEIGHBOURS), np.int64),
        distance=np.zeros((PIECES, NEIGHBOURS)),
        shoal=np.zeros((PIECES, 8)),
        normal=np.zeros((PIECES, 8)),
        away=np.zeros((PIECES, 8)),
        out=np.zeros((PIECES, 8)),
    )


@inlined
def in_view(dx: float, dy: float, dz: float, hx: float, hy: float, hz: float) -> bool:
    """Return whether what lies at the offset (dx, dy, dz) is within the 300 degree cone around h."""
    along = dx * hx + dy * hy + dz * hz
    return bool(along >= 0.0 or along * along < _BLIND * (dx * dx + dy * dy + dz * dz))


@inlined
def _first_not_above(layer: Int32s, begin: int, end: int, value: int) -> int:
    """Return the first place in begin..end whose layer is at least `value`."""
    while begin < end:
        middle = (begin + end) // 2
        if layer[middle] < value:
            begin = middle + 1
        else:
            end = middle
    return begin


@inlined
def find_runs(plan: Plan, crowd: Crowd, column: int, layer: int, runs: Int64s) -> int:
    """Write begin and end of each run of fishes in the 27 cells around a cell; return how many."""
    cx, cy = column // plan.columns, column % plan.columns
    found = 0
    for x in range(max(cx - 1, 0), min(cx + 2, plan.columns)):
        for y in range(max(cy - 1, 0), min(cy + 2, plan.columns)):
            begin = crowd.first[x * plan.columns + y]
            end = crowd.first[x * plan.columns + y + 1]
            begin = _first_not_above(crowd.layer, begin, end, layer - 1)
            end = _first_not_above(crowd.layer, begin, end, layer + 2)
            if end > begin:
                runs[2 * found], runs[2 * found + 1] = begin, end
                found += 1
    return found


@inlined
def _keep_nearest(
    crowd: Crowd, other: int, square: float, near: Int64s, distance: Float64s, found: int
) -> int:
    """Insert `other` among the nearest, ordered by distance, then id; return how many are kept."""
    at = found
    while at > 0 and (
        square < distance[at - 1]
        or (square == distance[at - 1] and crowd.id[other] < crowd.id[near[at - 1]])
    ):
        at -= 1
    if at == NEIGHBOURS:
        return found
    kept = min(found + 1, NEIGHBOURS)
    for k in range(kept - 1, at, -1):
        near[k], distance[k] = near[k - 1], distance[k - 1]
    near[at], distance[at] = other, square
    return kept


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
def watch(
    crowd: Crowd,
    me: int,
    schooling: bool,
    reach: float,
    number_of_runs: int,
    attention: Attention,
    piece: int,
) -> tuple[int, int, float]:
    """Find the nearest of one's species within `reach` [m], and who is about to collide.

    Write their places in the crowd and squared distances, nearest first; return how many they are,
    the place of the first to collide, -1 for none, and the time to it [s]. A schooler keeps clear of
    its own kind by separation alone.
    """
    runs, near, distance = attention.runs[piece], attention.near[piece], attention.distance[piece]
    found, threat, soonest = 0, -1, NO_DANGER
    x, y, z, kind = crowd.x[me], crowd.y[me], crowd.z[me], crowd.species[me]
    hx, hy, hz = crowd.hx[me], crowd.hy[me], crowd.hz[me]
    limit = reach * reach
    for run in range(number_of_runs):
        for k in range(runs[2 * run], runs[2 * run + 1]):
            dx, dy, dz = crowd.x[k] - x, crowd.y[k] - y, crowd.z[k] - z
            square = dx * dx + dy * dy + dz * dz
            if square > limit or k == me:
                continue
            same = crowd.species[k] == kind
            if same and schooling and found == NEIGHBOURS and square > distance[NEIGHBOURS - 1]:
                continue
            if not in_view(dx, dy, dz, hx, hy, hz):
                continue
            if same:
                found = _keep_nearest(crowd, k, square, near, distance, found)
                if schooling:
                    continue
            when = collision(crowd, me, k)
            if when < soonest or (
                threat >= 0 and when == soonest and crowd.id[k] < crowd.id[threat]
            ):
                threat, soonest = k, when
    return found, threat, soonest


@inlined
def see_shoal(plan: Plan, crowd: Crowd, me: int, sight: float, shoal: Float64s) -> float:
    """Write offset [m] and mean heading of one's own kind over nine squares, (6,); return how many.

    None where their middle is out of sight. The fish itself is left out.
    """
    side, kind = plan.squares, crowd.species[me]
    cx, cy = (
        crowd.column[me] // plan.columns // plan.block,
        crowd.column[me] % plan.columns // plan.block,
    )
    number = np.int64(-1)
    x, y, z = (
        -np.int64(crowd.x[me] * FIXED),
        -np.int64(crowd.y[me] * FIXED),
        -np.int64(crowd.z[me] * FIXED),
    )
    u, v, w = (
        -np.int64(crowd.hx[me] * FIXED),
        -np.int64(crowd.hy[me] * FIXED),
        -np.int64(crowd.hz[me] * FIXED),
    )
    for i in range(max(cx - 1, 0), min(cx + 2, side)):
        for j in range(max(cy - 1, 0), min(cy + 2, side)):
            at = i * side + j
            number += crowd.shoal[kind, at, 0]
            x += crowd.shoal[kind, at, 1]
            y += crowd.shoal[kind, at, 2]
            z += crowd.shoal[kind, at, 3]
            u += crowd.shoal[kind, at, 4]
            v += crowd.shoal[kind, at, 5]
            w += crowd.shoal[kind, at, 6]
    if number <= 0:
        return 0.0
    whole = number * FIXED
    dx, dy, dz = x / whole - crowd.x[me], y / whole - crowd.y[me], z / whole - crowd.z[me]
    if dx * dx + dy * dy + dz * dz > sight * sight:
        return 0.0
    shoal[0], shoal[1], shoal[2] = dx, dy, dz
    shoal[3], shoal[4], shoal[5] = u / whole, v / whole, w / whole
    return float(number)


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
