"""Pace: the gear and throttle that give a wanted speed, for behaviours that match, brake or stand (papers/000, 4.2)."""

from typing import Final

from components.arrays import Float64s
from components.kernels import inlined

SLOWEST: Final = -0.2
"""Throttle at which a fish backs up, its fins' best."""

BRISKEST: Final = 1.2
"""Throttle beyond which strides would look stretched."""

_SHIFT: Final = 1.1


@inlined
def pace(speeds: Float64s, length: float, wanted: float) -> tuple[int, float]:
    """Return gear and throttle for `wanted` [m/s], negative to back up, of a fish `length` [m] long.

    `speeds` are the species' own in its three gears [BL/s], (3,): the lowest gear that serves.
    """
    rate = wanted / length
    gear = int(rate > _SHIFT * speeds[0]) + int(rate > _SHIFT * speeds[1])
    return gear, min(max(rate / (speeds[gear] + 1e-9), SLOWEST), BRISKEST)
