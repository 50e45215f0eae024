"""Seeking: the nearest prey of who hunts, the nearest mate of who courts, and food by its smell.

Fishes are sought in the crowd's columns in squares that widen until enough are seen (FINDINGS 5): near by where there
are many, to the end of sight where there are few. Smell comes from all sides and reaches farther than sight.
"""

from math import sqrt
from typing import Final

from components.arrays import Int32s, Int64s
from components.chance import SEX, uniform
from components.ground import Terrain
from components.kernels import inlined, merged, row
from components.sightline import in_sight
from components.trigonometry import arc
from systems.mind.attention import NEIGHBOURS, Attention
from systems.mind.beware import can_swallow
from systems.mind.crowd import Crowd
from systems.mind.gather import layers_between
from systems.mind.nearest import insert
from systems.mind.perceive import in_view
from systems.mind.scene import Scene
from systems.mind.sparse import LONGEST_RUN, Sparse, find_sparse_runs

SMELL: Final = 1.5
"""Smell over sight [m], whatever the water's clarity."""

SCHOOLED: Final = 0.5
"""b1: a fish in a school is harder to catch (FINDINGS 2)."""

TURN: Final = 0.2
"""b2: and one that lies aside."""

LOYALTY: Final = 0.7
"""The cost of what one is after already, over its own."""

_MOST_TESTED: Final = 1024
_WIDEST: Final = 64
_FIRST_LOOK: Final = 4
_FARTHEST_PREY: Final = 0.584
"""Root of `SWALLOWED`, and a little: nothing that is farther, over sight, is both small enough and seen."""
_PI: Final = 3.141592653589793
_COMPANY: Final = 4.0
_BESIDE: Final = 4


@row
def is_male(seed: int, identity: int) -> bool:
    """Return the sex of a fish, drawn by its id."""
    return uniform(seed, SEX, 0, identity) < 0.5


@row
def in_company(crowd: Crowd, other: int) -> bool:
    """Return whether one of the next in the crowd is of its kind and within four of its lengths."""
    limit = _COMPANY * crowd.length[other] * _COMPANY * crowd.length[other]
    begin, end = crowd.stretch[0], crowd.stretch[1]
    for k in range(max(other - _BESIDE, begin), min(other + _BESIDE + 1, end)):
        if k != other and crowd.species[k] == crowd.species[other]:
            dx, dy, dz = (
                crowd.x[k] - crowd.x[other],
                crowd.y[k] - crowd.y[other],
                crowd.z[k] - crowd.z[other],
            )
            if dx * dx + dy * dy + dz * dz < limit:
                return True
    return False


@inlined
def _counted(crowd: Crowd, other: int, square: float) -> float:
    """Return the squared distance [m^2] that prey counts as: (1 + b1 S)^2 as much in company."""
    if in_company(crowd, other):
        return square * (1.0 + SCHOOLED) * (1.0 + SCHOOLED)
    return square


@inlined
def _is_prey(scene: Scene, me: int, other: int, taken: Int64s) -> bool:
    crowd = scene.crowd
    if scene.senses.eats[crowd.species[me], crowd.species[other]] == 0:
        return False
    by = taken[crowd.row[other]]
    return can_swallow(crowd.length[me], crowd.length[other]) and (by < 0 or by == crowd.id[me])


@row
def suits(crowd: Crowd, seed: int, me: int, other: int) -> bool:
    """Return whether `other` may be the mate of `me`: of its kind, the other sex, ready and free, or its suitor."""
    if crowd.species[other] != crowd.species[me] or other == me:
        return False
    courting = crowd.courting[other]
    if courting >= 0 and courting != crowd.id[me]:
        return False
    if courting < 0 and crowd.ready[other] == 0:
        return False
    return is_male(seed, crowd.id[other]) != is_male(seed, crowd.id[me])


@row
def visible(terrain: Terrain, crowd: Crowd, me: int, other: int) -> bool:
    """Return whether neither rock nor ground stands between two fishes."""
    return in_sight(
        terrain, crowd.x[me], crowd.y[me], crowd.z[me],
        crowd.x[other], crowd.y[other], crowd.z[other],
    )  # fmt: skip


