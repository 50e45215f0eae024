"""Rocks as content gives them and as kernels read them: packed ellipsoids, listed by squares of the plan.

Lists by square are what keeps a test against hundreds of rocks as cheap as one against a few (FINDINGS 5).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil
from typing import Final

import numpy as np

from components.arrays import Float64s, Int32s, Int64s
from components.trigonometry import DEGREE, cosine, sine

ROCK_REACH: Final = 3.0
"""[m] around a square within which every rock is listed."""

ROOF_REACH: Final = 1.0
"""[m] around a square within which no ground and no rock is higher than its roof."""

SQUARE: Final = 2.0
"""[m] side of the squares that list their rocks."""


@dataclass(frozen=True)
class Rock:
    """A rock as content gives it: an ellipsoid turned about z."""

    centre: tuple[float, float, float]
    "[m]"
    radii: tuple[float, float, float]
    "[m] semi-axes"
    yaw_deg: float = 0.0


def pack_rocks(rocks: Sequence[Rock]) -> tuple[Float64s, Float64s, Float64s]:
    """Return centres [m], (K, 3), semi-axes [m], (K, 3), and cosine and sine of the yaws, (K, 2).

    Raise ValueError where a semi-axis is no positive number.
    """
    if not all(min(rock.radii) > 0.0 for rock in rocks):
        raise ValueError("a rock needs radii > 0")
    centre = np.array([rock.centre for rock in rocks], np.float64).reshape(-1, 3)
    radii = np.array([rock.radii for rock in rocks], np.float64).reshape(-1, 3)
    yaw = [rock.yaw_deg * DEGREE for rock in rocks]
    axes = np.array([(cosine(a), sine(a)) for a in yaw], np.float64).reshape(-1, 2)
    return centre, radii, axes


def squares_around(
    centre: Float64s, radii: Float64s, axes: Float64s, extent: float, side: int, reach: float
) -> tuple[Int64s, Int64s]:
    """Return the first and last square, (K, 2) each, that lie within `reach` [m] of the box round each rock."""
    a, b = radii[:, :1] * axes, radii[:, 1:2] * axes[:, ::-1]
    half, middle = np.sqrt(a * a + b * b), centre[:, :2] + extent
    low = np.clip((middle - half - reach) // SQUARE, 0, side - 1)
    high = np.clip((middle + half + reach) // SQUARE, 0, side - 1)
    return low.astype(np.int64), high.astype(np.int64)


def list_rocks(
    centre: Float64s, radii: Float64s, axes: Float64s, extent: float
) -> tuple[int, Int32s, Int32s]:
    """Return squares a side, where each square's list begins, and the rocks in reach of each square."""
    side = max(1, ceil(2.0 * extent / SQUARE))
    lists: list[list[int]] = [[] for _ in range(side * side)]
    low, high = squares_around(centre, radii, axes, extent, side, ROCK_REACH)
    for rock in range(len(centre)):
        for i in range(low[rock, 0], high[rock, 0] + 1):
            for j in range(low[rock, 1], high[rock, 1] + 1):
                lists[i * side + j].append(rock)
    first = np.zeros(side * side + 1, np.int32)
    first[1:] = np.cumsum([len(rocks) for rocks in lists])
    return side, first, np.array([rock for rocks in lists for rock in rocks], np.int32)
