"""Paints a fish that holds station out of the plate: the median of a pixel that it never leaves is the fish.

At quarter size: hot pixels change over the clip; the dark (or bright) components that overlap them most, and that the
median shows too, are fishes. What they cover for much of the clip is grown and filled from around.
"""

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from tools.video.images import Bools, Grey
from tools.video.median_plate import median_of

_QUARTER: Final = 4
_HOT: Final = 20.0
"""[grey levels] between a pixel's 5th and 95th percentile over the clip, from which it is hot."""
_GROWN: Final = 9
_RADIUS: Final = 3
_OFTEN: Final = 0.3
"""Share of the clip for which a pixel must be covered by the fish to be painted over."""
_RIM: Final = 0.18
"""Share of a standing body's rim that must be hot: what never moves, as a stone, has none but where a fish passed."""
_LEAST: Final = 24
_ALIKE: Final = 0.1
"""Part of what the likeliest component overlaps that another must, to be looked at too."""
_MOST: Final = 0.35
"""Share of the frame above which a component is the ground, not a fish."""


def without_standing_fish(samples: NDArray[np.uint8], median: Grey) -> tuple[Grey, bool]:
    """Return the plate, and whether a fish was painted out; samples (n, height, width) stand as blurred frames."""
    found = _standing(samples, median)
    if found is None:
        return median, False
    height, width = median.shape
    cover = cv2.resize(found, (width, height), interpolation=cv2.INTER_NEAREST)
    return np.asarray(cv2.inpaint(median, cover, _RADIUS, cv2.INPAINT_TELEA), np.uint8), True


def _standing(samples: NDArray[np.uint8], median: Grey) -> Grey | None:
    """Return the mask at quarter size of what a fish covers too long, grown, None where there is none."""
    height, width = median.shape
    size = (max(1, width // _QUARTER), max(1, height // _QUARTER))
    small = np.stack([cv2.resize(s, size, interpolation=cv2.INTER_AREA) for s in samples])
    low, high = np.percentile(small, (5, 95), axis=0)
    swing = high - low
    centre = float(np.median(swing))
    spread = 1.4826 * float(np.median(np.abs(swing - centre)))
    hot = swing > max(_HOT, centre + 4.0 * spread)
    if hot.sum() < _LEAST:
        return None
    dark, bright = _candidate(small, hot), _candidate(255 - small, hot)
    best = max((dark, bright), key=lambda found: found[0])
    return best[1] if best[0] > 0.0 else None


def _candidate(small: NDArray[np.uint8], hot: Bools) -> tuple[float, Grey]:
    """Return how well dark components of the temporal minimum fit fishes that stay, 0 not at all, and their mask."""
    level, swept = cv2.threshold(
        np.min(small, axis=0), 0, 255, cv2.THRESH_BINARY_INV + cv2.THRESH_OTSU
    )
    closed = cv2.morphologyEx(swept, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
    count, labels = cv2.connectedComponents(closed)
    overlap = np.bincount(labels[hot], minlength=count)
    overlap[0] = 0
    stays = median_of(small) <= level
    covered = (small <= level).mean(axis=0) > _OFTEN
    fit, mask = 0.0, np.zeros(hot.shape, np.bool_)
    for label in np.flatnonzero(overlap > _ALIKE * max(int(overlap.max()), 1)).tolist():
        shape = labels == label
        share = _hot_rim(np.asarray(shape & stays, np.uint8), hot)
        if share >= _RIM and shape.mean() <= _MOST:
            fit += share * float(overlap[label])
            mask |= shape & covered
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (_GROWN, _GROWN))
    return fit, np.asarray(cv2.dilate(np.asarray(mask, np.uint8), disc), np.uint8)


def _hot_rim(core: Grey, hot: Bools) -> float:
    """Return which part of a standing body's rim changes, 0 where it is too small to be a body."""
    if core.sum() < _LEAST:
        return 0.0
    outer = cv2.dilate(core, np.ones((5, 5), np.uint8)) > 0
    inner = cv2.erode(core, np.ones((3, 3), np.uint8)) > 0
    return float(hot[outer & ~inner].mean())
