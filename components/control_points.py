"""Recorded control points in the world (papers/000, eqs. 9 and 13, with the scale a on t as on s: FINDINGS 1).

A populous species may keep the control points of its B-spline skin beside its nodes: then nothing has to be computed
from nodes to draw it, for the price of sixteen times the memory.
"""

import numpy as np

from components.arrays import Float32s, Float64s
from components.kernels import row
from components.segment import Segment


@row
def place_control_points(
    control: Float32s, rotation: Float64s, origin: Float64s, size: float, placed: Float32s
) -> None:
    """placed <- o + R (size s), eq. 13; s and placed (C, 3), R (3, 3), o (3,) [m], size [m] for 1 BL."""
    for point in range(len(control)):
        x, y, z = size * control[point, 0], size * control[point, 1], size * control[point, 2]
        for axis in range(3):
            turned = rotation[axis, 0] * x + rotation[axis, 1] * y + rotation[axis, 2] * z
            placed[point, axis] = np.float32(origin[axis] + turned)


@row
def _play(
    turn: Float64s,
    travel: Float64s,
    control: Float32s,
    size: float,
    rotation: Float64s,
    origin: Float64s,
    placed: Float32s,
) -> None:
    for k in range(len(turn)):
        m, t = turn[k], travel[k]
        for i in range(3):
            x, y, z = rotation[i, 0], rotation[i, 1], rotation[i, 2]
            origin[i] += size * (x * t[0] + y * t[1] + z * t[2])
            for j in range(3):
                rotation[i, j] = x * m[0, j] + y * m[1, j] + z * m[2, j]
        place_control_points(control[k], rotation, origin, size, placed[k])


def restored(segment: Segment, origin: Float64s, rotation: Float64s, size: float = 1.0) -> Float32s:
    """Return the control points after each entry of a segment played from o (3,) [m] and R (3, 3): (N, 378, 3) [m].

    `size` is the fish's length [m]. Raise ValueError where the segment holds no control points.
    """
    if segment.control is None:
        raise ValueError(f"{segment.pattern.name.lower()} holds no control points")
    placed = np.zeros_like(segment.control)
    moving = np.array(rotation, np.float64), np.array(origin, np.float64)
    _play(segment.rotation, segment.translation, segment.control, size, *moving, placed)
    return placed
