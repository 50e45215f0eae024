"""Muscles that make a body swim as it was filmed: what the clip does not show is captured with them (papers/000, 3.2).

A simplex search over contractions, lag and stiffness; frequency is the filmed one, as far as the model goes. What it
looks for is the sweep of tail and head, and the speed, all in one number.
"""

from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np
from scipy.optimize import minimize

from components.arrays import Float64s
from components.body import Body, Swim
from components.clock import TICKS_PER_SECOND
from components.repertoire import Pattern
from components.trigonometry import DEGREE
from systems.motor import controllers
from systems.motor.biomechanics import SUBSTEPS
from systems.motor.muscle_model import body_model
from tools.capture.cut import beat_start, cut
from tools.capture.measure import SwimFigures, measure_swim
from tools.capture.record import record
from tools.video.water.cycle import Cycle

FREQUENCIES: Final = (0.5, 6.0)
"""[Hz] that a species file allows."""

_RUNS: Final = 90
_SECONDS: Final = 2.0
_BEATS: Final = 5
_START: Final = np.array([0.3, 0.5, 140.0, 1.0])
_SCALE: Final = np.array([0.1, 0.1, 20.0, 0.4])
_LEAST: Final = np.array([0.05, 0.1, 60.0, 0.3])
_MOST: Final = np.array([0.6, 0.75, 175.0, 3.0])
_JOINT: Final = 45.0 * DEGREE
_FAILED: Final = 50.0


class Muscles(NamedTuple):
    """What was found, and what it does."""

    body: Body
    "with its stiffness"
    swim: Swim
    figures: SwimFigures


def muscles_for(body: Body, cycle: Cycle) -> Muscles | None:
    """Return muscles that swim a body about as a cycle does, None where none were found that swim it at all."""
    frequency = round(min(max(cycle.frequency, FREQUENCIES[0]), FREQUENCIES[1]), 3)
    sweep, head = cycle.sweep(), cycle.head_sweep()

    def cost(place: Float64s) -> float:
        outside = float(
            (
                np.maximum(_LEAST - place, 0.0) / _SCALE + np.maximum(place - _MOST, 0.0) / _SCALE
            ).sum()
        )
        figures = _figures(*_muscles(body, frequency, place))
        if figures is None:
            return _FAILED + outside
        return outside + _apart(figures, cycle.speed, sweep, head)

    simplex = np.concatenate((_START[None], _START + np.diag(_SCALE)))
    options = {"maxfev": _RUNS, "initial_simplex": simplex, "xatol": 1e-3, "fatol": 1e-4}
    found = minimize(cost, _START, method="Nelder-Mead", options=options)
    tuned, swim = _muscles(body, frequency, found.x)
    figures = _figures(tuned, swim)
    return None if figures is None else Muscles(tuned, swim, figures)


def _muscles(body: Body, frequency: float, place: Float64s) -> tuple[Body, Swim]:
    middle, rear, lag, stiffness = np.clip(place, _LEAST, _MOST).tolist()
    swim = Swim(round(middle, 3), round(rear, 3), round(lag, 1), frequency)
    return replace(body, stiffness=round(stiffness, 3)), swim


def _apart(figures: SwimFigures, speed: float, sweep: float, head: float) -> float:
    """Return how far a swim is from the filmed one."""
    off = 4.0 * (figures.sweep / sweep - 1.0) ** 2 + 2.0 * (figures.speed / speed - 1.0) ** 2
    off += 0.5 * ((figures.head_sweep - head) / sweep) ** 2
    return off + (0.0 if figures.backward else 5.0) + 10.0 * max(0.0, figures.joint - _JOINT)


def _figures(body: Body, swim: Swim) -> SwimFigures | None:
    """Return what a short run amounts to, None where it blows up or does not swim."""
    stroke = controllers.swim(swim, 1.0, 1.0)
    period = stroke.period // SUBSTEPS
    frames = max(round(_SECONDS * TICKS_PER_SECOND), _BEATS * period) + 2 * period + 3
    try:
        recording = record(body_model(body, swim), stroke, frames)
        first = round(beat_start(recording, period))
        segment = cut(recording, Pattern.SWIM_MEDIUM, first, period, True)
        figures = measure_swim(recording, segment, first)
    except (ValueError, ArithmeticError):
        return None
    return figures if figures.speed > 0.0 else None
