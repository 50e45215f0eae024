"""Muscle controllers: what the 12 muscles do to swim and to turn (papers/000, 3.2; FINDINGS 1, 1b).

A muscle's rest length is its length times 1 - c, c its contraction; below zero the muscle extends. Swimming uses the
middle and rear segments, sides in antiphase, the rear lagging; turning contracts one side of all three while the
other side extends by half as much.
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s
from components.kernels import row
from components.trigonometry import cosine, sine
from systems.motor.muscle_model import LEFT, MUSCLES

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
    "substep at which the pulses begin"


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
def contract(
    stroke: Stroke, length: Float64s, substep: int, substep_seconds: float, rest: Float64s
) -> None:
    """Write the rest lengths [BL] of the 12 muscles into `rest` (91,), from the springs' `length` (91,)."""
    ramp = min(1.0, substep * substep_seconds / RAMP_SECONDS)
    beat = TWO_PI * ((substep % stroke.period) / stroke.period) + stroke.offset
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
        left = mean + swing + _agonist(bend)
        right = mean - swing + _agonist(-bend)
        for muscle in range(4 * segment, 4 * segment + 4):
            contraction = left if LEFT[muscle % 4] == 1 else right
            rest[muscle] = length[muscle] * (1.0 - contraction)
