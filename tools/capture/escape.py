"""Captures the fast start: a C-start to the left from rest (FINDINGS 1b).

Two loops in the space of shapes turn a fish that has no speed. They are bettered for each body by a seeded search, one
change of its contractions at a time, which keeps joints below their limit; then the fast swim takes over.
"""

from math import floor, inf
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.chance import uniform
from components.clock import TICKS_PER_SECOND
from components.segment import Pattern, Segment
from components.trigonometry import DEGREE
from systems.motor.biomechanics import SUBSTEPS
from systems.motor.contract import FAST_START, KNOT_SECONDS, TWO_PI, Stroke
from systems.motor.muscle_model import BodyModel
from tools.capture.bend import START_LEAST, Bend, largest_joint, level_turn, speed_ahead
from tools.capture.cut import body_shape, cut
from tools.capture.phase import begun
from tools.capture.record import BlewUpError, Recording, record
from tools.capture.turns import Found

SEARCHES: Final = 400
"""Changes of the loops that are tried."""

NET_FRAMES: Final = TICKS_PER_SECOND
"""When the net turn is measured: 1 s after rest."""

ENOUGH: Final = 110.0 * DEGREE
"""[rad] beyond which a farther turn counts for nothing."""

EARLY_FRAMES: Final = 4
"""When the first bend's turn of the head is measured, within 67 ms ..."""

EARLY: Final = 90.0 * DEGREE
"""[rad] ... beyond which a farther one counts for nothing."""

JOINT: Final = 66.0 * DEGREE
"""[rad] that a joint may bend without loss."""

STRAIGHT: Final = 8.0 * DEGREE
"""[rad] that joints may be bent 1 s after rest without loss."""

LEAVING: Final = 1.2
"""[BL/s] speed after a second beyond which more counts for nothing."""

START_GAP: Final = 0.06
"""[BL] how near the fast swim's shape a fast start must end."""

END: Final = (44, 60)
"""Frames between which a fast start is cut."""

_PHASES: Final = 8
_SCALES: Final = (0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2)
_STRONGEST: Final = 0.8
_STEP: Final = 0.08
_LEAST_STEP: Final = 0.01
_SHARE: Final = 0.3
_SEED, _STREAM = 1999, 7
_LOOP_SUBSTEPS: Final = SUBSTEPS * floor(
    (FAST_START.shape[1] - 1) * KNOT_SECONDS * TICKS_PER_SECOND + 0.5
)


def fast_start(model: BodyModel, fast: Stroke, beat: Segment) -> Found:
    """Return the fast start to the left, from rest into the swim `fast`, whose cycle is `beat`.

    `model` lies in water of the law "firm".
    """
    loops = _bettered(model)
    runs = [_into_swim(model, fast, loops, k * TWO_PI / _PHASES) for k in range(_PHASES)]
    gaps = [_nearest(run, beat) for run in runs]
    gap, length, chosen = min((*found, k) for k, found in enumerate(gaps))
    alone = _alone(model, loops)
    net = level_turn(alone.rotation[0], alone.rotation[NET_FRAMES])
    joint = max(largest_joint(alone.nodes), largest_joint(runs[chosen].nodes[: length + 1]))
    bend = Bend(net, joint, gap)
    segment = cut(runs[chosen], Pattern.FAST_START_LEFT, 0, length, False)
    faults = bend.faults(START_LEAST, START_GAP)
    stroke = begun(_leaving(fast, loops, chosen * TWO_PI / _PHASES), 1)
    return Found(segment, bend.text(segment), faults, stroke)


def _alone(model: BodyModel, loops: Float64s) -> Recording:
    """Return a fast start that no swim follows; frame 0 is at rest."""
    stroke = Stroke(0.0, 0.0, 0.0, SUBSTEPS, 0.0, turn_at=SUBSTEPS, flight=1.0, loops=loops)
    return record(model, stroke, NET_FRAMES + 1)


def _loss(model: BodyModel, loops: Float64s) -> float:
    """Return what a fast start lacks, in degrees turned."""
    try:
        run = _alone(model, loops)
    except BlewUpError:
        return inf
    net = level_turn(run.rotation[0], run.rotation[NET_FRAMES])
    loss = (ENOUGH - min(net, ENOUGH)) + 5.0 * max(0.0, largest_joint(run.nodes) - JOINT)
    loss += 3.0 * max(0.0, largest_joint(run.nodes[-1:]) - STRAIGHT)
    loss += 0.5 * max(0.0, EARLY - level_turn(run.rotation[0], run.rotation[EARLY_FRAMES]))
    speed = speed_ahead(run.origin[-7:], run.rotation[-1, :, 0])
    return loss / DEGREE + 20.0 * max(0.0, LEAVING - speed)


def _bettered(model: BodyModel) -> Float64s:
    """Return loops that suit the body: random changes, kept where they help, wider after what helped."""
    least, scale = min((_loss(model, scale * FAST_START), scale) for scale in _SCALES)
    loops, step = scale * FAST_START, _STEP
    for turn in range(SEARCHES):
        if least <= 0.0:
            break
        tried = loops.copy()
        for segment in range(tried.shape[0]):
            for knot in range(tried.shape[1] - 1):
                place = tried.shape[1] * segment + knot
                if uniform(_SEED, _STREAM, turn, 2 * place) < _SHARE:
                    change = 2.0 * uniform(_SEED, _STREAM, turn, 2 * place + 1) - 1.0
                    bent = tried[segment, knot] + 1.7 * step * change
                    tried[segment, knot] = max(-_STRONGEST, min(_STRONGEST, bent))
        loss = _loss(model, tried)
        if loss < least:
            loops, least, step = tried, loss, 1.5 * step
        else:
            step = max(_LEAST_STEP, 0.95 * step)
    return loops


def _into_swim(model: BodyModel, fast: Stroke, loops: Float64s, offset: float) -> Recording:
    """Return a fast start that the fast swim follows, its beat shifted by `offset` [rad]."""
    return record(model, _leaving(fast, loops, offset), END[1] + 2)


def _leaving(fast: Stroke, loops: Float64s, offset: float) -> Stroke:
    return fast._replace(
        offset=offset, turn_at=SUBSTEPS, flight=1.0, loops=loops, swim_at=_LOOP_SUBSTEPS
    )


def _nearest(run: Recording, beat: Segment) -> tuple[float, int]:
    """Return the least distance [BL] of a shape that may be the last from the beat's, and its frame."""
    found = []
    for frame in range(END[0], END[1] + 1):
        away = np.abs(beat.shape.astype(np.float64) - body_shape(run, frame)).max(axis=(1, 2))
        found.append((float(away.min()), frame))
    return min(found)
