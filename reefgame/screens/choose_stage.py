"""The first sight of a clip, fitted into the window of `reefgame video --choose` (papers/003, section 3.1)."""

from typing import Final

import numpy as np

from components.arrays import Float64s
from tools.video.candidates import FirstSight
from tools.video.images import Colour

BAR: Final = 0.055
"""Of the window's height, kept free at its lower edge for a line of text."""


class ChooseStage:
    """A picture with the fishes in it, the one under the pointer, and the one that was chosen. Places have y up."""

    def __init__(self, sight: FirstSight) -> None:
        self._sight = sight
        self.hovered: int | None = None
        self.chosen: tuple[float, float] | None = None
        "the place that was clicked, in pixels of the clip as shown"

    @property
    def picture(self) -> Colour:
        """The frame, (height, width, 3)."""
        return self._sight.picture

    @property
    def number(self) -> int:
        """The frame's."""
        return self._sight.number

    @property
    def count(self) -> int:
        """How many fishes there are to choose from."""
        return len(self._sight.outlines)

    def box(self, width: int, height: int) -> tuple[float, float, float, float]:
        """Return where the picture lies in a window of width x height [px]: x, y, width and height."""
        rows, columns = self.picture.shape[:2]
        low = BAR * height
        scale = min(width / columns, (height - low) / rows)
        return (
            0.5 * (width - scale * columns),
            low + 0.5 * (height - low - scale * rows),
            scale * columns,
            scale * rows,
        )

    def outline(self, number: int, width: int, height: int) -> Float64s:
        """Return a fish's outline in the window [px], closed, (n + 1, 2)."""
        x, y, across, up = self.box(width, height)
        scale = across / self.picture.shape[1]
        points = self._sight.outlines[number][np.r_[: len(self._sight.outlines[number]), 0]] + 0.5
        return np.stack((x + scale * points[:, 0], y + up - scale * points[:, 1]), axis=1)

    def point(self, x: float, y: float, width: int, height: int) -> None:
        """Move the pointer to a place of the window [px]."""
        self.hovered = self._sight.under(self._in_picture(x, y, width, height))

    def click(self, x: float, y: float, width: int, height: int) -> bool:
        """Choose the fish at a place of the window [px]; return whether there is one."""
        place = self._in_picture(x, y, width, height)
        if self._sight.under(place) is None:
            return False
        self.chosen = self._sight.as_shown(place)
        return True

    def _in_picture(self, x: float, y: float, width: int, height: int) -> tuple[float, float]:
        left, low, across, up = self.box(width, height)
        scale = across / self.picture.shape[1]
        return (x - left) / scale - 0.5, (low + up - y) / scale - 0.5
