"""Who is near whom: fishes sorted into the cells of a grid, and copied in the cells' order (FINDINGS 5).

The plan is divided into square columns, each column into layers as high as a cell is wide. Fishes are counted into
layers, then into columns, so that a column's fishes lie together, the deeper the later; what minds look at is copied
in that order (systems/mind/crowd.py).
"""

from math import ceil
from typing import Final, NamedTuple

import numba
import numpy as np

from components.arrays import Float64s, Int32s, Int64s
from components.fish import Population
from components.ground import Terrain
from components.kernels import Launch, inlined, row
from components.senses import SenseTable
from components.table import Columns
from systems.mind.crowd import Rows, copy_all, copy_cells, make_crowd

REACH: Final = 2.5
"""Body lengths within which fishes tell their neighbours apart in a crowd: a dozen in a school."""

_PER_THREAD: Final = 8

PIECES: Final = _PER_THREAD * numba.config.NUMBA_NUM_THREADS
"""Pieces of a parallel loop over fishes: more even out what they cost, and each costs a start."""

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
    crowded: bool
    "whether a cell is as small as `REACH` asks; else it is wider, and fishes look as far as it is"


@inlined
def scattered(turn: int, pieces: int) -> int:
    """Return the piece of a turn: threads take turns in a row, and neighbours in the crowd go to several threads."""
    return turn % _PER_THREAD * (pieces // _PER_THREAD) + turn // _PER_THREAD


def divide(terrain: Terrain, senses: SenseTable, counts: Int64s) -> Plan:
    """Return the plan for `counts` fishes of each species, (S,): finer for more."""
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
    return Plan(cell, columns, layers, terrain.radius, block, squares, cell > widest)


@inlined
def _place(at: float, extent: float, cell: float, last: int) -> int:
    return min(max(int((at + extent) / cell), 0), last)


@row
def sort_cells(
    position: Float64s,
    number: int,
    plan: Plan,
    keys: Int32s,
    tally: Int32s,
    by_layer: Int32s,
    order: Int32s,
    first: Int32s,
) -> None:
    """Put `order`, the rows in any order, by column and layer; write `first`, where each column begins.

    Rows of a cell stay in the order in which they were.
    """
    last = plan.columns - 1
    tally[: plan.layers + 1] = 0
    first[: plan.columns * plan.columns + 2] = 0
    for i in range(number):
        column = _place(position[i, 0], plan.extent, plan.cell, last) * plan.columns
        column += _place(position[i, 1], plan.extent, plan.cell, last)
        layer = _place(-position[i, 2], 0.0, plan.cell, plan.layers - 1)
        keys[i, 0], keys[i, 1] = column, layer
        tally[layer + 1] += 1
        first[column + 2] += 1
    for layer in range(plan.layers):
        tally[layer + 1] += tally[layer]
    for column in range(plan.columns * plan.columns):
        first[column + 2] += first[column + 1]
    for k in range(number):
        i = order[k]
        by_layer[tally[keys[i, 1]]] = i
        tally[keys[i, 1]] += 1
    for k in range(number):
        column = keys[by_layer[k], 0]
        order[first[column + 1]] = by_layer[k]
        first[column + 1] += 1


class Grid:
    """Scratch: the fishes in cell order, made anew each tick by `sort`."""

    def __init__(self, population: Population, terrain: Terrain, senses: SenseTable) -> None:
        self.population, self.terrain, self.senses = population, terrain, senses
        self._rows = Columns(Rows, population.fish, population.mind)
        self._planned = -1
        self.plan = divide(terrain, senses, np.zeros(len(senses.length), np.int64))
        self.crowd = make_crowd(0, 0, 0, 0)
        self.order = self._by_layer = self._tally = np.zeros(0, np.int32)
        self._keys = np.zeros((0, 2), np.int32)
        self._sort_cells = Launch(sort_cells)
        self._copy, self._copy_all = Launch(copy_cells), Launch(copy_all)

    def _fit(self, number: int) -> None:
        """Make room for `number` fishes and for the plan."""
        plan, crowd = self.plan, self.crowd
        columns, squares = plan.columns**2, plan.squares**2
        if number > len(self.order):
            room = max(16, 2 * len(self.order), number)
            self.order, self._by_layer = np.zeros(room, np.int32), np.zeros(room, np.int32)
            self._keys = np.zeros((room, 2), np.int32)
        if plan.layers + 1 > len(self._tally):
            self._tally = np.zeros(2 * plan.layers + 1, np.int32)
        old = (len(crowd.x), len(crowd.first) - 2, crowd.shoal.shape[1])
        if number > old[0] or columns > old[1] or squares > old[2]:
            kinds = len(self.senses.length)
            self.crowd = make_crowd(
                len(self.order), max(columns, old[1]), kinds, max(squares, old[2])
            )

    def _start_anew(self, number: int) -> None:
        """Forget the last tick's order: rows have moved."""
        self.order[:number] = np.arange(number)

    def sort(self, reorder: bool = False) -> None:
        """Sort the living fishes into cells; with `reorder` put their rows in that order too."""
        number = self.population.count
        if self._planned != self.population.changes:
            self._divide(number)
        if reorder:
            self._start_anew(number)
            self._order(number)
            self.population.reorder(self.order[:number].astype(np.int64))
            self._start_anew(number)
        self._order(number)
        if number < SERIAL_BELOW:
            self._copy(0, number, number, self.order, self._keys, self._rows(), self.crowd)
        else:
            self._copy_all(PIECES, number, self.order, self._keys, self._rows(), self.crowd)

    def _divide(self, number: int) -> None:
        """Plan for the fishes that there are, of each species so many."""
        self._planned = self.population.changes
        species = self.population.fish.species[:number]
        counts = np.bincount(species, minlength=len(self.senses.length))
        self.plan = divide(self.terrain, self.senses, counts)
        self._fit(number)
        self._start_anew(number)

    def _order(self, number: int) -> None:
        self._sort_cells(
            self.population.fish.position, number, self.plan, self._keys, self._tally,
            self._by_layer, self.order, self.crowd.first,
        )  # fmt: skip
