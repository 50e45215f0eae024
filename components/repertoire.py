"""Action repertoires: captured segments, their file, and the library packed for kernels (papers/000
section 4).

Entry k of a segment holds M_k = R_k^T R_{k+1} (body space: FINDINGS 1 corrects eq. 6), t_k = R_k^T
(o_{k+1} - o_k) in BL (eq. 7) and d_k, the 23 nodes in body axes at frame k + 1 in BL (eq. 8).
Playing entry k: R <- R M_k, o <- o + R_before (length t_k), nodes = o + R (length d_k).
"""

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from components.arrays import Float32s, Float64s, Int8s, Int32s


class Pattern(IntEnum):
    """The motion patterns of a repertoire (papers/000 section 4.2); right turns are mirrored left turns."""

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


@dataclass(frozen=True)
class RepertoireLibrary:
    """All species' segments end to end, as kernels and the GPU read them. E entries, S segments."""

    rotation: Float64s
    "M, (E, 3, 3)"
    translation: Float64s
    "t [BL], (E, 3)"
    shape: Float32s
    "d [BL], (E, 23, 3)"
    start: Int32s
    "first entry of a segment, (S,)"
    length: Int32s
    "entries of a segment, (S,)"
    loops: Int8s
    "1 where a segment is a cycle, (S,)"
    pattern: Int8s
    "the segment's `Pattern`, (S,)"
    segment: Int32s
    "segment of (species, Pattern), -1 where there is none, (species, 5)"
    speed: Float64s
    "mean speed of a segment [BL/s], (S,)"
    turn: Float64s
    "net change of heading of a segment [rad], positive to the left, (S,)"
    node_reach: Float32s
    "most a node moves from one entry to another, for warping [BL]: see systems/motor/move.py, (E,)"


_MIRRORED_NODE = np.array([0] + [4 * r + 1 + s for r in range(5) for s in (1, 0, 3, 2)] + [21, 22])
_FLIP = np.array([1.0, 1.0, -1.0])


def mirrored(segment: Segment, pattern: Pattern) -> Segment:
    """Return the mirror image of a segment, left for right: z -> -z, top-left <-> top-right (FINDINGS 1)."""
    return Segment(
        pattern,
        segment.loops,
        segment.rotation * _FLIP[:, None] * _FLIP[None, :],
        segment.translation * _FLIP,
        (segment.shape[:, _MIRRORED_NODE] * _FLIP).astype(np.float32),
    )
