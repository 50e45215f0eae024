"""The simplified curve skeleton and its angles: what passes from a fish to a target (papers/003, algorithms 1 to 3).

An axis is sampled at the centre, `UP` points towards the head, the head, `LOW` points towards the tail and the tail.
The local frame is that of tools/video/motion.py: seen from above, the head towards +y, the right side towards +x. Bones
point away from the centre, so those of a straight fish stand at pi / 2 ahead of it and at 3 pi / 2 behind.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s

UP: Final = 3
"""u_num: points of the axis between centre and head."""
LOW: Final = 15
"""l_num: points of the axis between centre and tail."""
BONES: Final = UP + LOW + 2
CONTROLS: Final = BONES + 1
"""Body control points: centre, up_axis, head, low_axis, tail."""
HEAD: Final = UP + 1
"""Place of the head among the control points; the tail is the last."""
NAMES: Final = (
    *(f"up_axis_angle_{i + 1}" for i in range(UP)),
    "head_angle",
    *(f"low_axis_angle_{i + 1}" for i in range(LOW)),
    "tail_angle",
    "l_fin_angle",
    "r_fin_angle",
)
"""Columns of angles: bones, then the fins of the left and the right side."""
ANGLES: Final = len(NAMES)


@dataclass(frozen=True)
class Skeleton:
    """L of algorithm 1: how long each bone of a body is, in the body's own unit."""

    lengths: Float64s
    "up_len, head_len, low_len, tail_len, (20,)"

    @property
    def body_length(self) -> float:
        """body_len: the sum of all bones."""
        return float(self.lengths.sum())


def sampled_axis(axis: Float64s, centre: float) -> Float64s:
    """Return the control points (21, 2) of an axis (n, 2), head first, its centre at a fraction of its length."""
    step = np.sqrt((np.diff(axis, axis=0) ** 2).sum(axis=1))
    arc = np.concatenate((np.zeros(1), np.cumsum(step)))
    ahead = centre * (1.0 - np.arange(1, UP + 2) / (UP + 1))
    behind = centre + (1.0 - centre) * np.arange(1, LOW + 2) / (LOW + 1)
    at = np.concatenate((np.array([centre]), ahead, behind)) * arc[-1]
    return np.stack((np.interp(at, arc, axis[:, 0]), np.interp(at, arc, axis[:, 1])), axis=-1)


def bones(controls: Float64s) -> Float64s:
    """Return each bone as a vector away from the centre, from control points (..., 21, 2), (..., 20, 2)."""
    towards = np.diff(controls[..., : HEAD + 1, :], axis=-2)
    first = controls[..., HEAD + 1 : HEAD + 2, :] - controls[..., :1, :]
    return np.concatenate((towards, first, np.diff(controls[..., HEAD + 1 :, :], axis=-2)), axis=-2)


def skeleton_of(controls: Float64s) -> Skeleton:
    """Return the bone lengths of control points (21, 2) (algorithm 1)."""
    return Skeleton(np.sqrt((bones(controls) ** 2).sum(axis=-1)))


def angle_of(vectors: Float64s) -> Float64s:
    """Return the angles of vectors (..., 2) in the local frame, 0 to 2 pi."""
    return np.asarray(np.arctan2(vectors[..., 1], vectors[..., 0]) % (2.0 * np.pi))


def nearest_turn(angle: Float64s) -> Float64s:
    """Return angles brought to lie between -pi and pi."""
    return np.asarray((angle + np.pi) % (2.0 * np.pi) - np.pi)


def posed(skeleton: Skeleton, angles: Float64s) -> Float64s:
    """Return the control points that bones at these angles (20,) [rad] make, the centre at 0, (21, 2) (algorithm 3)."""
    along = skeleton.lengths[:, None] * np.stack((np.cos(angles), np.sin(angles)), axis=-1)
    points = np.zeros((CONTROLS, 2))
    points[1 : HEAD + 1] = np.cumsum(along[:HEAD], axis=0)
    points[HEAD + 1 :] = np.cumsum(along[HEAD:], axis=0)
    return points
