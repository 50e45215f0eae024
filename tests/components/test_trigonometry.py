"""Our own sine and cosine, against the C library's."""

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from components.trigonometry import DEGREE, arc, cosine, sine


@given(st.floats(-1e5, 1e5))
def test_sine_and_cosine_are_exact_to_the_last_digits(angle: float) -> None:
    assert abs(sine(angle) - math.sin(angle)) < 5e-16 + 1e-16 * abs(angle) / 10
    assert abs(cosine(angle) - math.cos(angle)) < 5e-16 + 1e-16 * abs(angle) / 10


@given(st.floats(-50.0, 50.0))
def test_sine_and_cosine_lie_on_the_circle_and_mirror(angle: float) -> None:
    s, c = sine(angle), cosine(angle)
    assert abs(s * s + c * c - 1.0) < 4e-16 * 2
    assert sine(-angle) == -s
    assert cosine(-angle) == c


def test_quarter_turns_hit_the_axes() -> None:
    for quarter in range(-8, 9):
        angle = 90.0 * quarter * DEGREE
        assert abs(sine(angle) - round(math.sin(angle))) < 2e-15
        assert abs(cosine(angle) - round(math.cos(angle))) < 2e-15


def test_no_step_shows_where_the_pieces_meet() -> None:
    near = np.pi / 4 * np.arange(-9, 10)
    for angle in near:
        below, above = np.nextafter(angle, -np.inf), np.nextafter(angle, np.inf)
        assert abs(sine(float(above)) - sine(float(below))) < 5e-15
        assert abs(cosine(float(above)) - cosine(float(below))) < 5e-15


@given(st.floats(-3.1415, 3.1415), st.floats(1e-6, 1e6))
def test_the_arc_of_a_direction_is_its_angle(angle: float, size: float) -> None:
    assert abs(arc(size * math.cos(angle), size * math.sin(angle)) - angle) < 1e-14
    assert arc(0.0, size) == math.pi / 2
    assert math.isnan(arc(0.0, 0.0))
