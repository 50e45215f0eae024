"""Bare schooling: neighbours and the rule of Reynolds alone, in the same grid and loop as whole minds.

Benches hold the whole mind, and scipy's k-d tree, against it. No game runs it.
"""

import numba

from components.arrays import Float64s, Int8s
from components.clock import TICKS_PER_SECOND, Clock
from components.fish import Population
from components.ground import Terrain
from components.kernel_turns import first_turn, next_turn
from components.kernels import Launch, loop, row
from components.senses import SenseTable
from components.vector import point
from systems.mind.attention import Attention, make_attention
from systems.mind.behave.school import keep_company
from systems.mind.crowd import Crowd, Rows, Sorting
from systems.mind.gather import gather, reach_of
from systems.mind.grid import (
    PIECES,
    SERIAL_BELOW,
    Grid,
    Plan,
    sort_on_all,
    sort_serially,
)
from systems.mind.nearest import nearest_of_kind
from systems.mind.perceive import see_around
from systems.mind.turns import quarter


@row
def flock_some(
    begin: int, end: int, plan: Plan, crowd: Crowd, senses: SenseTable,
    heading: Float64s, gear: Int8s, attention: Attention, piece: int,
) -> None:  # fmt: skip
    """Let those of places begin..end school."""
    column = layer = -1
    around = 0
    for me in range(begin, end):
        kind = crowd.species[me]
        if senses.schooling[kind] == 0:
            continue
        if crowd.column[me] != column or crowd.layer[me] != layer:
            column, layer = crowd.column[me], crowd.layer[me]
            around = gather(plan, crowd, column, layer, attention, piece)
        length = crowd.length[me]
        reach = reach_of(plan, senses.sight[kind], length)
        near, distance = attention.sought[piece], attention.sought_distance[piece]
        many, _ = see_around(crowd, me, reach, True, False, around, attention, piece)
        found = nearest_of_kind(many, attention, piece, near, distance)
        x, y, z, _, _ = keep_company(
            crowd, me, near, distance, found, senses.spacing[kind] * length
        )
        point(heading[crowd.row[me]], x, y, z)
        gear[crowd.row[me]] = 1


@loop
def flock_all(
    pieces: int, begin: int, end: int, plan: Plan, crowd: Crowd, senses: SenseTable,
    heading: Float64s, gear: Int8s, attention: Attention,
) -> None:  # fmt: skip
    """Let those of places begin..end school, on all threads."""
    turns = first_turn()
    for share in numba.prange(pieces):
        piece = next_turn(turns, share, pieces)
        while piece < pieces:
            first = begin + (end - begin) * piece // pieces
            last = begin + (end - begin) * (piece + 1) // pieces
            flock_some(first, last, plan, crowd, senses, heading, gear, attention, piece)
            piece = next_turn(turns, share, pieces)


@row
def school_serially(
    begin_end: tuple[int, int], number: int, plan: Plan, sorting: Sorting, rows: Rows, crowd: Crowd,
    senses: SenseTable, heading: Float64s, gear: Int8s, attention: Attention,
) -> None:  # fmt: skip
    """Sort `number` fishes and let those of the places `begin_end` school, on this thread."""
    sort_serially(number, begin_end, plan, plan.far, plan.block, sorting, rows, crowd)
    flock_some(begin_end[0], begin_end[1], plan, crowd, senses, heading, gear, attention, 0)


@row
def school_on_all(
    pieces: int, begin_end: tuple[int, int], number: int, plan: Plan, sorting: Sorting, rows: Rows,
    crowd: Crowd, senses: SenseTable, heading: Float64s, gear: Int8s, attention: Attention,
) -> None:  # fmt: skip
    """Sort `number` fishes and let those of the places `begin_end` school, on all threads."""
    sort_on_all(pieces, number, begin_end, plan, plan.far, plan.block, sorting, rows, crowd)
    flock_all(pieces, begin_end[0], begin_end[1], plan, crowd, senses, heading, gear, attention)


class BareSchooling:
    """Reads fishes, senses and clock; writes the schooling fishes' heading and gear."""

    def __init__(
        self,
        population: Population,
        senses: SenseTable,
        terrain: Terrain,
        clock: Clock,
        every: int = 4,
        visibility: float = 0.0,
    ) -> None:
        """Let every fish think each `every` ticks: 4 as whole minds do, or 1.

        The crowd is copied as far as they see whose `visibility` [m] it is, though schooling itself looks less far.
        """
        self.population, self.senses, self.clock, self.every = population, senses, clock, every
        self.grid = Grid(population, terrain, senses, visibility)
        self._attention = make_attention()
        self._serially, self._on_all = Launch(school_serially), Launch(school_on_all)

    def __call__(self) -> None:
        """Advance by one tick."""
        number, now, motor = self.population.count, self.clock.now, self.population.motor
        grid = self.grid
        grid.prepare(reorder=number >= SERIAL_BELOW and now % TICKS_PER_SECOND == 0)
        begin_end = quarter(number, now) if self.every > 1 else (0, number)
        given = (
            begin_end, number, grid.plan, grid.sorting, grid.rows(), grid.crowd, self.senses,
            motor.heading, motor.gear, self._attention,
        )  # fmt: skip
        if number < SERIAL_BELOW:
            self._serially(*given)
        else:
            self._on_all(PIECES, *given)
