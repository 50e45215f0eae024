"""A skin from the clip: the fish is laid out straight in some good frames, and what most of them show is its colour.

A view from above shows back and flanks. The belly is assumed lighter, as countershading has it; where the clip is lit
from behind, so that the fish is but a dark shape, all colours are assumed.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from tools.video.water.film import STATIONS, Film

ALONG, ACROSS = 96, 15
"""Points of a fish that is laid out straight: from nose to tail, and from its left to its right."""

SAMPLES: Final = 24
"""Frames that are looked at ..."""

EARLY: Final = 300
"""... among the first of the good ones."""

DARK, PALE, GREY = 80.0, 12.0, 14.0
"""Levels: a fish whose lightest parts are darker than `DARK`, or which differs from place to place by less than `PALE`
and is grey by less than `GREY`, is a shape and no more."""

_BAR: Final = 14.0
"""Levels by which a bar differs from what lies before and behind it."""
_MOST_BARS: Final = 8
_EDGE: Final = 0.8

Colour = tuple[int, int, int]
"""Red, green, blue, 0 to 255."""


@dataclass(frozen=True)
class Colours:
    """What is painted."""

    back: Colour
    flank: Colour
    belly: Colour
    tail: Colour
    bars: tuple[tuple[float, float], ...]
    "place s from 0 at the nose to 1 at the tail's root, and width, of each bar"
    bar: Colour
    assumed: bool
    "whether the clip shows no colours"


ASSUMED: Final = Colours(
    (74, 84, 62), (168, 172, 150), (238, 238, 228), (108, 112, 92), (), (60, 66, 50), True
)
"""Olive above, silver beneath: what many a fish of open water wears."""


def chosen(film: Film) -> list[int]:
    """Return the frames of a film whose colours are looked at: good ones, at even steps."""
    good = np.flatnonzero(film.good)[:EARLY]
    at = np.linspace(0, len(good) - 1, min(SAMPLES, len(good))).round().astype(int)
    return [int(good[i]) for i in at]


def straightened(
    picture: NDArray[np.uint8], axis: Float64s, half_width: Float64s
) -> NDArray[np.uint8]:
    """Return a fish laid out straight, from its axis (41, 2) and half-widths (41,) [px] in a picture (h, w, 3).

    Left to right, nose to tail: (15, 96, 3).
    """
    course = np.gradient(axis, axis=0)
    course /= np.maximum(np.sqrt((course**2).sum(axis=1)), 1e-9)[:, None]
    right = np.stack((-course[:, 1], course[:, 0]), axis=-1) * -half_width[:, None]
    at = np.linspace(0.0, STATIONS - 1.0, ALONG)
    stations = np.arange(STATIONS)
    line, side = (
        np.stack([np.interp(at, stations, part[:, i]) for i in (0, 1)], axis=-1)
        for part in (axis, right)
    )
    out = np.linspace(-0.9, 0.9, ACROSS)
    grid = (line[None] + out[:, None, None] * side[None]).astype(np.float32)
    return np.asarray(cv2.remap(picture, grid[..., 0], grid[..., 1], cv2.INTER_LINEAR), np.uint8)


def colours_of(
    pictures: Iterable[tuple[int, NDArray[np.uint8]]], film: Film, scale: float
) -> Colours:
    """Return the colours of a fish. `pictures` are frames' numbers in the film and pictures (h, w, 3), red first, in
    which a pixel of the film is `scale` pixels."""
    laid = [
        straightened(picture, film.axis[k] * scale, film.half_width[k] * scale)
        for k, picture in pictures
    ]
    return painted(np.median(np.stack(laid), axis=0)) if laid else ASSUMED


def painted(laid: Float64s) -> Colours:
    """Return the colours of a fish laid out straight, (15, 96, 3)."""
    body = laid[:, 6 : round(_EDGE * ALONG)]
    light = body.mean(axis=2)
    hue = float(np.median(body.max(axis=2) - body.min(axis=2)))
    low, high = np.percentile(light, (10, 90))
    if high < DARK or (high - low < PALE and hue < GREY):
        return ASSUMED
    middle, edges = body[5:10], np.concatenate((body[1:4], body[11:14]))
    back, flank = np.median(middle, axis=(0, 1)), np.median(edges, axis=(0, 1))
    belly = 255.0 - 0.4 * (255.0 - np.maximum(flank, back))
    bars, dark = _bars(middle.mean(axis=(0, 2)))
    bar = np.median(middle[:, dark], axis=(0, 1)) if dark.any() else back
    tail = np.median(laid[5:10, round(0.9 * ALONG) :], axis=(0, 1))
    return Colours(
        _whole(back), _whole(flank), _whole(belly), _whole(tail), bars, _whole(bar), False
    )


def _bars(light: Float64s) -> tuple[tuple[tuple[float, float], ...], NDArray[np.bool_]]:
    """Return places and widths of the dark bars in a profile of lightness along the back, and where they lie (n,)."""
    wide = len(light) // 4 * 2 + 1
    padded = np.pad(light, wide // 2, mode="edge")
    usual = np.array([np.percentile(padded[k : k + wide], 70) for k in range(len(light))])
    dark = light < usual - _BAR
    found = []
    for first, stop in _runs(dark):
        if 2 <= stop - first <= len(light) // 4:
            at = (6 + 0.5 * (first + stop - 1)) / (_EDGE * ALONG)
            found.append((round(float(at), 3), round((stop - first) / (_EDGE * ALONG), 3)))
    return tuple(found[:_MOST_BARS]), dark


def _runs(flags: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate(([0], flags.astype(np.int8), [0]))))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)


def _whole(colour: Float64s) -> Colour:
    red, green, blue = (int(min(max(round(float(c)), 0), 255)) for c in colour)
    return red, green, blue
