"""The sample-consensus model that papers/003 uses (its reference 29), written from the published description.

A pixel keeps 20 past values of itself; it is ground where at least 2 of them lie within 20 grey levels. One pixel of
ground in 16, by chance, replaces one of its values, and one of a neighbour's. The method is patented (EP 2015252,
US 8009918, JP 4699564, priority July 2007): docs/video.md.
"""

from typing import Final

import cv2
import numpy as np

from tools.video.images import Bools, Grey

_VALUES: Final = 20
_NEAR: Final = 20
_AGREE: Final = 2
_UPDATED: Final = 16


class SampleConsensus:
    """The model of a clip, started from the clean plate; chance is seeded, so a clip gives the same twice."""

    def __init__(self, plate: Grey) -> None:
        """Fill each pixel's values from its own neighbourhood in the plate."""
        self._chance = np.random.default_rng(0)
        self._height, self._width = plate.shape
        padded = np.pad(plate, 1, mode="edge")
        shifts = self._chance.integers(0, 3, (_VALUES, 2))
        self._values = np.stack(
            [padded[y : y + self._height, x : x + self._width] for y, x in shifts.tolist()]
        )

    def moving(self, blurred: Grey) -> Grey | None:
        """Return what has no two near values, and learn from the rest."""
        agreeing = np.zeros(blurred.shape, np.uint8)
        for values in self._values:
            agreeing += np.asarray(cv2.absdiff(values, blurred)) < _NEAR
        foreground = agreeing < _AGREE
        self._learn(blurred, foreground)
        return np.asarray(foreground, np.uint8) * np.uint8(255)

    def _learn(self, blurred: Grey, foreground: Bools) -> None:
        count = self._height * self._width // _UPDATED
        y = self._chance.integers(0, self._height, count)
        x = self._chance.integers(0, self._width, count)
        ground = ~foreground[y, x]
        y, x = y[ground], x[ground]
        self._values[self._chance.integers(0, _VALUES, len(y)), y, x] = blurred[y, x]
        aside = self._chance.integers(-1, 2, (2, len(y)))
        near_y = np.clip(y + aside[0], 0, self._height - 1)
        near_x = np.clip(x + aside[1], 0, self._width - 1)
        self._values[self._chance.integers(0, _VALUES, len(y)), near_y, near_x] = blurred[y, x]


def model(name: str, plate: Grey) -> SampleConsensus:
    """Return the model `vibe`."""
    del name
    return SampleConsensus(plate)
