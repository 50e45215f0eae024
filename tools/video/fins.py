"""Takes the fins off a mask: what an opening with a disc removes, but for head and tail (FINDINGS 4, rule 3).

A fin on one side bends the medial axis towards itself (papers/003, Fig. 3 e); without fins no such kink is there to be
smoothed.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s, Int32s
from tools.video.contour import outline_of
from tools.video.images import Grey

_DISC: Final = 0.5
"""Radius of the opening's disc over that of the largest disc inside the mask."""
_TAIL_REACH, _HEAD_REACH = 0.55, 0.8
"""Parts of the way from centre to tail and head beyond which nothing whose middle lies there is a fin."""
_SLENDER: Final = 0.5
"""Width over length below which a mask's foremost point is a snout's; that of a fish bent into a C may be a fin's."""
_TAIL_SHARE: Final = 0.01
_TRIFLE: Final = 0.002


@dataclass(frozen=True)
class Finless:
    """A mask with its fins apart."""

    body: Grey
    "the mask without fins, 0 or 255, (h, w)"
    outline: Float64s
    "its outer contour [px], (n, 2)"
    fins: tuple[Int32s, ...]
    "contours of the fins taken off [px], the largest first, each (n, 2)"
    radius: float
    "radius of the largest disc inside the mask [px]"


def without_fins(mask: Grey, outline: Int32s, centre: Float64s, ahead: Float64s) -> Finless:
    """Return the mask without fins; `centre` [px] and the unit vector `ahead` say where head and tail are."""
    depth = np.asarray(cv2.distanceTransform(mask, cv2.DIST_L2, 5), np.float32)
    radius = float(depth.max())
    residue = cv2.bitwise_and(mask, cv2.bitwise_not(_opened(depth, _DISC * radius)))
    parts, _ = cv2.findContours(residue, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    along = (outline - centre) @ ahead
    aside = (outline - centre) @ np.array([-ahead[1], ahead[0]])
    slender = np.ptp(aside) < _SLENDER * np.ptp(along)
    fins = _fins(
        [np.asarray(part, np.int32) for part in parts],
        centre,
        ahead,
        (float(along.min()), float(along.max())),
        # A pointed snout is no fin, however far back it begins: a pixel of its tip is enough to tell.
        float(along.max()) - 1.0 if slender else float("inf"),
        cv2.contourArea(outline),
    )
    body = mask.copy()
    cv2.drawContours(body, fins, -1, 0, cv2.FILLED)
    found = tuple(np.asarray(fin[:, 0, :], np.int32) for fin in fins)
    return Finless(body, outline_of(body), found, radius)


def _fins(
    parts: Sequence[Int32s],
    centre: Float64s,
    ahead: Float64s,
    reach: tuple[float, float],
    snout: float,
    whole: float,
) -> list[Int32s]:
    """Return the contours of a residue's parts that are fins; `reach` [px] is the mask's behind and ahead of centre.

    A part that goes further ahead than `snout` [px] is the head's.
    """
    areas = np.array([cv2.contourArea(part) for part in parts])
    places = [(part[:, 0, :] - centre) @ ahead for part in parts]
    along = np.array([float(place.mean()) for place in places])
    foremost = np.array([float(place.max()) for place in places])
    kept = (
        (areas < _TRIFLE * whole)
        | (along > _HEAD_REACH * reach[1])
        | (along < _TAIL_REACH * reach[0])
        | (foremost > snout)
    )
    if len(parts):
        rearmost = int(np.argmin(along))
        kept[rearmost] |= bool(areas[rearmost] > _TAIL_SHARE * whole and along[rearmost] < 0.0)
    return [parts[i] for i in sorted(np.flatnonzero(~kept).tolist(), key=lambda i: -areas[i])]


def _opened(depth: NDArray[np.float32], disc: float) -> Grey:
    """Return what discs of this radius [px] cover that fit into the mask of this depth."""
    outside = (depth <= disc).view(np.uint8)
    return (np.asarray(cv2.distanceTransform(outside, cv2.DIST_L2, 5)) <= disc) * np.uint8(255)
