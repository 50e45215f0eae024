"""Who is near whom: fishes sorted into the cells of a grid, and copied in the cells' order (FINDINGS 5).

The plan is divided into square columns, each column into layers as high as a cell is wide. Fishes are counted into
layers, then into columns, so that a column's fishes lie together, the deeper the later; what minds look at is copied
in that order. What results may not depend on the order within a cell: it follows the rows, and rows move.

A shoal is what a fish sees of many fishes far away: their number, mean place and mean heading over a square of the
plan, summed in whole numbers so that the order of summation cannot matter.
"""

from math import ceil, sqrt
from typing import Final, NamedTuple

import numba
import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.fish import Population
from components.ground import Terrain
from components.kernels import inlined, loop, row
from components.senses import SenseTable

REACH: Final = 1.8
"""Body lengths within which fishes tell their neighbours apart, however crowded."""

PIECES: Final = 64
"""Pieces of a parallel loop over fishes."""

SERIAL_BELOW: Final = 500
"""Fishes below which one thread is quicker than two."""

FIXED: Final = 65536.0
"""Whole numbers to a metre, or to a unit of heading, in the sums of shoals."""

_FEWEST_COLUMNS: Final = 16
_MOST_COLUMNS: Final = 256
_SUMS: Final = 7


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


class Crowd(NamedTuple):
    """The fishes in the order of cells, as minds see each other; (capacity,) each but `first` and `shoal`."""

    x: Float64s
    "[m]"
    y: Float64s
    "[m]"
    z: Float64s
    "[m]"
    hx: Float64s
    "the body's axis, unit"
    hy: Float64s
    "the body's axis, unit"
    hz: Float64s
    "the body's axis, unit"
    speed: Float64s
    "[m/s]"
    length: Float64s
    "[m]"
    id: Int64s
    "stable id"
    species: Int32s
    "row in the species table"
    row: Int32s
    "row in the fishes' tables"
    column: Int32s
    "column of the plan"
    layer: Int32s
    "layer of the column"
    first: Int32s
    "where each column begins, (columns^2 + 2,)"
    shoal: Int64s
    "number, sums of x, y, z [m / FIXED] and of heading, (species, squares^2, 7)"


