"""Where an id's row is: a hash table of as many places as fishes live, whatever ids were ever given (DESIGN 2).

Open addressing with linear steps; who leaves keeps a place until the table is built anew.
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Int64s
from components.chance import mix
from components.kernels import row, serial

_FREE: Final = -1
_SMALLEST: Final = 32


class Places(NamedTuple):
    """The table, as kernels read it: its size is a power of two."""

    id: Int64s
    "id at each place, -1 where free, (size,)"
    row: Int64s
    "row of that id, -1 where it left, (size,)"


@row
def _place_of(places: Places, identity: int) -> int:
    """Return the place that holds `identity`, else the free one where it belongs."""
    mask = len(places.id) - 1
    place = int(np.int64(mix(np.uint64(identity)) & np.uint64(mask)))
    while places.id[place] != identity and places.id[place] != _FREE:
        place = (place + 1) & mask
    return place


@row
def row_of(places: Places, identity: int) -> int:
    """Return the row of the id, -1 where there is none."""
    if identity < 0:
        return -1
    place = _place_of(places, identity)
    row: int = places.row[place] if places.id[place] == identity else -1
    return row


@serial
def rows_of(places: Places, ids: Int64s) -> Int64s:
    """Return the rows of the ids, -1 where there is none; (n,) each."""
    rows = np.empty(len(ids), np.int64)
    for at in range(len(ids)):
        rows[at] = row_of(places, ids[at])
    return rows


@row
def _point(places: Places, ids: Int64s, first: int) -> int:
    """Let ids[i] lead to row first + i; return how many free places that took."""
    taken = 0
    ids_at, rows_at = places
    for at in range(len(ids)):
        place = _place_of(places, ids[at])
        taken += ids_at[place] == _FREE
        ids_at[place] = ids[at]
        rows_at[place] = first + at
    return taken


class RowIndex:
    """The rows of all living ids."""

    def __init__(self) -> None:
        self._places = Places(np.empty(0, np.int64), np.empty(0, np.int64))
        self.rebuild(np.empty(0, np.int64))

    @property
    def places(self) -> Places:
        """The table; another after ids were added, or rebuilt to another size."""
        return self._places

    def rebuild(self, ids: Int64s) -> None:
        """Let ids[i] lead to row i, and no other id to any."""
        size = _SMALLEST
        while size < 3 * len(ids):
            size *= 2
        if size != len(self._places.id):
            self._places = Places(np.empty(size, np.int64), np.empty(size, np.int64))
        self._places.id[:], self._places.row[:] = _FREE, -1
        self._taken = _point(self._places, ids, 0)

    def add(self, ids: Int64s, first: int) -> bool:
        """Let new ids[i] lead to row first + i; return False where they find no room: rebuild then."""
        if 3 * (self._taken + len(ids)) > 2 * len(self._places.id):
            return False
        self._taken += _point(self._places, ids, first)
        return True

    def move(self, identity: int, row: int) -> None:
        """Let an id that is known lead to `row`; -1 forgets it."""
        self._places.row[_place_of(self._places, identity)] = row

    def row(self, identity: int) -> int:
        """Return the row of the id, -1 where there is none."""
        return int(row_of(self._places, identity))
