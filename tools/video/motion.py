"""The intermediate motion M of papers/003, eq. 14: what a clip's fish did, free of its place in any picture's pixels.

Angles are those of Algorithm 2 in the fish's own frame: seen from above, its head towards +y (pi / 2), its right
towards +x, anticlockwise, and continuous over frames. Places are pixels of the clip as shown, x right and y down.
"""

from dataclasses import dataclass
from math import pi
from typing import Final

import numpy as np

from components.arrays import Float32s, Float64s, Int8s
from tools.video.images import Bools

UPPER: Final = 3
"""u_num: points of the axis between centre and head."""
LOWER: Final = 15
"""l_num: points of the axis between centre and tail."""


@dataclass(frozen=True)
class Motion:
    """A motion of n frames, with u and l points of the axis ahead of its centre and behind."""

    rate: float
    "frames a second"
    first: int
    "the clip's frame that is the motion's first"
    size: tuple[int, int]
    "width and height of the clip as shown [px]"
    centre: Float64s
    "[px], (n, 2)"
    direction: Float64s
    "of the head, anticlockwise from the picture's right [rad], continuous, (n,)"
    head_angle: Float64s
    "of the bone from the last upper point to the head [rad], (n,)"
    tail_angle: Float64s
    "of the bone from the last lower point to the tail [rad], (n,)"
    up_angle: Float64s
    "of the bones from the centre towards the head [rad], (n, u)"
    low_angle: Float64s
    "of the bones from the centre towards the tail [rad], (n, l)"
    fin_angle: Float64s
    "of the left and right pectoral fin, from its top junction to its tip [rad], (n, 2)"
    head_length: Float64s
    "[px], (n,)"
    tail_length: Float64s
    "[px], (n,)"
    up_length: Float64s
    "[px], (n, u)"
    low_length: Float64s
    "[px], (n, l)"
    fin_length: Float64s
    "[px], (n, 2)"
    junction: Float64s
    "top left, top right, bottom left, bottom right [px], (n, 4, 2)"
    folded: Bools
    "whether the left and right fin were laid to the body, their places being guesses, (n, 2)"
    axis: Float32s
    "from head to tail at equal arc lengths [px], (n, 41, 2)"
    half_width: Float32s
    "of the body at these, without fins [px], (n, 41)"
    confidence: Float64s
    "0 where the frame failed and is bridged, up to 1, (n,)"
    fault: Int8s
    "why it failed, a `Fault`, (n,)"
    provenance: dict[str, str]
    "how it was made; no date, no host, no folder"

    @property
    def count(self) -> int:
        """Frames."""
        return len(self.centre)

    @property
    def length(self) -> float:
        """Length of the fish: the median of the good frames' axes [px]."""
        return float(np.median(lengths_of(self.axis.astype(np.float64))[self.good]))

    @property
    def good(self) -> Bools:
        """Which frames show what they say and are not bridged, (n,)."""
        return np.asarray(self.fault == 0)

    def bones(self) -> tuple[Float64s, Float64s]:
        """Return angles and lengths of all bones of the axis: up, head, low, tail; (n, u + l + 2) each."""
        angles = (self.up_angle, self.head_angle[:, None], self.low_angle, self.tail_angle[:, None])
        lengths = (
            self.up_length,
            self.head_length[:, None],
            self.low_length,
            self.tail_length[:, None],
        )
        return np.concatenate(angles, axis=1), np.concatenate(lengths, axis=1)


def lengths_of(axis: Float64s) -> Float64s:
    """Return the arc lengths of lines (n, points, 2), (n,)."""
    return np.asarray(np.sqrt((np.diff(axis, axis=1) ** 2).sum(axis=2)).sum(axis=1))


def angle_of(step: Float64s, direction: Float64s) -> Float64s:
    """Return the angle in the fish's frame of steps in the picture (n, ..., 2), continuous over n [rad], (n, ...).

    `direction` is the head's [rad], (n,). The first angle lies in [0, 2 pi).
    """
    turned = direction.reshape(-1, *([1] * (step.ndim - 2)))
    angle = np.arctan2(-step[..., 1], step[..., 0]) - turned + 0.5 * pi
    angle = np.unwrap(angle, axis=0)
    angle -= 2.0 * pi * np.floor(angle[:1] / (2.0 * pi))
    return np.asarray(angle)


def step_of(angle: Float64s, length: Float64s, direction: Float64s) -> Float64s:
    """Return the steps in the picture (n, ..., 2) of bones of an angle in the fish's frame: `angle_of` undone."""
    turned = direction.reshape(-1, *([1] * (angle.ndim - 1)))
    seen = angle + turned - 0.5 * pi
    return np.stack((length * np.cos(seen), -length * np.sin(seen)), axis=-1)


def rebuilt_axis(motion: Motion) -> Float64s:
    """Return head, upper points, centre, lower points and tail from angles and lengths [px], (n, u + l + 3, 2)."""
    up = step_of(
        np.concatenate((motion.up_angle, motion.head_angle[:, None]), axis=1),
        np.concatenate((motion.up_length, motion.head_length[:, None]), axis=1),
        motion.direction,
    )
    low = step_of(
        np.concatenate((motion.low_angle, motion.tail_angle[:, None]), axis=1),
        np.concatenate((motion.low_length, motion.tail_length[:, None]), axis=1),
        motion.direction,
    )
    centre = motion.centre[:, None]
    ahead = centre + np.cumsum(up, axis=1)
    behind = centre + np.cumsum(low, axis=1)
    return np.concatenate((ahead[:, ::-1], centre, behind), axis=1)


def fin_tips(motion: Motion) -> Float64s:
    """Return the tips of the left and right fin [px], (n, 2, 2)."""
    return motion.junction[:, :2] + step_of(motion.fin_angle, motion.fin_length, motion.direction)
