"""Who is near whom: fishes sorted into the cells of a grid, and copied in the cells' order (FINDINGS 5).

The plan is divided into square columns, each column into layers as high as a cell is wide. Fishes are counted into
layers, then into columns, so that a column's fishes lie together, the deeper the later; what minds look at is copied
in that order. Within a cell they stand by id, so nothing that minds see depends on the order of rows.

"""

from math import ceil, sqrt
from typing import Final, NamedTuple

import numba
import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.fish import Population
from components.ground import Terrain
from components.kernels import Launch, inlined, loop, row
from components.mind import Intention
from components.senses import SenseTable
from components.table import Columns

REACH: Final = 2.5
"""Body lengths within which fishes tell their neighbours apart in a crowd: a dozen in a school."""

_PER_THREAD: Final = 8

PIECES: Final = _PER_THREAD * numba.config.NUMBA_NUM_THREADS
"""Pieces of a parallel loop over fishes: more even out what they cost, and each costs a start."""

SERIAL_BELOW: Final = 500
"""Fishes below which one thread is quicker than two."""

_FEWEST_COLUMNS: Final = 16
_MOST_COLUMNS: Final = 512
SUMS: Final = 7
"""Whole numbers to a shoal."""

READY: Final = 0.25
"""Libido from which a fish answers a mate."""

_MATE: Final = int(Intention.MATE)


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
    intention: Int8s
    "the `Intention` of the last thought"
    phase: Int8s
    "the `Courtship`"
    courting: Int64s
    "stable id of the partner that one who mates attends to, -1 for none"
    ready: Int8s
    "1 where libido suffices to answer a mate"
    row: Int32s
    "row in the fishes' tables"
    place: Int32s
    "where the fish of a row stands here: the inverse of `row`"
    column: Int32s
    "column of the plan"
    layer: Int32s
    "layer of the column"
    first: Int32s
    "where each column begins, (columns^2 + 2,)"
    shoal: Int64s
    "number, sums of x, y, z [m / FIXED] and of heading, (species, squares^2, 7)"


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


class Rows(NamedTuple):
    """The columns of the fishes' tables that a crowd copies."""

    position: Float64s
    last_position: Float64s
    rotation: Float64s
    length: Float64s
    id: Int64s
    species: Int32s
    intention: Int8s
    courtship: Int8s
    focus: Int64s
    libido: Float64s


@inlined
def _cell_from(place: int, number: int, order: Int32s, keys: Int32s) -> int:
    """Return the first place from `place` on at which a cell begins."""
    while 0 < place < number:
        here, before = order[place], order[place - 1]
        if keys[here, 0] != keys[before, 0] or keys[here, 1] != keys[before, 1]:
            return place
        place += 1
    return place


@row
def _by_id(begin: int, end: int, order: Int32s, identity: Int64s) -> None:
    """Order a cell's rows by id: Shell's sort, which is plain insertion for the usual few."""
    gap = 1
    while gap < (end - begin) // 9:
        gap = 3 * gap + 1
    while gap > 0:
        for k in range(begin + gap, end):
            this, at = order[k], k
            while at >= begin + gap and identity[order[at - gap]] > identity[this]:
                order[at] = order[at - gap]
                at -= gap
            order[at] = this
        gap //= 3


@inlined
def _copy_one(k: int, i: int, keys: Int32s, rows: Rows, crowd: Crowd) -> None:
    """Copy the fish of row i to the place k."""
    x, y, z = rows.position[i, 0], rows.position[i, 1], rows.position[i, 2]
    crowd.x[k], crowd.y[k], crowd.z[k] = x, y, z
    crowd.hx[k], crowd.hy[k] = rows.rotation[i, 0, 0], rows.rotation[i, 1, 0]
    crowd.hz[k] = rows.rotation[i, 2, 0]
    dx, dy = x - rows.last_position[i, 0], y - rows.last_position[i, 1]
    dz = z - rows.last_position[i, 2]
    crowd.speed[k] = 60.0 * sqrt(dx * dx + dy * dy + dz * dz)
    crowd.length[k], crowd.id[k], crowd.species[k] = rows.length[i], rows.id[i], rows.species[i]
    crowd.intention[k], crowd.phase[k] = rows.intention[i], rows.courtship[i]
    crowd.courting[k] = rows.focus[i] if rows.intention[i] == _MATE else -1
    crowd.ready[k] = rows.libido[i] >= READY
    crowd.row[k], crowd.place[i] = i, k
    crowd.column[k], crowd.layer[k] = keys[i, 0], keys[i, 1]


@row
def _copy(
    begin: int, end: int, number: int, order: Int32s, keys: Int32s, rows: Rows, crowd: Crowd
) -> None:
    """Copy the cells that begin within begin..end."""
    begin, end = _cell_from(begin, number, order, keys), _cell_from(end, number, order, keys)
    cell = begin
    for k in range(begin + 1, end):
        here, before = order[k], order[k - 1]
        same = (keys[here, 0] == keys[before, 0]) & (keys[here, 1] == keys[before, 1])
        cell = cell if same else k
        # Seldom: the last tick's order stands, but for those who have changed cells.
        if same & (rows.id[here] < rows.id[before]):
            _by_id(cell, _cell_from(k + 1, number, order, keys), order, rows.id)
    for k in range(begin, end):
        _copy_one(k, order[k], keys, rows, crowd)


@loop
def _copy_all(
    pieces: int, number: int, order: Int32s, keys: Int32s, rows: Rows, crowd: Crowd
) -> None:
    for piece in numba.prange(pieces):
        begin, end = number * piece // pieces, number * (piece + 1) // pieces
        _copy(begin, end, number, order, keys, rows, crowd)


def make_crowd(capacity: int, columns: int, kinds: int, squares: int) -> Crowd:
    """Return a crowd with room for `capacity` fishes, as many columns in all and squares in all."""

    def reals() -> Float64s:
        return np.zeros(capacity)

    def wholes() -> Int32s:
        return np.zeros(capacity, np.int32)

    return Crowd(
        *(reals(), reals(), reals(), reals(), reals(), reals(), reals(), reals()),
        id=np.zeros(capacity, np.int64),
        species=wholes(),
        intention=np.zeros(capacity, np.int8),
        phase=np.zeros(capacity, np.int8),
        courting=np.full(capacity, -1, np.int64),
        ready=np.zeros(capacity, np.int8),
        row=wholes(),
        place=wholes(),
        column=wholes(),
        layer=wholes(),
        first=np.zeros(columns + 2, np.int32),
        shoal=np.zeros((kinds, squares, SUMS), np.int64),
    )


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
        self._copy, self._copy_all = Launch(_copy), Launch(_copy_all)

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