def divide(terrain: Terrain, senses: SenseTable, counts: Int64s) -> Plan:
    """Return the plan for `counts` fishes of each species, (S,): finer for more."""
    number = int(counts.sum())
    mean = sum(int(n) * float(s) for n, s in zip(counts, senses.length, strict=True))
    mean /= max(number, 1)
    side = 2.0 * terrain.radius
    columns = min(max(number // 4, _FEWEST_COLUMNS), _MOST_COLUMNS)
    cell = max(side / columns, REACH * mean, 1e-3)
    columns = ceil(side / cell)
    block = max(1, ceil(float(max(senses.sight, default=1.0)) / cell))
    return Plan(
        cell, columns, ceil(terrain.depth / cell) + 1, terrain.radius, block, ceil(columns / block)
    )


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
    """Write `order`, the rows by column and layer, and `first`, where each column begins."""
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
    for i in range(number):
        by_layer[tally[keys[i, 1]]] = i
        tally[keys[i, 1]] += 1
    for k in range(number):
        column = keys[by_layer[k], 0]
        order[first[column + 1]] = by_layer[k]
        first[column + 1] += 1


@row
def _copy(
    begin: int,
    end: int,
    order: Int32s,
    keys: Int32s,
    position: Float64s,
    last_position: Float64s,
    rotation: Float64s,
    length: Float64s,
    identity: Int64s,
    species: Int32s,
    crowd: Crowd,
) -> None:
    for k in range(begin, end):
        i = order[k]
        crowd.x[k], crowd.y[k], crowd.z[k] = position[i, 0], position[i, 1], position[i, 2]
        crowd.hx[k], crowd.hy[k] = rotation[i, 0, 0], rotation[i, 1, 0]
        crowd.hz[k] = rotation[i, 2, 0]
        dx = position[i, 0] - last_position[i, 0]
        dy = position[i, 1] - last_position[i, 1]
        dz = position[i, 2] - last_position[i, 2]
        crowd.speed[k] = 60.0 * sqrt(dx * dx + dy * dy + dz * dz)
        crowd.length[k], crowd.id[k], crowd.species[k] = length[i], identity[i], species[i]
        crowd.row[k], crowd.column[k], crowd.layer[k] = i, keys[i, 0], keys[i, 1]


@loop
def _copy_all(
    number: int,
    order: Int32s,
    keys: Int32s,
    position: Float64s,
    last_position: Float64s,
    rotation: Float64s,
    length: Float64s,
    identity: Int64s,
    species: Int32s,
    crowd: Crowd,
) -> None:
    for piece in numba.prange(PIECES):
        begin, end = number * piece // PIECES, number * (piece + 1) // PIECES
        _copy(
            begin, end, order, keys, position, last_position, rotation, length, identity, species,
            crowd,
        )  # fmt: skip


@row
def _gather_strip(strip: int, plan: Plan, schooling: Int8s, crowd: Crowd) -> None:
    """Sum the shoals over one strip of squares, which no other strip touches."""
    crowd.shoal[:, strip * plan.squares : (strip + 1) * plan.squares] = 0
    begin = crowd.first[strip * plan.block * plan.columns]
    end = crowd.first[min((strip + 1) * plan.block, plan.columns) * plan.columns]
    kind = square = -1
    number = x = y = z = u = v = w = 0
    for k in range(begin, end + 1):
        here = -1
        if k < end:
            here = strip * plan.squares + crowd.column[k] % plan.columns // plan.block
        if k == end or here != square or crowd.species[k] != kind:
            if number > 0 and schooling[kind] != 0:
                sums = crowd.shoal[kind, square]
                sums[0] += number
                sums[1], sums[2], sums[3] = sums[1] + x, sums[2] + y, sums[3] + z
                sums[4], sums[5], sums[6] = sums[4] + u, sums[5] + v, sums[6] + w
            if k == end:
                return
            kind, square = crowd.species[k], here
            number = x = y = z = u = v = w = 0
        number += 1
        x, y, z = (
            x + int(crowd.x[k] * FIXED),
            y + int(crowd.y[k] * FIXED),
            z + int(crowd.z[k] * FIXED),
        )
        u, v = u + int(crowd.hx[k] * FIXED), v + int(crowd.hy[k] * FIXED)
        w += int(crowd.hz[k] * FIXED)


@row
def _gather_serially(plan: Plan, schooling: Int8s, crowd: Crowd) -> None:
    for strip in range(plan.squares):
        _gather_strip(strip, plan, schooling, crowd)


@loop
def _gather_all(plan: Plan, schooling: Int8s, crowd: Crowd) -> None:
    for strip in numba.prange(plan.squares):
        _gather_strip(strip, plan, schooling, crowd)


def make_crowd(capacity: int, columns: int, kinds: int, squares: int) -> Crowd:
    """Return a crowd with room for `capacity` fishes, as many columns in all and squares in all."""
    whole = [np.zeros(capacity, np.int32) for _ in range(4)]
    place = [np.zeros(capacity) for _ in range(8)]
    return Crowd(
        *(place[0], place[1], place[2], place[3], place[4], place[5], place[6], place[7]),
        np.zeros(capacity, np.int64),
        *(whole[0], whole[1], whole[2], whole[3]),
        first=np.zeros(columns + 2, np.int32),
        shoal=np.zeros((kinds, squares, _SUMS), np.int64),
    )


class Grid:
    """Scratch: the fishes in cell order, made anew each tick by `sort`."""

    def __init__(self, terrain: Terrain, senses: SenseTable) -> None:
        self.terrain, self.senses = terrain, senses
        self.plan = divide(terrain, senses, np.zeros(len(senses.length), np.int64))
        self.crowd = make_crowd(0, 0, 0, 0)
        self.order = self._by_layer = self._tally = np.zeros(0, np.int32)
        self._keys = np.zeros((0, 2), np.int32)

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

    def sort(self, population: Population, reorder: bool = False) -> None:
        """Sort the living fishes into cells; with `reorder` put their rows in that order too."""
        fish, number = population.fish, population.count
        counts = np.bincount(fish.species[:number], minlength=len(self.senses.length))
        self.plan = divide(self.terrain, self.senses, counts)
        self._fit(number)
        self._order(population)
        if reorder:
            population.reorder(self.order[:number].astype(np.int64))
            self._order(population)
        columns = (
            self.order, self._keys, fish.position, fish.last_position, fish.rotation, fish.length,
            fish.id, fish.species, self.crowd,
        )  # fmt: skip
        if number < SERIAL_BELOW:
            _copy(0, number, *columns)
            _gather_serially(self.plan, self.senses.schooling, self.crowd)
        else:
            _copy_all(number, *columns)
            _gather_all(self.plan, self.senses.schooling, self.crowd)

    def _order(self, population: Population) -> None:
        sort_cells(
            population.fish.position, population.count, self.plan, self._keys, self._tally,
            self._by_layer, self.order, self.crowd.first,
        )  # fmt: skip
