"""Finds a still silhouette's axis, fins and junctions, as in a clip's frame (papers/003, sections 3.2, 4 and 5)."""

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s, Int32s
from tools.video.contour import outline_of
from tools.video.fins import Finless, without_fins
from tools.video.images import Grey
from tools.video.orientation import head_evidence, principal
from tools.video.pectorals import along_axis
from tools.video.retarget.skeleton import sampled_axis
from tools.video.retarget.still_axis import still_axis

_FRONT, _REAR = 0.05, 0.7
"""Of the axis from the head: between them a root is a paired fin's, in models of any kind."""
_LEAST: Final = 0.004
"""Of the silhouette's area: what is smaller is no fin."""
_BORDER: Final = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))


@dataclass(frozen=True)
class FinMark:
    """One fin in the picture [px]."""

    tip: Float64s
    "(2,)"
    top: Float64s
    "(2,)"
    bottom: Float64s
    "(2,)"
    outline: Float64s
    "the silhouette's edge from top by the tip to bottom, (n, 2)"


@dataclass(frozen=True)
class Landmarks:
    """What a silhouette shows [px]."""

    controls: Float64s
    "centre, up_axis, head, low_axis, tail, (21, 2)"
    fins: tuple[FinMark | None, FinMark | None]
    "the left and the right one as seen from above"
    outline: Float64s
    "the silhouette's edge, (n, 2)"


def landmarks(mask: Grey, towards: Float64s | None = None) -> Landmarks:
    """Return the landmarks of a silhouette, 0 or 255, with a rim of noughts.

    `towards` (2,) is where its head points, if that is known; else the heavier half is the head's.
    """
    edge = outline_of(mask).astype(np.int32)
    centre, ahead, _ = principal(edge)
    if towards is not None:
        ahead = ahead * (1.0 if float(ahead @ towards) >= 0.0 else -1.0)
    elif head_evidence(mask, centre, ahead) < 0.0:
        ahead = -ahead
    finless = without_fins(mask, edge, centre, ahead)
    line = still_axis(finless, centre, ahead)
    share = float(np.argmin(((line - centre) ** 2).sum(axis=1))) / (len(line) - 1)
    controls = sampled_axis(line, min(max(share, 0.1), 0.9))
    outline = edge.astype(np.float64)
    return Landmarks(controls, _fin_marks(finless, line, outline, float(cv2.contourArea(edge))), outline)


def _fin_marks(
    finless: Finless, axis: Float64s, outline: Float64s, area: float
) -> tuple[FinMark | None, FinMark | None]:
    """Return the largest fin of each side."""
    border = np.asarray(cv2.dilate(finless.body, _BORDER), np.uint8)
    found: list[FinMark | None] = [None, None]
    for fin in finless.fins:
        if cv2.contourArea(fin) < _LEAST * area:
            continue
        station, aside = along_axis(fin.astype(np.float64), axis)
        side = 0 if float(np.median(aside)) > 0.0 else 1
        mark = _mark(fin, station / (len(axis) - 1), aside, border, outline)
        if found[side] is None and mark is not None:
            found[side] = mark
    return found[0], found[1]


def _mark(
    fin: Int32s, along: Float64s, aside: Float64s, border: Grey, outline: Float64s
) -> FinMark | None:
    """Return a fin's landmarks, None where its root is no paired fin's."""
    at = np.flatnonzero(border[fin[:, 1], fin[:, 0]] > 0)
    if not len(at) or not _FRONT < float(along[at].mean()) < _REAR:
        return None
    places = fin.astype(np.float64)
    tip = _nearest(outline, places[int(np.argmax(np.abs(aside)))])
    top = _nearest(outline, places[at[int(np.argmin(along[at]))]])
    bottom = _nearest(outline, places[at[int(np.argmax(along[at]))]])
    if len({tip, top, bottom}) < 3:
        return None
    return FinMark(outline[tip], outline[top], outline[bottom], _stretch(outline, top, tip, bottom))


def _nearest(outline: Float64s, place: Float64s) -> int:
    return int(np.argmin(((outline - place) ** 2).sum(axis=1)))


def _stretch(outline: Float64s, start: int, by: int, end: int) -> Float64s:
    """Return the part of a closed line from one of its points by another to a third, (n, 2)."""
    n = len(outline)
    if (by - start) % n < (end - start) % n:
        return outline[(start + np.arange((end - start) % n + 1)) % n]
    return outline[(start - np.arange((start - end) % n + 1)) % n]
