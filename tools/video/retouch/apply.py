"""Puts edited angles back into a motion, so that its file, films and species follow (papers/003, eq. 17)."""

from dataclasses import replace

import numpy as np

from components.arrays import Float64s
from tools.video.motion import Motion, rebuilt_axis
from tools.video.retarget.skeleton import BONES, HEAD, UP

_LEAST = 1e-12


def retouched(motion: Motion, angles: Float64s, edits: int) -> Motion:
    """Return the motion with these angles [rad], columns as skeleton.NAMES, (T, 22); `edits` goes into its provenance.

    The fine axis keeps its detail: it moves by what the bones have moved, and the junctions move with it.
    """
    fresh = replace(
        motion,
        up_angle=angles[:, :UP],
        head_angle=angles[:, UP],
        low_angle=angles[:, HEAD : BONES - 1],
        tail_angle=angles[:, BONES - 1],
        fin_angle=angles[:, BONES:],
        provenance={**motion.provenance, "retouched": str(edits)},
    )
    before, after = rebuilt_axis(motion), rebuilt_axis(fresh)
    axis, junction = motion.axis.astype(np.float64), motion.junction.copy()
    for frame in np.flatnonzero(np.abs(after - before).max(axis=(1, 2)) > _LEAST):
        shift = _shift(before[frame], after[frame] - before[frame], axis.shape[1])
        away = ((junction[frame][:, None, :] - axis[frame]) ** 2).sum(axis=2)
        junction[frame] += shift[np.argmin(np.nan_to_num(away, nan=np.inf), axis=1)]
        axis[frame] += shift
    return replace(fresh, axis=axis.astype(np.float32), junction=junction)


def _shift(bones: Float64s, moved: Float64s, stations: int) -> Float64s:
    """Return how far evenly spaced stations move where the bones' ends (n, 2) move so far, (stations, 2)."""
    step = np.sqrt((np.diff(bones, axis=0) ** 2).sum(axis=1))
    arc = np.concatenate((np.zeros(1), np.cumsum(step)))
    at = np.linspace(0.0, float(arc[-1]), stations)
    return np.stack((np.interp(at, arc, moved[:, 0]), np.interp(at, arc, moved[:, 1])), axis=-1)
