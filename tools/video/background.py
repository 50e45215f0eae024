"""What is fish and what is ground: the interface behind which the background models stand (papers/003, section 4).

Every model is gated by one threshold T for the clip, Otsu's on the pooled differences from the clean plate: it keeps
shadows out, and matters more than the model (FINDINGS 4).
"""

from collections.abc import Callable
from importlib import import_module
from typing import Final, Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from tools.video.images import Grey
from tools.video.inpainting import without_standing_fish
from tools.video.median_plate import median_of

MODELS: Final = ("median", "mog2", "knn", "vibe")
"""Names of the models, the default first."""
_FLOOR: Final = 12
"""[grey levels] below which a difference is noise."""


class Background(Protocol):
    """A model of the ground that is shown the frames in order."""

    def moving(self, blurred: Grey) -> Grey | None:
        """Return the mask of what the model takes for foreground, None where the plate alone decides."""


class Plate:
    """The clean plate as a model: it has nothing to add to the difference from itself."""

    def moving(self, blurred: Grey) -> Grey | None:
        """Return None."""
        del blurred
        return None


def model_of(name: str, plate: Grey) -> Background:
    """Return the model called `name` (one of MODELS), started from the clean plate."""
    if name == "median":
        return Plate()
    module = "vibe" if name == "vibe" else "subtractors"
    make: Callable[[str, Grey], Background] = import_module(f"tools.video.{module}").model
    return make(name, plate)


def clean_plate(samples: NDArray[np.uint8]) -> tuple[Grey, bool]:
    """Return the ground without the fish, and whether a fish that holds station was painted out of it.

    `samples` is (n, height, width); the plate is blurred as frames are.
    """
    blurred = np.stack([blur(sample) for sample in samples])
    return without_standing_fish(blurred, median_of(blurred))


def blur(grey: Grey) -> Grey:
    """Return the picture smoothed over 3x3 pixels."""
    return np.asarray(cv2.GaussianBlur(grey, (3, 3), 0), np.uint8)


def threshold(samples: NDArray[np.uint8], plate: Grey) -> float:
    """Return T [grey levels]: Otsu's threshold of all samples' differences above the noise, 0 where there are none."""
    counts = np.zeros(256)
    for sample in samples:
        counts += np.bincount(np.ravel(cv2.absdiff(blur(sample), plate)), minlength=256)
    counts[: _FLOOR + 1] = 0.0
    return otsu(counts) if counts.sum() else 0.0


def otsu(counts: NDArray[np.float64]) -> float:
    """Return the value that parts a histogram (256,) into two classes of greatest variance between them (Otsu 1979)."""
    values = np.arange(len(counts))
    below, mass = np.cumsum(counts), np.cumsum(counts * values)
    total, whole = below[-1], mass[-1]
    split = (below > 0) & (below < total)
    if not split.any():
        return float(values[counts > 0][0])
    spread = np.zeros(len(counts))
    b, m = below[split], mass[split]
    spread[split] = (whole * b - m * total) ** 2 / (b * (total - b))
    best = np.flatnonzero(spread == spread.max())
    return float(best.mean() + 0.5)
