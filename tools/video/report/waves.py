"""What the midline does over a clip: its wave beside the course that the fish keeps over a beat, and the envelope."""

from math import isfinite
from typing import Final

import numpy as np

from components.arrays import Float64s
from tools.video.motion import Motion

_FEWEST: Final = 3


def sideways(motion: Motion, period: float) -> Float64s:
    """Return how far each station lies to the left of the fish's course, in lengths, (n, 41).

    The course is the mean over a beat, `period` [frames], of where its axis lies and points; over the whole clip where
    that holds no beat.
    """
    axis = motion.axis.astype(np.float64)
    middle = axis.mean(axis=1)
    angle = np.unwrap(_headings(axis))
    over = round(period) if isfinite(period) else motion.count
    course = _over_a_beat(np.concatenate((middle, angle[:, None]), axis=1), over)
    # The picture's y is down: the left of a fish that heads right lies above it.
    left = np.stack((np.sin(course[:, 2]), -np.cos(course[:, 2])), axis=-1)
    return np.asarray(np.einsum("nki,ni->nk", axis - course[:, None, :2], left) / motion.length)


def envelope(motion: Motion, period: float) -> Float64s:
    """Return half of what each station sweeps, in lengths, by the good frames, (41,)."""
    swept = sideways(motion, period)[motion.good]
    return np.asarray(0.5 * (swept.max(axis=0) - swept.min(axis=0)))


def _headings(axis: Float64s) -> Float64s:
    """Return the angle of each axis' mean line towards its head, clockwise in the picture [rad], (n,)."""
    away = axis - axis.mean(axis=1, keepdims=True)
    line = np.linalg.eigh(np.einsum("nki,nkj->nij", away, away))[1][:, :, 1]
    ahead = axis[:, 0] - axis[:, -1]
    line *= np.where((line * ahead).sum(axis=1) < 0.0, -1.0, 1.0)[:, None]
    return np.asarray(np.arctan2(line[:, 1], line[:, 0]))


def _over_a_beat(values: Float64s, over: int) -> Float64s:
    """Return values (n, m) averaged over so many frames; at the ends the line through the nearest so many."""
    count = len(values)
    over = min(max(over, _FEWEST), count)
    sums = np.concatenate((np.zeros((1, values.shape[1])), np.cumsum(values, axis=0)))
    means = (sums[over:] - sums[:-over]) / over
    at = np.arange(count) - 0.5 * (over - 1)
    smooth = np.stack([np.interp(at, np.arange(len(means)), mean) for mean in means.T], axis=-1)
    for span in (slice(0, over), slice(count - over, count)):
        t = np.arange(count)[span]
        slope, offset = np.polyfit(t - t.mean(), values[span], 1)
        line = offset + slope * (t - t.mean())[:, None]
        beyond = (at[span] < 0.0) | (at[span] > len(means) - 1)
        smooth[span] = np.where(beyond[:, None], line, smooth[span])
    return smooth
