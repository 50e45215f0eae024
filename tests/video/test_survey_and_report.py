"""The first pass over a clip, and what the report draws."""

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from tools.video.follow import Followed, follow
from tools.video.reading import Clip
from tools.video.report.overlay import overlaid
from tools.video.report.page import page
from tools.video.report.pictures import pictures
from tools.video.report.waves import envelope, sideways
from tools.video.survey import SAMPLES, survey


@pytest.fixture(scope="module")
def followed(fish_film: Path) -> Followed:
    return follow(fish_film)


def test_however_long_a_clip_is_as_many_samples_are_kept(film: Callable[..., Path]) -> None:
    chance = np.random.default_rng(0)
    found = {}
    for count in (20, 60, 230):
        noise = [chance.integers(80, 120, (48, 64)).astype(np.uint8) for _ in range(count)]
        found[count] = survey(Clip(film(noise)), lambda _: None)
    assert [one.count for one in found.values()] == [20, 60, 230]
    assert [len(one.samples) for one in found.values()] == [20, SAMPLES, SAMPLES]


def test_samples_come_from_the_whole_clip(film: Callable[..., Path]) -> None:
    fade = [np.full((48, 64), 20 + k, np.uint8) for k in range(200)]
    samples = survey(Clip(film(fade)), lambda _: None).samples[:, 0, 0].astype(int)
    assert samples[0] == 20
    assert samples[-1] > 205
    assert np.diff(samples).min() >= 4


def test_the_rate_of_a_clip_is_that_of_its_frames(film: Callable[..., Path]) -> None:
    fade = [np.full((48, 64), 20 + k, np.uint8) for k in range(100)]
    assert survey(Clip(film(fade, rate=60.0)), lambda _: None).rate == pytest.approx(60.0, rel=0.01)


def test_the_film_shows_every_frame_with_what_was_found(followed: Followed) -> None:
    film = list(overlaid(followed))
    assert len(film) == 45
    red = (film[0][..., 0] > 200) & (film[0][..., 1] < 100)
    assert red.sum() > 100


def test_a_beat_goes_from_head_to_tail_and_grows(followed: Followed) -> None:
    motion, period = followed.assembled.motion, followed.assembled.beat.period
    swept = envelope(motion, period)
    assert swept[-1] > 2.0 * swept[10]
    assert swept[-1] == pytest.approx(0.1, abs=0.04)
    wave = sideways(motion, period)
    assert wave.shape == (45, 41)
    assert abs(wave.mean()) < 0.01


def test_the_page_is_the_same_each_time(followed: Followed) -> None:
    assert page(followed) == page(followed)
    assert "45 of 45 frames are good" in page(followed)


def test_the_documents_pictures_are_those_that_are_drawn(fish_film: Path, checkout: Path) -> None:
    drawn = pictures(fish_film, 9)
    text = (checkout / "docs" / "video.md").read_text(encoding="utf-8")
    linked = set(re.findall(r"\(pictures/(video_\w+\.png)\)", text))
    assert linked == set(drawn)
    assert all(picture.ndim == 3 and picture.std() > 10 for picture in drawn.values())
