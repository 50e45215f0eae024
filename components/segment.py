"""A captured segment of motion, and a species' repertoire of them (papers/000, section 4).

Entry k of a segment holds M_k = R_k^T R_{k+1} (body space: FINDINGS 1 corrects eq. 6), t_k = R_k^T
(o_{k+1} - o_k) in BL (eq. 7) and d_k, the 23 nodes in body axes at frame k + 1 in BL (eq. 8).
Playing entry k: R <- R M_k, o <- o + R_before (length t_k), nodes = o + R (length d_k).
"""

from dataclasses import dataclass
from enum import IntEnum
from math import fsum, sqrt
from typing import Final

import numpy as np

from components.arrays import Float32s, Float64s
from components.clock import TICKS_PER_SECOND
from components.trigonometry import cosine, sine


class Pattern(IntEnum):
    """The motion patterns of a repertoire (papers/000 section 4.2); right turns mirror left."""

    SWIM_SLOW = 0
    SWIM_MEDIUM = 1
    SWIM_FAST = 2
    TURN_LEFT = 3
    TURN_RIGHT = 4


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


@dataclass(frozen=True)
class Repertoire:
    """The segments of one species, and what they were captured from."""

    segments: tuple[Segment, ...]
    provenance: dict[str, str]
    "fingerprint of body, parameters and kernels; no date, no host"


MIRROR_IMAGES: Final = ((Pattern.TURN_LEFT, Pattern.TURN_RIGHT),)
"""What is captured, and what is made of it as repertoires are packed."""

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
    )


def heading_change(segment: Segment) -> float:
    """Return the angle [rad] by which a segment turns the body's anterior axis to the left."""
    x, y, z = 1.0, 0.0, 0.0
    for m in segment.rotation[::-1].tolist():
        x, y, z = (row[0] * x + row[1] * y + row[2] * z for row in m)
    angle = 0.0
    for _ in range(12):  # sin(target - angle) brings it three times as many digits each time
        angle += (-z * cosine(angle) - x * sine(angle)) / sqrt(x * x + z * z)
    return angle


def mean_speed(segment: Segment) -> float:
    """Return the mean speed along the body's axis [BL/s]."""
    return fsum(segment.translation[:, 0].tolist()) * TICKS_PER_SECOND / len(segment.translation)
