"""Tables: a machine that appends, removes, reorders, snapshots and restores, against a plain list."""

from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from components.arrays import Float64s, Int64s
from components.table import Columns, Table, column


class _Things(Table):
    """A table with a scalar and a vector column."""

    number: Int64s = column(np.int64, fill=-1)
    "(capacity,)"
    place: Float64s = column(np.float64, 3)
    "(capacity, 3)"


class _Machine(RuleBasedStateMachine):
    def __init__(self) -> None:
        super().__init__()
        self.table = _Things(capacity=2)
        self.rows: list[tuple[int, float]] = []
        self.saved: tuple[dict[str, Any], list[tuple[int, float]]] = (self.table.snapshot(), [])
        self.next = 0

    @rule(number=st.integers(0, 9))
    def append(self, number: int) -> None:
        rows = self.table.append(number)
        assert rows == slice(len(self.rows), len(self.rows) + number)
        assert (self.table.number[rows] == -1).all()
        assert (self.table.place[rows] == 0.0).all()
        for row in range(rows.start, rows.stop):
            self.table.number[row] = self.next
            self.table.place[row] = self.next / 7
            self.rows.append((self.next, self.next / 7))
            self.next += 1

    @precondition(lambda self: self.rows)
    @rule(data=st.data())
    def remove(self, data: st.DataObject) -> None:
        row = data.draw(st.integers(0, len(self.rows) - 1))
        self.table.remove(row)
        self.rows[row] = self.rows[-1]
        self.rows.pop()

    @rule(data=st.data())
    def reorder(self, data: st.DataObject) -> None:
        order = data.draw(st.permutations(range(len(self.rows))))
        self.table.reorder(np.array(order, np.int64))
        self.rows = [self.rows[k] for k in order]

    @rule()
    def snapshot(self) -> None:
        self.saved = (self.table.snapshot(), list(self.rows))

    @rule()
    def restore(self) -> None:
        self.table.restore(self.saved[0])
        self.rows = list(self.saved[1])

    @rule()
    def miss(self) -> None:
        with pytest.raises(IndexError):
            self.table.remove(len(self.rows))
        with pytest.raises(IndexError):
            self.table.remove(-1)

    @invariant()
    def the_rows_are_the_list_s(self) -> None:
        assert self.table.count == len(self.rows) <= self.table.capacity
        assert self.table.live("number").tolist() == [number for number, _ in self.rows]
        places = self.table.live("place")
        assert places.shape == (len(self.rows), 3)
        assert (places == np.array([[place] for _, place in self.rows]).reshape(-1, 1)).all()


TestTables = _Machine.TestCase
TestTables.settings = settings(max_examples=60, stateful_step_count=30, deadline=None)


def test_a_new_row_forgets_what_stood_there() -> None:
    table = _Things(count=2)
    table.number[:2], table.place[:2] = 5, 1.0
    table.remove(1)
    table.append(1)
    assert table.number[1] == -1
    assert (table.place[1] == 0.0).all()


def test_tables_share_no_rows_and_no_columns() -> None:
    class More(_Things):
        extra: Float64s = column(np.float64)
        "(capacity,)"

    one, other = _Things(count=1), More(count=1)
    one.number[0] = 9
    assert other.number[0] == -1
    assert set(More.columns) == {"number", "place", "extra"}
    assert set(_Things.columns) == {"number", "place"}


class _Numbers(NamedTuple):
    place: Float64s
    number: Int64s


def test_columns_of_tables_that_have_grown_are_theirs() -> None:
    class Others(Table):
        place: Float64s = column(np.float64)
        "(capacity,)"

    others, things = Others(count=1), _Things(count=2)
    columns = Columns(_Numbers, others, things)
    before = columns()
    assert before.place is others.place
    assert before.number is things.number
    assert columns() is before
    things.append(things.capacity)
    assert columns().number is things.number
    others.restore({"place": np.arange(99.0)})
    assert columns().place is others.place
    assert columns().place[98] == 98.0
