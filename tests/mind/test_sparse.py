"""The coarse grid's lists: complete, in one order, and short in a swarm, whoever asks from where."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from components.arrays import Float64s
from systems.mind.sparse import LONGEST_RUN, MOST_LISTED, Sparse, list_sparse, sort_sparse

RADIUS, DEPTH = 20.0, 12.0


def sorted_points(points: Float64s) -> Sparse:
    number = len(points)
    zeros = np.zeros(number)
    room = Sparse(
        0.0, RADIUS, 0, 0, number, np.zeros(64 * 64 * 64, np.int32), zeros, zeros.copy(),
        zeros.copy(), np.zeros(number, np.int32), zeros.copy(), np.zeros(number, np.int32),
        np.ones(1, np.int32),
    )  # fmt: skip
    what, keys = np.arange(number, dtype=np.int32), np.zeros(number, np.int32)
    x, y, z = np.ascontiguousarray(points.T)
    cell, side, layers, _ = sort_sparse(room, DEPTH, 2.0, number, number, x, y, z, what, keys)
    return room._replace(cell=cell, side=side, layers=layers)


def listed_around(sparse: Sparse, at: Float64s, reach: float) -> list[int]:
    runs, listed = np.zeros(32, np.int32), np.zeros(MOST_LISTED + 1, np.int32)
    many = list_sparse(sparse, at[0], at[1], at[2], reach, runs, listed)
    return [int(sparse.what[k]) for k in listed[:many]]


def scattered(seed: int, number: int, wide: float) -> Float64s:
    drawn = np.random.default_rng(seed).uniform(-wide, wide, (number, 3))
    drawn[:, 2] = -np.abs(drawn[:, 2]) % DEPTH
    return drawn


@given(st.integers(0, 999), st.integers(1, 400), st.floats(0.5, RADIUS))
def test_a_list_holds_who_is_within_reach(seed: int, number: int, wide: float) -> None:
    points = scattered(seed, number, wide)
    sparse, at = sorted_points(points), points[0]
    reach = 1.49 * sparse.cell
    near = np.flatnonzero(((points - at) ** 2).sum(axis=1) < (0.999 * reach) ** 2)
    listed = listed_around(sparse, at, reach)
    assert len(listed) == len(set(listed))
    assert set(near.tolist()) <= set(listed)


@given(st.integers(0, 999), st.sampled_from([30, 300, 6000]), st.floats(0.1, 3.0))
def test_two_lists_agree_about_who_is_near_both(seed: int, number: int, wide: float) -> None:
    points = scattered(seed, number, wide)
    sparse = sorted_points(points)
    a, b = points[0], points[-1]
    one, other = (listed_around(sparse, at, 1.49 * sparse.cell) for at in (a, b))
    both = set(one) & set(other)
    assert [k for k in one if k in both] == [k for k in other if k in both]
    reach = (1.4 * sparse.cell) ** 2
    shared = [k for k in one if ((points[k] - b) ** 2).sum() < reach]
    assert set(shared) <= both


def test_of_a_swarm_in_one_place_some_are_listed_and_the_same_from_anywhere() -> None:
    points = np.full((20 * LONGEST_RUN, 3), -1.0)
    sparse = sorted_points(points)
    listed = listed_around(sparse, points[0], sparse.cell)
    assert LONGEST_RUN // 2 <= len(listed) <= LONGEST_RUN + 1
    assert listed == listed_around(sparse, points[0] + 0.3, sparse.cell)
