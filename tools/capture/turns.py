"""Captures turns out of the cruise, gradual and sharp (papers/000, 4.2; FINDINGS 1b).

A sharp turn is sought: the pulses are tried at several scales and from several phases of the beat, each try is cut
where the fish is back in its beat, and of those that bend no joint too far the one that turns farthest is kept.
"""

from collections.abc import Iterator
from math import floor
from typing import Final, NamedTuple

import numpy as np

from components.clock import TICKS_PER_SECOND
from components.segment import Pattern, Segment, heading_change
from components.trigonometry import DEGREE
from systems.motor.biomechanics import SUBSTEPS
from systems.motor.contract import TURN_PULSE, Stroke
from systems.motor.controllers import turn_left
from systems.motor.muscle_model import BodyModel
from tools.capture.bend import SHARP_LEAST, TURN_GAP, Bend, largest_joint, level_turn
from tools.capture.cut import body_shape, cut, shape_gap
from tools.capture.measure import turn_faults, turn_text
from tools.capture.phase import begun
from tools.capture.record import BlewUpError, Recording, at_rest, record


class Found(NamedTuple):
    """A segment that was cut."""

    segment: Segment
    figures: str
    "as one line for the provenance"
    faults: list[str]
    stroke: Stroke
    "what the muscles do, counted from the first entry"


GRADUAL_SCALE: Final = 0.15
"""Scale of the pulses that a gradual turn is tried with ..."""

GRADUAL_TURN: Final = 30.0 * DEGREE
"""[rad] ... and what it should turn: the turn grows with the scale ..."""

GRADUAL_RANGE: Final = (0.08, 0.32)
"""... between these."""

SHARP_SCALES: Final = (0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
SHARP_PHASES: Final = 16
SHARP_END: Final = (54, 72)
"""Frames between which a sharp turn is cut: it takes 1.2 s at most."""

SHARP_JOINT: Final = 65.0 * DEGREE
"""[rad] that a joint may bend in a sharp turn."""

_LONGEST_TURN: Final = 8
"""Beats after which a gradual turn is cut, however it looks."""

_PULSE_SECONDS: Final = max(float(p[1:].sum()) for p in TURN_PULSE)


def gradual_turn(model: BodyModel, stroke: Stroke, first: int) -> Found:
    """Return a gradual left turn out of the cruise at frame `first`; it ends in the cruise's shape and phase."""
    tried = heading_change(_gradual(model, stroke, first, GRADUAL_SCALE).segment)
    least, most = GRADUAL_RANGE
    scale = GRADUAL_SCALE * GRADUAL_TURN / tried if tried > 0.0 else most
    return _gradual(model, stroke, first, min(max(scale, least), most))


def _gradual(model: BodyModel, stroke: Stroke, first: int, scale: float) -> Found:
    period = stroke.period // SUBSTEPS
    turning = turn_left(stroke, scale, first + 1)
    recording = record(model, turning, first + _LONGEST_TURN * period + 1)
    beats = floor(_PULSE_SECONDS * TICKS_PER_SECOND / period) + 1
    while beats < _LONGEST_TURN and shape_gap(recording, first, first + beats * period) > TURN_GAP:
        beats += 1
    gap = shape_gap(recording, first, first + beats * period)
    segment = cut(recording, Pattern.TURN_LEFT, first, beats * period, False)
    faults = turn_faults(segment, gap, TURN_GAP)
    return Found(segment, turn_text(segment, gap), faults, begun(turning, first + 1))


class _Try(NamedTuple):
    """A sharp turn that was tried: the first `length` frames after a recording's first."""

    recording: Recording
    length: int
    bend: Bend
    stroke: Stroke


def sharp_turn(model: BodyModel, stroke: Stroke, first: int) -> Found:
    """Return the sharp left turn out of the cruise, one of whose beats begins at frame `first`.

    Tries that blow up count for nothing. Raise BlewUpError where all do.
    """
    tries = list(_tries(model, stroke, first))
    if not tries:
        raise BlewUpError(first)
    fit = [t for t in tries if t.bend.gap <= TURN_GAP and t.bend.joint <= SHARP_JOINT]
    best = max(fit, key=lambda t: t.bend.net) if fit else min(tries, key=lambda t: t.bend.joint)
    segment = cut(best.recording, Pattern.TURN_SHARP_LEFT, 0, best.length, False)
    faults = best.bend.faults(SHARP_LEAST, TURN_GAP)
    return Found(segment, best.bend.text(segment), faults, best.stroke)


def _tries(model: BodyModel, stroke: Stroke, first: int) -> Iterator[_Try]:
    period = stroke.period // SUBSTEPS
    state, swum = at_rest(model), 0
    for phase in range(SHARP_PHASES):
        begin = first + phase * period // SHARP_PHASES
        record(model, stroke, begin - swum, state, swum)
        swum = begin
        beat = record(model, stroke, period, state.copy(), begin)
        for scale in SHARP_SCALES:
            turning = turn_left(stroke, scale, begin + 1)
            try:
                recording = record(model, turning, SHARP_END[1] + 2, state.copy(), begin)
            except BlewUpError:
                continue
            yield _cut_in_beat(recording, beat, begun(turning, begin + 1))


def _cut_in_beat(recording: Recording, beat: Recording, stroke: Stroke) -> _Try:
    """Return a turn up to the frame whose shape is nearest to the beat's in its phase."""
    shapes = [body_shape(beat, k) for k in range(len(beat.nodes))]
    period = len(shapes)
    gaps = [
        float(np.abs(body_shape(recording, frame) - shapes[frame % period]).max())
        for frame in range(SHARP_END[0], SHARP_END[1] + 1)
    ]
    length = SHARP_END[0] + gaps.index(min(gaps))
    net = level_turn(beat.rotation[length % period], recording.rotation[length])
    joint = largest_joint(recording.nodes[: length + 1])
    return _Try(recording, length, Bend(net, joint, min(gaps)), stroke)
