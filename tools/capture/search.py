"""What tuning looks for: how well a body swims with given muscles, as one number to make small (FINDINGS 1b, 3).

A candidate is five numbers of the unit cube, which stand for contractions, lag, frequency and stiffness within the
ranges that fishes and the model allow. Its cost is that of two short swims, cruise and the faster gear, against what
a fish of that length and depth does.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final, NamedTuple

import numpy as np

from components.body import Body, Swim
from components.clock import TICKS_PER_SECOND
from components.repertoire import Pattern, heading_change
from components.trigonometry import DEGREE
from systems.motor import controllers
from systems.motor.biomechanics import SUBSTEPS
from systems.motor.muscle_model import body_model
from tools.capture.capture import GEARS
from tools.capture.cut import beat_start, cut
from tools.capture.faults import check
from tools.capture.measure import SwimFigures, measure_swim
from tools.capture.record import record
from tools.capture.turns import gradual_turn

FAILED: Final = 50.0
"""Cost of a candidate that blows up or does not swim at all."""

_RUN_SECONDS: Final = 3.0
_RUN_BEATS: Final = 6
"""A run lasts as long as either."""

_STRIDE: Final = 0.52
"""[BL] that a fish goes in a beat: speed over frequency."""

_STROUHAL: Final = (0.22, 0.38)
_SWEEP: Final = (0.14, 0.21)
_BEST_STROUHAL: Final = 0.3
_BEST_SWEEP: Final = 0.175
"""Within the ranges these decide, weakly, so that a search has one end."""

_HEAD: Final = 0.4
"""Of the tail's sweep, that the nose's may reach without cost."""

_TURN: Final = (14.0 * DEGREE, 34.0 * DEGREE)
"""[rad] of a gradual turn, well within the limits of measure.py."""

_FASTER: Final = 1.35
"""Speed of the fast gear over the cruise's, that it should reach."""

_STEADY: Final = 2e-5
"""[BL] by which the shape may differ between two beats of a short run without cost."""


class Candidate(NamedTuple):
    """A way to swim, rounded as a species file holds it."""

    swim: Swim
    stiffness: float


@dataclass(frozen=True)
class Aim:
    """What a body is tuned for."""

    body: Body
    "its stiffness does not matter: it is sought"
    speed: float
    "[BL/s] of the cruise"
    turning: bool = False
    "whether a gradual turn's angle counts as well: most bodies turn well without"


def aim_of(body: Body, length: float) -> Aim:
    """Return what a fish of `body` and `length` [m] should reach.

    Speed in body lengths falls with the cube root of length, as that of living fishes does (FINDINGS 3), and deep
    bodies are slower than slender ones; small species cruise at 1 to 3 BL/s, and none slower than .6.
    """
    depth = max([0.03, *(height for height in body.half_height if height < 0.5)])
    speed = 0.92 * length ** (-1 / 3) * (0.13 / depth) ** 0.25
    return Aim(body, round(min(max(speed, 1.0 if length < 0.5 else 0.6), 2.6), 2))


START: Final = (0.5, 0.7, 0.77, 0.46, 0.5)
"""The middle of what nine species were found to need."""


def candidate(aim: Aim, place: Sequence[float]) -> Candidate:
    """Return the candidate at `place`, five numbers from 0 to 1; a beat lasts whole frames."""
    middle, rear, lag, frequency, stiffness = (min(max(float(u), 0.0), 1.0) for u in place)
    wanted = aim.speed / _STRIDE * 0.6 * 3.0**frequency
    frames = round(TICKS_PER_SECOND / min(max(wanted, 0.6), 5.9))
    return Candidate(
        Swim(
            round(0.05 + 0.55 * middle, 3),
            round(0.1 + 0.6 * rear, 3),
            round(60.0 + 110.0 * lag, 1),
            round(TICKS_PER_SECOND / frames, 3),
        ),
        round(0.35 * (2.8 / 0.35) ** stiffness, 3),
    )


def costs(aim: Aim, places: Sequence[Sequence[float]]) -> list[float]:
    """Return the cost of each place: 0 for what swims like a fish, FAILED for what does not swim."""
    return [cost(aim, candidate(aim, place)) for place in places]


def cost(aim: Aim, tried: Candidate) -> float:
    """Return the cost of one candidate (FINDINGS 1b, "Tuning")."""
    try:
        cruise, fast = short_swims(aim.body, tried)
        turn = _turn(aim.body, tried) if aim.turning else _TURN[0]
    except (ValueError, ArithmeticError):
        return FAILED
    least = _FASTER * max(cruise.speed, 0.0)
    total = (
        4.0 * ((cruise.speed - aim.speed) / aim.speed) ** 2
        + _unlike(cruise)
        + 0.5 * _unlike(fast)
        + 4.0 * max(0.0, (least - fast.speed) / aim.speed) ** 2
        + 0.02 * float(np.log2(tried.stiffness)) ** 2
        + (_beyond(turn, _TURN) / (5.0 * DEGREE)) ** 2
    )
    return min(total, FAILED) if np.isfinite(total) else FAILED


def _unlike(swim: SwimFigures) -> float:
    """Return what a beat's figures are beyond a fish's."""
    sweep = max(swim.sweep, 1e-6)
    return (
        200.0 * _beyond(min(swim.strouhal, 2.0), _STROUHAL) ** 2
        + 900.0 * _beyond(swim.sweep, _SWEEP) ** 2
        + 20.0 * max(0.0, swim.head_sweep / sweep - _HEAD) ** 2
        + (0.0 if swim.backward else 20.0)
        + 0.1 * max(0.0, float(np.log10(max(swim.closure, 1e-12) / _STEADY)))
        + 2.0 * (min(swim.strouhal, 2.0) - _BEST_STROUHAL) ** 2
        + 4.0 * (swim.sweep - _BEST_SWEEP) ** 2
    )


def _beyond(value: float, limits: tuple[float, float]) -> float:
    return max(limits[0] - value, value - limits[1], 0.0)


def short_swims(body: Body, tried: Candidate) -> tuple[SwimFigures, SwimFigures]:
    """Return the figures of cruise and fast gear. Raise ValueError where the body does not swim."""
    check(body, tried.swim)
    return (
        _short_swim(body, tried, Pattern.SWIM_MEDIUM),
        _short_swim(body, tried, Pattern.SWIM_FAST),
    )


def _short_swim(body: Body, tried: Candidate, gear: Pattern) -> SwimFigures:
    """Return the figures of a beat soon after the start. Raise ValueError where the body does not swim."""
    model = body_model(replace(body, stiffness=tried.stiffness), tried.swim)
    stroke = controllers.swim(tried.swim, *GEARS[gear])
    period = stroke.period // SUBSTEPS
    frames = max(round(_RUN_SECONDS * TICKS_PER_SECOND), _RUN_BEATS * period) + 2 * period + 3
    recording = record(model, stroke, frames)
    first = int(beat_start(recording, period) + 0.5)
    segment = cut(recording, gear, first, period, False)
    return measure_swim(recording, segment, first)


def _turn(body: Body, tried: Candidate) -> float:
    """Return the angle [rad] of a gradual turn soon after the start. Raise ValueError where it fails."""
    model = body_model(replace(body, stiffness=tried.stiffness), tried.swim)
    stroke = controllers.swim(tried.swim)
    segment = gradual_turn(model, stroke, round(_RUN_SECONDS * TICKS_PER_SECOND / 2)).segment
    return heading_change(segment)
