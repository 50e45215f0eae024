"""What moves where a clip's fish is first seen: the fishes among which a user chooses (papers/003, section 3.1)."""

from dataclasses import dataclass
from itertools import takewhile

import cv2
import numpy as np

from components.arrays import Int32s
from tools.video.background import Plate
from tools.video.follow import Scene
from tools.video.images import Colour
from tools.video.mask import Segmenter


@dataclass(frozen=True)
class FirstSight:
    """The first frame in which something moves, and all that moves in it."""

    number: int
    "the frame's"
    picture: Colour
    "at the working size"
    outlines: tuple[Int32s, ...]
    "of what moves, the largest first [px of the picture], (n, 2) each"
    scale: float
    "pixels of the picture for one of the clip as shown"

    def under(self, place: tuple[float, float]) -> int | None:
        """Return which outline holds a place of the picture [px], the smallest where several do; None where none."""
        holding = [
            number
            for number, outline in enumerate(self.outlines)
            if cv2.pointPolygonTest(outline, place, measureDist=False) >= 0.0
        ]
        return holding[-1] if holding else None

    def as_shown(self, place: tuple[float, float]) -> tuple[float, float]:
        """Return a place of the picture in pixels of the clip as shown, as `Choices.select` takes it."""
        return place[0] / self.scale, place[1] / self.scale


def first_sight(scene: Scene) -> FirstSight | None:
    """Return the frame in which `--select` would choose, None where nothing moves in any."""
    segmenter = Segmenter(scene.plate, scene.gate, Plate())
    segmenter.wary = scene.wary
    shot = takewhile(lambda frame: frame.number < scene.survey.stop, scene.clip.frames(colour=True))
    for frame in shot:
        if frame.number < scene.survey.first or frame.grey is None or frame.colour is None:
            continue
        height, width = frame.grey.shape
        found = segmenter.outlines(frame.grey, (0, 0, width, height))
        large = np.flatnonzero(found.areas > 0.0)
        if len(large):
            order = large[np.argsort(-found.areas[large], kind="stable")]
            outlines = tuple(found.outlines[k] for k in order.tolist())
            return FirstSight(frame.number, frame.colour, outlines, scene.clip.scale)
    return None
