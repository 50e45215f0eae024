"""Turns: every piece is taken, by one thread, however many there are of either."""

import numba
import numpy as np
import pytest

from components.arrays import Int64s
from components.kernel_turns import first_turn, next_turn
from components.kernels import loop, row


@row
def count_in_turn(turns: int, pieces: int, taken: Int64s) -> None:
    piece = next_turn(turns)
    while piece < pieces:
        taken[piece] += 1
        piece = next_turn(turns)


@loop
def count(pieces: int, taken: Int64s) -> None:
    turns = first_turn()
    for _ in numba.prange(pieces):
        count_in_turn(turns, pieces, taken)


@row
def count_twice(pieces: int, taken: Int64s) -> None:
    count(pieces, taken)
    count(pieces, taken)


@pytest.mark.parametrize("pieces", [0, 1, 7, 100_000])
def test_each_piece_is_taken_once_in_every_loop(pieces: int) -> None:
    taken = np.zeros(pieces, np.int64)
    count(pieces, taken)
    assert (taken == 1).all()
    count_twice(pieces, taken)
    assert (taken == 3).all()
