"""The medial axis of a finless mask from head to tail, by arc length (papers/003, section 4.3; FINDINGS 4, rules 4, 5).

Eq. 1 pairs the two sides of the smooth contour; three passes then march along the normals to both sides of the mask and
take the middle. Head and tail tips extend it.
"""

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s
from tools.video.contour import evenly
from tools.video.fins import Finless
from tools.video.images import Bools, Grey

STATIONS: Final = 41
"""Points of an axis, evenly by arc length from head to tail."""
FIRST, LAST = 3, 38
"""Stations between which the axis is the middle of the mask; before and after it runs straight to the tips."""
_SIDES: Final = 129
_PASSES: Final = 2
_STEP: Final = 0.5
_NEAR_TIP: Final = 0.03
_FORK: Final = 0.012
"""[BL] that the lobes of a forked tail stand out beyond the fork."""
_STIFF: Final = 2.0
_WHOLE_OF_SPINE: Final = (STATIONS - 1) / (LAST - FIRST - 1)
_ROUND_FIN: Final = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (7, 7))
_ROOT: Final = (-2, -6)
"""Stations that say where the tail goes: those after them may lie in one of its lobes."""
_FEWEST: Final = 12
"""Stations without a fin's root that it takes to bridge the rest."""


@dataclass(frozen=True)
class Axis:
    """The medial axis of one frame [px]."""

    spine: Float64s
    "stations FIRST to LAST - 1, head first, (35, 2)"
    half_width: Float64s
    "[px] of the body at these, (35,)"
    head: Float64s
    "(2,)"
    tail: Float64s
    "middle of the tail's end, (2,)"
    lobes: Float64s
    "mean of the tail's two tips, nan where there is no fork, (2,)"


def _stiffness() -> Float64s:
    count = LAST - FIRST
    second = np.zeros((count - 2, count))
    for i in range(count - 2):
        second[i, i : i + 3] = (1.0, -2.0, 1.0)
    return np.asarray(_STIFF * second.T @ second)


_STIFFNESS: Final = _stiffness()
_SMOOTH: Final = np.linalg.inv(np.eye(LAST - FIRST) + _STIFFNESS)


def medial_axis(finless: Finless, contour: Float64s, ahead: Float64s) -> Axis:
    """Return the axis of a finless mask whose smooth contour [px] is given, (256, 2); `ahead` points to the head."""
    line = paired(contour, ahead)
    reach = 1.6 * finless.radius + 2.0
    shade = _fin_shade(finless)
    for _ in range(_PASSES):
        stations = evenly(line, STATIONS)[FIRST:LAST]
        normal = _normals(stations)
        left, right = _chord(finless.body, stations, normal, reach)
        middle = stations + normal * (0.5 * (right - left))[:, None]
        spoilt = _spoilt(shade, stations, normal, left, right)
        spine = _smoothed(middle, spoilt)
        head = _head_tip(finless.body, spine)
        tail, lobes = _tail(finless.body, finless.outline, spine)
        end = tail if np.isnan(lobes[0]) else lobes
        line = np.concatenate((head[None], spine, end[None]))
    half_width = 0.5 * (_bridged(left, spoilt) + _bridged(right, spoilt))
    return Axis(spine, half_width, head, tail, lobes)


def _fin_shade(finless: Finless) -> Grey | None:
    """Return the mask of where a fin stood and its surroundings, None where there was none."""
    if not finless.fins:
        return None
    shade = np.zeros_like(finless.body)
    cv2.drawContours(shade, finless.fins, -1, 255, cv2.FILLED)
    return np.asarray(cv2.dilate(shade, _ROUND_FIN), np.uint8)


def _spoilt(
    shade: Grey | None, line: Float64s, normal: Float64s, left: Float64s, right: Float64s
) -> Bools:
    """Return at which stations the mask's edge is a fin's root, (n,)."""
    spoilt = np.zeros(len(line), np.bool_)
    if shade is None:
        return spoilt
    for away in (-left, right):
        at = line + normal * away[:, None]
        spoilt |= _sampled(shade, at[:, 0], at[:, 1]) > 0
    near = spoilt.copy()
    near[1:] |= spoilt[:-1]
    near[:-1] |= spoilt[1:]
    return near if np.count_nonzero(~near) >= _FEWEST else np.zeros_like(near)


def _smoothed(middle: Float64s, spoilt: Bools) -> Float64s:
    """Return the middles (n, 2) smoothed; where they are spoilt the curve of the rest runs on."""
    if not spoilt.any():
        return np.asarray(_SMOOTH @ middle)
    weight = np.where(spoilt, 0.0, 1.0)
    return np.asarray(np.linalg.solve(np.diag(weight) + _STIFFNESS, middle * weight[:, None]))


def _bridged(width: Float64s, spoilt: Bools) -> Float64s:
    """Return half-widths with those at fins' roots between those before and after them."""
    at = np.arange(len(width))
    return np.interp(at, at[~spoilt], width[~spoilt])


def whole_axis(head: Float64s, spine: Float64s, tail: Float64s) -> Float64s:
    """Return the axis from tip to tip at equal arc lengths [px], (41, 2)."""
    return evenly(np.concatenate((head[None], spine, tail[None])), STATIONS)


