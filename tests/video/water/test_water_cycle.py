"""One clean cycle out of filmed beats: truth, closure, and what does not matter to it (FINDINGS 4)."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.body import Body
from components.segment import Pattern, Segment, mean_speed
from tools.video.water.beats import bouts
from tools.video.water.cycle import STROUHAL, Cycle, cycle
from tools.video.water.film import Film
from tools.video.water.truth import centre_lines

FilmOf = Callable[..., Film]
NAMES = ["sardine", "blue_tang", "reef_shark"]


def _cycle(film: Film) -> Cycle:
    return cycle(film, bouts(film)[0])


@pytest.mark.parametrize("name", NAMES)
def test_sweep_speed_and_wave_are_those_of_the_swim(
    film: FilmOf,
    body: Callable[[str], Body],
    segments: Callable[[str], dict[Pattern, Segment]],
    name: str,
) -> None:
    swim = segments(name)[Pattern.SWIM_MEDIUM]
    line = centre_lines(body(name), swim, 2 * len(swim.shape))
    length = float(np.sqrt((np.diff(line, axis=1) ** 2).sum(axis=2)).sum(axis=1).mean())
    found, noisy = _cycle(film(name)), _cycle(film(name, noise=0.5))
    for one, close in ((found, 0.015), (noisy, 0.03)):
        assert one.sweep() == pytest.approx(np.ptp(line[:, -1, 1]) / length, rel=close)
        assert one.head_sweep() == pytest.approx(np.ptp(line[:, 0, 1]) / length, abs=0.004)
        assert one.speed == pytest.approx(mean_speed(swim) / length, rel=close)
        assert not one.assumed
    assert noisy.wavelength() == pytest.approx(found.wavelength(), rel=0.04)
    assert 0.8 < found.wavelength() < 1.5


@settings(max_examples=8)
@given(
    heading=st.floats(-3.0, 3.0),
    scale=st.floats(0.2, 5.0),
    aside=st.floats(-1000.0, 1000.0),
)
def test_where_which_way_and_how_large_a_fish_was_filmed_does_not_matter(
    film: FilmOf, heading: float, scale: float, aside: float
) -> None:
    usual, other = film("sardine", frames=60), film("sardine", frames=60, heading=heading)
    other = replace(other, axis=scale * other.axis + aside, half_width=scale * other.half_width)
    phase = np.linspace(0.0, 1.0, 9)
    np.testing.assert_allclose(_cycle(other).lines(phase), _cycle(usual).lines(phase), atol=2e-5)


def test_a_bend_of_the_course_is_taken_out(film: FilmOf) -> None:
    straight, bent = _cycle(film("sardine")), _cycle(film("sardine", circling=0.5))
    assert bent.sweep() == pytest.approx(straight.sweep(), rel=0.02)
    assert bent.stride == pytest.approx(straight.stride, rel=0.01)


@pytest.mark.parametrize("name", NAMES)
def test_a_cycle_closes_and_goes_straight_ahead(film: FilmOf, name: str) -> None:
    found = _cycle(film(name, noise=0.5, circling=0.3))
    line = found.lines(np.arange(61) / 60)
    np.testing.assert_allclose(
        line[-1] - line[0], np.broadcast_to([found.stride, 0.0], (41, 2)), atol=1e-12
    )
    steps = np.sqrt((np.diff(line, axis=1) ** 2).sum(axis=2))
    np.testing.assert_allclose(steps, 1 / 40, rtol=1e-12)
    course = line[:-1, 0] - line[:-1, -1]
    assert abs(np.arctan2(course[:, 1], course[:, 0]).mean()) < 0.01


def test_who_holds_station_gets_the_usual_stride(film: FilmOf) -> None:
    travelled, held = _cycle(film("sardine")), _cycle(film("sardine", holds_station=True))
    assert held.assumed
    assert held.stride == pytest.approx(held.sweep() / STROUHAL)
    assert held.sweep() == pytest.approx(travelled.sweep(), rel=0.01)
    assert held.stride == pytest.approx(travelled.stride, rel=0.25)


def test_a_wave_that_runs_forwards_is_told(film: FilmOf) -> None:
    shown = film("sardine")
    backwards = _cycle(replace(shown, axis=shown.axis[::-1]))
    assert _cycle(shown).wavelength() > 0.0 > backwards.wavelength()


def test_slow_cameras_give_fewer_harmonics(film: FilmOf) -> None:
    slow, quick = _cycle(film("sardine", frames=60, rate=22.0)), _cycle(film("sardine", rate=60.0))
    assert not slow.bends[:, 2:].any()
    assert quick.bends[:, 3].any()
    assert slow.sweep() == pytest.approx(quick.sweep(), rel=0.12)
