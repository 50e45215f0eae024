"""Kernels as callees, fields of tuples read once, and kernels as systems launch them."""

from typing import NamedTuple

import numpy as np
import pytest

from components.arrays import Float64s
from components.kernel_dispatch import Kernel
from components.kernels import Launch, row


class Pair(NamedTuple):
    a: Float64s
    b: Float64s


class Scene(NamedTuple):
    near: Pair
    far: Pair
    step: float


@row
def scaled(values: Float64s, i: int, by: int) -> float:
    return float(values[i]) * by


@row
def sum_scaled(values: Float64s) -> float:
    total = 0.0
    for i in range(len(values)):
        total += scaled(values, i, 2) + scaled(values, i, 3)
    return total


@row
def advance(scene: Scene, count: int) -> float:
    last = 0.0
    for i in range(count):
        near, far = scene.near, scene.far
        if near.a[i] > 0.5:
            near, far = far, near
        near.b[i] += scene.step * scene.far.a[i]
        last = far.b[i]
    return last


@row
def at(values: Float64s, i: int) -> float:
    return float(values[i])


@row
def last(values: Float64s) -> float:
    return float(values[-1])


@row
def tripled(values: Float64s, i: int) -> float:
    return 3.0 * float(values[i])


@row
def sum_tripled(values: Float64s) -> float:
    return tripled(values, 1) + tripled(values, 2)


for kernel in (scaled, sum_scaled, tripled, sum_tripled):
    # Compiled anew in each run: what comes from the cache has no callees to look at.
    setattr(kernel, "caches", None)  # noqa: B010  # to mypy it is a function


@pytest.fixture
def values() -> Float64s:
    return np.arange(4.0)


def test_constants_share_one_callee(values: Float64s) -> None:
    assert sum_scaled(values) == 30.0
    assert isinstance(scaled, Kernel)
    assert scaled._callee is not None
    assert len(scaled._callee.overloads) == 1


def test_a_callee_is_compiled_for_python_when_python_calls_it(values: Float64s) -> None:
    assert sum_scaled(values) == 30.0
    assert scaled(values, 3, 2) == 6.0


def test_callers_take_a_kernel_in_that_python_called_first(values: Float64s) -> None:
    assert tripled(values, 1) == 3.0
    assert sum_tripled(values) == 9.0
    assert isinstance(tripled, Kernel)
    assert tripled._callee is not None
    taken = [compiled.library for compiled in tripled._callee.overloads.values()]
    assert [type(library).__name__ for library in taken] == ["_CalleeLibrary"]


def test_fields_that_change_hands_are_read_where_they_are() -> None:
    def scene() -> Scene:
        arrays = [np.array([0.0, 1.0, 0.2]) + k for k in range(4)]
        return Scene(Pair(arrays[0], arrays[1]), Pair(arrays[2], arrays[3]), 0.5)

    ours, plain = scene(), scene()
    assert advance(ours, 3) == advance.py_func(plain, 3)  # type: ignore[attr-defined]  # a numba kernel
    assert np.array_equal(ours.near.b, plain.near.b)
    assert np.array_equal(ours.far.b, plain.far.b)


def test_only_constant_indices_count_from_the_end(values: Float64s) -> None:
    assert last(values[1:]) == 3.0
    assert at(values[1:], 1) == 2.0
    assert at(values[1:], -1) == 0.0


def test_a_launch_looks_at_types_once(values: Float64s, monkeypatch: pytest.MonkeyPatch) -> None:
    launch = Launch(sum_scaled)
    assert launch(values) == 30.0
    monkeypatch.setattr("components.kernels.entry", None)
    assert launch(2.0 * values) == 60.0
