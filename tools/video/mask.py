"""The fish's mask in each frame: threshold with hysteresis, opening, closing, and the component that is the fish.

FINDINGS 4, rule 1. The fish is looked for near where it was; where it is not found there, in the whole frame.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple, TypeAlias

import cv2
import numpy as np

from components.arrays import Float64s, Int32s
from tools.video.background import Background, Plate, blur
from tools.video.faults import Fault
from tools.video.images import Grey

_WEAK: Final = 0.6
_CUT: Final = cv2.getStructuringElement(cv2.MORPH_RECT, (3, 3))
_JOIN: Final = cv2.getStructuringElement(cv2.MORPH_RECT, (5, 5))
_REACH: Final = cv2.getStructuringElement(cv2.MORPH_RECT, (9, 9))
_MARGIN: Final = 0.12
"""How far round its last place the fish is looked for, over the longer side of its box."""
_LEAST: Final = 150
"""[px] of area below which nothing is a fish."""
_LEAST_ROUND: Final = 30
RIM: Final = 2
"""[px] of ground all round a mask that is cut out."""
Box: TypeAlias = tuple[int, int, int, int]
_SMALLEST, _LARGEST = 0.45, 1.7
"""Area of the fish over its usual one: below, part of it is hidden; above, something touches it."""


@dataclass(frozen=True)
class Sighting:
    """The fish in one frame: its mask, and where that lies in the frame."""

    mask: Grey
    "0 or 255, holes filled, with a rim of RIM noughts all round, (h, w)"
    outline: Int32s
    "its outer contour [px] in the mask, (n, 2)"
    corner: tuple[int, int]
    "x and y [px] of the mask's first pixel in the frame"
    box: Box
    "left, top, right, bottom [px] in the frame"
    area: float
    "[px]"
    contrast: float
    "mean difference from the plate inside the mask, over T"
    at_edge: bool
    "whether it touches the edge of the frame"


class Outlines(NamedTuple):
    """All that differs from the plate in a part of a frame."""

    outlines: list[Int32s]
    "[px from the part's corner], (n, 2) each"
    areas: Float64s
    "[px], 0 for what is too small to be a fish, (m,)"
    difference: Grey
    "from the plate"


class Segmenter:
    """Finds the fish frame by frame; frames are given in order."""

    def __init__(self, plate: Grey, gate: float, model: Background) -> None:
        """`gate` is T [grey levels]."""
        self._plate, self._gate, self._model = plate, max(gate, 1.0), model
        self._box: Box | None = None
        self.usual_area = 0.0
        "[px] of the fish alone; 0 as long as it is not known"
        self.select: tuple[float, float] | None = None
        "a place [px] that the fish covers when it is first seen"
        self.wary = True
        "whether what differs weakly is fish only within 4 px of what differs strongly: where there are shadows"

    def differing(self, grey: Grey, box: Box) -> tuple[Grey, Grey | None]:
        """Return the differences from the plate inside `box`, and what the model takes for foreground."""
        left, top, right, bottom = box
        blurred = blur(grey[top:bottom, left:right])
        difference = np.asarray(cv2.absdiff(blurred, self._plate[top:bottom, left:right]), np.uint8)
        return difference, self._model.moving(blurred)

    def filtered(self, difference: Grey, moving: Grey | None) -> Grey:
        """Return the mask of all that differs: threshold with hysteresis, opening, closing."""
        strong = cv2.threshold(difference, self._gate, 255, cv2.THRESH_BINARY)[1]
        weak = cv2.threshold(difference, _WEAK * self._gate, 255, cv2.THRESH_BINARY)[1]
        mask = cv2.bitwise_and(weak, cv2.dilate(strong, _REACH)) if self.wary else weak
        if moving is not None:
            mask = cv2.bitwise_and(mask, cv2.dilate(moving, _REACH))
        opened = cv2.morphologyEx(mask, cv2.MORPH_OPEN, _CUT)
        return np.asarray(cv2.morphologyEx(opened, cv2.MORPH_CLOSE, _JOIN), np.uint8)

    def find(self, grey: Grey) -> Sighting | None:
        """Return the fish in this frame, None where it is not seen."""
        whole = (0, 0, grey.shape[1], grey.shape[0])
        near = self._around(grey)
        found = self._pick(grey, near)
        if near != whole and (found is None or self._crosses(found, near, grey)):
            found = self._pick(grey, whole)
        if found is not None:
            self._box = found.box
        return found

    def _around(self, grey: Grey) -> Box:
        """Return where to look first; a model that learns must see whole frames."""
        height, width = grey.shape
        if self._box is None or not isinstance(self._model, Plate):
            return 0, 0, width, height
        left, top, right, bottom = self._box
        more = int(_MARGIN * max(right - left, bottom - top)) + 8
        return (
            max(0, left - more),
            max(0, top - more),
            min(width, right + more),
            min(height, bottom + more),
        )

    def _crosses(self, found: Sighting, near: Box, grey: Grey) -> bool:
        """Return whether the fish goes on beyond where it was looked for."""
        edges = (0, 0, grey.shape[1], grey.shape[0])
        touched = zip(found.box, near, edges, strict=True)
        return any(side == limit and limit != edge for side, limit, edge in touched)

    def outlines(self, grey: Grey, near: Box) -> Outlines:
        """Return the outlines of all that differs inside `near`."""
        difference, moving = self.differing(grey, near)
        mask = self.filtered(difference, moving)
        found, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        areas = np.array([cv2.contourArea(c) if len(c) > _LEAST_ROUND else 0.0 for c in found])
        outlines = [np.asarray(c[:, 0, :], np.int32) for c in found]
        return Outlines(outlines, np.where(areas >= _LEAST, areas, 0.0), difference)

    def _pick(self, grey: Grey, near: Box) -> Sighting | None:
        outlines, size, difference = self.outlines(grey, near)
        if not len(size) or size.max() == 0.0:
            return None
        best = self._best(outlines, size, near)
        return self._cut_out(outlines[best], float(size[best]), difference, near, grey)

    def _best(self, outlines: Sequence[Int32s], size: Float64s, near: Box) -> int:
        """Return the component that is the fish: where it was, else where it was chosen, else the largest."""
        corner = np.array(near[:2])
        if self._box is not None:
            left, top, right, bottom = self._box
            place, scale = (
                np.array([left + right, top + bottom]) / 2.0,
                max(right - left, bottom - top, 1),
            )
            away = [np.hypot(*(o.mean(axis=0) + corner - place)) / scale for o in outlines]
            return int(np.argmax(size / (1.0 + 4.0 * np.array(away) ** 2)))
        if self.select is not None:
            chosen = np.array(self.select) - corner
            away = [float(np.hypot(*(o - chosen).T).min()) for o in outlines]
            inside = [cv2.pointPolygonTest(o, tuple(chosen.tolist()), False) >= 0 for o in outlines]
            return int(np.argmin(np.where(size > 0.0, np.where(inside, 0.0, away), np.inf)))
        return int(np.argmax(size))

    def _cut_out(
        self, outline: Int32s, area: float, difference: Grey, near: Box, grey: Grey
    ) -> Sighting:
        x, y, w, h = cv2.boundingRect(outline)
        mask = np.zeros((h + 2 * RIM, w + 2 * RIM), np.uint8)
        own = outline - np.array([x - RIM, y - RIM], np.int32)
        cv2.drawContours(mask, [own], 0, 255, cv2.FILLED)
        contrast = (
            cv2.mean(difference[y : y + h, x : x + w], mask[RIM:-RIM, RIM:-RIM])[0] / self._gate
        )
        left, top = near[0] + x, near[1] + y
        height, width = grey.shape
        box = (left, top, left + w, top + h)
        at_edge = left <= 0 or top <= 0 or left + w >= width or top + h >= height
        return Sighting(mask, own, (left - RIM, top - RIM), box, area, float(contrast), at_edge)

    def fault(self, found: Sighting | None) -> Fault:
        """Return what is wrong with a sighting, nothing where it shows the fish alone and whole."""
        if found is None:
            return Fault.NO_FISH
        if found.at_edge:
            return Fault.AT_EDGE
        if self.usual_area > 0.0 and found.area > _LARGEST * self.usual_area:
            return Fault.TOUCHED
        if self.usual_area > 0.0 and found.area < _SMALLEST * self.usual_area:
            return Fault.HIDDEN
        return Fault.NONE