@merged
def _search(scene: Scene, me: int, taken: Int64s, attention: Attention, piece: int) -> int:
    """List the nearest prey in view; return how many.

    Prey in company counts as farther by 1 + b1, so that a straggler is not hidden behind its school.
    """
    crowd, plan, senses = scene.crowd, scene.plan, scene.senses
    sought, distance = attention.sought[piece], attention.sought_distance[piece]
    x, y, z, length = crowd.x[me], crowd.y[me], crowd.z[me], crowd.length[me]
    sight = senses.sight[crowd.species[me]]
    keen, visibility = sight * sight / length, scene.habitat.visibility
    cx, cy = crowd.column[me] // plan.columns, crowd.column[me] % plan.columns
    found, tested, wide = 0, 0, _FIRST_LOOK
    while True:
        found = tested = 0
        reach = min(plan.cell * wide, visibility)
        limit = reach * reach
        aside = min(wide, plan.far)
        for i in range(max(cx - aside, 0), min(cx + aside + 1, plan.columns)):
            for j in range(max(cy - wide, 0), min(cy + wide + 1, plan.columns)):
                begin = crowd.first[i * plan.columns + j]
                end = crowd.first[i * plan.columns + j + 1]
                if begin == end:
                    continue
                begin, end = layers_between(
                    crowd.layer, begin, end, crowd.layer[me] - wide, crowd.layer[me] + wide + 1
                )
                if tested > _MOST_TESTED:
                    end = begin
                tested += end - begin
                for k in range(begin, end):
                    dx, dy, dz = crowd.x[k] - x, crowd.y[k] - y, crowd.z[k] - z
                    square = dx * dx + dy * dy + dz * dz
                    if square > min(limit, keen * crowd.length[k]) or k == me:
                        continue
                    if found == NEIGHBOURS and square >= distance[NEIGHBOURS - 1]:
                        continue
                    if not _is_prey(scene, me, k, taken):
                        continue
                    if in_view(dx, dy, dz, crowd.hx[me], crowd.hy[me], crowd.hz[me]):
                        counted = _counted(crowd, k, square)
                        found = insert(k, counted, sought, distance, found)
        most = min(_FARTHEST_PREY * sight, visibility)
        if found >= NEIGHBOURS or tested > _MOST_TESTED or reach >= most or wide >= _WIDEST:
            return found
        wide *= 2


@row
def _turning(crowd: Crowd, me: int, other: int, far: float) -> float:
    """Return 1 + b2 E / pi: what it takes to turn to it, E being the angle."""
    dx, dy, dz = (
        crowd.x[other] - crowd.x[me],
        crowd.y[other] - crowd.y[me],
        crowd.z[other] - crowd.z[me],
    )
    along = (dx * crowd.hx[me] + dy * crowd.hy[me] + dz * crowd.hz[me]) / (far + 1e-9)
    along = min(max(along, -1.0), 1.0)
    return 1.0 + TURN * arc(along, sqrt(1.0 - along * along)) / _PI


@row
def seek_prey(
    scene: Scene, me: int, kept: int, taken: Int64s, attention: Attention, piece: int
) -> tuple[int, float]:
    """Return the place of the prey that costs least, -1 for none, and its distance [m].

    `kept` is the place of the prey it is after, -1 for none: it stays with it unless another costs much less.
    """
    crowd = scene.crowd
    found = _search(scene, me, taken, attention, piece)
    best, least, near = -1, 1e18, 1e18
    for k in range(found):
        other = attention.sought[piece, k]
        far = cost = sqrt(attention.sought_distance[piece, k])
        if in_company(crowd, other):
            far /= 1.0 + SCHOOLED
        cost *= _turning(crowd, me, other, far)
        if other == kept:
            cost *= LOYALTY
        if cost < least and visible(scene.terrain, crowd, me, other):
            best, least, near = other, cost, far
    return best, near


@row
def seek_mate(scene: Scene, me: int, attention: Attention, piece: int) -> tuple[int, float]:
    """Return the place of the nearest mate in sight, -1 for none, and its distance [m]."""
    crowd, sparse = scene.crowd, scene.willing
    runs, x, y, z = attention.coarse_runs[piece], crowd.x[me], crowd.y[me], crowd.z[me]
    sight = scene.senses.sight[crowd.species[me]]
    keen, reach = sight * sight / crowd.length[me], min(scene.habitat.visibility, sparse.cell)
    best, least = -1, reach * reach
    for run in range(find_sparse_runs(sparse, x, y, z, reach, runs)):
        begin, end = runs[2 * run], runs[2 * run + 1]
        for k in range(begin, end, (end - begin) // LONGEST_RUN + 1):
            dx, dy, dz = sparse.x[k] - x, sparse.y[k] - y, sparse.z[k] - z
            square, other = dx * dx + dy * dy + dz * dz, sparse.what[k]
            if (
                square < least
                and square <= keen * crowd.length[other]
                and in_view(dx, dy, dz, crowd.hx[me], crowd.hy[me], crowd.hz[me])
                and suits(crowd, scene.seed, me, other)
                and visible(scene.terrain, crowd, me, other)
            ):
                best, least = other, square
    return best, sqrt(least)


@row
def smell_food(
    sparse: Sparse, x: float, y: float, z: float, reach: float, runs: Int32s
) -> tuple[int, float]:
    """Return the row of the nearest food within `reach` [m] of (x, y, z), -1 for none, and its distance [m]."""
    best, at = reach * reach, -1
    for run in range(find_sparse_runs(sparse, x, y, z, reach, runs)):
        begin, end = runs[2 * run], runs[2 * run + 1]
        step = 1 if end - begin < LONGEST_RUN else (end - begin) // LONGEST_RUN + 1
        for k in range(begin, end, step):
            dx, dy, dz = sparse.x[k] - x, sparse.y[k] - y, sparse.z[k] - z
            square = dx * dx + dy * dy + dz * dz
            nearer = square < best
            best = square if nearer else best
            at = k if nearer else at
    return (sparse.what[at] if at >= 0 else -1), sqrt(best)
