"""Turns: who thinks in a tick, and who of them looks round (papers/000, 3.2; FINDINGS 5).

A quarter of the fishes thinks in a tick, and they stand side by side in the crowd and in its plan: neighbours share the
look around their cell, and nobody far from them need be copied. Looking round for hunters, food and mates is what a
thought costs: who is calm does it seldom.
"""

from typing import Final

from components.kernels import inlined, merged
from components.prefetch import prefetch
from systems.mind.attention import BATCH, Thoughts
from systems.mind.crowd import place_of
from systems.mind.intend import EAT, ESCAPE, LEAVE, MATE, WANDER
from systems.mind.scene import Minds, Scene

LOOK_EVERY: Final = 4
"""[thoughts] between two looks round of who has no cause to look more often: .27 s."""

LATE: Final = 4
"""[ticks] since its last thought after which a fish beside the quarter thinks with it: it has just left it."""

_AGAIN: Final = 2
"""[ticks] since its last thought before which nobody thinks again: it has just come from the quarter before."""

_BESIDE: Final = (16, 32)
"""Places beside the quarter at which who is late is looked for: so many, and one in so many of all."""


@inlined
def _looks_round(now: int, identity: int, minds: Minds, i: int) -> bool:
    """Return whether a fish looks round for hunters, food and mates in this thought.

    Who is new, flees, courts, leaves or was interrupted does; else in every fourth thought.
    """
    about = minds.intention[i]
    busy = (about == ESCAPE) | (about == MATE) | (about == LEAVE) | (minds.memory[i] >= 0)
    new = minds.thought_at[i] < 0
    return bool(busy | new | ((now // 4 + identity) % LOOK_EVERY == 0))


@inlined
def quarter(number: int, now: int) -> tuple[int, int]:
    """Return begin and end of the quarter of `number` places whose turn it is to think; in a world's first tick all."""
    if now == 0:
        return 0, number
    return number * (now & 3) // 4, number * ((now & 3) + 1) // 4


@inlined
def thinking(number: int, now: int) -> tuple[int, int]:
    """Return begin and end of the places among which those think whose turn it is, or who is late."""
    begin, end = quarter(number, now)
    beside = _BESIDE[0] + number // _BESIDE[1]
    return max(begin - beside, 0), min(end + beside, number)


@inlined
def _ask_for(minds: Minds, i: int) -> None:
    """Ask for what the steps to come read and write of row i."""
    prefetch(minds.eaten, i)
    prefetch(minds.ate_at, i)
    prefetch(minds.mated_at, i)
    prefetch(minds.hunger, i)
    prefetch(minds.libido, i)
    prefetch(minds.wary_of, i)
    prefetch(minds.since, i)
    prefetch(minds.danger, i)
    prefetch(minds.heading, i)
    prefetch(minds.urgency, i)
    prefetch(minds.throttle, i)
    prefetch(minds.gape, i)


@merged
def list_turns(
    scene: Scene, begin: int, end: int, mine: tuple[int, int], minds: Minds, thoughts: Thoughts,
    row: int,
) -> tuple[int, int]:  # fmt: skip
    """List who thinks among places begin..end of the crowd, at most `BATCH`, from `row` of the thoughts on.

    `mine` is the quarter whose turn it is. Return the row after the last, and the place from which to go on.
    """
    crowd = scene.crowd
    again = _AGAIN if scene.now > 0 else 0
    at, last, me = row, row + BATCH, begin
    while me < end and at < last:
        i = crowd.row[me]
        if scene.now - minds.thought_at[i] >= (again if mine[0] <= me < mine[1] else LATE):
            previous, target = minds.intention[i], -1
            if previous in (EAT, MATE):
                target = place_of(scene.places, crowd, minds.focus[i])
            thoughts.me[at], thoughts.previous[at], thoughts.target[at] = me, previous, target
            thoughts.looks[at] = _looks_round(scene.now, crowd.id[me], minds, i)
            _ask_for(minds, i)
            if previous == WANDER:
                prefetch(minds.wander_until, i)
                prefetch(minds.wander, i)
            at += 1
        me += 1
    return at, me
