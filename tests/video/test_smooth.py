"""Smoothing, bridges, in-betweens and beats."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tools.video.beats import beat_of, tail_swing
from tools.video.smooth import KEPT, in_between, noise_for, smoothed

ALL = np.ones(60, np.bool_)
FRAME = np.arange(60.0)


@given(start=st.floats(-500, 500), speed=st.floats(-20, 20), noise=st.floats(0.01, 30))
def test_a_steady_course_is_left_as_it_is(start: float, speed: float, noise: float) -> None:
    line = start + speed * FRAME
    assert np.abs(smoothed(line, ALL, noise) - line).max() < 1e-3 * (1.0 + abs(start) + abs(speed))


@given(first=st.integers(5, 30), gap=st.integers(1, 12))
def test_what_was_not_seen_is_bridged_along_the_course(first: int, gap: int) -> None:
    line = np.stack((3.0 * FRAME, 200.0 - FRAME), axis=-1)
    seen = ALL.copy()
    seen[first : first + gap] = False
    broken = np.where(seen[:, None], line, np.nan)
    assert np.abs(smoothed(broken, seen, 0.1) - line).max() < 1e-2


@pytest.mark.parametrize("period", [6.0, 12.0, 25.0])
def test_a_beat_keeps_its_amplitude(period: float) -> None:
    wave = np.sin(2.0 * np.pi * FRAME / period)
    smooth = smoothed(wave, ALL, noise_for(period))
    assert np.abs(smooth - wave)[10:-10].max() < 2.0 * (1.0 - KEPT) + 1e-3


def test_noise_is_smoothed_away() -> None:
    rough = np.random.default_rng(1).normal(0.0, 1.0, 60)
    assert smoothed(rough, ALL, noise_for(40.0)).std() < 0.6 * rough.std()


def test_five_in_betweens_pass_through_the_frames_and_between_them() -> None:
    wave = np.sin(2.0 * np.pi * FRAME / 20.0)
    fine = in_between(wave, 0.001)
    assert len(fine) == 59 * 6 + 1
    assert np.abs(fine[::6] - wave).max() < 0.01
    truth = np.sin(2.0 * np.pi * np.arange(len(fine)) / 120.0)
    assert np.abs(fine - truth)[30:-30].max() < 0.01


def test_nothing_seen_cannot_be_smoothed() -> None:
    with pytest.raises(ValueError, match="nothing is seen"):
        smoothed(FRAME, ~ALL, 1.0)


@settings(max_examples=40)
@given(
    period=st.floats(4.0, 40.0),
    beats=st.floats(2.0, 8.0),
    phase=st.floats(0.0, 6.28),
    drift=st.floats(-0.2, 0.2),
)
def test_a_beat_is_found_within_one_per_cent(
    period: float, beats: float, phase: float, drift: float
) -> None:
    at = np.arange(round(period * beats))
    noise = np.random.default_rng(3).normal(0.0, 0.003, len(at))
    swing = 0.1 * np.sin(2.0 * np.pi * at / period + phase) + drift * at / len(at) + noise
    found = beat_of(swing, np.ones(len(at), np.bool_))
    assert found.period == pytest.approx(period, rel=0.01 if beats > 3.0 else 0.03)
    assert found.amplitude == pytest.approx(0.1, rel=0.1)


def test_a_still_tail_does_not_beat() -> None:
    assert beat_of(np.zeros(50), np.ones(50, np.bool_)).certainty == 0.0
    assert np.isnan(beat_of(np.zeros(3), np.ones(3, np.bool_)).period)


def test_a_tail_swings_to_the_side_it_lies_on() -> None:
    axis = np.zeros((2, 41, 2))
    axis[..., 0] = -np.arange(41.0)
    axis[0, 21:, 1] = np.arange(20.0)
    axis[1, 21:, 1] = -np.arange(20.0)
    swing = tail_swing(axis)
    assert swing[0] == pytest.approx(-swing[1])
    assert abs(swing[0]) > 0.3
