"""Wanting: hunger and libido with what feeds them in sight, unease, and curiosity (papers/004; FINDINGS 2)."""

from math import sqrt
from typing import Final

from components.arrays import Float64s, Int64s
from components.food import in_stomach
from components.habitat import Habitat
from components.kernels import merged, row
from components.mind import FOOD, Role
from systems.mind.act import liked_depth
from systems.mind.attention import NO_DANGER, Attention, Thoughts
from systems.mind.behave.wander import is_curious, nearest_home
from systems.mind.feel import (
    APPETISING,
    FOOD_FAR,
    FOOD_NEAR,
    MATE_FAR,
    MATE_NEAR,
    appetite,
    desire,
    hunger_of,
    libido_of,
    speed_of,
    stimulus,
    unease,
)
from systems.mind.intend import (
    AFRAID,
    AVOID_OBSTACLE,
    EAT,
    MATE,
    RELENT,
    WANTING,
    WATCHFUL,
)
from systems.mind.scene import Minds, Scene
from systems.mind.seek import LOYALTY, SMELL, seek_mate, seek_prey, smell_food, suits

SEARCH_EVERY: Final = 8
"""[thoughts] on average between looks round for a mate where none is near."""

_PREY: Final = int(Role.PREY)
_PREDATOR: Final = int(Role.PREDATOR)
_CURIOUS_PREDATOR: Final = 0.3
_NOWHERE: Final = 0.5
_LOSES_SIGHT: Final = 2.0


@merged
def _seek_food(
    scene: Scene, me: int, minds: Minds, plain: float, target: int, attention: Attention, piece: int
) -> tuple[int, float]:
    """Return the focus that food or prey deserves, -1 for none, and its distance [m]. Prey goes before food."""
    crowd, senses, i = scene.crowd, scene.senses, scene.crowd.row[me]
    kind, x, y, z = crowd.species[me], crowd.x[me], crowd.y[me], crowd.z[me]
    eager = minds.intention[i] == EAT or plain + APPETISING > WANTING
    if not eager:
        return -1, NO_DANGER
    if senses.hunts[kind] != 0:
        prey, far = seek_prey(scene, me, target, minds.swallowed_by, attention, piece)
        if prey >= 0:
            return crowd.id[prey], far
    if senses.grazes[kind] != 0 and scene.food.number > 0:
        reach = min(SMELL * senses.sight[kind], scene.food.cell)
        if plain <= WANTING * RELENT:
            # What does not tempt would not be eaten.
            reach = min(reach, crowd.length[me] / FOOD_FAR)
        food, far = smell_food(scene.food, x, y, z, reach, attention.coarse_runs[piece])
        kept = FOOD - minds.focus[i]
        if food >= 0 and 0 <= kept < len(scene.there) and scene.there[kept] and kept != food:
            place = scene.food_position
            old = speed_of(place[kept, 0] - x, place[kept, 1] - y, place[kept, 2] - z)
            if LOYALTY * old < far:
                food, far = kept, old
        if food >= 0:
            return FOOD - food, far
    return -1, NO_DANGER


@merged
def _keep_meal(scene: Scene, me: int, minds: Minds, target: int) -> tuple[int, float]:
    """Return the meal in focus, which is the prey at the place `target` or food, and its distance [m]; -1 if gone."""
    crowd, i = scene.crowd, scene.crowd.row[me]
    x, y, z, kept = crowd.x[me], crowd.y[me], crowd.z[me], FOOD - minds.focus[i]
    if target >= 0:
        by = minds.swallowed_by[crowd.row[target]]
        if by < 0 or by == crowd.id[me]:
            far = speed_of(crowd.x[target] - x, crowd.y[target] - y, crowd.z[target] - z)
            return minds.focus[i], far
    elif 0 <= kept < len(scene.there) and scene.there[kept]:
        place = scene.food_position
        return minds.focus[i], speed_of(place[kept, 0] - x, place[kept, 1] - y, place[kept, 2] - z)
    return -1, NO_DANGER


@merged
def _find_meal(
    scene: Scene, me: int, minds: Minds, plain: float, target: int, looks: bool,
    attention: Attention, piece: int,
) -> tuple[int, float]:  # fmt: skip
    """Return the focus that a meal deserves, -1 for none, and its distance [m].

    Who does not look round keeps to what it eats already, and seeks another where that is gone.
    """
    meal, far, keeps = -1, NO_DANGER, not looks and minds.focus[scene.crowd.row[me]] != -1
    if keeps:
        meal, far = _keep_meal(scene, me, minds, target)
    if looks or (keeps and meal == -1):
        meal, far = _seek_food(scene, me, minds, plain, target, attention, piece)
    return meal, far


