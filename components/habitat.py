"""Light and temperature: both fall with depth and vary over a level's day (papers/004's habits; FINDINGS 2).

Units: light 1 is noon just under the surface; temperature in degrees Celsius. Only + - * / and our own sine: minds
decide by them.
"""

from typing import Final, NamedTuple

from components.kernels import inlined
from components.trigonometry import sine

_TURN: Final = 6.283185307179586


class Habitat(NamedTuple):
    """The level's light and warmth. It never changes during a dive; the tick says what of the day it is."""

    day_ticks: int
    "[ticks] of a day; 0 where the sun stands still"
    dawn: float
    "share of the day that has passed when the dive begins: 0 sunrise, .25 noon, .5 sunset"
    night: float
    "light at midnight over noon's"
    clarity: float
    "[m] depth over which light falls to a half"
    surface: float
    "[C] mean temperature at the surface"
    swing: float
    "[C] by which the surface is warmer in the afternoon than the mean"
    fall: float
    "[C/m] by which temperature falls with depth"
    visibility: float = 22.0
    "[m] farthest that anything is seen through the water"


STILL: Final = Habitat(0, 0.25, 0.1, 12.0, 26.0, 0.0, 0.15)
"""Noon for ever in warm water: what a level without these keys has."""


@inlined
def daylight(habitat: Habitat, tick: int) -> float:
    """Return the light just under the surface, from `night` to 1, at a tick."""
    if habitat.day_ticks == 0:
        share = habitat.dawn
    else:
        share = habitat.dawn + (tick % habitat.day_ticks) / habitat.day_ticks
    high = sine(_TURN * (share - int(share)))
    return habitat.night + (1.0 - habitat.night) * max(high, 0.0)


@inlined
def light(habitat: Habitat, day: float, z: float) -> float:
    """Return the light at height z [m], negative, under `day`: it falls as 1 / (1 + depth / clarity)."""
    return day / (1.0 + max(-z, 0.0) / habitat.clarity)


@inlined
def temperature(habitat: Habitat, day: float, z: float) -> float:
    """Return the temperature [C] at height z [m], negative, under daylight `day`."""
    warm = habitat.swing * (2.0 * day - 1.0) / (1.0 + max(-z, 0.0) / 3.0)
    return habitat.surface + warm - habitat.fall * max(-z, 0.0)
