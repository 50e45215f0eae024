"""What the water needs of a filmed fish: its axis frame by frame, its widths, and which frames are sound.

The picture's axes: x to the right, y down. The camera looks down on the fish, so that its right lies below it where it
heads to the picture's right.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from components.fault import FaultError
from tools.video.motion import Motion

STATIONS = 41
"""Points of an axis, evenly by arc length from nose to tail tip."""


class FilmError(FaultError):
    """A motion gives no species: one line that says what it lacks."""


@dataclass(frozen=True)
class Film:
    """A fish as F frames of a camera saw it, evenly in time."""

    rate: float
    "frames a second of the camera"
    axis: Float64s
    "[px] from nose to tail tip at equal arc lengths, (F, 41, 2)"
    half_width: Float64s
    "of the body without its fins [px], (F, 41)"
    good: NDArray[np.bool_]
    "False where a frame was bridged, (F,)"

    @property
    def length(self) -> float:
        """Length of the axis in a typical good frame [px]."""
        good = self.axis[self.good] if self.good.any() else self.axis
        steps = np.diff(good, axis=1)
        return float(np.median(np.sqrt((steps**2).sum(axis=2)).sum(axis=1)))


def film_of(motion: Motion) -> Film:
    """Return what the water needs of a motion. Raise FilmError where no frame of it is good."""
    if not motion.good.any():
        raise FilmError("no frame of this motion is good")
    axis, width = motion.axis.astype(np.float64), motion.half_width.astype(np.float64)
    return Film(motion.rate, axis, width, motion.good)


def angles(film: Film) -> Float64s:
    """Return where each of the 40 parts of the axis points, headwards [rad], steady over frames, (F, 40).

    They count as the picture does: to the fish's right.
    """
    ahead = film.axis[:, :-1] - film.axis[:, 1:]
    found = np.unwrap(np.arctan2(ahead[..., 1], ahead[..., 0]), axis=1)
    whole = 2.0 * np.pi * np.round((np.unwrap(found[:, 0]) - found[:, 0]) / (2.0 * np.pi))
    steady: Float64s = found + whole[:, None]
    return steady


def weights(film: Film) -> Float64s:
    """Return each part's share of the body's mass, as its width squared, (40,)."""
    typical = (
        np.median(film.half_width[film.good], axis=0) if film.good.any() else np.ones(STATIONS)
    )
    share = (0.5 * (typical[1:] + typical[:-1])) ** 2
    whole = float(share.sum())
    even: Float64s = np.full(len(share), 1.0 / len(share))
    return share / whole if whole > 0.0 else even


def places(film: Film) -> Float64s:
    """Return where the middle of the body's mass is [BL], picture axes, (F, 2)."""
    middle = 0.5 * (film.axis[:, 1:] + film.axis[:, :-1])
    found: Float64s = np.einsum("j,fjc->fc", weights(film), middle) / film.length
    return found
