"""Where a picture is taken from: the eye, its axes and its lens."""

from dataclasses import dataclass
from math import inf
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.trigonometry import cosine, sine

VIEWFINDER_ASPECT: Final = 1.5
"""Width over height of the frame in which photographs are judged, whatever the window's (DESIGN 7)."""

VIEWFINDER_SLOPE: Final = 0.4142135623730951
"""Tangent of half the viewfinder's vertical field of view, 45 degrees."""


@dataclass(frozen=True)
class Camera:
    """An eye looking along `forward`; right-handed with `right` and `up`."""

    eye: Float64s
    "[m], world axes, (3,)"
    forward: Float64s
    "unit, (3,)"
    right: Float64s
    "unit, (3,)"
    up: Float64s
    "unit, (3,)"
    slope: float = 0.5773502691896257
    "tangent of half the vertical field of view"
    sight: float = inf
    "[m] at which things fade for this eye, in the clearest water"

    @property
    def axes(self) -> Float64s:
        """Forward, right and up as rows, (3, 3)."""
        return np.array([self.forward, self.right, self.up])


def camera_at(eye: Float64s, yaw: float, pitch: float, slope: float = 0.5773502691896257) -> Camera:
    """Return the camera at `eye` [m] that looks along `yaw` and `pitch` [rad]; exact over machines."""
    cy, sy, cp, sp = cosine(yaw), sine(yaw), cosine(pitch), sine(pitch)
    forward = np.array([cy * cp, sy * cp, sp])
    right = np.array([sy, -cy, 0.0])
    up = np.array([-cy * sp, -sy * sp, cp])
    return Camera(np.asarray(eye, np.float64).copy(), forward, right, up, slope)


def camera_towards(eye: Float64s, at: Float64s, slope: float = 0.5773502691896257) -> Camera:
    """Return the camera at `eye` [m] that looks at the point `at` [m], world z up."""
    forward = np.asarray(at, np.float64) - np.asarray(eye, np.float64)
    forward = forward / max(float(np.sqrt(forward @ forward)), 1e-9)
    right = np.cross(forward, (0.0, 0.0, 1.0))
    size = float(np.sqrt(right @ right))
    right = right / size if size > 1e-6 else np.array([0.0, -1.0, 0.0])
    return Camera(
        np.asarray(eye, np.float64).copy(), forward, right, np.cross(right, forward), slope
    )
