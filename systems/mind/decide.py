"""Deciding: each mind's intention, its focus, and what of it is remembered (papers/000 section 3.2; papers/004)."""

from typing import Final

from components.chance import WHIM, uniform
from components.kernels import merged
from components.mind import SUBMARINE, Role, Why
from systems.mind.act import NONE
from systems.mind.attention import NO_DANGER, Thoughts
from systems.mind.crowd import Crowd
from systems.mind.intend import (
    AVOID_FISH,
    EAT,
    ESCAPE,
    MATE,
    OBEY,
    SCHOOL,
    Held,
    Percept,
    intend,
)
from systems.mind.scene import Minds, Scene
from systems.mind.want import curiosity, habits, is_timid

_PLAYER: Final = int(Why.PLAYER)
_CURIOSITY: Final = int(Why.CURIOSITY)
_PREDATOR: Final = int(Role.PREDATOR)


@merged
def _take_up(
    scene: Scene, me: int, minds: Minds, intention: int, memory: int, threat: bool
) -> None:
    """Remember what begins, what is interrupted, and what courtship ends with it."""
    i = scene.crowd.row[me]
    previous = minds.intention[i]
    if intention != previous or threat:
        minds.since[i] = scene.now
    if memory >= 0 and memory != minds.memory[i]:
        minds.memory_focus[i] = minds.focus[i]
    courts = intention == MATE or memory == MATE
    begins = intention == MATE and previous != MATE and minds.courtship[i] == NONE
    if begins or (not courts and minds.courtship[i] != NONE):
        minds.courtship[i], minds.courtship_since[i] = NONE, scene.now
    minds.intention[i], minds.memory[i] = intention, memory


@merged
def _attend(crowd: Crowd, intention: int, why: int, thoughts: Thoughts, k: int) -> int:
    """Return the focus that passes: what the intention is about."""
    predator, scare = thoughts.predator[k], thoughts.scare[k]
    when, meets = thoughts.when[k], thoughts.meets[k]
    if intention == EAT:
        return int(thoughts.meal[k])
    if intention == MATE:
        return int(crowd.id[thoughts.mate[k]])
    if intention == SCHOOL and thoughts.found[k] > 0:
        return int(crowd.id[thoughts.near[k, 0]])
    if intention == ESCAPE and predator >= 0 and thoughts.worst[k] > scare:
        return int(crowd.id[predator])
    if intention == AVOID_FISH and when < NO_DANGER and when <= meets:
        return int(crowd.id[thoughts.other[k]])
    submarine = (
        why == _CURIOSITY
        or (intention == ESCAPE and scare > 0.0)
        or (intention == AVOID_FISH and meets < when)
    )
    return SUBMARINE if submarine else -1


@merged
def _decide_one(scene: Scene, minds: Minds, thoughts: Thoughts, k: int) -> None:
    """Choose one mind's intention, and what it is about."""
    crowd, senses, me = scene.crowd, scene.senses, thoughts.me[k]
    i, kind = crowd.row[me], crowd.species[me]
    role, previous = senses.role[kind], thoughts.previous[k]
    much = curious = 0.0
    if thoughts.looks[k] != 0:
        much, thoughts.rise[k] = habits(scene, me)
    if scene.submarines > 0:
        curious = curiosity(
            role, senses.curiosity[kind], senses.sight[kind], scene.habitat.visibility,
            thoughts.away[k], scene.seed, scene.now, crowd.id[me],
        )  # fmt: skip
    company = 0
    if senses.schooling[kind] != 0:
        company = thoughts.found[k] + int(thoughts.number[k] > 0.0)
    collision = min(thoughts.when[k], thoughts.meets[k])
    percept = Percept(
        thoughts.obstacle[k], collision, collision < NO_DANGER, is_timid(role, senses.hunted[kind]),
        minds.fear[i], minds.danger[i], company, minds.hunger[i], minds.libido[i],
        thoughts.meal[k] != -1, thoughts.mate[k] >= 0, role == _PREDATOR, minds.focus[i] >= 0,
        much, curious,
        minds.hunger[i] == minds.libido[i]
        and uniform(scene.seed, WHIM, scene.now, crowd.id[me]) < 0.5,
    )  # fmt: skip
    held = Held(previous, minds.why[i], minds.since[i], minds.memory[i])
    intention, why, value, memory = intend(scene.now, held, percept)
    _take_up(scene, me, minds, intention, memory, collision < NO_DANGER)
    minds.why[i], minds.why_value[i] = why, value
    minds.focus[i] = _attend(crowd, intention, why, thoughts, k)


@merged
def decide(scene: Scene, minds: Minds, thoughts: Thoughts, begin: int, end: int) -> None:
    """Choose what each means to do; who obeys the player keeps to that."""
    for k in range(begin, end):
        i = scene.crowd.row[thoughts.me[k]]
        minds.fear[i], minds.thought_at[i] = thoughts.fear[k], scene.now
        minds.danger[i] = max(thoughts.worst[k], thoughts.scare[k])
        predator = thoughts.predator[k]
        minds.wary_of[i] = scene.crowd.id[predator] if predator >= 0 else -1
        if thoughts.previous[k] == OBEY:
            minds.why[i], minds.why_value[i] = _PLAYER, 0.0
        else:
            _decide_one(scene, minds, thoughts, k)
