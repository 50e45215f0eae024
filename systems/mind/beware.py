"""Bewaring: the predators that a fish sees, large fishes that pass, and how afraid it is of them.

A fish sees others from its `sight` times the root of their length over its own, for contrast limits sight under water
as much as size does, and nothing beyond the water's visibility.

Who eats it is seen from afar, the farther the larger; behind rocks and ground nobody is (papers/000, 3.2).
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s, Int64s
from components.kernels import inlined, merged
from components.senses import SWALLOWED
from components.sightline import in_sight
from systems.mind.attention import MOST_AROUND, NO_DANGER, Attention
from systems.mind.crowd import place_of
from systems.mind.feel import fear_of
from systems.mind.nearest import NOBODY, keep, list_nearest, name
from systems.mind.perceive import BLIND, LATERAL_LINE, collision
from systems.mind.scene import Scene

WAKE: Final = 2.0
"""Lengths of a hunter within which it is felt, as the water moves that it pushes on, out of sight or not."""

LOOMS: Final = 3.0
"""Lengths of a large fish within which others mind where it swims."""

NEGLIGIBLE: Final = 0.1
"""Fear of one predator, or the submarine, too small to look twice."""


@inlined
def can_swallow(length: float, victim: float) -> bool:
    """Return whether a fish `length` [m] long swallows one of the length `victim`."""
    return victim <= SWALLOWED * length


@merged
def watch_hunters(
    scene: Scene, me: int, target: int, around: int, attention: Attention, piece: int,
    hunters: Int64s, distance: Float64s,
) -> tuple[int, int, float]:  # fmt: skip
    """Find the nearest that eat this fish, in view or felt, and the first hunter to collide with it.

    They are among the `around` listed. Write places and squared distances, nearest first, (NEIGHBOURS,) each; return
    how many they are, the place of who collides, -1 for none, and the time to it [s]. Who eats it, or is its
    `target`'s place, is no obstacle.
    """
    crowd, sparse, senses = scene.crowd, scene.hunters, scene.senses
    listed, eaters = attention.hunters_around[piece], attention.company[piece]
    big, square = attention.others[piece], attention.square[piece]
    kind, length = crowd.species[me], crowd.length[me]
    x, y, z = crowd.x[me], crowd.y[me], crowd.z[me]
    hx, hy, hz = crowd.hx[me], crowd.hy[me], crowd.hz[me]
    farthest = min(scene.habitat.visibility, sparse.cell)
    limit = farthest * farthest
    keen = senses.sight[kind] * senses.sight[kind] / length
    many = large = 0
    for at in range(around):
        k = listed[at]
        other = sparse.what[k]
        dx, dy, dz = sparse.x[k] - x, sparse.y[k] - y, sparse.z[k] - z
        s, size = dx * dx + dy * dy + dz * dz, sparse.size[k]
        felt = LATERAL_LINE * length + WAKE * size
        along = dx * hx + dy * hy + dz * hz
        seen = (along >= 0.0) | (along * along < BLIND * s) | (s < felt * felt)
        seen &= (s <= min(limit, keen * size)) & (other != me) & (many < MOST_AROUND)
        eats = senses.eats[sparse.kind[k], kind] != 0
        looms = (other != target) & (s < LOOMS * size * LOOMS * size) & (large < MOST_AROUND)
        eaters[many], square[many], big[large] = other, s, other
        many += seen & eats & can_swallow(size, length)
        large += seen & (not eats) & looms
    nearest = NOBODY
    for at in range(many):
        nearest = keep(nearest, name(square[at], at))
    found = list_nearest(nearest, many, eaters, square, hunters, distance)
    threat, soonest = -1, NO_DANGER
    for at in range(large):
        when = collision(crowd, me, big[at])
        if when < soonest:
            threat, soonest = big[at], when
    return found, threat, soonest


@merged
def fear_all(
    scene: Scene, me: int, found: int, hunters: Int64s, distance: Float64s
) -> tuple[float, float, int, int]:
    """Return the fear of all `found` predators, of the most dangerous, its place, -1 for none, and how many are seen.

    Those behind rock and ground drop out of the lists. Who is as afraid as it can be looks no farther.
    """
    crowd, wariness = scene.crowd, scene.senses.wariness[scene.crowd.species[me]]
    fear, worst, place, seen = 0.0, 0.0, -1, 0
    for k in range(found):
        if fear >= 1.0:
            break
        other = hunters[k]
        one = fear_of(wariness, crowd.length[other], sqrt(distance[k]))
        if one < NEGLIGIBLE:
            continue
        if not in_sight(
            scene.terrain, crowd.x[me], crowd.y[me], crowd.z[me],
            crowd.x[other], crowd.y[other], crowd.z[other],
        ):  # fmt: skip
            continue
        hunters[seen], distance[seen] = other, distance[k]
        seen += 1
        fear += one
        if one > worst:
            worst, place = one, other
    return min(fear, 1.0), worst, place, seen


@merged
def fear_known(
    scene: Scene, me: int, known: int, before: float, hunters: Int64s, distance: Float64s
) -> tuple[float, float, int, int]:
    """Return what `fear_all` does, of the one predator of the id `known` that it keeps an eye on.

    It is as afraid as it was `before`, or more if that one has come nearer.
    """
    crowd = scene.crowd
    other = place_of(scene.places, crowd, known)
    if other < 0:
        return 0.0, 0.0, -1, 0
    dx, dy, dz = (
        crowd.x[other] - crowd.x[me],
        crowd.y[other] - crowd.y[me],
        crowd.z[other] - crowd.z[me],
    )
    hunters[0], distance[0] = other, dx * dx + dy * dy + dz * dz
    worst = fear_of(
        scene.senses.wariness[crowd.species[me]], crowd.length[other], sqrt(distance[0])
    )
    return max(before, worst), worst, other, 1
