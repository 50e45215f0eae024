"""A captured segment of motion, and a species' repertoire of them (papers/000, section 4).

Entry k of a segment holds M_k = R_k^T R_{k+1} (body space: FINDINGS 1 corrects eq. 6), t_k = R_k^T
(o_{k+1} - o_k) in BL (eq. 7) and d_k, the 23 nodes in body axes at frame k + 1 in BL (eq. 8).
Playing entry k: R <- R M_k, o <- o + R_before (length t_k), nodes = o + R (length d_k).

A species that is populous may hold its skin's control points too, s_k in body axes at frame k + 1 (eq. 9).
"""

from dataclasses import dataclass
from enum import IntEnum
from math import fsum
from typing import Final

import numpy as np

from components.arrays import Float32s, Float64s
from components.clock import TICKS_PER_SECOND
from components.kernels import row
from components.trigonometry import arc

CONTROL_POINTS: Final = 2 * 21 * 9
"""Control points of a body's skin: right side, then left, each 21 rows from the nose back, 9 from back to belly."""


class Pattern(IntEnum):
    """The motion patterns of a repertoire (papers/000 section 4.2); right turns mirror left."""

    SWIM_SLOW = 0
    SWIM_MEDIUM = 1
    SWIM_FAST = 2
    TURN_LEFT = 3
    TURN_RIGHT = 4
    TURN_SHARP_LEFT = 5
    TURN_SHARP_RIGHT = 6
    FAST_START_LEFT = 7
    FAST_START_RIGHT = 8


@dataclass(frozen=True)
class Segment:
    """One captured segment of N entries at 60 a second."""

    pattern: Pattern
    loops: bool
    rotation: Float64s
    "M, (N, 3, 3)"
    translation: Float64s
    "t [BL], (N, 3)"
    shape: Float32s
    "d [BL], (N, 23, 3)"
    control: Float32s | None = None
    "s [BL], (N, 378, 3), where control points are recorded"


@dataclass(frozen=True)
class Repertoire:
    """The segments of one species, and what they were captured from."""

    segments: tuple[Segment, ...]
    provenance: dict[str, str]
    "fingerprint of body, parameters and kernels; no date, no host"


MIRROR_IMAGES: Final = (
    (Pattern.TURN_LEFT, Pattern.TURN_RIGHT),
    (Pattern.TURN_SHARP_LEFT, Pattern.TURN_SHARP_RIGHT),
    (Pattern.FAST_START_LEFT, Pattern.FAST_START_RIGHT),
)
"""What is captured, and what is made of it as repertoires are packed."""

REQUIRED: Final = frozenset(
    (Pattern.SWIM_SLOW, Pattern.SWIM_MEDIUM, Pattern.SWIM_FAST, Pattern.TURN_LEFT)
)
"""Without these no species swims; sharp turns and fast starts are played where there are any."""

_MIRRORED_NODE = np.array([0] + [4 * r + 1 + s for r in range(5) for s in (1, 0, 3, 2)] + [21, 22])
_FLIP = np.array([1.0, 1.0, -1.0])


def mirrored(segment: Segment, pattern: Pattern) -> Segment:
    """Return the mirror image of a segment, left for right: z -> -z (FINDINGS 1)."""
    return Segment(
        pattern,
        segment.loops,
        segment.rotation * _FLIP[:, None] * _FLIP[None, :],
        segment.translation * _FLIP,
        (segment.shape[:, _MIRRORED_NODE] * _FLIP).astype(np.float32),
        None if segment.control is None else _mirrored_control(segment.control),
    )


def _mirrored_control(control: Float32s) -> Float32s:
    """Return control points with their sides exchanged."""
    sides = control.reshape(len(control), 2, CONTROL_POINTS // 2, 3)[:, ::-1]
    exchanged: Float32s = (sides * _FLIP).astype(np.float32).reshape(control.shape)
    return exchanged


@row
def turn_left_over(rotation: Float64s, left: Float64s) -> None:
    """Write how far [rad] the anterior axis turns to the left from each entry on to a segment's end.

    `rotation` is the segment's M, (N, 3, 3), `left` (N,); each angle lies within half a turn either way.
    """
    x, y, z = 1.0, 0.0, 0.0
    for k in range(len(rotation) - 1, -1, -1):
        m = rotation[k]
        x, y, z = (
            m[0, 0] * x + m[0, 1] * y + m[0, 2] * z,
            m[1, 0] * x + m[1, 1] * y + m[1, 2] * z,
            m[2, 0] * x + m[2, 1] * y + m[2, 2] * z,
        )
        left[k] = arc(x, -z)


def heading_change(segment: Segment) -> float:
    """Return the angle [rad] by which a segment turns the body's anterior axis to the left."""
    left = np.zeros(len(segment.rotation))
    turn_left_over(segment.rotation, left)
    return float(left[0])


def mean_speed(segment: Segment) -> float:
    """Return the mean speed along the body's axis [BL/s]."""
    return fsum(segment.translation[:, 0].tolist()) * TICKS_PER_SECOND / len(segment.translation)
