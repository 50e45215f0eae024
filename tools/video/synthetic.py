"""Clips with known truth: our own species' captured swims drawn as a camera above a tank would see them.

The body, caudal and pectoral fins are silhouettes of the captured nodes (components/repertoire.py); a textured ground,
noise, blur, a moving shadow and beating fins make it hard. The truth is the centre line from nose to tail tip.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np

from components.arrays import Float32s, Float64s
from components.body import Body
from components.segment import Segment
from tools.capture.report.silhouette import silhouette_of
from tools.video.images import Grey

_SHIFT: Final = 4
_TAIL_THICKNESS: Final = 0.012


@dataclass(frozen=True)
class Setting:
    """What the camera sees besides the fish."""

    width: int = 960
    height: int = 544
    body_length: float = 330.0
    "[px]"
    noise: float = 4.0
    "standard deviation [grey levels]"
    blur: float = 0.9
    "standard deviation of the lens [px]"
    shadow: float = 0.82
    "brightness under the moving shadow; 1 is none"
    fins: float = 1.0
    "how far the pectoral fins beat; 0 leaves them out"
    travels: bool = True
    "round the tank; else it holds station"
    ground: int = 185
    ink: int = 45
    fins_ink: int = 80
    seed: int = 1


class SyntheticClip:
    """A species that swims `segment` over and over; frame k is entry k of the segment."""

    def __init__(self, body: Body, segment: Segment, setting: Setting | None = None) -> None:
        """Prepare silhouettes and ground."""
        self.setting = setting or Setting()
        self.segment = segment
        self._drawn = silhouette_of(body)
        self._chance = np.random.default_rng(self.setting.seed)
        self._ground = self._textured()
        self._yaw = _yaws(segment)

    def truth(self, number: int) -> Float64s:
        """Return the centre line [px] from nose to tail tip at frame `number`, (41, 2), x right and y down."""
        return self._placed(self._drawn.middle, number)

    def frame(self, number: int) -> Grey:
        """Return the picture at frame `number`; `frames` draws noise in order."""
        s = self.setting
        image = self._ground.copy()
        for fin, side in zip(self._drawn.fins_above, (-1.0, 1.0), strict=True):
            if s.fins > 0.0:
                _fill(image, self._fin(fin, side, number), s.fins_ink)
        ridge = self._placed(self._drawn.tail_above, number)
        _fill(image, _ribbon(ridge, _TAIL_THICKNESS * s.body_length), s.ink)
        _fill(image, self._placed(self._drawn.above, number), s.ink)
        if s.shadow < 1.0:
            image = self._shaded(image, number)
        if s.blur > 0.0:
            image = np.asarray(cv2.GaussianBlur(image, (0, 0), s.blur), np.float32)
        image += self._chance.normal(0.0, 1.0, image.shape).astype(np.float32) * s.noise
        return np.clip(image, 0.0, 255.0).astype(np.uint8)

    def frames(self, count: int) -> Iterator[Grey]:
        """Yield the first `count` frames."""
        for number in range(count):
            yield self.frame(number)

    def _placed(self, weights: Float64s, number: int) -> Float64s:
        """Return points of the silhouette in the picture [px], (n, 2)."""
        k = number % len(self.segment.shape)
        flat = (weights @ self.segment.shape[k].astype(np.float64))[:, (0, 2)]
        return self._in_tank(flat, number)

    def _in_tank(self, flat: Float64s, number: int) -> Float64s:
        s = self.setting
        angle = 0.012 * number if s.travels else 0.0
        yaw = angle + self._yaw[number % len(self._yaw)]
        cos, sin = np.cos(yaw), np.sin(yaw)
        # Body axes: x ahead, z right. In the picture y is down: right of a fish that heads right is below it.
        x, y = flat[:, 0] + 0.45, flat[:, 1]
        away = np.array([s.width / 2, s.height / 2])
        if s.travels:
            away = away + np.array(
                [0.27 * s.width * np.sin(angle), -0.08 * s.height * np.cos(angle)]
            )
        turned = np.stack((cos * x - sin * y, sin * x + cos * y), axis=-1)
        return away + s.body_length * turned

    def _fin(self, weights: Float64s, side: float, number: int) -> Float64s:
        k = number % len(self.segment.shape)
        flat = (weights @ self.segment.shape[k].astype(np.float64))[:, (0, 2)]
        root = flat[[0, -1]].mean(axis=0)
        beat = side * self.setting.fins * (0.45 * np.sin(0.21 * number + side) - 0.1)
        cos, sin = np.cos(beat), np.sin(beat)
        away = flat - root
        turned = np.stack(
            (cos * away[:, 0] - sin * away[:, 1], sin * away[:, 0] + cos * away[:, 1]), -1
        )
        return self._in_tank(root + turned, number)

    def _textured(self) -> Float32s:
        s = self.setting
        rough = self._chance.normal(0.0, 1.0, (s.height // 8 + 1, s.width // 8 + 1)).astype(
            np.float32
        )
        fine = cv2.resize(rough, (s.width, s.height), interpolation=cv2.INTER_CUBIC)
        across = np.linspace(-12.0, 12.0, s.width, dtype=np.float32)
        return np.asarray(s.ground + 7.0 * np.asarray(fine) + across, np.float32)

    def _shaded(self, image: Float32s, number: int) -> Float32s:
        s = self.setting
        cover = np.zeros((s.height // 8, s.width // 8), np.float32)
        centre = (int(s.width / 8 * (0.5 + 0.4 * np.sin(0.017 * number))), s.height // 16)
        cv2.ellipse(cover, centre, (s.width // 48, s.height // 28), 20, 0, 360, 1.0, -1)
        soft = cv2.resize(cv2.GaussianBlur(cover, (0, 0), 1.2), (s.width, s.height))
        shaded: Float32s = image * (1.0 - (1.0 - s.shadow) * np.asarray(soft))
        return shaded


def _yaws(segment: Segment) -> Float64s:
    """Return the heading of each frame about its mean over the cycle [rad], clockwise in the picture, (N,)."""
    turned, yaws = np.eye(3), []
    for m in segment.rotation:
        turned = turned @ m
        yaws.append(np.arctan2(turned[2, 0], turned[0, 0]))
    found = np.array(yaws)
    centred: Float64s = found - found.mean()
    return centred


def _ribbon(line: Float64s, thick: float) -> Float64s:
    along = np.gradient(line, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    aside = np.stack((-along[:, 1], along[:, 0]), axis=-1) * (0.5 * thick)
    return np.concatenate((line + aside, (line - aside)[::-1]))


def _fill(image: Float32s, places: Float64s, ink: int) -> None:
    """Draw a closed shape with places in sixteenths of a pixel."""
    fixed = np.round(places * (1 << _SHIFT)).astype(np.int32)
    cv2.fillPoly(image, [fixed], float(ink), lineType=cv2.LINE_8, shift=_SHIFT)
