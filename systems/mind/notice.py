"""Noticing: company and dangers, all that may decide before wants are felt (papers/004; papers/000, 3.2).

Each function takes one step for the minds of the rows `begin` to `end` of a batch.
"""

from typing import Final

from components.kernels import merged
from components.mind import Role
from systems.mind.attention import NO_DANGER, Attention, Thoughts
from systems.mind.beware import NEGLIGIBLE, fear_all, fear_known, watch_hunters
from systems.mind.feel import fear_of_submarine, speed_of
from systems.mind.gather import gather, reach_of
from systems.mind.nearest import nearest_of_kind
from systems.mind.perceive import (
    feel_ahead,
    first_to_collide,
    meet_submarine,
    see_around,
)
from systems.mind.scene import Minds, Scene
from systems.mind.shoal import NO_SHOAL, see_shoal, square_of, sum_around
from systems.mind.sparse import list_sparse

_PREY: Final = int(Role.PREY)
_NEAR_BY: Final = 1.0
"""[m] from each other within which minds share what they list of hunters."""


@merged
def notice_company(
    scene: Scene, thoughts: Thoughts, begin: int, end: int, attention: Attention, piece: int
) -> None:
    """List the nearest of its kind and who collides first; minds of a cell share the look around it."""
    crowd, senses = scene.crowd, scene.senses
    column = layer = -1
    around = 0
    for k in range(begin, end):
        me = thoughts.me[k]
        kind = crowd.species[me]
        if crowd.column[me] != column or crowd.layer[me] != layer:
            column, layer = crowd.column[me], crowd.layer[me]
            around = gather(scene.plan, crowd, column, layer, attention, piece)
        reach = reach_of(scene.plan, senses.sight[kind], crowd.length[me])
        schooling = senses.schooling[kind] != 0
        same, crossing = see_around(crowd, me, reach, schooling, True, around, attention, piece)
        thoughts.found[k] = 0
        if schooling or thoughts.looks[k] != 0:
            thoughts.found[k] = nearest_of_kind(
                same, attention, piece, thoughts.near[k], thoughts.distance[k]
            )
        thoughts.other[k], thoughts.when[k] = first_to_collide(
            crowd, me, thoughts.target[k], senses.eats, crossing, attention, piece
        )


@merged
def notice_shoals(scene: Scene, thoughts: Thoughts, begin: int, end: int) -> None:
    """See the shoals that schoolers belong to; those of a kind in a square, one after the other, share the sums."""
    plan, crowd, senses = scene.plan, scene.crowd, scene.senses
    column = square = here = last = -1
    sums = NO_SHOAL
    for k in range(begin, end):
        me = thoughts.me[k]
        kind = crowd.species[me]
        thoughts.number[k] = 0.0
        if senses.schooling[kind] == 0:
            continue
        if crowd.column[me] != column:
            column = crowd.column[me]
            here = square_of(plan, column)
        if kind != last or here != square:
            last, square = kind, here
            sums = sum_around(plan, crowd, kind, square)
        far = min(2.0 * senses.sight[kind], scene.habitat.visibility)
        thoughts.number[k] = see_shoal(crowd, me, sums, far, thoughts.shoal[k])


@merged
def notice_hunters(
    scene: Scene, minds: Minds, thoughts: Thoughts, begin: int, end: int, attention: Attention,
    piece: int,
) -> None:  # fmt: skip
    """Look for hunters, who looks round, and fear them; the others keep an eye on whom they feared most.

    Minds near each other share a list of the hunters around.
    """
    crowd, shared, around = scene.crowd, -1.0, 0
    near_by = min(_NEAR_BY, 0.49 * scene.hunters.cell)
    far = min(scene.habitat.visibility, scene.hunters.cell) + near_by
    x = y = z = 0.0
    for k in range(begin, end):
        me = thoughts.me[k]
        thoughts.seen[k] = 0
        if thoughts.looks[k] == 0:
            continue
        dx, dy, dz = crowd.x[me] - x, crowd.y[me] - y, crowd.z[me] - z
        if dx * dx + dy * dy + dz * dz > shared:
            x, y, z = crowd.x[me], crowd.y[me], crowd.z[me]
            around = list_sparse(
                scene.hunters, x, y, z, far, attention.coarse_runs[piece],
                attention.hunters_around[piece],
            )  # fmt: skip
            # A little less, so that rounding leaves nobody out.
            shared = 0.99 * near_by * near_by
        if around > 0:
            thoughts.seen[k], big, soon = watch_hunters(
                scene, me, thoughts.target[k], around, attention, piece, thoughts.hunters[k],
                thoughts.hunter_distance[k],
            )  # fmt: skip
            if soon < thoughts.when[k]:
                thoughts.other[k], thoughts.when[k] = big, soon
    for k in range(begin, end):
        me, i = thoughts.me[k], crowd.row[thoughts.me[k]]
        hunters, distance = thoughts.hunters[k], thoughts.hunter_distance[k]
        fear, worst, predator, seen = 0.0, 0.0, -1, 0
        if thoughts.seen[k] > 0:
            fear, worst, predator, seen = fear_all(scene, me, thoughts.seen[k], hunters, distance)
        elif thoughts.looks[k] == 0 and minds.wary_of[i] >= 0:
            fear, worst, predator, seen = fear_known(
                scene, me, minds.wary_of[i], minds.fear[i], hunters, distance
            )
        thoughts.fear[k], thoughts.worst[k] = fear, worst
        thoughts.predator[k], thoughts.seen[k] = predator, seen


@merged
def notice_obstacles(scene: Scene, thoughts: Thoughts, begin: int, end: int) -> None:
    """Feel ahead for what stands still."""
    crowd = scene.crowd
    for k in range(begin, end):
        me = thoughts.me[k]
        alarm = 0.8 * crowd.length[me] + 0.2
        near = feel_ahead(scene.terrain, crowd, me, 1.5 * alarm, thoughts.normal[k])
        thoughts.obstacle[k] = near / alarm


@merged
def notice_submarine(scene: Scene, thoughts: Thoughts, begin: int, end: int) -> None:
    """See whether the submarine comes too near, which prey alone fears, and only within sight."""
    crowd, senses, velocity = scene.crowd, scene.senses, scene.submarine_velocity
    if scene.submarines == 0:
        for k in range(begin, end):
            thoughts.meets[k], thoughts.scare[k] = NO_DANGER, 0.0
        return
    speed = speed_of(velocity[0, 0], velocity[0, 1], velocity[0, 2])
    for k in range(begin, end):
        me, away, scare = thoughts.me[k], thoughts.away[k], 0.0
        kind = crowd.species[me]
        thoughts.meets[k] = meet_submarine(
            crowd, me, scene.submarine, velocity, scene.submarines, away
        )
        if senses.role[kind] == _PREY:
            far = speed_of(away[0], away[1], away[2])
            scare = fear_of_submarine(senses.wariness[kind], speed, far)
            if scare < NEGLIGIBLE or far > scene.habitat.visibility:
                scare = 0.0
        thoughts.scare[k] = scare
        if thoughts.looks[k] == 0 and thoughts.predator[k] >= 0:
            # The fear that it has kept since it looked round is of both.
            thoughts.fear[k] = max(thoughts.fear[k], scare)
        else:
            thoughts.fear[k] = min(thoughts.fear[k] + scare, 1.0)
