"""The outline of a fish between its stations, in body lengths (FINDINGS 1b, 8).

x is the distance from the nose backwards. The body ends inside the root of the caudal fin. The snout is rounded: the
outline grows there like a power of x below 1.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.body import Body

SNOUT: Final = 0.6
"""Power of x by which most snouts open; 0.5 would be a parabola, 1 a cone."""
ROOT: Final = 0.42
"""Where the body ends between the last ring (0) and the tail's tips (1)."""
FLARE: Final = 1.12
"""Height of the body's end over that of the last ring."""
MOUTH_DROP: Final = 0.16
"""How far the snout lies under the body's axis, over the first ring's half-height."""
KEEL: Final = 1.12
"""Power of the sine that makes a cross-section a little lens-shaped."""


@dataclass(frozen=True)
class Outline:
    """Knots of the outline over x ** SNOUT; made by `outline_of`."""

    end: float
    "x [BL] where the body ends"
    knots: Float64s
    "x ** SNOUT, (7,)"
    height: Float64s
    "half-height [BL], (7,)"
    width: Float64s
    "half-width [BL], (7,)"
    first: float
    "x [BL] of the first ring"
    drop: float
    "how far the snout lies under the axis [BL]"
    snout: float = SNOUT
    "power of x at which the knots are spaced"

    def half_height(self, x: Float64s) -> Float64s:
        """Return the half-height at x, both in BL."""
        return _monotone(self._powers(x), self.knots, self.height, self.snout)

    def half_width(self, x: Float64s) -> Float64s:
        """Return the half-width at x, both in BL."""
        return _monotone(self._powers(x), self.knots, self.width, self.snout)

    def middle(self, x: Float64s) -> Float64s:
        """Return the height of the section's middle over the axis at x, both in BL."""
        before = np.clip(1.0 - np.asarray(x) / (1.6 * self.first), 0.0, 1.0)
        lowered: Float64s = -self.drop * before**2
        return lowered

    def section(self, x: Float64s, around: Float64s) -> Float64s:
        """Return points (..., 3) of the right half at x and `around`, 0 at the back to 1 at the belly."""
        angle = np.pi * around
        y = self.middle(x) + self.half_height(x) * np.cos(angle)
        z = self.half_width(x) * np.clip(np.sin(angle), 0.0, 1.0) ** KEEL
        return np.stack(np.broadcast_arrays(-x, y, z), axis=-1)

    def _powers(self, x: Float64s) -> Float64s:
        powers: Float64s = np.clip(np.asarray(x, np.float64), 0.0, self.end) ** self.snout
        return powers


def outline_of(body: Body) -> Outline:
    """Return the smooth outline through the body's five stations."""
    last = body.station[4]
    end = last + ROOT * (1.0 - last)
    x = np.array([0.0, *body.station, end])
    height = np.array([0.0, *body.half_height, FLARE * body.half_height[4]])
    width = np.array([0.0, *body.half_width, 0.16 * body.half_width[4]])
    drop = MOUTH_DROP * body.half_height[0]
    return Outline(end, x**body.snout, height, width, body.station[0], drop, body.snout)


def _monotone(at: Float64s, x: Float64s, y: Float64s, snout: float) -> Float64s:
    """Interpolate without overshoot (Fritsch and Carlson 1980); the more pointed the snout, the hollower."""
    gap = np.diff(x)
    rise = np.diff(y) / gap
    slopes = np.empty_like(y)
    slopes[0], slopes[-1] = (1.35 + 1.5 * (SNOUT - snout)) * rise[0], rise[-1]
    left, right = rise[:-1], rise[1:]
    same = left * right > 0
    weight_l, weight_r = 2 * gap[1:] + gap[:-1], gap[1:] + 2 * gap[:-1]
    total = np.where(
        same, weight_l / np.where(same, left, 1) + weight_r / np.where(same, right, 1), 1
    )
    slopes[1:-1] = np.where(same, (weight_l + weight_r) / total, 0.0)
    i = np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(gap) - 1)
    t = (at - x[i]) / gap[i]
    value: Float64s = (
        (1 + 2 * t) * (1 - t) ** 2 * y[i]
        + t * (1 - t) ** 2 * gap[i] * slopes[i]
        + t * t * (3 - 2 * t) * y[i + 1]
        + t * t * (t - 1) * gap[i] * slopes[i + 1]
    )
    return value
