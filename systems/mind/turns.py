"""Turns: who thinks in a tick, and who of them looks round (papers/000, 3.2; FINDINGS 5).

A quarter of the fishes thinks in a tick, by blocks of 3 x 3 columns, so that neighbours share the look around their
cell. Looking round for hunters, food and mates is what a thought costs: who is calm does it seldom.
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

LATE: Final = 6
"""[ticks] after which a fish thinks halfway between two turns of where it is: it has crossed between blocks."""


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
    scene: Scene, begin: int, end: int, minds: Minds, thoughts: Thoughts, row: int
) -> tuple[int, int]:
    """List whose turn it is among places begin..end of the crowd, at most `BATCH`, from `row` of the thoughts on.

    Return the row after the last, and the place from which to go on.
    """
    crowd, side = scene.crowd, scene.plan.columns
    here, turn, at, last, me = -1, 0, row, row + BATCH, begin
    while me < end and at < last:
        if crowd.column[me] != here:
            here = crowd.column[me]
            turn = here // side // 3 + 2 * (here % side // 3) - scene.now
            # In the first tick of all everybody thinks; later who is new waits a tick at most.
            if turn & 1 != 0 and scene.now > 0:
                me = min(crowd.first[here + 1], end)
                continue
        i = crowd.row[me]
        if turn & 3 == 0 or scene.now - minds.thought_at[i] >= LATE:
            previous, target = minds.intention[i], -1
            if previous in (EAT, MATE):
                target = place_of(scene.places, crowd.place, minds.focus[i])
            thoughts.me[at], thoughts.previous[at], thoughts.target[at] = me, previous, target
            thoughts.looks[at] = _looks_round(scene.now, crowd.id[me], minds, i)
            _ask_for(minds, i)
            if previous == WANDER:
                prefetch(minds.wander_until, i)
                prefetch(minds.wander, i)
            at += 1
        me += 1
    return at, me
