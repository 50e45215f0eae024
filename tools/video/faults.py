"""What can be wrong with a frame: one that fails is marked with the reason, never silently wrong (FINDINGS 4)."""

from enum import IntEnum
from math import cos, radians
from typing import Final

import numpy as np

from components.arrays import Float64s
from tools.video.images import Grey

INSIDE: Final = 0.95
"""Share of an axis that must lie inside the mask."""
BEND: Final = 40.0
"""[degrees] between neighbouring parts of an axis below which it is smooth."""
LENGTH: Final = 0.15
"""Part of the usual length by which a frame's may differ."""
_END: Final = 0.06


class Fault(IntEnum):
    """Why a frame is not good."""

    NONE = 0
    DAMAGED = 1
    CUT = 2
    NO_FISH = 3
    AT_EDGE = 4
    TOUCHED = 5
    HIDDEN = 6
    ROUND = 7
    OUTSIDE = 8
    BENT = 9
    LENGTH = 10
    ENDS = 11
    REVERSED = 12


REASONS: Final[dict[Fault, str]] = {
    Fault.NONE: "good",
    Fault.DAMAGED: "the frame is damaged",
    Fault.CUT: "the film is cut: another shot",
    Fault.NO_FISH: "no fish is seen",
    Fault.AT_EDGE: "the fish leaves the frame",
    Fault.TOUCHED: "two fishes touch, or something covers the fish",
    Fault.HIDDEN: "part of the fish is hidden",
    Fault.ROUND: "the outline has no direction",
    Fault.OUTSIDE: "the axis leaves the fish",
    Fault.BENT: "the axis is bent sharply",
    Fault.LENGTH: "the fish is not as long as usual",
    Fault.ENDS: "head or tail was not found",
    Fault.REVERSED: "the head is on the wrong side",
}


def fault_of_axis(axis: Float64s, mask: Grey, outline: Float64s, ahead: Float64s) -> Fault:
    """Return what is wrong with an axis (41, 2) in its mask (h, w), whose outline (n, 2) is known; [px]."""
    height, width = mask.shape
    columns = np.clip(axis[:, 0] + 0.5, 0, width - 1).astype(np.intp)
    rows = np.clip(axis[:, 1] + 0.5, 0, height - 1).astype(np.intp)
    if np.count_nonzero(mask[rows, columns]) < INSIDE * len(axis):
        return Fault.OUTSIDE
    steps = np.diff(axis, axis=0)
    length = np.sqrt((steps**2).sum(axis=1))
    turn = (steps[1:] * steps[:-1]).sum(axis=1)
    if (turn < cos(radians(BEND)) * length[1:] * length[:-1]).any():
        return Fault.BENT
    whole = float(length.sum())
    for end in (axis[0], axis[-1]):
        if float(((outline - end) ** 2).sum(axis=1).min()) > (_END * whole) ** 2:
            return Fault.ENDS
    return Fault.NONE if float((axis[0] - axis[len(axis) // 2]) @ ahead) > 0.0 else Fault.REVERSED


def good(fault: Fault) -> bool:
    """Return whether a frame with this fault is good."""
    return fault == Fault.NONE
