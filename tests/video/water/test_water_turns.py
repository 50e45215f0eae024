"""Gears and turns cut out of a film: found, mirrored where they go right, ended where the fish is in its beat again."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from components.body import Body
from components.repertoire import Repertoire
from components.segment import Pattern, Segment, heading_change, mean_speed, mirrored
from reefgame.content import load_species
from tools.capture.measure import SwimFigures
from tools.video.water import species
from tools.video.water.beats import bouts
from tools.video.water.film import Film, places
from tools.video.water.gaits import gaits_of
from tools.video.water.muscles import Muscles
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


def _with_two_turns(body: Body, held: dict[Pattern, Segment]) -> Film:
    """Return a film of a gradual turn to the left and a sharp one to the right."""
    right = mirrored(held[Pattern.TURN_SHARP_LEFT], Pattern.TURN_SHARP_RIGHT)
    outing = _outing(held, [held[Pattern.TURN_LEFT], right])
    return filmed(body, outing, frames=len(outing.shape) - 6)


@pytest.mark.parametrize("name", ["sardine", "blue_tang"])
def test_a_gradual_and_a_sharp_turn_are_found(
    body: Callable[[str], Body], segments: Segments, name: str
) -> None:
    held = segments(name)
    shown = _with_two_turns(body(name), held)
    cuts, cruise, _ = gaits_of(shown, bouts(shown), body(name))
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


def _in_a_flume(shown: Film, beat: int) -> Film:
    """Return a film in whose picture a steady current takes back what the fish swims in its first three beats."""
    at = places(shown)
    current = (at[3 * beat] - at[0]) / (3 * beat)
    carried = shown.length * current * np.arange(len(at))[:, None]
    return replace(shown, axis=shown.axis - carried[:, None])


def _with_a_camera_beside(shown: Film, beat: int) -> Film:
    """Return a film whose camera goes along with the fish."""
    padded = np.pad(places(shown), ((beat // 2, beat - 1 - beat // 2), (0, 0)), mode="edge")
    middle = np.stack([np.convolve(padded[:, i], np.ones(beat) / beat, "valid") for i in (0, 1)], 1)
    return replace(shown, axis=shown.axis - shown.length * middle[:, None])


@pytest.mark.parametrize("name", ["sardine", "clownfish", "angelfish"])
def test_turns_in_a_current_are_those_through_the_water(
    body: Callable[[str], Body], segments: Segments, name: str
) -> None:
    held = segments(name)
    shown = _with_two_turns(body(name), held)
    carried = _in_a_flume(shown, len(held[Pattern.SWIM_MEDIUM].shape))
    still, flume = (gaits_of(film, bouts(film), body(name)) for film in (shown, carried))
    assert (still.cruise.assumed, flume.cruise.assumed) == (False, True)
    assert [cut.segment.pattern for cut in flume.cuts] == [
        Pattern.SWIM_MEDIUM, Pattern.TURN_LEFT, Pattern.TURN_SHARP_LEFT,
    ]  # fmt: skip
    for found, truth in zip(flume.cuts, still.cuts, strict=True):
        turned = DEGREES * heading_change(found.segment)
        assert turned == pytest.approx(DEGREES * heading_change(truth.segment), abs=1.0)
        assert mean_speed(found.segment) == pytest.approx(mean_speed(truth.segment), rel=0.1)


@pytest.mark.parametrize("name", ["anthias", "angelfish"])
def test_a_single_turn_neither_hides_the_beats_nor_is_a_slow_one(
    body: Callable[[str], Body], segments: Segments, name: str
) -> None:
    held = segments(name)
    outing = _outing(held, [held[Pattern.TURN_SHARP_LEFT]])
    shown = filmed(body(name), outing, frames=len(outing.shape) - 6)
    cuts, cruise, _ = gaits_of(shown, bouts(shown), body(name))
    beat = len(held[Pattern.SWIM_MEDIUM].shape)
    assert cruise.frequency == pytest.approx(60 / beat, rel=0.01)
    assert [cut.segment.pattern for cut in cuts] == [Pattern.SWIM_MEDIUM, Pattern.TURN_SHARP_LEFT]


def test_turns_that_a_camera_goes_along_with_are_not_taken(
    body: Callable[[str], Body], segments: Segments
) -> None:
    held = segments("sardine")
    outing = _outing(held, [held[Pattern.TURN_SHARP_LEFT]])
    shown = filmed(body("sardine"), outing, frames=len(outing.shape) - 6)
    shown = _with_a_camera_beside(shown, len(held[Pattern.SWIM_MEDIUM].shape))
    gaits = gaits_of(shown, bouts(shown), body("sardine"))
    assert [cut.segment.pattern for cut in gaits.cuts] == [Pattern.SWIM_MEDIUM]
    assert list(gaits.refused) == pytest.approx([75] * len(gaits.refused), abs=12)
    assert gaits.refused
    assert all("the camera goes along" in why for why in gaits.refused.values())


@pytest.mark.parametrize("beside", [True, False])
def test_the_user_is_told_why_a_turn_is_not_taken_and_what_is_assumed(
    body: Callable[[str], Body],
    repertoire: Callable[[str], Repertoire],
    segments: Segments,
    monkeypatch: pytest.MonkeyPatch,
    beside: bool,
) -> None:
    held = segments("sardine")
    figures = SwimFigures(2.2, 4.0, 0.16, 0.03, 0.29, 0.0, backward=True)
    muscles = Muscles(body("sardine"), load_species("sardine").swim, figures)
    monkeypatch.setattr(species, "muscles_for", lambda *_: muscles)
    monkeypatch.setattr(species, "capture", lambda *_: repertoire("sardine"))
    outing = _outing(held, [held[Pattern.TURN_SHARP_LEFT]])
    shown = filmed(body("sardine"), outing, frames=len(outing.shape) - 6)
    seen = _with_a_camera_beside if beside else _in_a_flume
    told = species.species_of(seen(shown, 15), "clip", lambda *_: None).said
    why = [line for line in told if "a turn is not taken: its way does not turn" in line]
    current = [line for line in told if "a current that stays the same" in line]
    assert (len(why), len(current)) == ((1, 0) if beside else (0, 1))
    assert any("could not give them: swim slow, swim fast, turn left" in line for line in told)


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
    cuts, _, _ = gaits_of(leapt, bouts(leapt), body("sardine"))
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
    cuts, usual, _ = gaits_of(shown, bouts(shown), body("sardine"))
    found = {cut.segment.pattern: mean_speed(cut.segment) for cut in cuts}
    assert usual.frequency == pytest.approx(4.0, rel=0.01)
    for part in (slow, cruise, fast):
        assert found[part.pattern] == pytest.approx(mean_speed(part), rel=0.08)
