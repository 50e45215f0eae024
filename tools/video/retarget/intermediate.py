"""The intermediate motion M as retargeting plays it: one row of angles a frame (papers/003, eq. 14)."""

from dataclasses import dataclass, replace

import numpy as np

from components.arrays import Float64s
from tools.video.motion import Motion
from tools.video.retarget.skeleton import BONES, LOW, UP
from tools.video.retarget.target import ModelError


@dataclass(frozen=True)
class IntermediateMotion:
    """M_i of T frames."""

    centre: Float64s
    "[px] of the picture, x right and y down, (T, 2)"
    direction: Float64s
    "of the head, anticlockwise from the picture's right [rad], without jumps, (T,)"
    angles: Float64s
    "of bones and fins in the local frame [rad], columns as skeleton.NAMES, without jumps, (T, 22)"
    length: float
    "init_len of eq. 15: the fish's axis [px]"
    rate: float
    "frames a second"

    @property
    def frames(self) -> int:
        """How many there are."""
        return len(self.direction)

    @property
    def fin_rest(self) -> Float64s:
        """The usual angle [rad] of the left and the right fin, (2,)."""
        return np.asarray(np.median(self.angles[:, BONES:], axis=0))

    def with_angles(self, angles: Float64s) -> "IntermediateMotion":
        """Return the motion with other angles, (T, 22)."""
        return replace(self, angles=angles)

    def at_rate(self, rate: float) -> "IntermediateMotion":
        """Return the motion at another number of frames a second, between frames in a straight line."""
        count = max(1, int((self.frames - 1) * rate / self.rate) + 1)
        when = np.arange(count) * (self.rate / rate)
        before = np.minimum(when.astype(np.intp), max(self.frames - 2, 0))
        after = np.minimum(before + 1, self.frames - 1)
        share = when - before

        def between(values: Float64s) -> Float64s:
            part = share.reshape(-1, *(1,) * (values.ndim - 1))
            return np.asarray(values[before] + part * (values[after] - values[before]))

        return replace(
            self,
            centre=between(self.centre),
            direction=between(self.direction),
            angles=between(self.angles),
            rate=rate,
        )


def intermediate(motion: Motion) -> IntermediateMotion:
    """Return what retargeting needs of a motion. Raise ModelError where its bones are not those of skeleton.py."""
    bones = (motion.up_angle.shape[1], motion.low_angle.shape[1])
    if bones != (UP, LOW):
        raise ModelError(
            f"the motion has {bones[0]} and {bones[1]} points of the axis, {UP} and {LOW} are expected"
        )
    angles, _ = motion.bones()
    return IntermediateMotion(
        centre=motion.centre,
        direction=motion.direction,
        angles=np.concatenate((angles, motion.fin_angle), axis=1),
        length=motion.length,
        rate=motion.rate,
    )
