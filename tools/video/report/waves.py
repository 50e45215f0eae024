"""What the midline does over a clip: its wave beside the fish's own mean line, and the envelope of it."""

import numpy as np

from components.arrays import Float64s
from tools.video.motion import Motion


def sideways(motion: Motion) -> Float64s:
    """Return how far each station lies to the left of the fish's mean line in its frame, in lengths, (n, 41)."""
    axis = motion.axis.astype(np.float64)
    away = axis - axis.mean(axis=1, keepdims=True)
    spread = np.einsum("nki,nkj->nij", away, away)
    line = np.linalg.eigh(spread)[1][:, :, 1]
    ahead = axis[:, 0] - axis[:, -1]
    line *= np.where((line * ahead).sum(axis=1) < 0.0, -1.0, 1.0)[:, None]
    # The picture's y is down: the left of a fish that heads right lies above it.
    left = np.stack((line[:, 1], -line[:, 0]), axis=-1)
    return np.asarray(np.einsum("nki,ni->nk", away, left) / motion.length)


def envelope(motion: Motion) -> Float64s:
    """Return half of what each station sweeps, in lengths, by the good frames, (41,)."""
    swept = sideways(motion)[motion.good]
    return np.asarray(0.5 * (swept.max(axis=0) - swept.min(axis=0)))
