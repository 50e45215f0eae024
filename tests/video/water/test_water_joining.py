"""Filmed segments among captured ones: what is kept, what is scaled, and what a changed body does to them."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.body import Body, Swim, rest_nodes
from components.repertoire import Pattern, Repertoire, Segment, mean_speed
from tools.video.water.joining import FILMED, fits, is_filmed, joined, refitted, rejoined

SWIM = Swim(0.3, 0.5, 150.0, 4.0)
Five = tuple[float, float, float, float, float]


def _each(values: Five, change: Callable[[float], float]) -> Five:
    one, two, three, four, five = (change(value) for value in values)
    return one, two, three, four, five


@pytest.fixture
def filmed(repertoire: Callable[[str], Repertoire]) -> Segment:
    """A cruise that no muscle swam: the sardine's, half as fast again."""
    swim = next(s for s in repertoire("sardine").segments if s.pattern == Pattern.SWIM_MEDIUM)
    return replace(swim, translation=1.5 * swim.translation)


@pytest.fixture
def made(
    filmed: Segment, repertoire: Callable[[str], Repertoire], body: Callable[[str], Body]
) -> Repertoire:
    notes = {"swim_medium": "filmed", "warnings": "swim_medium: too lazy"}
    captured = repertoire("sardine")
    odd = {**captured.provenance, "warnings": "swim_medium: stiff; turn_left: small"}
    return joined([filmed], notes, replace(captured, provenance=odd), body("sardine"), SWIM)


def test_gears_keep_their_order_and_proportions(
    made: Repertoire, filmed: Segment, repertoire: Callable[[str], Repertoire]
) -> None:
    speed = {s.pattern: mean_speed(s) for s in made.segments}
    captured = {s.pattern: mean_speed(s) for s in repertoire("sardine").segments}
    assert speed[Pattern.SWIM_SLOW] < speed[Pattern.SWIM_MEDIUM] < speed[Pattern.SWIM_FAST]
    assert speed[Pattern.SWIM_MEDIUM] == mean_speed(filmed)
    for pattern, before in captured.items():
        assert speed[pattern] == pytest.approx(1.5 * before)


def test_notes_tell_of_the_filmed_segment_alone_what_it_is(made: Repertoire) -> None:
    assert is_filmed(made)
    assert made.provenance[FILMED] == "swim_medium"
    assert made.provenance["swim_medium"] == "filmed"
    assert "swim_medium_phase" not in made.provenance
    assert "swim_fast_phase" in made.provenance
    assert made.provenance["warnings"] == "turn_left: small; swim_medium: too lazy"
    assert "fingerprint" not in made.provenance


def test_it_serves_the_body_and_swim_that_it_was_made_for(
    made: Repertoire, body: Callable[[str], Body], repertoire: Callable[[str], Repertoire]
) -> None:
    sardine = body("sardine")
    assert fits(made, sardine, SWIM)
    assert fits(made, replace(sardine, snout=0.9, dorsal=None), SWIM)
    assert not fits(made, replace(sardine, tail_span=0.2), SWIM)
    assert not fits(made, sardine, replace(SWIM, lag_deg=120.0))
    assert not fits(repertoire("sardine"), sardine, SWIM)
    assert not is_filmed(repertoire("sardine"))


def test_the_same_body_gives_the_same_shapes(filmed: Segment, body: Callable[[str], Body]) -> None:
    sardine = body("sardine")
    rest = replace(filmed, shape=np.repeat(rest_nodes(sardine)[None], 3, axis=0).astype(np.float32))
    again = refitted(rest, sardine.station, sardine)
    np.testing.assert_allclose(again.shape, rest.shape, atol=1e-6)


@given(
    deeper=st.floats(0.5, 2.0),
    wider=st.floats(0.5, 2.0),
    along=st.floats(-0.03, 0.03),
    span=st.floats(0.05, 0.2),
)
def test_a_changed_body_keeps_its_axis(
    repertoire: Callable[[str], Repertoire], body: Callable[[str], Body],
    deeper: float, wider: float, along: float, span: float,
) -> None:  # fmt: skip
    sardine = body("sardine")
    filmed = next(s for s in repertoire("sardine").segments if s.pattern == Pattern.SWIM_MEDIUM)
    changed = replace(
        sardine,
        station=_each(sardine.station, lambda s: s + along),
        half_width=_each(sardine.half_width, lambda w: w * wider),
        half_height=_each(sardine.half_height, lambda h: h * deeper),
        tail_span=span,
    )
    found = refitted(filmed, sardine.station, changed).shape.astype(np.float64)
    rings = found[:, 1:21].reshape(len(found), 5, 4, 3)
    widths = np.linalg.norm(rings[:, :, 1] - rings[:, :, 0], axis=2)
    heights = rings[:, :, 0, 1] - rings[:, :, 3, 1]
    np.testing.assert_allclose(
        widths, np.broadcast_to(2.0 * np.array(changed.half_width), widths.shape), rtol=1e-5
    )
    np.testing.assert_allclose(
        heights, np.broadcast_to(1.5 * np.array(changed.half_height), heights.shape), rtol=1e-5
    )
    np.testing.assert_allclose(found[:, 21, 1] - found[:, 22, 1], 2.0 * span, rtol=1e-5)
    np.testing.assert_array_equal(found[:, 0], filmed.shape[:, 0])


def test_a_changed_body_has_the_filmed_segment_and_new_others(
    made: Repertoire, repertoire: Callable[[str], Repertoire], body: Callable[[str], Body]
) -> None:
    wider = replace(
        body("sardine"), half_width=_each(body("sardine").half_width, lambda w: 1.2 * w)
    )
    captured = repertoire("blue_tang")
    again = rejoined(made, captured, wider, SWIM)
    assert fits(again, wider, SWIM)
    assert again.provenance["warnings"].endswith("swim_medium: too lazy")
    old, new = ({s.pattern: s for s in one.segments} for one in (made, again))
    assert len(new[Pattern.SWIM_MEDIUM].shape) == len(old[Pattern.SWIM_MEDIUM].shape)
    theirs = next(s for s in captured.segments if s.pattern == Pattern.TURN_LEFT)
    np.testing.assert_array_equal(new[Pattern.TURN_LEFT].shape, theirs.shape)


def test_damaged_notes_are_told(
    made: Repertoire, repertoire: Callable[[str], Repertoire], body: Callable[[str], Body]
) -> None:
    for note in ("", "0.1 0.2", "a b c d e"):
        damaged = replace(made, provenance={**made.provenance, "filmed_at": note})
        with pytest.raises(ValueError, match=r"filmed_at|could not convert"):
            rejoined(damaged, repertoire("sardine"), body("sardine"), SWIM)
