"""What a launch is given is read once while it is the same objects, and anew when it is not."""

import gc
import weakref
from typing import Any, NamedTuple

import numba
import numpy as np
import pytest

from components.arrays import Float64s
from components.kernels import Launch, loop, row


class Pair(NamedTuple):
    a: Float64s
    b: Float64s
    times: int


class Nest(NamedTuple):
    pair: Pair
    step: float


@row
def total(pair: Pair, more: Float64s, step: float) -> float:
    whole = 0.0
    for value in pair.a:
        whole += value
    for value in pair.b:
        whole += pair.times * value
    return float(whole + more[0] + step)


@row
def total_of_nest(nest: Nest) -> float:
    return total(nest.pair, nest.pair.a, nest.step)


@loop
def add_to_all(pair: Pair, step: float) -> None:
    a, b = pair.a, pair.b
    for i in numba.prange(len(a)):
        a[i] += step * b[i]


@pytest.fixture
def pair() -> Pair:
    return Pair(np.arange(3.0), np.ones(2), 2)


def test_elements_are_read_in_each_call_and_so_are_numbers(pair: Pair) -> None:
    launch, more = Launch(total), np.zeros(1)
    assert launch(pair, more, 0.0) == 7.0
    pair.a[0], pair.b[1], more[0] = 10.0, 2.0, 100.0
    assert launch(pair, more, 0.5) == 119.5


def test_other_arrays_and_numbers_in_a_tuple_are_noticed(pair: Pair) -> None:
    launch, more = Launch(total), np.zeros(1)
    assert launch(pair, more, 0.0) == 7.0
    assert launch(pair._replace(a=np.ones(5)), more, 0.0) == 9.0
    assert launch(pair._replace(times=3), more, 0.0) == 9.0
    assert launch(pair, np.ones(1), 0.0) == 8.0
    assert launch(pair, more, 0.0) == 7.0


def test_tuples_within_tuples_are_noticed(pair: Pair) -> None:
    launch, nest = Launch(total_of_nest), Nest(pair, 0.5)
    assert launch(nest) == 7.5
    assert launch(nest._replace(step=1.5)) == 8.5
    assert launch(Nest(pair._replace(b=np.zeros(1)), 0.0)) == 3.0
    assert launch(nest) == 7.5


def test_what_is_gone_is_not_taken_for_what_lies_in_its_place() -> None:
    launch = Launch(total)
    for number in range(1, 50):
        fresh = Pair(np.ones(number), np.ones(2 * number), 1)
        assert launch(fresh, np.zeros(1), 0.0) == 3.0 * number
        del fresh


def test_a_refused_argument_leaves_nothing_half_read(pair: Pair) -> None:
    launch, more = Launch(total), np.zeros(1)
    assert launch(pair, more, 0.0) == 7.0
    nothing: Any = None
    other: Any = (np.ones(9), pair.b)
    with pytest.raises(TypeError, match="unbox array"):
        launch(Pair(np.ones(9), nothing, 2), more, 0.0)
    assert launch(pair, more, 0.0) == 7.0
    with pytest.raises(ValueError, match="size mismatch for tuple, expected 3 element"):
        launch(other, more, 0.0)
    assert launch(pair, more, 0.0) == 7.0


def test_launches_of_one_kernel_do_not_mix_up_what_they_were_given(pair: Pair) -> None:
    one, other, more = Launch(total), Launch(total), np.zeros(1)
    longer = pair._replace(a=np.ones(10))
    for _ in range(2):
        assert one(pair, more, 0.0) == 7.0
        assert other(longer, more, 0.0) == 14.0
        assert total(pair, more, 1.0) == 8.0


def test_a_launch_keeps_its_last_arguments_alive_and_no_longer_than_itself() -> None:
    launch, more = Launch(total), np.zeros(1)
    first, second = np.ones(1), np.ones(2)
    of_first, of_second = weakref.ref(first), weakref.ref(second)
    launch(Pair(first, more, 1), more, 0.0)
    launch(Pair(second, more, 1), more, 0.0)
    del first, second
    assert of_first() is None
    assert of_second() is not None
    del launch
    gc.collect()
    assert of_second() is None


def test_parallel_kernels_read_as_serial_ones_do(pair: Pair) -> None:
    launch, equal = Launch(add_to_all), pair._replace(b=np.ones(3))
    for _ in range(2):
        launch(equal, 2.0)
    launch(equal._replace(a=pair.b), 1.0)
    assert equal.a.tolist() == [4.0, 5.0, 6.0]
    assert pair.b.tolist() == [2.0, 2.0]
