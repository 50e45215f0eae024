"""Where a fish is and which way it heads: moments of its mask, and the heavier half is the head's (papers/003, 4.1).

Principal component analysis leaves the sign open. Continuity settles it from frame to frame; what the first frames say
together settles it once.
"""

from collections.abc import Sequence
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s, Int32s
from tools.video.images import Grey
from tools.video.mask import Sighting

_ROUND: Final = 1.15
"""Ratio of principal spreads below which a shape has no direction."""


def principal(outline: Int32s) -> tuple[Float64s, Float64s, float]:
    """Return barycentre [px], unit vector of greatest spread and ratio of spreads of what a contour holds."""
    m = cv2.moments(outline)
    centre = np.array([m["m10"], m["m01"]]) / m["m00"]
    spread = np.array([[m["mu20"], m["mu11"]], [m["mu11"], m["mu02"]]]) / m["m00"]
    values, vectors = np.linalg.eigh(spread)
    return centre, vectors[:, 1], float(np.sqrt(values[1] / max(values[0], 1e-9)))


def is_round(ratio: float) -> bool:
    """Return whether a shape of this ratio of spreads has no direction."""
    return ratio < _ROUND


def head_evidence(mask: Grey, centre: Float64s, ahead: Float64s) -> float:
    """Return how much the mask speaks for its head lying `ahead`: minus the skewness along that line.

    A long thin tail behind makes the distribution of pixels lean forwards, towards the heavier half.
    """
    y, x = np.nonzero(mask[::2, ::2])
    along = (2.0 * x - centre[0]) * ahead[0] + (2.0 * y - centre[1]) * ahead[1]
    along = along - along.mean()
    return float(-(along**3).mean() / max((along**2).mean() ** 1.5, 1e-9))


def first_heading(sightings: Sequence[Sighting]) -> Float64s:
    """Return the unit vector towards the head in the first of these frames, by what all of them say together."""
    _, first, _ = principal(sightings[0].outline)
    ahead, evidence = first, 0.0
    for sighting in sightings:
        centre, found, ratio = principal(sighting.outline)
        if is_round(ratio):
            continue
        ahead = continued(found, ahead)
        evidence += head_evidence(sighting.mask, centre, ahead)
    return first if evidence >= 0.0 else -first


def continued(found: Float64s, before: Float64s) -> Float64s:
    """Return the unit vector with the sign that turns by less than a right angle from the one before."""
    return found if float(found @ before) >= 0.0 else -found
