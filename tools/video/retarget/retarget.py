"""The whole way from a motion to a moving target: angles, pose, place in the picture (papers/003, section 5)."""

from dataclasses import dataclass

import numpy as np

from components.arrays import Float64s
from tools.video.retarget.intermediate import IntermediateMotion
from tools.video.retarget.rig import FinMode, Rig
from tools.video.retarget.skeleton import BONES
from tools.video.retarget.target import Target


@dataclass(frozen=True)
class Placement:
    """Where and how large a target is in the picture (section 5.3)."""

    centre: Float64s
    "[px], (2,)"
    direction: float
    "of the head, anticlockwise from the picture's right [rad]"
    scale: float
    "pixels for each of the target's units: the fish's length over the target's"
    mirrored: bool = False
    "whether the target's right side is shown on its left"

    def to_picture(self, points: Float64s) -> Float64s:
        """Return local points (n, 2) in the picture [px]."""
        return points @ (self.scale * self._axes) + self.centre

    def to_local(self, points: Float64s) -> Float64s:
        """Return points of the picture [px], (n, 2), in the local frame."""
        return (points - self.centre) @ self._axes.T / self.scale

    @property
    def _axes(self) -> Float64s:
        """The local axes as unit vectors of the picture, rows."""
        cosine, sine = np.cos(self.direction), np.sin(self.direction)
        side = -1.0 if self.mirrored else 1.0
        return np.array([[side * sine, side * cosine], [cosine, -sine]])


class Retargeting:
    """A motion played by a target; frame by frame or, between frames, by angles of one's own."""

    def __init__(self, target: Target, motion: IntermediateMotion, fins: FinMode = "turn") -> None:
        self.target, self.motion = target, motion
        self.rig = Rig(target, fins)
        self.scale = motion.length / target.skeleton.body_length
        self._shift = np.zeros(BONES + 2)
        if fins != "paper":
            self._shift[BONES:] = target.rest_angles[BONES:] - motion.fin_rest

    def angles(self, frame: int) -> Float64s:
        """Return the target's angles at `frame` [rad], (22,)."""
        return self.target_angles(self.motion.angles[frame])

    def target_angles(self, angles: Float64s) -> Float64s:
        """Return the target's angles for angles of the fish [rad], (22,)."""
        return np.asarray(angles + self._shift)

    def motion_angles(self, angles: Float64s) -> Float64s:
        """Return the fish's angles that make the target's `angles` (22,), the inverse of `target_angles`."""
        return np.asarray(angles - self._shift)

    def vertices(self, frame: int) -> Float64s:
        """Return the target's vertices at `frame` in the local frame, (V, 2)."""
        return self.rig.pose(self.angles(frame))

    def placement(self, frame: int) -> Placement:
        """Return where the target is at `frame` (eq. 15, turned round: the picture keeps the fish's size)."""
        return Placement(self.motion.centre[frame], float(self.motion.direction[frame]), self.scale)
