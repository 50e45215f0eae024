"""A sheet to draw a model on: smooth filled shapes with soft edges and a little volume, on a transparent ground."""

from collections.abc import Sequence
from typing import Final, TypeAlias

import cv2
import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from tools.video.retarget.target import Texture

Points: TypeAlias = Sequence[tuple[float, float]]
Rgb: TypeAlias = tuple[int, int, int]
WIDTH, HEIGHT = 560, 768
_FINE: Final = 2
"""Times that a sheet is finer while it is drawn on."""
_SPLINE: Final = 10
"""Points of a curve between two given ones."""


def curve(points: Points, closed: bool = True) -> Float64s:
    """Return a smooth line through points (Catmull-Rom), (n, 2)."""
    p = np.array(points, np.float64)
    around = np.concatenate((p[-1:], p, p[:2])) if closed else np.concatenate((p[:1], p, p[-1:]))
    a, b, c, d = (around[i : len(around) - 3 + i, None, :] for i in range(4))
    t = np.linspace(0.0, 1.0, _SPLINE, endpoint=False)[None, :, None]
    line = 0.5 * (
        2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t**2 + (3 * b - a - 3 * c + d) * t**3
    )
    return np.asarray(line.reshape(-1, 2))


class Sheet:
    """Places are x from the middle line, to the right, and y from the top [px of the finished drawing]."""

    def __init__(self) -> None:
        self._paint = np.zeros((HEIGHT * _FINE, WIDTH * _FINE, 4))

    def shape(
        self,
        points: Points,
        colour: Rgb,
        volume: float = 0.0,
        sharp: bool = False,
        inside: bool = False,
    ) -> None:
        """Fill a closed shape; `volume` darkens its rim, `inside` keeps it within what is drawn already."""
        line = np.array(points, np.float64) if sharp else curve(points)
        cover = self._cover(line)
        shade = np.ones(1)
        if volume > 0.0:
            depth = np.asarray(
                cv2.distanceTransform((cover > 0.5).astype(np.uint8), cv2.DIST_L2, 5), np.float64
            )
            round_off = np.clip(depth / max(float(depth.max()), 1.0), 0.0, 1.0)
            shade = 1.0 - volume * (1.0 - np.sqrt(1.0 - (1.0 - round_off) ** 2))[..., None]
        self._lay(cover, np.array(colour, np.float64) * shade, inside)

    def pair(
        self,
        points: Points,
        colour: Rgb,
        volume: float = 0.0,
        sharp: bool = False,
        inside: bool = False,
    ) -> None:
        """Fill a shape and its mirror image across the middle line."""
        self.shape(points, colour, volume, sharp, inside)
        self.shape([(-x, y) for x, y in points], colour, volume, sharp, inside)

    def line(self, points: Points, colour: Rgb, width: float, inside: bool = True) -> None:
        """Draw a smooth open line of a width [px]."""
        cover = np.zeros(self._paint.shape[:2], np.uint8)
        places = self._fine(curve(points, closed=False))
        cv2.polylines(cover, [places], False, 255, max(1, round(width * _FINE)), cv2.LINE_AA, 4)
        self._lay(cover / 255.0, np.array(colour, np.float64), inside)

    def lines(self, points: Points, colour: Rgb, width: float) -> None:
        """Draw a line and its mirror image, within what is drawn already."""
        self.line(points, colour, width)
        self.line([(-x, y) for x, y in points], colour, width)

    def disc(self, x: float, y: float, radius: float, colour: Rgb, volume: float = 0.0) -> None:
        """Fill a disc."""
        turn = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
        self.shape([(x + radius * np.cos(t), y + radius * np.sin(t)) for t in turn], colour, volume)

    def finished(self) -> Texture:
        """Return the drawing, (h, w, 4)."""
        small = cv2.resize(self._paint, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)
        opacity = small[..., 3:]
        colour = np.where(opacity > 0.0, small[..., :3] / np.maximum(opacity, 1e-9), 255.0)
        return np.asarray(
            np.round(np.concatenate((colour, opacity * 255.0), axis=2)).clip(0, 255), np.uint8
        )

    def _fine(self, line: Float64s) -> NDArray[np.int32]:
        places = (line + np.array([0.5 * WIDTH, 0.0])) * (_FINE * 16)
        return np.asarray(np.round(places), np.int32)

    def _cover(self, line: Float64s) -> Float64s:
        cover = np.zeros(self._paint.shape[:2], np.uint8)
        cv2.fillPoly(cover, [self._fine(line)], 255, cv2.LINE_AA, 4)
        return cover / 255.0

    def _lay(self, cover: Float64s, colour: Float64s, inside: bool) -> None:
        """Lay a colour over the sheet, whose colours are kept multiplied by their opacity."""
        x, y, w, h = cv2.boundingRect((cover > 0.0).astype(np.uint8))
        part = np.s_[y : y + h, x : x + w]
        under = self._paint[part]
        share = (cover[part] * under[..., 3] if inside else cover[part])[..., None]
        shown = colour[part] if colour.ndim == 3 else colour
        under[..., :3] = under[..., :3] * (1.0 - share) + shown * share
        under[..., 3:] = under[..., 3:] * (1.0 - share) + share
