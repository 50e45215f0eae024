"""One texture for all of a mesh's materials: pictures and plain colours side by side."""

from collections.abc import Sequence
from typing import Final

import numpy as np

from components.arrays import Float64s
from tools.video.retarget.target import Texture

_PLAIN: Final = 4
"""[px] of a side of a plain colour's square."""


def plain(colour: Sequence[float]) -> Texture:
    """Return a small square of one colour, red, green, blue and opacity from 0 to 1."""
    texel = np.clip(np.round(np.array(colour, np.float64) * 255.0), 0, 255).astype(np.uint8)
    return np.broadcast_to(texel, (_PLAIN, _PLAIN, 4)).copy()


def tinted(picture: Texture, factor: Sequence[float]) -> Texture:
    """Return a picture with its colours multiplied by red, green, blue and opacity from 0 to 1."""
    return np.asarray(np.clip(picture * np.array(factor), 0, 255), np.uint8)


def joined(pictures: Sequence[Texture]) -> tuple[Texture, list[int]]:
    """Return all pictures side by side, and where each begins [px]."""
    height = max(picture.shape[0] for picture in pictures)
    padded = [np.pad(p, ((0, height - p.shape[0]), (0, 0), (0, 0)), mode="edge") for p in pictures]
    starts = np.cumsum([0, *(p.shape[1] for p in pictures)])[:-1]
    return np.concatenate(padded, axis=1), [int(start) for start in starts]


def placed(uv: Float64s, picture: Texture, start: int) -> Float64s:
    """Return places in the joined texture [px] of uv in the unit square, y down; beyond it the picture repeats."""
    size = np.array([picture.shape[1] - 1.0, picture.shape[0] - 1.0])
    # A whole number is the far edge, not the near one.
    wrapped = np.where((uv >= 0.0) & (uv <= 1.0), uv, uv - np.floor(uv))
    return np.asarray(wrapped * size + np.array([float(start), 0.0]))
