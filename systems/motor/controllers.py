"""The nine motor controllers: a stroke of muscles and fins for each thing a fish does (papers/000, 3.2; papers/004).

Muscles swim and turn, the pectoral fins balance, climb, dive, brake and back; a glide is no stroke at all. Each
controller makes a `Stroke` or changes one, so that they may be had together: `ascend(swim(...))` swims upwards.
"""

from math import floor
from typing import Final

from components.body import Body, Swim
from components.clock import TICKS_PER_SECOND
from components.trigonometry import DEGREE
from systems.motor.biomechanics import SUBSTEPS
from systems.motor.contract import Stroke
from systems.motor.pectorals import FOLDED, Pectorals

SLOPE: Final = 25.0 * DEGREE
"""[rad] of climbing and diving."""

FIN_SHAPE: Final = 0.5
"""Area of both pectoral fins over the square of their length: ovals nearly a third as broad as long."""

ROW_HZ: Final = 3.0
"""Strokes a second of fins that row backwards ..."""

ROW_REACH: Final = 6.0
"""... and the fastest speed of their middles over the fins' length [1/s]: 37 degrees either way."""

_LEAST_FRAMES: Final = 4


def swim(parameters: Swim, amplitude: float = 1.0, pace: float = 1.0) -> Stroke:
    """Return the swim at so much of the cruise's amplitude and frequency; a beat lasts whole frames."""
    frames = floor(TICKS_PER_SECOND / (parameters.frequency_hz * pace) + 0.5)
    return Stroke(
        amplitude * parameters.contraction_middle,
        amplitude * parameters.contraction_rear,
        parameters.lag_deg * DEGREE,
        SUBSTEPS * max(frames, _LEAST_FRAMES),
        0.0,
    )


def glide() -> Stroke:
    """Return the stroke of a fish that does nothing."""
    return Stroke(0.0, 0.0, 0.0, SUBSTEPS * _LEAST_FRAMES, 0.0)


def turn_left(stroke: Stroke, scale: float, frame: int) -> Stroke:
    """Return `stroke` with a turn to the left from `frame` on, `scale` of the fullest."""
    return stroke._replace(turn=scale, turn_at=SUBSTEPS * frame)


def turn_right(stroke: Stroke, scale: float, frame: int) -> Stroke:
    """Return `stroke` with a turn to the right from `frame` on, `scale` of the fullest."""
    return turn_left(stroke, -scale, frame)


def balance(stroke: Stroke) -> Stroke:
    """Return `stroke` with fins that right a rolled body."""
    return stroke._replace(fins=stroke.fins._replace(righting=1.0))


def ascend(stroke: Stroke, slope: float = SLOPE) -> Stroke:
    """Return `stroke` with fins that pitch the nose up by `slope` [rad] and keep the body upright."""
    return stroke._replace(fins=stroke.fins._replace(righting=1.0, pitching=1.0, pitch=slope))


def descend(stroke: Stroke, slope: float = SLOPE) -> Stroke:
    """Return `stroke` with fins that pitch the nose down by `slope` [rad] and keep the body upright."""
    return ascend(stroke, -slope)


def brake(body: Body) -> Stroke:
    """Return the stroke of a fish that sets its pectoral fins against the stream and lies still."""
    return balance(glide()._replace(fins=_spread(body)))


def backward(body: Body) -> Stroke:
    """Return the stroke of a fish that rows backwards with its pectoral fins."""
    fins = _spread(body)._replace(
        rowing=ROW_REACH * body.pectoral_length, period=SUBSTEPS * TICKS_PER_SECOND // int(ROW_HZ)
    )
    return balance(glide()._replace(fins=fins))


def _spread(body: Body) -> Pectorals:
    """Return fins set broadside."""
    return FOLDED._replace(area=FIN_SHAPE * body.pectoral_length * body.pectoral_length)
