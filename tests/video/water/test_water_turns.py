"""Gears and turns cut out of a film: found, mirrored where they go right, ended where the fish is in its beat again."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from components.body import Body
from components.segment import Pattern, Segment, heading_change, mean_speed, mirrored
from tools.video.water.beats import bouts
from tools.video.water.film import Film
from tools.video.water.gaits import gaits_of
from tools.video.water.truth import filmed
from tools.video.water.turns import GENTLE, QUICK, slow_heading, swings

Segments = Callable[[str], dict[Pattern, Segment]]
DEGREES = 180.0 / np.pi


def _outing(held: dict[Pattern, Segment], turns: list[Segment]) -> Segment:
    """Return a swim with turns between beats, as one segment."""
    beats = [held[Pattern.SWIM_MEDIUM]] * 5
    parts = beats + [part for turn in turns for part in (turn, *beats)]
    return Segment(
        Pattern.SWIM_MEDIUM,
        False,
        np.concatenate([part.rotation for part in parts]),
        np.concatenate([part.translation for part in parts]),
        np.concatenate([part.shape for part in parts]),
    )


@pytest.mark.parametrize("name", ["sardine", "blue_tang"])
def test_a_gradual_and_a_sharp_turn_are_found(
    body: Callable[[str], Body], segments: Segments, name: str
) -> None:
    held = segments(name)
    right = mirrored(held[Pattern.TURN_SHARP_LEFT], Pattern.TURN_SHARP_RIGHT)
    outing = _outing(held, [held[Pattern.TURN_LEFT], right])
    shown = filmed(body(name), outing, frames=len(outing.shape) - 6)
    cuts, cruise = gaits_of(shown, bouts(shown), body(name))
    found = {cut.segment.pattern: cut.segment for cut in cuts}
    assert set(found) == {Pattern.SWIM_MEDIUM, Pattern.TURN_LEFT, Pattern.TURN_SHARP_LEFT}
    for pattern in (Pattern.TURN_LEFT, Pattern.TURN_SHARP_LEFT):
        turned = DEGREES * heading_change(found[pattern])
        assert turned == pytest.approx(DEGREES * heading_change(held[pattern]), abs=6.0)
        gap = (
            np.abs(found[Pattern.SWIM_MEDIUM].shape - found[pattern].shape[-1])
            .max(axis=(1, 2))
            .min()
        )
        assert gap < 0.06
        assert not found[pattern].loops
    assert cruise.frequency == pytest.approx(60 / len(held[Pattern.SWIM_MEDIUM].shape), rel=0.01)


def test_a_fish_that_goes_round_and_round_makes_no_turn(
    body: Callable[[str], Body], segments: Segments
) -> None:
    swim = segments("sardine")[Pattern.SWIM_MEDIUM]
    for circling in (0.0, 0.2, 0.6):
        shown = filmed(body("sardine"), swim, frames=240, circling=circling)
        assert swings(shown, 4.0, GENTLE) == swings(shown, 4.0, QUICK) == []


def test_a_turn_with_bridged_frames_is_left_out(
    body: Callable[[str], Body], segments: Segments
) -> None:
    held = segments("sardine")
    outing = _outing(held, [held[Pattern.TURN_SHARP_LEFT]])
    shown = filmed(body("sardine"), outing, frames=len(outing.shape) - 6)
    (swing,) = swings(shown, 4.0, QUICK)
    assert swing.turn * DEGREES == pytest.approx(79.0, abs=12.0)
    good = shown.good.copy()
    good[swing.first + 10] = False
    assert swings(replace(shown, good=good), 4.0, QUICK) == []


def test_the_slow_heading_has_no_beat_in_it(
    body: Callable[[str], Body], segments: Segments
) -> None:
    swim = segments("sardine")[Pattern.SWIM_MEDIUM]
    shown: Film = filmed(body("sardine"), swim, frames=120, circling=0.3, heading=0.0)
    heading = slow_heading(shown, 4.0)[15:-15]
    # Right in the picture is below: a course that bends clockwise turns to the right.
    np.testing.assert_allclose(
        np.diff(heading) * 60.0, 0.3 * np.sign(np.diff(heading)[0]), atol=0.01
    )


def test_a_leap_of_the_film_is_no_turn(body: Callable[[str], Body], segments: Segments) -> None:
    swim = segments("sardine")[Pattern.SWIM_MEDIUM]
    shown = filmed(body("sardine"), swim, frames=150)
    later = filmed(body("sardine"), swim, frames=150, heading=1.2)
    axis = np.concatenate((shown.axis[:75], later.axis[75:]))
    leapt = replace(shown, axis=axis)
    cuts, _ = gaits_of(leapt, bouts(leapt), body("sardine"))
    assert swings(leapt, 4.0, QUICK) != []
    assert [cut.segment.pattern for cut in cuts] == [Pattern.SWIM_MEDIUM]


def test_much_faster_and_slower_beats_are_other_gears(
    body: Callable[[str], Body], segments: Segments
) -> None:
    held = segments("sardine")
    slow, cruise, fast = (
        held[p] for p in (Pattern.SWIM_SLOW, Pattern.SWIM_MEDIUM, Pattern.SWIM_FAST)
    )
    parts = [*[slow] * 7, *[cruise] * 16, *[fast] * 12]
    outing = Segment(
        Pattern.SWIM_MEDIUM,
        False,
        np.concatenate([part.rotation for part in parts]),
        np.concatenate([part.translation for part in parts]),
        np.concatenate([part.shape for part in parts]),
    )
    shown = filmed(body("sardine"), outing, frames=len(outing.shape) - 6)
    cuts, usual = gaits_of(shown, bouts(shown), body("sardine"))
    found = {cut.segment.pattern: mean_speed(cut.segment) for cut in cuts}
    assert usual.frequency == pytest.approx(4.0, rel=0.01)
    for part in (slow, cruise, fast):
        assert found[part.pattern] == pytest.approx(mean_speed(part), rel=0.08)
