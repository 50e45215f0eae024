"""Elliptic Fourier contours (papers/003, eqs. 2-6)."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tools.video.contour import (
    MOST_HARMONICS,
    RESIDUAL,
    coefficients,
    evenly,
    harmonics_needed,
    kept,
    rebuilt,
    smooth_contour,
)

T = np.linspace(0.0, 2.0 * np.pi, 256, endpoint=False)


@given(a=st.floats(5, 200), b=st.floats(5, 200), turn=st.floats(0, 3), x=st.floats(-500, 500))
def test_an_ellipse_is_its_first_harmonic(a: float, b: float, turn: float, x: float) -> None:
    flat = a * np.cos(T) + 1j * b * np.sin(T)
    placed = flat * np.exp(1j * turn) + x
    line = np.stack((placed.real, placed.imag), axis=-1)
    again = rebuilt(kept(coefficients(line), 1))
    assert np.abs(again - line).max() < 1e-9 * (abs(x) + a + b)
    assert harmonics_needed(coefficients(line), 2.0 * max(a, b)) == 1


@given(st.lists(st.floats(-3, 3), min_size=8, max_size=8))
def test_harmonics_are_the_fewest_that_lie_near_enough(waves: list[float]) -> None:
    radius = 60.0 + sum(w * np.cos((k + 2) * T) for k, w in enumerate(waves))
    line = np.stack((radius * np.cos(T), radius * np.sin(T)), axis=-1)
    fourier = coefficients(line)
    s = harmonics_needed(fourier, 120.0)

    def residual(harmonics: int) -> float:
        away = rebuilt(kept(fourier, harmonics)) - line
        return float(np.sqrt((away**2).sum(axis=1).mean()))

    assert s == MOST_HARMONICS or residual(s) < RESIDUAL * 120.0
    assert s == 1 or residual(s - 1) >= RESIDUAL * 120.0


@given(st.lists(st.tuples(st.floats(-50, 50), st.floats(-50, 50)), min_size=3, max_size=12))
def test_even_points_lie_at_equal_arc_lengths(corners: list[tuple[float, float]]) -> None:
    line = np.array(corners)
    whole = np.hypot(*np.diff(line, axis=0).T).sum()
    even = evenly(line, 33)
    assert np.allclose(even[0], line[0])
    assert np.allclose(even[-1], line[-1], atol=1e-6)
    steps = np.hypot(*np.diff(even, axis=0).T)
    assert (steps <= whole / 32 + 1e-6).all()


def test_a_fin_is_smoothed_away_and_the_body_kept() -> None:
    radius = 80.0 + np.where(np.abs(T - 1.0) < 0.04, 12.0, 0.0)
    line = np.stack((2.5 * radius * np.cos(T), radius * np.sin(T)), axis=-1)
    smooth, harmonics = smooth_contour(line, 400.0)
    assert harmonics <= 6
    plain = np.stack((200.0 * np.cos(T), 80.0 * np.sin(T)), axis=-1)
    away = np.sqrt(((smooth[:, None] - plain) ** 2).sum(axis=2)).min(axis=1)
    assert away.max() < 6.0
