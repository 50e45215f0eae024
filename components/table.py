"""Struct-of-arrays tables: one row an entity, capacity doubling, removal by moving the last row
(DESIGN 2).

A table declares its columns in the class body and documents each one's unit and shape:

    class FoodTable(Table):
        position: Float64s = column(np.float64, 3)
        "[m], (capacity, 3)"

Only rows below `count` live. Arrays of columns go stale when the table grows; `Columns` hands kernels those that hold.
"""

from math import prod
from typing import Any, ClassVar, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import DTypeLike

from components.arrays import AnyArray, Int64s

_Named = TypeVar("_Named", bound=tuple[Any, ...])


class Column(NamedTuple):
    """One declared column: its type, the shape of one row's value and what a new row holds."""

    dtype: DTypeLike
    shape: tuple[int, ...]
    fill: float


def column(dtype: DTypeLike, *shape: int, fill: float = 0) -> Any:
    """Declare a column of `dtype` whose value in one row has `shape`; new rows hold `fill`."""
    return Column(dtype, shape, fill)


class Table:
    """Arrays of equal capacity, one row an entity; `count` rows live."""

    columns: ClassVar[dict[str, Column]] = {}
    growths: ClassVar[int] = 0
    "how often any table has grown since the start"

    def __init_subclass__(cls) -> None:
        """Collect the columns that the class body declares."""
        declared = {n: v for n, v in vars(cls).items() if isinstance(v, Column)}
        cls.columns = {**cls.columns, **declared}

    def __init__(self, count: int = 0, capacity: int = 16) -> None:
        self.count = 0
        self.capacity = max(capacity, count, 1)
        for name, spec in self.columns.items():
            setattr(self, name, np.zeros((self.capacity, *spec.shape), spec.dtype))
        self.append(count)

    def append(self, number: int) -> slice:
        """Add `number` rows holding their columns' fill values; return where they stand."""
        first, self.count = self.count, self.count + number
        if self.count > self.capacity:
            self._grow(self.count)
        for name, spec in self.columns.items():
            getattr(self, name)[first : self.count] = spec.fill
        return slice(first, self.count)

    def remove(self, row: int) -> None:
        """Move the last row into `row` and forget the last. Raise IndexError where no such row lives."""
        if not 0 <= row < self.count:
            raise IndexError(f"row {row} of {self.count}")
        last = self.count - 1
        for name in self.columns:
            values = getattr(self, name)
            values[row] = values[last]
        self.count = last

    def reorder(self, order: Int64s) -> None:
        """Put row `order[i]` at i, for a permutation `order` of shape (count,)."""
        for name, spec in self.columns.items():
            # A number of each row at a time: whole rows twice over would be what a large world's memory peaks with.
            for values in self.live(name).reshape(self.count, prod(spec.shape)).T:
                values[:] = values[order]

    def live(self, name: str) -> AnyArray:
        """Return a view of the living rows of the column `name`."""
        values: AnyArray = getattr(self, name)[: self.count]
        return values

    def snapshot(self) -> dict[str, AnyArray]:
        """Return copies of every column's living rows."""
        return {name: self.live(name).copy() for name in self.columns}

    def restore(self, saved: dict[str, AnyArray]) -> None:
        """Make the living rows equal to `saved`, as `snapshot` returned it."""
        self.count = len(next(iter(saved.values())))
        if self.count > self.capacity:
            self._grow(self.count)
        for name in self.columns:
            getattr(self, name)[: self.count] = saved[name]

    def _grow(self, needed: int) -> None:
        Table.growths += 1
        while self.capacity < needed:
            self.capacity *= 2
        for name, spec in self.columns.items():
            old = getattr(self, name)
            # Pages of zeros that no row touches yet take no memory; `append` fills the rows.
            new = np.zeros((self.capacity, *spec.shape), spec.dtype)
            new[: len(old)] = old
            setattr(self, name, new)


class Columns(Generic[_Named]):
    """The columns that a kernel takes, as the NamedTuple `kind` names them: the same tuple until a table has grown."""

    def __init__(self, kind: type[_Named], *tables: Table) -> None:
        """Take the tables; where two have a column of one name, that of the first counts."""
        self._kind, self._tables = kind, tables
        self._look_up()

    def __call__(self) -> _Named:
        """Return the columns; stale when a table grows."""
        if self._growths != Table.growths:
            self._look_up()
        return self._columns

    def _look_up(self) -> None:
        tables = {name: table for table in reversed(self._tables) for name in table.columns}
        names: tuple[str, ...] = self._kind._fields  # type: ignore[attr-defined]  # a NamedTuple
        self._columns = self._kind(*(getattr(tables[name], name) for name in names))
        self._growths = Table.growths
