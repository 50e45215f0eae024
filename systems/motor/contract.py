"""Muscle controllers: what the 12 muscles do to swim and to turn (papers/000, 3.2; FINDINGS 1, 1b).

A muscle's rest length is its length times 1 - c, c its contraction; below zero the muscle extends. Swimming uses the
middle and rear segments, sides in antiphase, the rear lagging; turning contracts one side of all three while the
other side extends by half as much.
"""

from math import floor
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s
from components.kernels import row
from components.trigonometry import cosine, sine
from systems.motor.muscle_model import LEFT, MUSCLES
from systems.motor.pectorals import FOLDED, Pectorals

RAMP_SECONDS: Final = 0.5
"""How long the swim takes to reach its full contractions."""

TWO_PI: Final = 6.283185307179586

TURN_PULSE: Final[Float64s] = np.array(
    [
        [0.42, 0.00, 0.08, 0.03, 0.55],
        [0.60, 0.33, 0.21, 0.30, 0.16],
        [0.60, 0.00, 0.21, 0.30, 0.12],
    ]
)
"""Contraction, start, rise, hold and fall [s] of the three segments' pulses in a full turn, (3, 5)."""

EXTENSION: Final = 0.5
"""How far the other side extends, over the contraction."""

FAST_START: Final[Float64s] = np.array(
    [
        [0.0, 0.62, 0.59, 0.59, 0.65, -0.71, 0.31, 0.70, 0.70, 0.35, -0.10, 0.22, 0.0],
        [0.0, 0.27, 0.23, 0.33, 0.52, 0.24, -0.47, -0.46, 0.32, 0.22, -0.07, 0.23, 0.0],
        [0.0, 0.09, 0.31, 0.32, 0.68, 0.27, 0.43, 0.33, 0.48, 0.71, 0.28, 0.25, 0.0],
    ]
)
"""Contraction of the left of the three segments at 0, .05, ... .6 s of a C-start to the left, negative on
the right: two loops in the space of shapes, which turn a fish that has no speed, (3, 13)."""

KNOT_SECONDS: Final = 0.05
"""Between two contractions of `FAST_START`."""


class Stroke(NamedTuple):
    """What the controllers play: a swim, and a turn to the left that starts at `turn_at`."""

    middle: float
    "contraction of S2, peak to peak"
    rear: float
    "contraction of S3, peak to peak"
    lag: float
    "[rad] of S3 behind S2"
    period: int
    "[substeps] of a beat"
    offset: float
    "[rad] of the beat at the first substep"
    turn: float = 0.0
    "scale of `TURN_PULSE`, negative to the right"
    turn_at: int = 0
    "substep at which turn or fast start begins"
    flight: float = 0.0
    "scale of the fast start's loops, negative to the right"
    loops: Float64s = FAST_START
    "contractions of the fast start, as `FAST_START`"
    fins: Pectorals = FOLDED
    "what the pectoral fins are told"
    swim_at: int = 0
    "substep at which the swim begins to ramp in"


@row
def _ease(fraction: float) -> float:
    """Return the cosine ramp from 0 to 1."""
    return 0.5 - 0.5 * cosine(0.5 * TWO_PI * min(max(fraction, 0.0), 1.0))


@row
def _agonist(bend: float) -> float:
    """Return the contraction of the side that `bend` pulls: the other side extends."""
    return bend if bend > 0.0 else EXTENSION * bend


@row
def pulse(segment: int, seconds: float) -> float:
    """Return the contraction of a full turn's pulse in `segment`, `seconds` after the turn's start."""
    top, start, rise = TURN_PULSE[segment, 0], TURN_PULSE[segment, 1], TURN_PULSE[segment, 2]
    hold, fall = TURN_PULSE[segment, 3], TURN_PULSE[segment, 4]
    age = seconds - start
    height: float = top * (_ease(age / rise) - _ease((age - rise - hold) / fall))
    return height


@row
def loop_bend(loops: Float64s, segment: int, seconds: float) -> float:
    """Return the contraction of a fast start in `segment`, `seconds` after its start: straight from knot to knot."""
    place = seconds / KNOT_SECONDS
    knot = floor(place)
    if knot < 0 or knot >= loops.shape[1] - 1:
        return 0.0
    bend: float = loops[segment, knot]
    bend += (place - knot) * (loops[segment, knot + 1] - bend)
    return bend


@row
def contract(
    stroke: Stroke, length: Float64s, substep: int, substep_seconds: float, rest: Float64s
) -> None:
    """Write the rest lengths [BL] of the 12 muscles into `rest` (91,), from the springs' `length` (91,)."""
    since = max(0, substep - stroke.swim_at)
    ramp = min(1.0, since * substep_seconds / RAMP_SECONDS)
    beat = TWO_PI * ((since % stroke.period) / stroke.period) + stroke.offset
    age = (substep - stroke.turn_at) * substep_seconds
    for segment in range(MUSCLES // 4):
        mean, swing, bend = 0.0, 0.0, 0.0
        if segment == 1:
            mean = 0.5 * ramp * stroke.middle
            swing = mean * sine(beat)
        if segment == 2:
            mean = 0.5 * ramp * stroke.rear
            swing = mean * sine(beat - stroke.lag)
        if stroke.turn != 0.0:
            bend = stroke.turn * pulse(segment, age)
        if stroke.flight != 0.0:
            bend += stroke.flight * loop_bend(stroke.loops, segment, age)
        left = mean + swing + _agonist(bend)
        right = mean - swing + _agonist(-bend)
        for muscle in range(4 * segment, 4 * segment + 4):
            contraction = left if LEFT[muscle % 4] == 1 else right
            rest[muscle] = length[muscle] * (1.0 - contraction)
