"""The medial axis of one still silhouette, whose tail may be forked and whose parts may be of any width (papers/003, 4.3).

A clip's axis (tools/video/midline.py) may lean on the frames before; a picture has none, and is often seen from the side.
So chords span the whole silhouette, both lobes of a tail with the notch between, and there is time for more passes.
"""

from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s
from tools.video.contour import coefficients, evenly, harmonics_needed, kept, rebuilt
from tools.video.contour import POINTS as CONTOUR_POINTS
from tools.video.fins import Finless
from tools.video.images import Grey

STATIONS: Final = 41
_PASSES: Final = 8
_ENDS: Final = 3
"""Stations at each end over which the axis runs on straight."""
_REACH: Final = 0.4
"""[BL] that chords go to each side at most."""
_STEPS: Final = 121
_STIFF: Final = 6.0


def _smoother(count: int) -> Float64s:
    second = np.diff(np.eye(count), n=2, axis=0)
    return np.linalg.inv(np.eye(count) + _STIFF * second.T @ second)


_SMOOTH: Final = _smoother(STATIONS - 2 * _ENDS)


def still_axis(finless: Finless, centre: Float64s, ahead: Float64s) -> Float64s:
    """Return the axis of a finless silhouette at equal arc lengths [px], head first, (41, 2).

    `centre` (2,) lies in it and the unit vector `ahead` points to the head.
    """
    smooth = _smooth_mask(finless)
    along = (finless.outline - centre) @ ahead
    line = evenly(centre + np.outer(np.array([along.max(), along.min()]), ahead), STATIONS)
    for _ in range(_PASSES):
        reach = _REACH * float(np.sqrt((np.diff(line, axis=0) ** 2).sum(axis=1)).sum())
        middle = _middles(smooth, line, reach)[_ENDS:-_ENDS]
        inner = np.asarray(_SMOOTH @ middle)
        head = _end(finless.outline, inner[0], inner[0] - inner[4], reach)
        tail = _end(finless.outline, inner[-1], inner[-1] - inner[-5], reach)
        line = evenly(np.concatenate((head[None], inner, tail[None])), STATIONS)
    return line


def _smooth_mask(finless: Finless) -> Grey:
    """Return the filled contour of the fewest harmonics that do."""
    fourier = coefficients(evenly(finless.outline, CONTOUR_POINTS, closed=True))
    contour = rebuilt(kept(fourier, harmonics_needed(fourier, 0.5 * len(finless.outline))))
    filled = np.zeros_like(finless.body)
    cv2.fillPoly(filled, [np.round(contour * 16.0).astype(np.int32)], 255, shift=4)
    return filled


def _middles(mask: Grey, line: Float64s, reach: float) -> Float64s:
    """Return the middle between the outermost places of the mask along each station's normal, (41, 2)."""
    course = np.gradient(line, axis=0)
    course /= np.maximum(np.sqrt((course**2).sum(axis=1)), 1e-9)[:, None]
    normal = np.stack((-course[:, 1], course[:, 0]), axis=-1)
    away = np.linspace(-reach, reach, _STEPS)
    places = line[:, None, :] + away[None, :, None] * normal[:, None, :]
    x, y = np.round(places[..., 0]).astype(np.intp), np.round(places[..., 1]).astype(np.intp)
    held = (x >= 0) & (y >= 0) & (x < mask.shape[1]) & (y < mask.shape[0])
    inside = held & (mask[np.where(held, y, 0), np.where(held, x, 0)] > 0)
    first = away[inside.argmax(axis=1)]
    last = away[_STEPS - 1 - inside[:, ::-1].argmax(axis=1)]
    aside = np.where(inside.any(axis=1), 0.5 * (first + last), 0.0)
    return line + aside[:, None] * normal


def _end(outline: Float64s, start: Float64s, course: Float64s, reach: float) -> Float64s:
    """Return the place on the line from `start` along `course` as far out as the outline goes beside it."""
    course = course / max(float(np.sqrt(course @ course)), 1e-9)
    away = outline - start
    along, aside = away @ course, away @ np.array([-course[1], course[0]])
    near = along[(along > 0.0) & (np.abs(aside) < reach)]
    return np.asarray(start + max(float(near.max(initial=0.0)), 1.0) * course)
