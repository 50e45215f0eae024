"""Balance: the part of a fish's mean roll that is taken out in a tick (papers/000, appendix B).

Eq. 3 shows a false roll within each beat (FINDINGS 1), so what is corrected is a running mean.
"""

from typing import Final

from components.clock import TICK_SECONDS
from components.kernels import inlined
from systems.motor.columns import Motors

ROLL_MEMORY: Final = TICK_SECONDS / 0.4
"""Share of today's roll in the running mean: about a beat, so that the false roll of a beat, 6
degrees either way, averages out."""

RIGHTING: Final = 1.5 * TICK_SECONDS
"""Share of the mean roll taken out in a tick."""

FASTEST_RIGHTING: Final = 1.5 * TICK_SECONDS
"""[rad] a tick."""


@inlined
def roll(ahead: float, above: float, aside: float) -> float:
    """Return the roll [rad] from the upward parts of the body's x, y and z axes (appendix B).

    Its sine is -aside / sqrt(1 - ahead^2); root and arc are taken to their second terms, within 1
    degree for what balance meets. On its back a fish rolls to the nearer side as if from a quarter
    turn.
    """
    sine = max(-1.0, min(1.0, -aside * (1.0 + 0.5 * ahead * ahead)))
    if above < 0.0:
        sine = 1.0 if aside <= 0.0 else -1.0
    return sine * (1.0 + sine * sine * (1.0 / 6.0))


@inlined
def righting(i: int, motor: Motors, angle: float) -> float:
    """Take today's roll into the running mean; return the part of it [rad] to take out now."""
    mean = float(motor.mean_roll[i])
    mean += ROLL_MEMORY * (angle - mean)
    correction = max(-FASTEST_RIGHTING, min(FASTEST_RIGHTING, RIGHTING * mean))
    motor.mean_roll[i] = mean - correction
    return correction
