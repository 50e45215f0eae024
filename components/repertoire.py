"""Action repertoires as the game uses them: read, saved, and packed for kernels (papers/000, section 4).

Segments stand in components/segment.py, the file's format in components/repertoire_file.py.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from components.arrays import Float32s, Float64s, Int8s, Int32s
from components.body import NODES
from components.repertoire_file import RepertoireError, load, save
from components.segment import (
    MIRROR_IMAGES,
    Pattern,
    Repertoire,
    Segment,
    heading_change,
    mean_speed,
    mirrored,
    turn_left_over,
)

__all__ = [
    "Pattern",
    "Repertoire",
    "RepertoireError",
    "RepertoireLibrary",
    "Segment",
    "heading_change",
    "load",
    "mean_speed",
    "mirrored",
    "pack",
    "save",
    "turn_left_over",
]

_Array = TypeVar("_Array", Float32s, Float64s)


@dataclass(frozen=True)
class RepertoireLibrary:
    """All species' segments end to end, as kernels and the GPU read them. E entries, S segments.

    The last `spare` entries belong to no segment: what fishes in live physics show, written as they move.
    """

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
    "segment of (species, Pattern), -1 where there is none, (species, 9)"
    speed: Float64s
    "mean speed of a segment [BL/s], (S,)"
    turn: Float64s
    "net change of heading of a segment [rad], positive to the left, (S,)"
    spare: int = 0
    "entries at the end that belong to no segment"

    @property
    def after(self) -> Int32s:
        """The entry that follows each: in a cycle the first follows the last, a turn's last and spare ones themselves,
        (E,)."""
        follows = np.arange(1, len(self.shape) + 1, dtype=np.int32)
        ends = self.start + self.length - 1
        follows[ends] = np.where(self.loops == 1, self.start, ends)
        follows[len(follows) - self.spare :] -= 1
        return follows


def pack(repertoires: Sequence[Repertoire], spare: int = 0) -> RepertoireLibrary:
    """Return all segments end to end, species by species in `Pattern`'s order, with right turns mirrored.

    After them come `spare` entries of noughts.
    """
    table = np.full((len(repertoires), len(Pattern)), -1, np.int32)
    segments: list[Segment] = []
    for species, repertoire in enumerate(repertoires):
        for pattern, segment in sorted(_with_mirrored(repertoire).items()):
            table[species, pattern] = len(segments)
            segments.append(segment)
    lengths = np.array([len(s.translation) for s in segments], np.int32)
    return RepertoireLibrary(
        rotation=_joined([s.rotation for s in segments], np.zeros((spare, 3, 3))),
        translation=_joined([s.translation for s in segments], np.zeros((spare, 3))),
        shape=_joined([s.shape for s in segments], np.zeros((spare, NODES, 3), np.float32)),
        start=(np.cumsum(lengths) - lengths).astype(np.int32),
        length=lengths,
        loops=np.array([s.loops for s in segments], np.int8),
        pattern=np.array([s.pattern for s in segments], np.int8),
        segment=table,
        speed=np.array([mean_speed(s) for s in segments], np.float64),
        turn=np.array([heading_change(s) for s in segments], np.float64),
        spare=spare,
    )


def _with_mirrored(repertoire: Repertoire) -> dict[Pattern, Segment]:
    """Return a repertoire's segments and the turns that its own ones mirror."""
    held = {segment.pattern: segment for segment in repertoire.segments}
    for one, other in MIRROR_IMAGES:
        if one in held and other not in held:
            held[other] = mirrored(held[one], other)
    return held


def _joined(parts: list[_Array], end: _Array) -> _Array:
    """Return arrays end to end, C order, `end` after them."""
    return np.ascontiguousarray(np.concatenate([*parts, end]))
