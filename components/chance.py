"""Chance that does not depend on the order of evaluation: named, counter-based integer streams
(DESIGN 2).

A draw is a hash of (seed, stream, tick, id), so it is the same whichever thread asks first and
whether or not anybody else asked. The mix is the finaliser of SplitMix64 (Steele, Lea and Flood
2014), applied once for each word.
"""

from typing import Final

import numpy as np

from components.kernels import row

WANDER: Final = 1
PLACE: Final = 2
SIZE: Final = 3
HEADING: Final = 4
SEGMENT: Final = 5
NOISE: Final = 6
PLACE_IN_SCHOOL: Final = 8
PANIC: Final = 11
CURIOSITY: Final = 12
FOOD_PLACE: Final = 9
EATEN: Final = 10
SEX: Final = 13
MATED: Final = 14
RESTOCK: Final = 15
WHIM: Final = 16
PLANT: Final = 20


@row
def mix(word: np.uint64) -> np.uint64:
    """Return SplitMix64's finaliser of a 64-bit word."""
    z = np.uint64(word) + np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return z ^ (z >> np.uint64(31))


@row
def draw(seed: int, stream: int, tick: int, identity: int) -> np.uint64:
    """Return 64 random bits named by (seed, stream, tick, identity)."""
    word = mix(np.uint64(seed) ^ mix(np.uint64(stream)))
    return mix(mix(word ^ np.uint64(tick)) ^ np.uint64(identity))


@row
def uniform(seed: int, stream: int, tick: int, identity: int) -> float:
    """Return a float64 in [0, 1), uniform, named by (seed, stream, tick, identity)."""
    return np.float64(draw(seed, stream, tick, identity) >> np.uint64(11)) * (
        1.0 / 9007199254740992.0
    )
