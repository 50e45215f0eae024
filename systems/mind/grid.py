"""Who is near whom: fishes sorted into the cells of a grid, and copied in the cells' order (FINDINGS 5).

The plan is divided into square columns, each column into layers as high as a cell is wide. Fishes are counted into
columns; within each they are put in order, the deeper the later, when they are copied (systems/mind/crowd.py).
"""

from math import ceil
from typing import Final, NamedTuple

import numba
import numpy as np

from components.arrays import Float64s, Int32s, Int64s
from components.fish import Population
from components.ground import Terrain
from components.kernels import Launch, inlined, loop, row
from components.senses import SenseTable
from components.table import Columns
from systems.mind.crowd import (
    Crowd,
    Rows,
    Sorting,
    copy_all,
    copy_columns,
    make_crowd,
    make_sorting,
)

REACH: Final = 2.5
"""Body lengths within which fishes tell their neighbours apart in a crowd: a dozen in a school."""

_PER_THREAD: Final = 8

PIECES: Final = _PER_THREAD * numba.config.NUMBA_NUM_THREADS
"""Pieces of a parallel loop over fishes: more even out what they cost, and each costs a start.

They follow the threads, so kernels are told: what is compiled for two threads serves four from the cache.
"""

SERIAL_BELOW: Final = 500
"""Fishes below which one thread is quicker than two."""

_FEWEST_COLUMNS: Final = 16
_MOST_COLUMNS: Final = 512


class Plan(NamedTuple):
    """How the world is divided into cells this tick."""

    cell: float
    "[m] side of a cell; neighbours are seen this far at least"
    columns: int
    "columns a side"
    layers: int
    "layers of a column, from the surface down"
    extent: float
    "[m] half the side of the plan"
    block: int
    "columns a side of the squares over which shoals are summed"
    squares: int
    "such squares a side"
    far: int
    "columns within which all lies that anybody sees"
    hunters: int
    "fishes of species that eat others"
    crowded: bool
    "whether a cell is as small as `REACH` asks; else it is wider, and fishes look as far as it is"


