"""The crowd: the fishes copied in the order of cells, as minds see each other (FINDINGS 5).

In a column the deeper come later, within a cell they stand by id: nothing that minds see depends on the order of rows.
"""

from math import sqrt
from typing import Final, NamedTuple

import numba
import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.index import Places, row_of
from components.kernel_turns import first_turn, next_turn
from components.kernels import inlined, loop, row
from components.mind import Intention
from components.prefetch import prefetch

SUMS: Final = 7
"""Whole numbers to a shoal."""

READY: Final = 0.25
"""Libido from which a fish answers a mate."""

_AHEAD: Final = 12
"""Places ahead of the one copied at which rows are asked for."""

_MATE: Final = int(Intention.MATE)


class Crowd(NamedTuple):
    """The fishes in the order of cells, as minds see each other; (capacity,) each but the last three."""

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
    stretch: Int32s
    """what those who think in this tick may look at: begin and end of the places copied, the first strip of squares
    summed and the one after the last, (4,)"""


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


class Sorting(NamedTuple):
    """How the fishes are put in order; (capacity,) each."""

    column: Int32s
    "column of each row"
    layer: Int32s
    "layer of each row"
    by_column: Int32s
    "the rows by column"
    order: Int32s
    "the rows by column, layer and id; until they are sorted as they were a tick ago"


@inlined
def place_of(places: Places, crowd: Crowd, identity: int) -> int:
    """Return where the fish `identity` stands in the crowd, -1 where it lives no more or too far away to be copied."""
    if identity < 0:
        return -1
    i = row_of(places, identity)
    if i < 0:
        return -1
    k = crowd.place[i]
    # Who is not copied has an old place, where another stands now.
    return k if crowd.stretch[0] <= k < crowd.stretch[1] and crowd.row[k] == i else -1


@inlined
def _column_from(place: int, number: int, sorting: Sorting) -> int:
    """Return the first place from `place` on at which a column begins."""
    column, by_column = sorting.column, sorting.by_column
    while 0 < place < number and column[by_column[place]] == column[by_column[place - 1]]:
        place += 1
    return place


@inlined
def _after(a: int, b: int, layer: Int32s, identity: Int64s) -> bool:
    """Return whether the row a comes after b in a column: it is deeper, or its id larger."""
    deeper = layer[a] > layer[b]
    return bool(deeper | ((layer[a] == layer[b]) & (identity[a] > identity[b])))


@row
def _sort_column(begin: int, end: int, order: Int32s, layer: Int32s, identity: Int64s) -> None:
    """Order a column's rows by layer and id: Shell's sort, which is plain insertion for the usual few."""
    gap = 1
    while gap < (end - begin) // 9:
        gap = 3 * gap + 1
    while gap > 0:
        for k in range(begin + gap, end):
            this, at = order[k], k
            while at >= begin + gap and _after(order[at - gap], this, layer, identity):
                order[at] = order[at - gap]
                at -= gap
            order[at] = this
        gap //= 3


@inlined
def _ask_for(rows: Rows, i: int) -> None:
    """Ask for what is copied of row i."""
    prefetch(rows.position, i)
    prefetch(rows.last_position, i)
    prefetch(rows.rotation, i)
    prefetch(rows.length, i)
    prefetch(rows.id, i)
    prefetch(rows.focus, i)
    prefetch(rows.libido, i)


@inlined
def _copy_one(k: int, i: int, sorting: Sorting, rows: Rows, crowd: Crowd) -> None:
    """Copy the fish of row i to the place k."""
    x, y, z = rows.position[i, 0], rows.position[i, 1], rows.position[i, 2]
    crowd.x[k], crowd.y[k], crowd.z[k] = x, y, z
    crowd.hx[k], crowd.hy[k] = rows.rotation[i, 0, 0], rows.rotation[i, 1, 0]
    crowd.hz[k] = rows.rotation[i, 2, 0]
    dx, dy = x - rows.last_position[i, 0], y - rows.last_position[i, 1]
    dz = z - rows.last_position[i, 2]
    crowd.speed[k] = 60.0 * sqrt(dx * dx + dy * dy + dz * dz)
    crowd.length[k], crowd.id[k], crowd.species[k] = rows.length[i], rows.id[i], rows.species[i]
    crowd.phase[k] = rows.courtship[i]
    crowd.courting[k] = rows.focus[i] if rows.intention[i] == _MATE else -1
    crowd.ready[k] = rows.libido[i] >= READY
    crowd.row[k], crowd.place[i] = i, k
    crowd.column[k], crowd.layer[k] = sorting.column[i], sorting.layer[i]


@row
def copy_columns(
    begin: int, end: int, number: int, sorting: Sorting, rows: Rows, crowd: Crowd
) -> None:
    """Put the columns that begin within begin..end in order, and copy them."""
    begin, end = _column_from(begin, number, sorting), _column_from(end, number, sorting)
    order, column, layer = sorting.order, sorting.column, sorting.layer
    for k in range(begin, end):
        order[k] = sorting.by_column[k]
    start = begin
    for k in range(begin + 1, end):
        here, before = order[k], order[k - 1]
        same = column[here] == column[before]
        start = start if same else k
        # Seldom: the last tick's order stands, but for those who have changed cells.
        if same & _after(before, here, layer, rows.id):
            _sort_column(start, _column_from(k + 1, number, sorting), order, layer, rows.id)
    for k in range(begin, end):
        _ask_for(rows, order[min(k + _AHEAD, end - 1)])
        _copy_one(k, order[k], sorting, rows, crowd)


@loop
def copy_all(
    pieces: int, begin: int, end: int, number: int, sorting: Sorting, rows: Rows, crowd: Crowd
) -> None:
    """Copy the columns that begin within begin..end on all threads, a share to each of `pieces`."""
    turns = first_turn()
    for share in numba.prange(pieces):
        piece = next_turn(turns, share, pieces)
        while piece < pieces:
            first = begin + (end - begin) * piece // pieces
            last = begin + (end - begin) * (piece + 1) // pieces
            copy_columns(first, last, number, sorting, rows, crowd)
            piece = next_turn(turns, share, pieces)


def make_sorting(capacity: int) -> Sorting:
    """Return room to sort `capacity` fishes."""
    return Sorting(*(np.zeros(capacity, np.int32) for _ in Sorting._fields))


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
        phase=np.zeros(capacity, np.int8),
        courting=np.full(capacity, -1, np.int64),
        ready=np.zeros(capacity, np.int8),
        row=wholes(),
        place=wholes(),
        column=wholes(),
        layer=wholes(),
        first=np.zeros(columns + 2, np.int32),
        shoal=np.zeros((kinds, squares, SUMS), np.int64),
        stretch=np.zeros(4, np.int32),
    )
