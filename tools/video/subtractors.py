"""The mixture-of-Gaussians and nearest-neighbour models of OpenCV, started from the clean plate.

They learn what stands still, so they absorb a fish that holds station (FINDINGS 4); they serve where light changes.
"""

from typing import Any, Final

import cv2
import numpy as np

from tools.video.images import Grey

_HISTORY: Final = 500
_TAUGHT: Final = 20
_SHADOW: Final = 127


class Subtractor:
    """One of OpenCV's models behind our interface."""

    def __init__(self, learner: Any, plate: Grey) -> None:
        """Teach it the plate."""
        self._learner = learner
        for _ in range(_TAUGHT):
            learner.apply(plate)

    def moving(self, blurred: Grey) -> Grey | None:
        """Return what it takes for foreground; what it takes for shadow is ground."""
        found = np.asarray(self._learner.apply(blurred), np.uint8)
        return np.asarray(cv2.threshold(found, _SHADOW, 255, cv2.THRESH_BINARY)[1], np.uint8)


def model(name: str, plate: Grey) -> Subtractor:
    """Return the model `mog2` or `knn`."""
    makers = {"mog2": cv2.createBackgroundSubtractorMOG2, "knn": cv2.createBackgroundSubtractorKNN}
    return Subtractor(makers[name](history=_HISTORY, detectShadows=True), plate)
