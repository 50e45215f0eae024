"""Beats found in a filmed motion (issue 6, Numbers: frequency within one in a hundred)."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tools.video.water.beats import bouts
from tools.video.water.film import Film, FilmError, angles

FilmOf = Callable[..., Film]


@pytest.mark.parametrize(("name", "truth"), [("sardine", 4.0), ("reef_shark", 60 / 42)])
@pytest.mark.parametrize("rate", [25.0, 60.0, 110.0])
def test_the_frequency_is_right_to_one_in_a_hundred(
    film: FilmOf, name: str, truth: float, rate: float
) -> None:
    shown = film(name, frames=round(3.1 / truth * rate), rate=rate, noise=0.5)
    assert bouts(shown)[0].frequency == pytest.approx(truth, rel=0.01)


@settings(max_examples=10)
@given(circling=st.floats(-0.6, 0.6), heading=st.floats(-3.1, 3.1))
def test_turning_as_a_whole_changes_no_frequency(
    film: FilmOf, circling: float, heading: float
) -> None:
    shown = film("sardine", frames=60, circling=circling, heading=heading)
    assert bouts(shown)[0].frequency == pytest.approx(4.0, rel=0.01)


def test_a_fish_that_drifts_without_a_beat_is_refused(film: FilmOf) -> None:
    shown = film("sardine", frames=40)
    stiff = replace(
        shown, axis=np.repeat(shown.axis[:1], 40, axis=0) + np.arange(40)[:, None, None]
    )
    with pytest.raises(FilmError, match="hardly bends"):
        bouts(stiff)


def test_a_glimpse_of_a_beat_is_refused(film: FilmOf) -> None:
    with pytest.raises(FilmError, match=r"too few|evenly"):
        bouts(film("reef_shark", frames=20))


def test_random_bending_is_no_beat(film: FilmOf) -> None:
    shown = film("sardine", frames=120)
    order = np.random.default_rng(1).permutation(120)
    with pytest.raises(FilmError, match="evenly"):
        bouts(replace(shown, axis=shown.axis[order]))


def test_bouts_keep_out_of_bridged_frames(film: FilmOf) -> None:
    shown = film("sardine", frames=240)
    good = shown.good.copy()
    good[60:120] = False
    found = bouts(replace(shown, good=good))
    assert all(good[b.first : b.stop].mean() >= 0.8 for b in found)
    assert {b.first > 90 for b in found} == {False, True}


def test_the_steadiest_bout_comes_first(film: FilmOf) -> None:
    shown = film("sardine", frames=180)
    axis = shown.axis.copy()
    axis[:90] += np.random.default_rng(2).normal(size=(90, 41, 2)) * 3.0
    found = bouts(replace(shown, axis=axis))
    assert found[0].first >= 80
    assert [b.steadiness for b in found] == sorted((b.steadiness for b in found), reverse=True)


@given(heading=st.floats(-20.0, 20.0))
@settings(max_examples=12)
def test_angles_are_steady_over_frames_and_along_the_axis(film: FilmOf, heading: float) -> None:
    found = angles(film("sardine", frames=40, circling=6.0, heading=heading))
    assert np.abs(np.diff(found, axis=0)).max() < 1.0
    assert np.abs(np.diff(found, axis=1)).max() < 1.0
