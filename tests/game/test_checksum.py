"""Checksums: every bit of every column counts."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from components.fish import FishTable
from components.mind import MindTable
from reefgame.checksum import hash_words, table_checksum


def filled(count: int = 7) -> FishTable:
    table = FishTable(count=count)
    table.position[:count] = np.random.default_rng(3).normal(size=(count, 3))
    return table


@given(row=st.integers(0, 6), axis=st.integers(0, 2))
def test_one_ulp_in_one_cell_changes_the_checksum(row: int, axis: int) -> None:
    table = filled()
    before = table_checksum(table)
    table.position[row, axis] = np.nextafter(table.position[row, axis], np.inf)
    assert table_checksum(table) != before


def test_dead_rows_do_not_count() -> None:
    table, other = filled(), filled()
    other.append(1)
    other.position[7] = 99.0
    other.remove(7)
    assert table_checksum(table) == table_checksum(other)


def test_columns_of_single_bytes_count_to_the_last() -> None:
    table = MindTable(count=5)
    before = table_checksum(table)
    table.intention[4] = 1
    assert table_checksum(table) != before


@given(st.lists(st.integers(0, 2**64 - 1), max_size=40), st.data())
def test_the_order_of_words_matters(words: list[int], data: st.DataObject) -> None:
    array = np.array(words, np.uint64)
    other = np.array(data.draw(st.permutations(words)), np.uint64)
    same = hash_words(array, np.uint64(1)) == hash_words(other, np.uint64(1))
    assert same == bool((array == other).all())
