"""Finds a still silhouette's axis, fins and junctions (papers/003, sections 3.2, 4 and 5; Table 1)."""

from dataclasses import dataclass

import cv2
import numpy as np

from components.arrays import Float64s
from tools.video.contour import outline_of
from tools.video.images import Grey
from tools.video.retarget.skeleton import sampled_axis
from tools.video.retarget.still_axis import still_axis
from tools.video.retarget.still_fins import fin_of


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
    edge = outline_of(mask)
    centre, ahead = _principal(mask)
    if towards is not None:
        ahead = _pointed(ahead, towards)
    axis = still_axis(mask, edge, centre, ahead)
    found = [fin_of(mask, axis, side) for side in (0, 1)]
    body = mask.copy()
    for fin in found:
        if fin is not None:
            body[fin[2] > 0] = 0
    axis = still_axis(body, outline_of(body), centre, ahead)
    share = float(np.argmin(((axis - centre) ** 2).sum(axis=1))) / (len(axis) - 1)
    marks = [None if fin is None else _mark(edge, *fin) for fin in found]
    return Landmarks(sampled_axis(axis, min(max(share, 0.1), 0.9)), (marks[0], marks[1]), edge)


def _principal(mask: Grey) -> tuple[Float64s, Float64s]:
    """Return the barycentre [px] and the unit vector of greatest spread of a mask, the thinner end behind it."""
    y, x = np.nonzero(mask)
    places = np.stack((x, y), axis=1).astype(np.float64)
    centre = places.mean(axis=0)
    places -= centre
    _, vectors = np.linalg.eigh(places.T @ places)
    ahead = vectors[:, 1]
    thin_ahead = float(((places @ ahead) ** 3).sum()) > 0.0
    return centre, -ahead if thin_ahead else ahead


def _pointed(ahead: Float64s, towards: Float64s) -> Float64s:
    """Return the principal direction with the sign that points `towards`; that itself where it lies across."""
    towards = towards / np.sqrt(towards @ towards)
    along = float(ahead @ towards)
    return towards if abs(along) < 0.5 else ahead * np.sign(along)


def _mark(outline: Float64s, top: Float64s, bottom: Float64s, fin: Grey) -> FinMark | None:
    """Return a fin's landmarks on the silhouette's edge; its tip is the point farthest from the root."""
    own = outline_of(np.asarray(cv2.dilate(fin, np.ones((3, 3), np.uint8)), np.uint8))
    far = own[int(np.argmax(((own - 0.5 * (top + bottom)) ** 2).sum(axis=1)))]
    places = [_nearest(outline, place) for place in (top, far, bottom)]
    if len(set(places)) < 3:
        return None
    stretch = _stretch(outline, *places)
    return FinMark(outline[places[1]], outline[places[0]], outline[places[2]], stretch)


def _nearest(outline: Float64s, place: Float64s) -> int:
    return int(np.argmin(((outline - place) ** 2).sum(axis=1)))


def _stretch(outline: Float64s, start: int, by: int, end: int) -> Float64s:
    """Return the part of a closed line from one of its points by another to a third, (n, 2)."""
    n = len(outline)
    if (by - start) % n < (end - start) % n:
        return outline[(start + np.arange((end - start) % n + 1)) % n]
    return outline[(start - np.arange((start - end) % n + 1)) % n]
