"""Hunger, libido, fear and unease: ranges, ends and monotony of the thesis' formulas."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.food import in_stomach
from components.habitat import STILL, daylight, light, temperature
from systems.mind.feel import (
    FOOD_FAR,
    FOOD_NEAR,
    appetite,
    desire,
    fear_of,
    fear_of_submarine,
    hunger_of,
    libido_of,
    stimulus,
    unease,
)

share = st.floats(0.0, 1.0)
some = settings(max_examples=200, deadline=None)


@given(st.floats(0.0, 10.0), st.floats(0.0, 10.0))
@some
def test_a_stimulus_grows_with_nearness_from_none_to_whole(a: float, b: float) -> None:
    near, far = sorted((a, b), reverse=True)
    weak, strong = (stimulus(s, FOOD_FAR, FOOD_NEAR) for s in (far, near))
    assert 0.0 <= weak <= strong <= 1.0


def test_a_stimulus_is_nothing_beyond_q1_and_whole_within_q2() -> None:
    assert stimulus(0.99 * FOOD_FAR, FOOD_FAR, FOOD_NEAR) == 0.0
    assert stimulus(FOOD_NEAR, FOOD_FAR, FOOD_NEAR) == 1.0
    assert stimulus(0.999999 * FOOD_NEAR, FOOD_FAR, FOOD_NEAR) == pytest.approx(1.0, abs=1e-4)
    middle = 0.5 * (FOOD_FAR + FOOD_NEAR)
    assert stimulus(middle, FOOD_FAR, FOOD_NEAR) == pytest.approx(1.0 / 3.0)


@given(st.floats(0.0, 12.0), st.floats(0.0, 12.0), share, share)
@some
def test_hunger_falls_with_the_stomach_and_rises_with_temptation(
    a: float, b: float, s: float, t: float
) -> None:
    full, empty = max(a, b), min(a, b)
    little, much = sorted((s, t))
    assert 0.0 <= hunger_of(appetite(full, 4.0), s) <= hunger_of(appetite(empty, 4.0), s) <= 1.0
    assert hunger_of(appetite(a, 4.0), little) <= hunger_of(appetite(a, 4.0), much)


def test_hunger_is_one_minus_meals_over_appetite() -> None:
    assert hunger_of(appetite(1.0, 4.0), 0.0) == 0.75
    assert hunger_of(appetite(4.0, 4.0), 0.5) == pytest.approx(0.4)
    assert hunger_of(appetite(8.0, 4.0), 1.0) == 0.0


def test_a_meal_is_digested_evenly() -> None:
    assert in_stomach(2.0, 100, 100, 50.0) == 2.0
    assert in_stomach(2.0, 100, 125, 50.0) == 1.0
    assert in_stomach(2.0, 100, 1000, 50.0) == 0.0


@given(st.floats(-10.0, 1e6), st.floats(1.0, 1e5), share, share, share)
@some
def test_libido_grows_with_time_and_shrinks_with_hunger(
    waited: float, breeding: float, h: float, g: float, s: float
) -> None:
    hungry, sated = max(h, g), min(h, g)
    assert 0.0 <= desire(waited, breeding, hungry) <= desire(waited, breeding, sated) <= 1.0
    assert desire(waited, breeding, h) <= desire(waited + 5.0, breeding, h)
    assert 0.0 <= libido_of(desire(waited, breeding, h), s) <= 1.0


def test_who_has_just_mated_is_not_allured() -> None:
    assert libido_of(desire(0.0, 100.0, 0.0), 1.0) == 0.0
    assert libido_of(desire(50.0, 100.0, 0.0), 1.0) == 1.0


@given(st.floats(0.1, 10.0), st.floats(0.1, 4.0), st.floats(0.0, 50.0), st.floats(0.0, 50.0))
@some
def test_fear_grows_with_nearness_and_size(
    wariness: float, size: float, a: float, b: float
) -> None:
    near, far = min(a, b), max(a, b)
    assert 0.0 <= fear_of(wariness, size, far) <= fear_of(wariness, size, near) <= 1.0
    assert fear_of(wariness, size, far) <= fear_of(wariness, 2.0 * size, far)
    assert fear_of(wariness, size, 0.5 * wariness * size) == 1.0
    assert fear_of_submarine(wariness, 0.0, far) <= fear_of_submarine(wariness, 3.0, far) <= 1.0


@given(st.floats(-40.0, 0.0), st.sampled_from((-1, 0, 1)), st.sampled_from((-1, 0, 1)), share)
@some
def test_unease_is_a_share_and_says_where_to_go(
    z: float, bright: int, warm: int, day: float
) -> None:
    much, way = unease(STILL, day, z, bright, warm)
    assert 0.0 <= much <= 1.0
    assert way in (-1.0, 0.0, 1.0)
    if bright == 0 and warm == 0:
        assert much == 0.0


def test_who_likes_light_goes_up_and_who_likes_the_dark_goes_down() -> None:
    deep, shallow = -30.0, -1.0
    noon = daylight(STILL, 0)
    assert light(STILL, noon, shallow) > light(STILL, noon, deep)
    assert temperature(STILL, noon, shallow) > temperature(STILL, noon, deep)
    assert unease(STILL, noon, deep, 1, 0)[0] > 0.0
    assert unease(STILL, noon, deep, 1, 0)[1] == 1.0
    assert unease(STILL, noon, shallow, 1, 0)[0] == 0.0
    much, way = unease(STILL, noon, shallow, -1, 0)
    assert (round(much, 2), way) == (0.83, -1.0)
    assert unease(STILL, noon, deep, 0, 1)[1] == 1.0
    assert unease(STILL, noon, shallow, 0, -1)[1] == -1.0
