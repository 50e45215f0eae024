"""Rotations: properties of the kernels on 3x3 matrices."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from components.arrays import Float64s
from components.rotation import between, multiply, orthonormalise, set_axes, turned

angles = st.floats(-3.0, 3.0)
small = st.floats(-0.2, 0.2)


def _rotation(u: float, v: float, w: float) -> Float64s:
    """Return the rotation of a rotation vector, by Rodrigues' formula in full."""
    angle = np.sqrt(u * u + v * v + w * w)
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = u / angle, v / angle, w / angle
    k = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    r: Float64s = np.eye(3) + np.sin(angle) * k + (1.0 - np.cos(angle)) * (k @ k)
    return r


def _is_rotation(r: Float64s, within: float) -> bool:
    square = np.abs(r.T @ r - np.eye(3)).max() < within
    return bool(square) and abs(np.linalg.det(r) - 1.0) < 10 * within


@given(small, small, small, angles, angles, angles)
def test_a_small_turn_is_rodrigues_rotation(
    u: float, v: float, w: float, x: float, y: float, z: float
) -> None:
    found = np.array(turned(x, y, z, u, v, w))
    np.testing.assert_allclose(found, _rotation(u, v, w) @ (x, y, z), atol=1e-9)


@given(angles, angles, angles, angles, angles, angles)
def test_a_product_is_the_matrix_product(
    a: float, b: float, c: float, d: float, e: float, f: float
) -> None:
    r, m = _rotation(a, b, c), _rotation(d, e, f)
    expected = r @ m
    multiply(r, m)
    np.testing.assert_allclose(r, expected, atol=1e-14)


@given(angles, angles, angles, st.lists(st.floats(-1e-3, 1e-3), min_size=9, max_size=9))
def test_nearly_a_rotation_becomes_one(u: float, v: float, w: float, error: list[float]) -> None:
    exact = _rotation(u, v, w)
    r = exact + np.reshape(error, (3, 3))
    for _ in range(3):
        set_axes(r, r[0, 0], r[1, 0], r[2, 0], r[0, 1], r[1, 1], r[2, 1])
    assert _is_rotation(r, 1e-12)
    assert np.abs(r - exact).max() < 5e-3


@given(st.lists(st.floats(-1e6, 1e6), min_size=9, max_size=9))
def test_any_matrix_becomes_a_rotation(values: list[float]) -> None:
    r = np.reshape(np.array(values), (3, 3)).copy()
    x = r[:, 0].copy()
    orthonormalise(r)
    assert _is_rotation(r, 1e-9)
    if np.linalg.norm(x) > 1e-6 and not np.allclose(r, np.eye(3)):
        np.testing.assert_allclose(r[:, 0], x / np.linalg.norm(x), atol=1e-9)


@given(angles, angles, angles, small, small, small, st.floats(0.0, 1.0))
def test_between_two_rotations_lies_the_great_arc(
    a: float, b: float, c: float, u: float, v: float, w: float, alpha: float
) -> None:
    last = _rotation(a, b, c)
    now = _rotation(u, v, w) @ last
    out = np.empty((3, 3))
    between(last, now, alpha, out)
    assert _is_rotation(out, 1e-12)
    size = np.sqrt(u * u + v * v + w * w)
    arc = _rotation(alpha * u, alpha * v, alpha * w) @ last
    assert np.abs(out - arc).max() < 0.3 * size**2 + 1e-12
    between(last, now, 1.0, out)
    np.testing.assert_allclose(out, now, atol=1e-12)