def paired(contour: Float64s, ahead: Float64s) -> Float64s:
    """Return the middle of the contour's two sides between head and tail (eq. 1), (129, 2)."""
    away = contour - contour.mean(axis=0)
    along = away @ ahead
    far = away[:, 0] ** 2 + away[:, 1] ** 2
    head = int(np.argmax(np.where(along > 0.0, far, 0.0)))
    tail = int(np.argmax(np.where(along < 0.0, far, 0.0)))
    turned = np.concatenate((contour[head:], contour[: head + 1]))
    at = (tail - head) % len(contour)
    return 0.5 * (evenly(turned[: at + 1], _SIDES) + evenly(turned[at:][::-1], _SIDES))


def _normals(line: Float64s) -> Float64s:
    """Return unit vectors to the right of a line's course in the picture, (n, 2)."""
    along = np.empty_like(line)
    along[1:-1] = line[2:] - line[:-2]
    along[0], along[-1] = line[1] - line[0], line[-1] - line[-2]
    along /= np.sqrt((along**2).sum(axis=1))[:, None]
    return np.stack((-along[:, 1], along[:, 0]), axis=-1)


def _chord(body: Grey, line: Float64s, normal: Float64s, reach: float) -> tuple[Float64s, Float64s]:
    """Return how far the mask goes to the left and right of each point of a line [px], (n,) each."""
    count = int(reach / _STEP)
    steps = np.arange(-count, count + 1) * _STEP
    inside = _sampled(
        body, line[:, :1] + steps * normal[:, :1], line[:, 1:] + steps * normal[:, 1:]
    )
    outside = inside == 0
    return _first(outside[:, count::-1]), _first(outside[:, count:])


def _sampled(image: Grey, x: Float64s, y: Float64s) -> Grey:
    """Return the pixels nearest to places; beyond the edge those at the edge."""
    height, width = image.shape
    columns = (x + 0.5).astype(np.intp)
    rows = (y + 0.5).astype(np.intp)
    np.clip(columns, 0, width - 1, out=columns)
    np.clip(rows, 0, height - 1, out=rows)
    return np.asarray(image.ravel()[rows * width + columns])


def _first(outside: Bools) -> Float64s:
    """Return how far along each row the mask ends [px], (n,)."""
    found = np.argmax(outside, axis=1)
    found[~outside[np.arange(len(outside)), found]] = outside.shape[1]
    return np.asarray(np.maximum(found - 0.5, 0.0) * _STEP)


def _course(line: Float64s, end: int, inner: int) -> Float64s:
    """Return the unit vector from one of a line's points to another."""
    course = line[end] - line[inner]
    return np.asarray(course / max(float(np.sqrt(course @ course)), 1e-9))


def _head_tip(body: Grey, spine: Float64s) -> Float64s:
    """Return where the spine's first direction leaves the mask ahead of it."""
    course = _course(spine, 0, 4)
    span = float(np.sqrt(((spine[0] - spine[8]) ** 2).sum())) + 8.0
    steps = np.arange(0.0, span, _STEP)
    places = spine[0] + steps[:, None] * course
    outside = _sampled(body, places[:, 0], places[:, 1]) == 0
    at = int(np.argmax(outside)) if outside.any() else len(steps) - 1
    return np.asarray(spine[0] + max(steps[at] - 0.5 * _STEP, _STEP) * course)


def _tail(body: Grey, outline: Float64s, spine: Float64s) -> tuple[Float64s, Float64s]:
    """Return the tail's end, and the mean of its two tips where it is forked, nan where it is not."""
    origin, course = spine[_ROOT[0]], _course(spine, *_ROOT)
    step = spine[1:] - spine[:-1]
    length = float(np.sqrt(step[:, 0] ** 2 + step[:, 1] ** 2).sum()) * _WHOLE_OF_SPINE
    away = outline - origin
    along = away @ course
    aside = away @ np.array([-course[1], course[0]])
    near = (along > 0.0) & (along < 0.3 * length) & (np.abs(aside) < 0.2 * length)
    if not near.any():
        return spine[-1] + course, np.full(2, np.nan)
    profile = np.where(near, along, -np.inf)
    first = int(profile.argmax())
    far = float(profile[first])
    end = aside[profile >= far - _NEAR_TIP * length]
    middle = 0.5 * (end.min() + end.max())
    way = far * course + middle * np.array([-course[1], course[0]])
    tip = origin + _last_inside(body, origin, way, far) * way
    return tip, _lobes(outline, profile, first, _FORK * length)


def _last_inside(body: Grey, origin: Float64s, way: Float64s, far: float) -> float:
    """Return the part of a way [px] at which it leaves the mask for the last time."""
    parts = np.arange(0.0, far, _STEP) / far
    inside = np.flatnonzero(_sampled(body, origin[0] + parts * way[0], origin[1] + parts * way[1]))
    return float(parts[inside[-1]]) + 0.5 * _STEP / far if len(inside) else 1.0


def _lobes(outline: Float64s, profile: Float64s, first: int, prominence: float) -> Float64s:
    """Return the mean of a forked tail's tips, nan where no second one rises by `prominence` [px].

    `profile` says how far the outline reaches at each of its points, minus infinity where it is not the tail.
    """
    onward = np.concatenate((profile[first:], profile[:first]))
    best, other = 0.0, 0
    for way, sign in ((onward, 1), (np.concatenate((onward[:1], onward[:0:-1])), -1)):
        ends = int((way == -np.inf).argmax())
        run = way[:ends] if ends else way
        rise = run - np.minimum.accumulate(run)
        at = int(rise.argmax())
        if rise[at] > best:
            best, other = float(rise[at]), sign * at
    if best < prominence:
        return np.full(2, np.nan)
    return np.asarray(0.5 * (outline[first] + outline[(first + other) % len(outline)]))
