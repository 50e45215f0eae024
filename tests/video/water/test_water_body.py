"""What a silhouette from above tells of a body, and what is assumed."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.body import Body
from tools.video.water.body import LEAST, body_of, widths
from tools.video.water.film import Film

FilmOf = Callable[..., Film]


@pytest.mark.parametrize("name", ["sardine", "blue_tang", "reef_shark"])
def test_half_widths_are_those_of_the_fish(
    film: FilmOf, body: Callable[[str], Body], name: str
) -> None:
    true, found = body(name), body_of(film(name, noise=0.3))
    at = np.interp(found.station, (0.0, *true.station, 1.0), (0.0, *true.half_width, 0.0))
    # Swimming shortens a muscle-driven body, so that it seems wider for its length.
    np.testing.assert_allclose(found.half_width, at, rtol=0.09)


def test_a_frame_that_failed_does_not_count(film: FilmOf) -> None:
    shown = film("sardine", frames=30)
    wild, good = shown.half_width.copy(), shown.good.copy()
    wild[:14], good[:14] = 500.0, False
    np.testing.assert_array_equal(
        widths(replace(shown, half_width=wild, good=good)),
        widths(
            replace(shown, axis=shown.axis[14:], half_width=shown.half_width[14:], good=good[14:])
        ),
    )


@settings(max_examples=12)
@given(scale=st.floats(0.0, 8.0), fork=st.floats(0.0, 0.3))
def test_any_outline_gives_a_body_that_a_species_may_have(
    film: FilmOf, scale: float, fork: float
) -> None:
    shown = film("sardine", frames=4)
    odd = shown.half_width * (scale + fork * np.sin(np.arange(41.0)))
    found = body_of(replace(shown, half_width=np.maximum(odd, 0.0)))
    assert all(LEAST <= w <= 0.4 for w in found.half_width)
    assert all(0.004 <= h <= 0.4 for h in found.half_height)
    assert np.diff(found.station).min() >= 0.04
