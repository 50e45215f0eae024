"""Where a fish is and which way it heads: moments of its mask, and the heavier half is the head's (papers/003, 4.1).

Principal component analysis leaves the sign open. Continuity settles it from frame to frame; what the first frames say
together settles it once.
"""

from collections.abc import Sequence
from typing import Final, NamedTuple

import cv2
import numpy as np

from components.arrays import Float64s, Int32s
from tools.video.mask import Sighting

_ROUND: Final = 1.15
"""Ratio of principal spreads below which a shape has no direction."""


class Shape(NamedTuple):
    """Moments of what a contour holds."""

    centre: Float64s
    "barycentre [px], (2,)"
    axis: Float64s
    "unit vector of greatest spread, its sign open, (2,)"
    ratio: float
    "greatest spread over least"
    lean: float
    "how much speaks for the head lying along the axis: a thin tail leaves the skewness on its side"

    @property
    def is_round(self) -> bool:
        """Whether it has no direction."""
        return self.ratio < _ROUND

    def evidence(self, ahead: Float64s) -> float:
        """Return how much speaks for the head lying `ahead`, along the axis or against it."""
        return self.lean if float(self.axis @ ahead) >= 0.0 else -self.lean


def shape_of(outline: Int32s) -> Shape:
    """Return the moments of what a closed contour (n, 2) holds."""
    m = cv2.moments(outline)
    centre = np.array([m["m10"], m["m01"]]) / m["m00"]
    spread = np.array([[m["mu20"], m["mu11"]], [m["mu11"], m["mu02"]]]) / m["m00"]
    values, vectors = np.linalg.eigh(spread)
    x, y = vectors[:, 1]
    third = (
        x**3 * m["mu30"] + 3 * x**2 * y * m["mu21"] + 3 * x * y**2 * m["mu12"] + y**3 * m["mu03"]
    )
    ratio = float(np.sqrt(values[1] / max(values[0], 1e-9)))
    lean = -float(third / m["m00"] / max(values[1], 1e-9) ** 1.5)
    return Shape(centre, vectors[:, 1], ratio, lean)


def first_heading(sightings: Sequence[Sighting]) -> Float64s:
    """Return the unit vector towards the head in the first of these frames, by what all of them say together."""
    first = shape_of(sightings[0].outline).axis
    ahead, evidence = first, 0.0
    for sighting in sightings:
        shape = shape_of(sighting.outline)
        if not shape.is_round:
            ahead = continued(shape.axis, ahead)
            evidence += shape.evidence(ahead)
    return first if evidence >= 0.0 else -first


def continued(found: Float64s, before: Float64s) -> Float64s:
    """Return the unit vector with the sign that turns by less than a right angle from the one before."""
    return found if float(found @ before) >= 0.0 else -found
