"""What a fish feels: hunger, libido, fear, and unease where light and warmth do not suit it (papers/004; FINDINGS 2).

The formulas are the thesis', each variable from 0 to 1, with its stimulus terms: what is near makes one want it.
Tu's lengths are in units of his world: here food and mates are measured in the fish's own lengths, in his ratios, and
fear in metres over the predator's length, as `SenseTable.wariness` says.
"""

from math import sqrt
from typing import Final

from components.habitat import Habitat, light, temperature
from components.kernels import inlined

APPETISING: Final = 0.8
"""a_h: weight of the stimulus of food."""

ALLURING: Final = 0.5
"""a_l: weight of the stimulus of a mate."""

FOOD_FAR: Final = 1.0 / 8.0
"""q1 [1/BL]: food farther than 8 lengths does not tempt."""

FOOD_NEAR: Final = 1.0 / 2.0
"""q2 [1/BL]: food within 2 lengths tempts wholly."""

MATE_FAR: Final = 1.0 / 16.0
MATE_NEAR: Final = 1.0 / 4.0

OVERFULL: Final = 2.0
"""Appetites in the stomach from which nothing tempts any more."""

BRIGHT_FROM: Final = 0.45
"""Light that who likes it wants at least."""

DARK_TO: Final = 0.55
"""Light that who likes the dark bears at most."""

WARM_WITHIN: Final = 1.2
"""[C] below the mean of the surface that who likes warmth bears."""

COLD_BELOW: Final = 1.0
"""[C] below the mean of the surface that who likes the cold wants."""

_DEGREES: Final = 2.0


@inlined
def stimulus(nearness: float, far: float, near: float) -> float:
    """Return S, 0 to 1, of something at 1 / `nearness`: 0 below q1 = `far`, 1 above q2 = `near`."""
    if nearness <= far:
        return 0.0
    if nearness >= near:
        return 1.0
    return (nearness - far) / (2.0 * near - far - nearness)


@inlined
def appetite(stomach: float, meals: float) -> float:
    """Return hunger without stimulus, -1 to 1: 1 - n R(t) / a, `stomach` being n R and `meals` a.

    It falls below 0 where more is in the stomach than fills it: then only what is near tempts.
    """
    return max(1.0 - stomach / meals, -1.0)


@inlined
def hunger_of(plain: float, tempted: float) -> float:
    """Return H, 0 to 1, from `appetite` and the stimulus of food; 0 for the overfull."""
    if plain <= 1.0 - OVERFULL:
        return 0.0
    return min(max(plain + APPETISING * tempted, 0.0), 1.0)


@inlined
def desire(waited: float, breeding: float, hunger: float) -> float:
    """Return libido without stimulus, 0 to 1: p1 t (1 - H), `waited` and `breeding` = 1 / p1 in ticks."""
    return min(max(waited, 0.0) / breeding * (1.0 - hunger), 1.0)


@inlined
def libido_of(plain: float, allured: float) -> float:
    """Return L, 0 to 1, from `desire` and the stimulus of a mate: without desire there is none."""
    return min(plain + ALLURING * allured * min(4.0 * plain, 1.0), 1.0)


@inlined
def fear_of(wariness: float, size: float, far: float) -> float:
    """Return F_i, 0 to 1: min(D0 / d, 1), D0 being `wariness` [m] times the predator's `size` [m]."""
    return min(wariness * size / (far + 1e-9), 1.0)


@inlined
def fear_of_submarine(wariness: float, speed: float, far: float) -> float:
    """Return F_i of the submarine at `far` [m]: it is feared as a fish that grows with its `speed` [m/s]."""
    return min(wariness * (0.5 + 0.6 * speed) / (far + 1e-9), 1.0)


@inlined
def speed_of(vx: float, vy: float, vz: float) -> float:
    """Return the length of a velocity."""
    return sqrt(vx * vx + vy * vy + vz * vz)


@inlined
def unease(habitat: Habitat, day: float, z: float, bright: int, warm: int) -> tuple[float, float]:
    """Return how little light and warmth at height z [m] suit the habits, 0 to 1, and where to go: 1 up, -1 down.

    Contradictory habits (`bright` and `warm` are 1, -1 or 0) pull both ways: the stronger is followed.
    """
    lit, much, way = light(habitat, day, z), 0.0, 0.0
    if bright > 0:
        much, way = max(BRIGHT_FROM - lit, 0.0) / BRIGHT_FROM, 1.0
    elif bright < 0:
        much, way = max(lit - DARK_TO, 0.0) / (1.0 - DARK_TO), -1.0
    if warm != 0:
        below = habitat.surface - temperature(habitat, day, z)
        lack = below - WARM_WITHIN if warm > 0 else COLD_BELOW - below
        lack = min(max(lack, 0.0) / _DEGREES, 1.0)
        if lack > much:
            much, way = lack, 1.0 if warm > 0 else -1.0
    return min(much, 1.0), way