@merged
def _seek_mate(
    scene: Scene, me: int, minds: Minds, target: int, found: int, near: Int64s, distance: Float64s,
    attention: Attention, piece: int,
) -> tuple[int, float]:  # fmt: skip
    """Return the place of the partner, -1 for none, and its distance [m]: the old one first, then who is near."""
    crowd, senses, i = scene.crowd, scene.senses, scene.crowd.row[me]
    if minds.intention[i] == MATE and target >= 0 and suits(crowd, scene.seed, me, target):
        far = speed_of(
            crowd.x[target] - crowd.x[me],
            crowd.y[target] - crowd.y[me],
            crowd.z[target] - crowd.z[me],
        )
        if far < _LOSES_SIGHT * senses.sight[crowd.species[me]]:
            return target, far
    for k in range(found):
        if suits(crowd, scene.seed, me, near[k]):
            return near[k], sqrt(distance[k])
    if senses.schooling[crowd.species[me]] != 0:
        return -1, NO_DANGER
    if (scene.now // 4 + crowd.id[me]) % SEARCH_EVERY != 0:
        return -1, NO_DANGER
    return seek_mate(scene, me, attention, piece)


@row
def suit(
    habitat: Habitat, day: float, z: float, bright: int, warm: int, low: float, high: float
) -> tuple[float, float]:
    """Return unease and where to go, as `unease`; none where the liked depth, `low` to `high` [m], ends there."""
    much, way = unease(habitat, day, z, bright, warm)
    if (high - z if way > 0.0 else z - low) < _NOWHERE:
        much = 0.0
    return much, way


@row
def curiosity(
    role: int, chance: float, sight: float, visibility: float, away: Float64s, seed: int, now: int,
    identity: int,
) -> float:  # fmt: skip
    """Return the distance [m] to the submarine, `away`, that a fish comes to look at, else 0."""
    far = speed_of(away[0], away[1], away[2])
    if role == _PREY or far > min(2.0 * sight, visibility):
        return 0.0
    if role == _PREDATOR:
        chance = _CURIOUS_PREDATOR
    return far if is_curious(seed, now, identity, chance) else 0.0


@merged
def habits(scene: Scene, me: int) -> tuple[float, float]:
    """Return unease and where to go; none for who has no such habit, or a home point."""
    crowd, senses, kind = scene.crowd, scene.senses, scene.crowd.species[me]
    x, y = crowd.x[me], crowd.y[me]
    if senses.bright[kind] == 0 and senses.warm[kind] == 0:
        return 0.0, 0.0
    if nearest_home(scene.terrain, kind, x, y) >= 0:
        return 0.0, 0.0
    low, high = liked_depth(
        scene.terrain, x, y, crowd.length[me], senses.deep[kind], senses.shallow[kind]
    )
    return suit(
        scene.habitat, scene.day, crowd.z[me], senses.bright[kind], senses.warm[kind], low, high
    )


@row
def is_timid(role: int, hunted: int) -> bool:
    """Return whether a species flees: prey does, and pacifists that are eaten."""
    return role == _PREY or (role != _PREDATOR and hunted != 0)


@merged
def want_meals(
    scene: Scene, minds: Minds, thoughts: Thoughts, begin: int, end: int, attention: Attention,
    piece: int,
) -> None:  # fmt: skip
    """Feel hunger, and find a meal for it: who looks round, or eats already. Who is in danger looks for none.

    Who eats keeps to its meal between two looks round, unless that is gone.
    """
    crowd, senses = scene.crowd, scene.senses
    for k in range(begin, end):
        thoughts.meal[k] = -1
        if thoughts.looks[k] == 0 and thoughts.previous[k] != EAT:
            continue
        me = thoughts.me[k]
        i, kind = crowd.row[me], crowd.species[me]
        blocked = thoughts.obstacle[k] < (
            WATCHFUL if thoughts.previous[k] == AVOID_OBSTACLE else 1.0
        )
        threat = min(thoughts.when[k], thoughts.meets[k]) < NO_DANGER
        afraid = thoughts.fear[k] > AFRAID and is_timid(senses.role[kind], senses.hunted[kind])
        urgent = blocked or threat or afraid
        stomach = in_stomach(minds.eaten[i], minds.ate_at[i], scene.now, senses.digestion[kind])
        plain = appetite(stomach, senses.appetite[kind])
        far = NO_DANGER
        if not urgent:
            thoughts.meal[k], far = _find_meal(
                scene,
                me,
                minds,
                plain,
                thoughts.target[k],
                thoughts.looks[k] != 0,
                attention,
                piece,
            )
        near = stimulus(crowd.length[me] / (far + 1e-9), FOOD_FAR, FOOD_NEAR)
        minds.hunger[i] = hunger_of(plain, near)
        thoughts.urgent[k], thoughts.plain[k] = urgent, plain


@merged
def want_mates(
    scene: Scene, minds: Minds, thoughts: Thoughts, begin: int, end: int, attention: Attention,
    piece: int,
) -> None:  # fmt: skip
    """Feel libido, and find a mate for it: who looks round. Who is in danger looks for none."""
    crowd, senses = scene.crowd, scene.senses
    for k in range(begin, end):
        thoughts.mate[k] = -1
        if thoughts.looks[k] == 0:
            continue
        me = thoughts.me[k]
        i, kind = crowd.row[me], crowd.species[me]
        far, wish = NO_DANGER, 0.0
        if senses.role[kind] != _PREDATOR:
            waited = float(scene.now - minds.mated_at[i])
            wish = desire(waited, senses.breeding[kind], hunger_of(thoughts.plain[k], 0.0))
        if thoughts.urgent[k] == 0 and libido_of(wish, 1.0) > WANTING * RELENT:
            thoughts.mate[k], far = _seek_mate(
                scene, me, minds, thoughts.target[k], thoughts.found[k], thoughts.near[k],
                thoughts.distance[k], attention, piece,
            )  # fmt: skip
        allured = stimulus(crowd.length[me] / (far + 1e-9), MATE_FAR, MATE_NEAR)
        minds.libido[i] = libido_of(wish, allured)
