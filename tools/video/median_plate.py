"""The clean plate where the fish moves: each pixel's median over frames from the whole clip (FINDINGS 4)."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from tools.video.images import Grey

_BAND: Final = 64
"""Rows taken at a time: their samples stay in the processor's cache."""


def median_of(samples: NDArray[np.uint8]) -> Grey:
    """Return the median over the first axis of (n, height, width)."""
    plate = np.empty(samples.shape[1:], np.uint8)
    for top in range(0, len(plate), _BAND):
        band = np.sort(samples[:, top : top + _BAND], axis=0)
        plate[top : top + _BAND] = band[len(band) // 2]
    return plate