def divide(terrain: Terrain, senses: SenseTable, counts: Int64s, visibility: float) -> Plan:
    """Return the plan for `counts` fishes of each species, (S,): finer for more.

    Nobody sees farther than `visibility` [m].
    """
    number = int(counts.sum())
    mean = sum(int(n) * float(s) for n, s in zip(counts, senses.length, strict=True))
    mean /= max(number, 1)
    side = 2.0 * terrain.radius
    widest = side / min(max(number // 4, _FEWEST_COLUMNS), _MOST_COLUMNS)
    cell = max(widest, REACH * mean, 1e-3)
    columns = ceil(side / cell)
    block = max(1, ceil(float(max(senses.sight, default=1.0)) / cell))
    squares = ceil(columns / block)
    layers = ceil(terrain.depth / cell) + 1
    far = max(1, ceil(min(visibility, side) / cell))
    hunters = int(counts[senses.hunts != 0].sum())
    return Plan(cell, columns, layers, terrain.radius, block, squares, far, hunters, cell > widest)


@inlined
def _place(at: float, extent: float, cell: float, last: int) -> int:
    return min(max(int((at + extent) / cell), 0), last)


@row
def find_cells(
    begin: int, end: int, position: Float64s, plan: Plan, column: Int32s, layer: Int32s
) -> None:
    """Write column and layer of the rows begin..end."""
    last = plan.columns - 1
    for i in range(begin, end):
        x = _place(position[i, 0], plan.extent, plan.cell, last)
        y = _place(position[i, 1], plan.extent, plan.cell, last)
        column[i] = x * plan.columns + y
        layer[i] = _place(-position[i, 2], 0.0, plan.cell, plan.layers - 1)


@row
def sort_columns(number: int, plan: Plan, sorting: Sorting, first: Int32s) -> None:
    """Put the rows of the last tick's order by column; write `first`, where each column begins.

    Rows of a column stay in the order in which they were.
    """
    column, order, by_column = sorting.column, sorting.order, sorting.by_column
    first[: plan.columns * plan.columns + 2] = 0
    for i in range(number):
        first[column[i] + 2] += 1
    for at in range(plan.columns * plan.columns):
        first[at + 2] += first[at + 1]
    for k in range(number):
        at = column[order[k]] + 1
        by_column[first[at]] = order[k]
        first[at] += 1


@row
def choose_stretch(
    number: int, begin_end: tuple[int, int], plan: Plan, far: int, block: int, sorting: Sorting,
    crowd: Crowd,
) -> None:  # fmt: skip
    """Write the crowd's `stretch`: what those at the places `begin_end` may look at.

    It is all columns within `far` of theirs, and whole squares, `block` columns wide, beside theirs. The other rows
    stay as they are: sorted by column.
    """
    west = east = 0
    if number > 0:
        west = sorting.column[sorting.by_column[begin_end[0]]] // plan.columns
        east = sorting.column[sorting.by_column[begin_end[1] - 1]] // plan.columns
    last = -(-plan.columns // block)
    first, end = max(west // block - 1, 0), min(east // block + 2, last)
    west, east = min(west - far, first * block), max(east + far + 1, end * block)
    stretch = crowd.stretch
    stretch[0] = crowd.first[max(west, 0) * plan.columns]
    stretch[1] = crowd.first[min(east, plan.columns) * plan.columns]
    stretch[2], stretch[3] = first, end
    for k in range(stretch[0]):
        sorting.order[k] = sorting.by_column[k]
    for k in range(stretch[1], number):
        sorting.order[k] = sorting.by_column[k]


@row
def sort_serially(
    number: int, begin_end: tuple[int, int], plan: Plan, far: int, block: int, sorting: Sorting,
    rows: Rows, crowd: Crowd,
) -> None:  # fmt: skip
    """Sort `number` fishes into cells and copy those that the ones at places `begin_end` may look at, on this thread.

    `far` and `block` are as `choose_stretch` has them.
    """
    find_cells(0, number, rows.position, plan, sorting.column, sorting.layer)
    sort_columns(number, plan, sorting, crowd.first)
    choose_stretch(number, begin_end, plan, far, block, sorting, crowd)
    copy_columns(crowd.stretch[0], crowd.stretch[1], number, sorting, rows, crowd)


@loop
def _find_all(
    pieces: int, number: int, position: Float64s, plan: Plan, column: Int32s, layer: Int32s
) -> None:
    for piece in numba.prange(pieces):
        begin, end = number * piece // pieces, number * (piece + 1) // pieces
        find_cells(begin, end, position, plan, column, layer)


@row
def sort_on_all(
    pieces: int, number: int, begin_end: tuple[int, int], plan: Plan, far: int, block: int,
    sorting: Sorting, rows: Rows, crowd: Crowd,
) -> None:  # fmt: skip
    """As `sort_serially`, on all threads."""
    _find_all(pieces, number, rows.position, plan, sorting.column, sorting.layer)
    sort_columns(number, plan, sorting, crowd.first)
    choose_stretch(number, begin_end, plan, far, block, sorting, crowd)
    copy_all(pieces, crowd.stretch[0], crowd.stretch[1], number, sorting, rows, crowd)


class Grid:
    """Scratch: room for the fishes in cell order, and how the world is divided for them."""

    def __init__(
        self, population: Population, terrain: Terrain, senses: SenseTable, visibility: float
    ) -> None:
        """Take the fishes, their world and senses; nobody sees farther than `visibility` [m]."""
        self.population, self.terrain, self.senses = population, terrain, senses
        self.visibility = visibility
        self._rows = Columns(Rows, population.fish, population.mind)
        self._planned = -1
        self.plan = divide(terrain, senses, np.zeros(len(senses.length), np.int64), visibility)
        self.crowd, self.sorting = make_crowd(0, 0, 0, 0), make_sorting(0)
        self._sort = Launch(sort_serially)

    def rows(self) -> Rows:
        """Return the columns that the crowd copies; stale when a table grows."""
        return self._rows()

    def prepare(self, reorder: bool = False) -> None:
        """Make room for the living fishes and plan for them; with `reorder` put their rows in cell order."""
        number = self.population.count
        if self._planned != self.population.changes:
            self._divide(number)
        if reorder:
            self._start_anew(number)
            self._sort(number, (0, number), self.plan, 1, 1, self.sorting, self._rows(), self.crowd)
            self.population.reorder(self.sorting.order[:number].astype(np.int64))
            self._start_anew(number)

    def _divide(self, number: int) -> None:
        """Plan for the fishes that there are, of each species so many."""
        self._planned = self.population.changes
        species = self.population.fish.species[:number]
        counts = np.bincount(species, minlength=len(self.senses.length))
        self.plan = divide(self.terrain, self.senses, counts, self.visibility)
        self._fit(number)
        self._start_anew(number)

    def _fit(self, number: int) -> None:
        """Make room for `number` fishes and for the plan."""
        plan, crowd, room = self.plan, self.crowd, len(self.sorting.order)
        columns, squares = plan.columns**2, plan.squares**2
        if number > room:
            room = max(16, 2 * room, number)
            self.sorting = make_sorting(room)
        old = (len(crowd.x), len(crowd.first) - 2, crowd.shoal.shape[1])
        if number > old[0] or columns > old[1] or squares > old[2]:
            kinds = len(self.senses.length)
            self.crowd = make_crowd(room, max(columns, old[1]), kinds, max(squares, old[2]))

    def _start_anew(self, number: int) -> None:
        """Forget the last tick's order: rows have moved."""
        self.sorting.order[:number] = np.arange(number)
