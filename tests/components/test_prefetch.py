"""Prefetching asks the processor for a row, and changes nothing: before the array's end and beyond it."""

import numba
import numpy as np
import pytest

from components.arrays import Float64s
from components.kernels import row
from components.prefetch import prefetch


@row
def add_up(column: Float64s, ahead: int) -> float:
    total = 0.0
    for i in range(len(column)):
        prefetch(column, i + ahead)
        total += column[i]
    return total


@row
def add_up_vectors(column: Float64s, ahead: int) -> float:
    total = 0.0
    for i in range(len(column)):
        prefetch(column, i + ahead)
        total += column[i, 0] + column[i, 2]
    return total


@pytest.mark.parametrize("ahead", [0, 12, 10**9])
def test_asking_ahead_changes_nothing(ahead: int) -> None:
    numbers = np.arange(300.0)
    assert add_up(numbers, ahead) == numbers.sum()
    vectors = numbers.reshape(100, 3)
    assert add_up_vectors(vectors, ahead) == vectors[:, [0, 2]].sum()


def test_the_processor_is_asked() -> None:
    compiled = numba.njit(add_up.py_func)  # type: ignore[attr-defined]  # anew: a kept kernel shows no code
    compiled(np.arange(3.0), 1)
    (code,) = compiled.inspect_asm().values()
    assert "prefetch" in code or "prfm" in code
