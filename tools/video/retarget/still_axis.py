"""The medial axis of one still silhouette, its tail forked or not, its parts of any width (papers/003, 4.3).

A clip's axis (tools/video/midline.py) may lean on the frames before; a picture has none, and often shows a side. So
chords are taken across the principal direction first and along normals later; in the tail they span both lobes with
the notch between.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from tools.video.contour import evenly
from tools.video.images import Bools, Grey

STATIONS: Final = 81
_STRAIGHT, _BENT = 5, 3
"""Passes whose chords lie across the principal direction, and along the axis' own normals."""
_ENDS: Final = 5
"""Stations at each end over which the axis runs on straight."""
_TAIL: Final = 0.8
"""Of the axis: behind it chords reach from lobe to lobe."""
REACH: Final = 0.42
"""[BL] that chords go to each side at most."""
_STEPS: Final = 301
_STIFF: Final = 300.0


def _smoother(count: int) -> Float64s:
    second = np.diff(np.eye(count), n=2, axis=0)
    return np.asarray(np.linalg.inv(np.eye(count) + _STIFF * second.T @ second))


_SMOOTH: Final = _smoother(STATIONS - 2 * _ENDS)


def still_axis(mask: Grey, outline: Float64s, centre: Float64s, ahead: Float64s) -> Float64s:
    """Return the axis of a silhouette at equal arc lengths [px], head first, (81, 2).

    `outline` (n, 2) is its edge, `centre` (2,) lies in it and the unit vector `ahead` points to the head.
    """
    along = (outline - centre) @ ahead
    line = evenly(centre + np.outer(np.array([along.max(), along.min()]), ahead), STATIONS)
    across = np.broadcast_to(np.array([-ahead[1], ahead[0]]), line.shape)
    for number in range(_STRAIGHT + _BENT):
        normal = across if number < _STRAIGHT else normals(line)
        inner = np.asarray(_SMOOTH @ _middles(mask, line, normal)[_ENDS:-_ENDS])
        reach = REACH * length_of(line)
        head = _end(outline, inner[0], inner[0] - inner[8], reach)
        tail = _end(outline, inner[-1], inner[-1] - inner[-9], reach)
        line = evenly(np.concatenate((head[None], inner, tail[None])), STATIONS)
    return line


def length_of(line: Float64s) -> float:
    """Return the arc length of a line (n, 2)."""
    return float(np.sqrt((np.diff(line, axis=0) ** 2).sum(axis=1)).sum())


def normals(line: Float64s) -> Float64s:
    """Return unit vectors to the fish's left of a line from head to tail, (n, 2)."""
    course = np.gradient(line, axis=0)
    course /= np.maximum(np.sqrt((course**2).sum(axis=1)), 1e-9)[:, None]
    return np.stack((-course[:, 1], course[:, 0]), axis=-1)


def inside_along(mask: Grey, line: Float64s, normal: Float64s, away: Float64s) -> Bools:
    """Return whether places `away` (k,) [px] along the normals of a line (n, 2) lie in the mask, (n, k)."""
    places = line[:, None, :] + away[None, :, None] * normal[:, None, :]
    x, y = np.round(places[..., 0]).astype(np.intp), np.round(places[..., 1]).astype(np.intp)
    held = (x >= 0) & (y >= 0) & (x < mask.shape[1]) & (y < mask.shape[0])
    return np.asarray(held & (mask[np.where(held, y, 0), np.where(held, x, 0)] > 0))


def _middles(mask: Grey, line: Float64s, normal: Float64s) -> Float64s:
    """Return the middle of the mask's chord through, or nearest to, each station, (81, 2)."""
    reach = REACH * length_of(line)
    away = np.linspace(-reach, reach, _STEPS)
    inside = inside_along(mask, line, normal, away)
    aside = np.zeros(len(line))
    for station, row in enumerate(inside):
        if row.any():
            first, last = _chord(row, station >= _TAIL * len(line))
            aside[station] = 0.5 * (away[first] + away[last])
    return line + aside[:, None] * normal


def _chord(row: NDArray[np.bool_], whole: bool) -> tuple[int, int]:
    """Return the first and last place of a chord: the run nearest the middle or, where `whole`, all runs."""
    at = np.flatnonzero(row)
    if whole:
        return int(at[0]), int(at[-1])
    runs = np.split(at, np.flatnonzero(np.diff(at) > 1) + 1)
    middle = len(row) // 2
    best = min(runs, key=lambda run: max(int(run[0]) - middle, middle - int(run[-1]), 0))
    return int(best[0]), int(best[-1])


def _end(outline: Float64s, start: Float64s, course: Float64s, reach: float) -> Float64s:
    """Return the place on the line from `start` along `course` as far out as the outline goes beside it."""
    course = course / max(float(np.sqrt(course @ course)), 1e-9)
    away = outline - start
    along, aside = away @ course, away @ np.array([-course[1], course[0]])
    near = along[(along > 0.0) & (np.abs(aside) < reach)]
    return np.asarray(start + max(float(near.max(initial=0.0)), 1.0) * course)
