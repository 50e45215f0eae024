"""Turns: every piece is taken, by one thread, however many there are of either."""

import numba
import numpy as np
import pytest

from components.arrays import Int64s
from components.kernel_turns import first_turn, next_turn
from components.kernels import loop, row, serial
from systems.motor.swim import CHUNKS, place_of_turn


@row
def count_in_turn(turns: int, share: int, pieces: int, taken: Int64s) -> None:
    piece = next_turn(turns, share, pieces)
    while piece < pieces:
        taken[piece] += 1
        piece = next_turn(turns, share, pieces)


@loop
def count(pieces: int, taken: Int64s) -> None:
    turns = first_turn()
    for share in numba.prange(pieces):
        count_in_turn(turns, share, pieces, taken)


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


@row
def take(turns: int, shares: Int64s, pieces: int, taken: Int64s) -> None:
    for k in range(len(shares)):
        taken[k] = next_turn(turns, shares[k], pieces)


@serial
def order(shares: Int64s, pieces: int) -> Int64s:
    taken = np.zeros(len(shares), np.int64)
    take(first_turn(), shares, pieces, taken)
    return taken


def test_the_first_shares_take_from_the_front_and_the_last_from_the_back_until_they_meet() -> None:
    assert order(np.array([0, 4, 0, 2, 3, 1, 0]), 5).tolist() == [0, 4, 1, 2, 3, 5, 5]
    assert order(np.array([0, 0, 0, 0, 4]), 3).tolist() == [0, 1, 2, 3, 3]


def test_a_fish_swims_on_the_thread_that_it_thinks_on() -> None:
    places = np.array([place_of_turn(chunk) for chunk in range(CHUNKS)])
    assert sorted(places) == list(range(CHUNKS))
    front_of_its_quarter = places % (CHUNKS // 4) < CHUNKS // 8
    assert front_of_its_quarter.tolist() == [True] * (CHUNKS // 2) + [False] * (CHUNKS // 2)
