"""Colours of a clip on a skin: the fish laid out straight, its bars, and shapes that have no colours."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tools.video.water.colours import (
    ACROSS,
    ALONG,
    ASSUMED,
    chosen,
    colours_of,
    painted,
    straightened,
)
from tools.video.water.film import Film

OLIVE, SAND = (92, 110, 60), (190, 170, 120)


def _film(angle: float = 0.0, frames: int = 3) -> Film:
    along = np.linspace(120.0, -120.0, 41)
    line = np.stack((200 + along * np.cos(angle), 200 + along * np.sin(angle)), axis=-1)
    width = np.full((frames, 41), 30.0)
    return Film(30.0, np.tile(line, (frames, 1, 1)), width, np.ones(frames, bool))


def _picture(film: Film) -> np.ndarray:
    """Return a fish with an olive back, sand-coloured flanks and a dark bar at .4 of its length."""
    y, x = np.mgrid[:400, :400]
    nose, tail = film.axis[0, 0], film.axis[0, -1]
    ahead = (nose - tail) / np.hypot(*(nose - tail))
    s = ((nose[0] - x) * ahead[0] + (nose[1] - y) * ahead[1]) / np.hypot(*(nose - tail))
    out = np.abs((x - nose[0]) * ahead[1] - (y - nose[1]) * ahead[0]) / 30.0
    picture = np.where((out < 0.45)[..., None], OLIVE, SAND)
    picture[np.abs(s - 0.4) < 0.03] = (20, 22, 18)
    return picture.astype(np.uint8)


@pytest.mark.parametrize("angle", [0.0, 0.7, -2.5])
def test_back_flank_and_bar_are_seen_whichever_way_the_fish_lies(angle: float) -> None:
    film = _film(angle)
    found = colours_of([(k, _picture(film)) for k in range(3)], film, 1.0)
    assert not found.assumed
    np.testing.assert_allclose(found.back, OLIVE, atol=4)
    np.testing.assert_allclose(found.flank, SAND, atol=4)
    assert sum(found.belly) > sum(found.flank)
    ((at, width),) = found.bars
    assert at == pytest.approx(0.4 / 0.8, abs=0.02)
    assert width == pytest.approx(0.06 / 0.8, abs=0.025)
    assert max(found.bar) < 60


def test_pictures_of_another_size_than_the_films_serve() -> None:
    film = _film()
    small = np.ascontiguousarray(_picture(film)[::2, ::2])
    found = colours_of([(0, small)], film, 0.5)
    np.testing.assert_allclose(found.back, OLIVE, atol=6)


@given(st.integers(0, 79), st.integers(0, 5))
def test_a_dark_shape_has_no_colours(level: int, noise: int) -> None:
    chance = np.random.default_rng(level)
    laid = level + noise * chance.normal(size=(ACROSS, ALONG, 3))
    assert painted(np.clip(laid, 0, 74)) == ASSUMED


def test_no_pictures_give_the_assumed_colours() -> None:
    assert colours_of([], _film(), 1.0) == ASSUMED


def test_only_good_frames_are_looked_at() -> None:
    film = _film(frames=200)
    film.good[::2] = False
    found = chosen(film)
    assert len(found) == 24
    assert all(film.good[k] for k in found)


def test_laid_out_straight_left_stays_left() -> None:
    film = _film()
    picture = np.zeros((400, 400, 3), np.uint8)
    picture[:200] = 200
    laid = straightened(picture, film.axis[0], film.half_width[0])
    # Headed to the picture's right, the fish has its left above.
    assert laid[0].min() == 200
    assert laid[-1].max() == 0
