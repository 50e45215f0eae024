"""Pectoral fins: their tips and the four junctions with the body (papers/003, section 4.4, Table 1, Fig. 4).

A tip is the point of a fin farthest from the axis; junctions are the first and last places where what the opening took
off borders the body (FINDINGS 4, rule 7: steadier than the angle of Fig. 4). A side without a fin has folded it.
"""

from typing import Final, NamedTuple

import cv2
import numpy as np

from components.arrays import Float64s
from tools.video.fins import Finless
from tools.video.images import Grey

FRONT, REAR = 0.12, 0.55
"""[BL] from the head between which a fin's root is a pectoral one's."""
_BORDER: Final = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))


class Pectorals(NamedTuple):
    """Fins of one frame [px], nan where folded; left and right are the fish's own, seen from above."""

    tip: Float64s
    "left, right, (2, 2)"
    junction: Float64s
    "top left, top right, bottom left, bottom right; top is nearer to the head, (4, 2)"


def pectorals_of(finless: Finless, axis: Float64s) -> Pectorals:
    """Return the fins of a frame whose axis (41, 2) [px] is known."""
    tip, junction = np.full((2, 2), np.nan), np.full((4, 2), np.nan)
    if not finless.fins:
        return Pectorals(tip, junction)
    border = np.asarray(cv2.dilate(finless.body, _BORDER), np.uint8)
    course = courses(axis)
    for fin in finless.fins:
        side, found, ends = _placed(fin.astype(np.float64), border, axis, course)
        if side >= 0 and np.isnan(tip[side, 0]):
            tip[side], junction[side], junction[2 + side] = found, ends[0], ends[1]
    return Pectorals(tip, junction)


def _placed(
    fin: Float64s, border: Grey, axis: Float64s, course: Float64s
) -> tuple[int, Float64s, Float64s]:
    """Return a fin's side (0 left, 1 right, -1 no pectoral fin), its tip, and the ends of its root, (2, 2)."""
    station, aside = along_axis(fin, axis, course)
    root = border[fin[:, 1].astype(np.intp), fin[:, 0].astype(np.intp)] > 0
    if not root.any():
        return -1, fin[0], fin[:2]
    s = station / (len(axis) - 1)
    middle = float(s[root].mean())
    if not FRONT < middle < REAR:
        return -1, fin[0], fin[:2]
    at = np.flatnonzero(root)
    ends = fin[[at[np.argmin(s[at])], at[np.argmax(s[at])]]]
    side = 0 if float(aside.sum()) > 0.0 else 1
    return side, fin[int(np.argmax(np.abs(aside)))], ends


def courses(axis: Float64s) -> Float64s:
    """Return unit vectors along an axis (n, 2) towards the tail, (n, 2)."""
    course = np.empty_like(axis)
    course[1:-1] = axis[2:] - axis[:-2]
    course[0], course[-1] = axis[1] - axis[0], axis[-1] - axis[-2]
    course /= np.maximum(np.sqrt(course[:, 0] ** 2 + course[:, 1] ** 2), 1e-9)[:, None]
    return course


def along_axis(places: Float64s, axis: Float64s, course: Float64s) -> tuple[Float64s, Float64s]:
    """Return the nearest station of each place and how far it lies to the fish's left of the axis [px], (n,) each."""
    x = places[:, :1] - axis[:, 0]
    y = places[:, 1:] - axis[:, 1]
    nearest = (x * x + y * y).argmin(axis=1)
    row = np.arange(len(places))
    left = y[row, nearest] * course[nearest, 0] - x[row, nearest] * course[nearest, 1]
    return nearest + 0.0, left
