"""Draws what was found in a frame over it: contour, axis, fins, and a word about frames that failed."""

from collections.abc import Iterator
from math import ceil
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s, Int32s
from tools.video.contour import rebuilt
from tools.video.faults import REASONS, Fault
from tools.video.features import Features
from tools.video.follow import Followed
from tools.video.images import Colour
from tools.video.motion import fin_tips, rebuilt_axis
from tools.video.writing import even

CONTOUR: Final = (70, 200, 90)
AXIS: Final = (235, 50, 40)
BRIDGED: Final = (250, 170, 0)
FIN: Final = (20, 120, 250)
TIPS: Final = (230, 40, 220)
_SHIFT: Final = 4
_SMALL: Final = 640
"""[px] of the longer side below which a film is drawn twice as large."""


def overlaid(followed: Followed) -> Iterator[Colour]:
    """Yield the clip's frames in colour with what was found drawn over them; a damaged frame repeats the last."""
    clip, motion = followed.scene.clip, followed.assembled.motion
    points, tips = rebuilt_axis(motion) * clip.scale, fin_tips(motion) * clip.scale
    last = np.zeros((clip.working[1], clip.working[0], 3), np.uint8)
    for frame, features in zip(clip.frames(colour=True), followed.features, strict=False):
        last = last if frame.colour is None else frame.colour
        at = frame.number - motion.first
        fault = Fault(int(followed.assembled.fault[frame.number]))
        picture = Picture(last, ceil(_SMALL / max(last.shape[:2])))
        picture.features(features)
        if 0 <= at < motion.count:
            picture.line(points[at], AXIS if fault == Fault.NONE else BRIDGED, 2)
            for side in np.flatnonzero(~motion.folded[at]).tolist():
                junction = motion.junction[at, [side, 2 + side]] * clip.scale
                picture.line(np.stack((junction[0], tips[at, side], junction[1])), FIN, 1)
        picture.words(f"{frame.number}: {REASONS[fault]}", AXIS if fault else CONTOUR)
        yield even(picture.image)


class Picture:
    """A picture to draw on, in pixels of the frame whatever it is magnified by."""

    def __init__(self, image: Colour, times: int = 1) -> None:
        """Begin with a copy of a frame (h, w, 3), `times` as large."""
        self.times = times
        size = (image.shape[1] * times, image.shape[0] * times)
        self.image = np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_CUBIC), np.uint8)

    def features(self, features: Features) -> None:
        """Draw a frame's contour, the ends of its axis and the tips of its fins."""
        if features.contour is not None:
            self.line(rebuilt(features.contour), CONTOUR, 1, closed=True)
        if features.ends is not None:
            self.dots(features.ends[:2], TIPS)
        if features.fins is not None:
            self.dots(features.fins, FIN)

    def line(
        self, places: Float64s, colour: tuple[int, int, int], thick: int, closed: bool = False
    ) -> None:
        """Draw a line through places (n, 2)."""
        cv2.polylines(self.image, [self._fixed(places)], closed, colour, thick, cv2.LINE_AA, _SHIFT)

    def dots(self, places: Float64s, colour: tuple[int, int, int], radius: float = 3.0) -> None:
        """Draw discs at places (n, 2); those that are nan are left out."""
        for x, y in self._fixed(places[~np.isnan(places[:, 0])]).tolist():
            reach = round(radius * (1 << _SHIFT))
            cv2.circle(self.image, (x, y), reach, colour, -1, cv2.LINE_AA, _SHIFT)

    def words(
        self,
        text: str,
        colour: tuple[int, int, int],
        place: tuple[float, float] | None = None,
        size: float = 0.7,
    ) -> None:
        """Write a line of text, at the top left unless a place in the frame is given."""
        x, y = (10, 26) if place is None else (place[0] * self.times, place[1] * self.times)
        font = cv2.FONT_HERSHEY_SIMPLEX
        at = (round(x), round(y))
        for away in ((-1, -1), (-1, 1), (1, -1), (1, 1), (0, 2), (2, 0), (0, -2), (-2, 0)):
            near = (at[0] + away[0], at[1] + away[1])
            cv2.putText(self.image, text, near, font, size, (255, 255, 255), 1, cv2.LINE_AA)
        cv2.putText(self.image, text, at, font, size, colour, 1, cv2.LINE_AA)

    def _fixed(self, places: Float64s) -> Int32s:
        """Return places in sixteenths of the picture's pixels."""
        middle = (places + 0.5) * self.times - 0.5
        return np.round(middle * (1 << _SHIFT)).astype(np.int32)
