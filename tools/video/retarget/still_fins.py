"""The paired fins of a still silhouette: where its half width leaps, a fin is rooted (papers/003, section 4.4).

A clip's fins are what an opening with a disc removes (tools/video/fins.py). Models have thick fins, arms, claws and
stems of any width, so here a root is a bump of the half width along the axis over what surrounds it; junctions are its
ends, as in Fig. 4, and all of the mask beyond the root is the fin.
"""

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from tools.video.images import Grey
from tools.video.retarget.still_axis import REACH, inside_along, length_of, normals

_FRONT, _REAR = 0.06, 0.74
"""Of the axis: roots lie between them."""
_WIDEST: Final = 0.24
"""[BL] of a root along the axis, at most."""
_BUMP: Final = 0.03
"""[BL] that a fin stands out at least."""
_LEAST: Final = 0.006
"""Of the silhouette's area: what is smaller is no fin."""
_STEPS: Final = 600


def fin_of(mask: Grey, axis: Float64s, side: int) -> tuple[Float64s, Float64s, Grey] | None:
    """Return the top and bottom junction [px] and the mask of the largest fin on a side (0 left, 1 right), or None."""
    length = length_of(axis)
    normal = normals(axis) * (-1.0 if side else 1.0)
    away = np.linspace(0.0, REACH * length, _STEPS)
    width = _half_width(mask, axis, normal, away)
    best: tuple[Float64s, Float64s, Grey] | None = None
    largest = _LEAST * float(np.count_nonzero(mask))
    for first, last in _bumps(width, length):
        top = axis[first] + width[first] * normal[first]
        bottom = axis[last] + width[last] * normal[last]
        middle = (first + last) // 2
        fin = _beyond(
            mask,
            top,
            bottom,
            axis[middle]
            + 0.5 * (0.5 * (width[first] + width[last]) + width[middle]) * normal[middle],
        )
        area = float(np.count_nonzero(fin))
        if largest < area < 0.4 * np.count_nonzero(mask):
            best, largest = (top, bottom, fin), area
    return best


def _half_width(mask: Grey, axis: Float64s, normal: Float64s, away: Float64s) -> Float64s:
    """Return how far the mask goes unbroken from each station of the axis [px], (n,)."""
    outside = ~inside_along(mask, axis, normal, away)
    return np.asarray(np.where(outside.any(axis=1), away[outside.argmax(axis=1)], away[-1]))


def _bumps(width: Float64s, length: float) -> list[tuple[int, int]]:
    """Return the stations before and after each bump of a half width (n,)."""
    n = len(width)
    window = int(_WIDEST * n) | 1
    high = width - _opened(width, window) > _BUMP * length
    edges = np.flatnonzero(np.diff(np.concatenate(([False], high, [False])).astype(np.int8)))
    found = []
    for first, end in edges.reshape(-1, 2):
        start, stop = _foot(width, int(first) - 1, -1), _foot(width, int(end), 1)
        if _FRONT * n < start and stop < _REAR * n:
            found.append((start, stop))
    return found


def _foot(width: Float64s, at: int, step: int) -> int:
    """Return where a bump's flank ends: on from `at` as long as the width falls steeply."""
    at = min(max(at, 0), len(width) - 1)
    while 0 < at < len(width) - 1 and width[at] - width[at + step] > 0.12 * width[at]:
        at += step
    return at


def _opened(width: Float64s, window: int) -> Float64s:
    """Return the morphological opening of a line of values."""
    kernel = np.ones((1, window), np.uint8)
    values = width.astype(np.float32)[None]
    return np.asarray(
        cv2.morphologyEx(values, cv2.MORPH_OPEN, kernel, borderType=cv2.BORDER_REPLICATE)[0],
        np.float64,
    )


def _beyond(mask: Grey, top: Float64s, bottom: Float64s, inner: Float64s) -> Grey:
    """Return the part of the mask that a cut from top to bottom takes off, on the side of `inner`."""
    cut: NDArray[np.uint8] = mask.copy()
    stretch = 0.06 * (bottom - top) + 2.0 * (bottom - top) / max(
        float(np.sqrt(((bottom - top) ** 2).sum())), 1e-9
    )
    ends = [tuple(round(float(v)) for v in point) for point in (top - stretch, bottom + stretch)]
    cv2.line(cut, ends[0], ends[1], 0, 2, cv2.LINE_8)
    _, labels = cv2.connectedComponents(cut, connectivity=4)
    x, y = (round(float(v)) for v in inner)
    held = 0 <= y < mask.shape[0] and 0 <= x < mask.shape[1]
    label = int(labels[y, x]) if held else 0
    return np.asarray((labels == label) & (cut > 0), np.uint8) * np.uint8(255 if label else 0)
