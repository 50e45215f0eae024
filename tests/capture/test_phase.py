"""The notes on muscle phase: physics told by them alone goes on where replay stands (papers/000, 9.1)."""

import json
from math import ceil

import numpy as np
import pytest

from components.arrays import Float64s
from components.body import Body, Swim
from components.repertoire import Pattern, Repertoire
from systems.motor import controllers
from systems.motor.contract import Stroke
from systems.motor.muscle_model import body_model
from tools.capture.cut import body_shape
from tools.capture.phase import begun
from tools.capture.record import State, at_rest, record

PAST_RAMP = 120


def noted_stroke(repertoire: Repertoire, swim: Swim, name: str) -> Stroke:
    """Return the stroke at the first entry of a segment, as its notes say."""
    note = repertoire.provenance
    amplitude, pace = (float(part) for part in note[f"{name}_gear"].split())
    stroke = controllers.swim(swim, amplitude, pace)
    return stroke._replace(
        offset=float(note[f"{name}_phase"]),
        swim_at=-stroke.period * ceil(PAST_RAMP / stroke.period),
        turn=float(note.get(f"{name}_scale", "0")),
    )


def swum(body: Body, swim: Swim, cruise: Stroke, phase: float) -> State:
    """Return a fish that has long cruised and stands where the beat has come to `phase` [rad]."""
    state = at_rest(body_model(body, swim))
    frames = cruise.period // 4
    ahead = (phase - cruise.offset) / (2 * np.pi) * frames
    assert ahead == pytest.approx(round(ahead), abs=1e-6)
    record(body_model(body, swim), cruise, 60 * frames + round(ahead) % frames, state)
    return state


def shapes(body: Body, swim: Swim, stroke: Stroke, state: State, frames: int) -> Float64s:
    run = record(body_model(body, swim), stroke, frames, state)
    return np.array([body_shape(run, frame) for frame in range(frames)])


pytestmark = pytest.mark.parametrize("name", ["sardine"])


@pytest.mark.parametrize("pattern", [Pattern.SWIM_SLOW, Pattern.SWIM_MEDIUM, Pattern.SWIM_FAST])
def test_physics_in_the_noted_phase_makes_the_captured_beat(
    shipped: Repertoire, body: Body, swim: Swim, pattern: Pattern
) -> None:
    stroke = noted_stroke(shipped, swim, pattern.name.lower())
    captured = shipped.segments[pattern].shape
    assert stroke.period == 4 * len(captured)
    state = swum(body, swim, stroke, stroke.offset)
    again = shapes(body, swim, stroke, state, len(captured))
    assert np.abs(again - captured).max() < 1e-5
    late = shapes(body, swim, stroke, state, 1)
    assert np.abs(late[0] - captured[1]).max() > 1e-3


@pytest.mark.parametrize(("place", "pattern"), [(3, "turn_left"), (4, "turn_sharp_left")])
def test_physics_told_of_a_turn_makes_the_captured_one(
    shipped: Repertoire, body: Body, swim: Swim, place: int, pattern: str
) -> None:
    cruise = noted_stroke(shipped, swim, "swim_medium")
    turn = noted_stroke(shipped, swim, pattern)
    assert turn.turn > 0
    captured = shipped.segments[place].shape
    again = shapes(body, swim, turn, swum(body, swim, cruise, turn.offset), len(captured))
    assert np.abs(again - captured).max() < 1e-5


def test_physics_told_of_a_fast_start_makes_the_captured_one(
    shipped: Repertoire, body: Body, swim: Swim
) -> None:
    note = shipped.provenance
    stroke = noted_stroke(shipped, swim, "fast_start_left")._replace(
        flight=1.0,
        loops=np.array(json.loads(note["fast_start_left_loops"])),
        swim_at=int(note["fast_start_left_swim_at"]),
    )
    captured = shipped.segments[5].shape
    model = body_model(body, swim, "firm")
    state = at_rest(model)
    record(model, controllers.glide(), 1, state)
    run = record(model, stroke, len(captured), state)
    again = np.array([body_shape(run, frame) for frame in range(len(captured))])
    assert np.abs(again - captured).max() < 1e-5


def test_a_stroke_begun_later_does_what_the_first_did(body: Body, swim: Swim) -> None:
    model = body_model(body, swim)
    stroke = controllers.turn_left(controllers.swim(swim), 0.3, 50)._replace(swim_at=8)
    state = at_rest(model)
    record(model, stroke, 45, state)
    on = record(model, stroke, 60, state.copy(), 45)
    late = begun(stroke, 45)
    again = record(model, late, 60, state)
    assert np.abs(on.nodes - again.nodes).max() < 1e-9
    assert late.turn_at == 20
