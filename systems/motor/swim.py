"""Swim: bound, control and move in one launch, some fishes at a time (papers/000, section 6).

Each is a system that can run alone, and plays to the same bits then. Together they start threads once, and Python hands
over the fishes once: with 10,000 fishes those cost as much as bounding.
"""

from typing import Final

import numba

from components.arrays import Float64s
from components.ground import Terrain
from components.kernel_turns import first_turn, next_turn
from components.kernels import Launch, inlined, loop, row
from systems.motor.bound import Bound, Bounded, bound_some
from systems.motor.choose import Gaits
from systems.motor.columns import Bodies, Motors
from systems.motor.control import Control, Controlled, control_rows
from systems.motor.move import Move, move_rows
from systems.motor.track import Track

PARALLEL_FROM: Final = 500
"""Fishes from which two threads are worth their launch."""

CHUNKS: Final = 64
_EIGHTH: Final = CHUNKS // 8


@row
def swim_rows(
    first: int, last: int, terrain: Terrain, girth: Float64s, bounded: Bounded,
    controlled: Controlled, gaits: Gaits, seed: int, tick: int, bodies: Bodies, motors: Motors,
    track: Track,
) -> None:  # fmt: skip
    """Bound, control and move the fishes of rows first to last - 1."""
    bound_some(terrain, girth, first, last, bounded)
    control_rows(first, last, controlled, gaits, seed, tick)
    move_rows(first, last, bodies, motors, track, terrain)


@inlined
def place_of_turn(chunk: int) -> int:
    """Return the place of a chunk among the rows: the first halves of all quarters come first, then the second halves.

    Minds think quarter by quarter, one thread from its front, one from its back (systems/mind/turns.py): so a fish
    swims on the thread that it thinks on.
    """
    half = CHUNKS // 2
    eighth, inside = 2 * (chunk % half // _EIGHTH) + chunk // half, chunk % _EIGHTH
    return eighth * _EIGHTH + inside


@loop
def swim_parallel(
    count: int, terrain: Terrain, girth: Float64s, bounded: Bounded, controlled: Controlled,
    gaits: Gaits, seed: int, tick: int, bodies: Bodies, motors: Motors, track: Track,
) -> None:  # fmt: skip
    """Bound, control and move `count` fishes on all threads, to the same bits as `swim_rows`."""
    turns = first_turn()
    for share in numba.prange(CHUNKS):
        chunk = next_turn(turns, share, CHUNKS)
        while chunk < CHUNKS:
            place = place_of_turn(chunk)
            first, last = place * count // CHUNKS, (place + 1) * count // CHUNKS
            swim_rows(
                first, last, terrain, girth, bounded, controlled, gaits, seed, tick, bodies, motors,
                track,
            )  # fmt: skip
            chunk = next_turn(turns, share, CHUNKS)


class Swim:
    """Reads and writes what `Bound`, `Control` and `Move`, its parts, do."""

    def __init__(self, bound: Bound, control: Control, move: Move) -> None:
        self.bound, self.control, self.move = bound, control, move
        self._serially, self._in_parallel = Launch(swim_rows), Launch(swim_parallel)

    def __call__(self) -> None:
        """Bound, control and move every fish for a tick."""
        bound, control, move = self.bound, self.control, self.move
        count, clock = move.population.count, control.clock
        given = (
            bound.terrain, bound.senses.girth, bound.columns(), control.columns(), control.gaits,
            int(clock.seed[0]), clock.now, move.bodies(), move.motors(), move.track,
        )  # fmt: skip
        if count < PARALLEL_FROM:
            self._serially(0, count, *given)
        else:
            self._in_parallel(count, *given)
