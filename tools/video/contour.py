"""Smooth contours by elliptic Fourier coefficients (papers/003, section 4.3, eqs. 2-6; Kuhl and Giardina 1982).

A contour resampled evenly by arc length is a periodic complex sequence x + i y; a, b, c and d of eq. 2 are its Fourier
transform's at k and -k. S harmonics are kept: the fewest that lie near enough to the contour.
"""

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from tools.video.images import Grey

POINTS: Final = 256
MOST_HARMONICS: Final = 12
RESIDUAL: Final = 0.0075
"""Root mean square distance [BL] from the contour below which harmonics are enough."""


def outline_of(mask: Grey) -> Float64s:
    """Return the outer contour of a mask's largest part [px], closed, anticlockwise in x right, y down, (n, 2)."""
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    return np.asarray(max(contours, key=len)[:, 0, :], np.float64)


def evenly(line: Float64s, count: int, closed: bool = False) -> Float64s:
    """Return `count` points at equal arc lengths along a line (n, 2); the end is left out where it is closed."""
    if closed:
        line = np.concatenate((line, line[:1]))
    step = line[1:] - line[:-1]
    arc = np.zeros(len(line))
    np.cumsum(np.sqrt(step[:, 0] ** 2 + step[:, 1] ** 2), out=arc[1:])
    at = np.arange(count) * (arc[-1] / (count if closed else count - 1))
    spread = np.empty((count, 2))
    spread[:, 0] = np.interp(at, arc, line[:, 0])
    spread[:, 1] = np.interp(at, arc, line[:, 1])
    return spread


def coefficients(contour: Float64s) -> NDArray[np.complex128]:
    """Return the Fourier coefficients of a closed contour (n, 2), (n,)."""
    return np.fft.fft(contour[:, 0] + 1j * contour[:, 1]) / len(contour)


def harmonics_needed(fourier: NDArray[np.complex128], length: float) -> int:
    """Return S, the fewest harmonics, MOST_HARMONICS at most, whose residual is below RESIDUAL of `length` [px]."""
    power = np.abs(fourier) ** 2
    k = np.abs(np.fft.fftfreq(len(fourier), 1.0 / len(fourier)))
    rest = [float(power[k > s].sum()) for s in range(1, MOST_HARMONICS)]
    enough = [s for s, left in enumerate(rest, 1) if np.sqrt(left) < RESIDUAL * length]
    return enough[0] if enough else MOST_HARMONICS


def smooth_contour(contour: Float64s, length: float) -> tuple[Float64s, int]:
    """Return the contour (n, 2) rebuilt from S harmonics, (256, 2), and S; `length` of the fish [px]."""
    fourier = coefficients(evenly(contour, POINTS, closed=True))
    harmonics = harmonics_needed(fourier, length)
    return rebuilt(kept(fourier, harmonics)), harmonics


def kept(fourier: NDArray[np.complex128], harmonics: int) -> NDArray[np.complex128]:
    """Return the coefficients k = 0, 1 ... S, -S ... -1 alone, (2 S + 1,)."""
    return np.concatenate((fourier[: harmonics + 1], fourier[-harmonics:]))


def rebuilt(low: NDArray[np.complex128], count: int = POINTS) -> Float64s:
    """Return the closed contour of coefficients as `kept` gives them, (count, 2)."""
    harmonics = len(low) // 2
    whole = np.zeros(count, np.complex128)
    whole[: harmonics + 1] = low[: harmonics + 1]
    whole[-harmonics:] = low[harmonics + 1 :]
    line = np.fft.ifft(whole) * count
    return np.stack((line.real, line.imag), axis=-1)
