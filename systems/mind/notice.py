"""Noticing: company and dangers, all that may decide before wants are felt (papers/004; papers/000, 3.2)."""

from typing import Final, NamedTuple

from components.arrays import Float64s
from components.kernels import merged
from components.mind import Role
from systems.mind.beware import fear_all, watch_hunters
from systems.mind.feel import fear_of_submarine, speed_of
from systems.mind.perceive import (
    Attention,
    feel_ahead,
    meet_submarine,
    reach_of,
    see_around,
    watch,
)
from systems.mind.scene import Scene
from systems.mind.shoal import see_shoal

_PREY: Final = int(Role.PREY)


class Dangers(NamedTuple):
    """What a fish perceives of company and dangers."""

    found: int
    "nearest of its kind listed"
    number: float
    "fishes of its shoal, 0 for none"
    other: int
    "place of who collides first, -1 for none"
    when: float
    "[s] until then"
    meets: float
    "[s] until the submarine is too near"
    obstacle: float
    "distance of the nearest obstacle over the distance that alarms"
    seen: int
    "predators listed"
    predator: int
    "place of the most dangerous, -1 for none"
    fear: float
    danger: float
    scare: float
    "fear of the submarine"


@merged
def _scared(scene: Scene, me: int, away: Float64s) -> float:
    """Return fear of the submarine: prey's alone."""
    senses, kind = scene.senses, scene.crowd.species[me]
    if senses.role[kind] != _PREY or scene.submarines == 0:
        return 0.0
    v = scene.submarine_velocity
    return fear_of_submarine(
        senses.wariness[kind], speed_of(v[0, 0], v[0, 1], v[0, 2]),
        speed_of(away[0], away[1], away[2]),
    )  # fmt: skip


@merged
def notice(
    scene: Scene, me: int, target: int, around: int, hunter_runs: int, attention: Attention,
    piece: int,
) -> Dangers:  # fmt: skip
    """Look at all that may be company or danger."""
    crowd, senses = scene.crowd, scene.senses
    kind, length = crowd.species[me], crowd.length[me]
    schooling = senses.schooling[kind] != 0
    reach = reach_of(scene.plan, senses.sight[kind], length)
    many = see_around(crowd, me, reach, around, attention, piece)
    found, other, when = watch(crowd, me, schooling, target, senses.eats, many, attention, piece)
    number = 0.0
    if schooling:
        far = min(2.0 * senses.sight[kind], scene.habitat.visibility)
        number = see_shoal(scene.plan, crowd, me, far, attention.shoal[piece])
    seen, predator, fear, danger = 0, -1, 0.0, 0.0
    if hunter_runs > 0:
        seen, big, soon = watch_hunters(scene, me, target, hunter_runs, attention, piece)
        if soon < when:
            other, when = big, soon
        fear, danger, predator, seen = fear_all(
            scene, me, seen, attention.hunters[piece], attention.hunter_distance[piece]
        )
    alarm = 0.8 * length + 0.2
    obstacle = feel_ahead(scene.terrain, crowd, me, 1.5 * alarm, attention.normal[piece]) / alarm
    away = attention.away[piece]
    meets = meet_submarine(
        crowd, me, scene.submarine, scene.submarine_velocity, scene.submarines, away
    )
    scare = _scared(scene, me, away)
    return Dangers(
        found, number, other, when, meets, obstacle, seen, predator, min(fear + scare, 1.0),
        max(danger, scare), scare,
    )  # fmt: skip
