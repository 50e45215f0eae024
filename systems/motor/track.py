"""Track: the library as the motor system's kernels read it, and where to enter its segments.

Shapes lie in planes so that vector units run along them; the entry of each segment that looks most
like every other entry is found once, so that a change of segment need not search (papers/000,
section 5.2).
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float32s, Float64s, Int8s, Int32s
from components.body import NODES
from components.kernels import row
from components.repertoire import Pattern, RepertoireLibrary

PLANE: Final = NODES + 1
"""Numbers in a plane of a shape: the nodes and a nought, a multiple of what vector units hold."""

_ARC: Final = (
    6435 / 557056,
    143 / 10240,
    231 / 13312,
    63 / 2816,
    35 / 1152,
    5 / 112,
    3 / 40,
    1 / 6,
    1.0,
)
"""Terms of arcsin(x) / x in x^2, the last first."""


class Track(NamedTuple):
    """The library as move reads it. E entries, S segments."""

    rotation: Float64s
    "M, (E, 3, 3)"
    translation: Float64s
    "t [BL], (E, 3)"
    shape: Float32s
    "d [BL] by planes x, y, z, padded with noughts: kernels run along them, (E, 3, 24)"
    start: Int32s
    "(S,)"
    length: Int32s
    "(S,)"
    loops: Int8s
    "(S,)"
    pattern: Int8s
    "(S,)"
    segment: Int32s
    "(species, 9)"
    speed: Float64s
    "[BL/s], (S,)"
    after: Int32s
    "the entry that follows each, (E,)"
    turn: Float64s
    "rotation vector of M [rad], body axes, (E, 3)"
    match: Int32s
    "the frame of each pattern's segment whose shape is nearest to an entry's, 0 in turns, (E, 9)"
    literal: bool = False
    "whether changes of segment are warped as appendix A is printed"


def planes(shape: Float32s) -> Float32s:
    """Return shapes (E, 23, 3) as planes (E, 3, 24), which vector units can read."""
    padded = np.zeros((len(shape), 3, PLANE), np.float32)
    padded[:, :, :NODES] = shape.transpose(0, 2, 1)
    return padded


def rotation_vectors(rotation: Float64s) -> Float64s:
    """Return the rotation vectors [rad] of rotations (E, 3, 3), (E, 3): to 1e-9 below .2 rad, where swims lie, to 1e-6
    below .6, where fast starts do. The arc's series."""
    a = 0.5 * (rotation - rotation.transpose(0, 2, 1))
    sine = np.stack((a[:, 2, 1], a[:, 0, 2], a[:, 1, 0]), axis=1)
    s = (sine[:, 0] * sine[:, 0] + sine[:, 1] * sine[:, 1]) + sine[:, 2] * sine[:, 2]
    series = np.zeros_like(s)
    for term in _ARC:
        series = series * s + term
    return np.ascontiguousarray(sine * series[:, None])


def track(library: RepertoireLibrary, literal: bool = False) -> Track:
    """Return the library as kernels read it, with the places to enter its segments."""
    shape = planes(library.shape)
    match = np.zeros((len(shape), len(Pattern)), np.int32)
    _fill_match(shape, library.start, library.length, library.loops, library.segment, match)
    return Track(
        np.ascontiguousarray(library.rotation),
        np.ascontiguousarray(library.translation),
        shape,
        library.start,
        library.length,
        library.loops,
        library.pattern,
        library.segment,
        library.speed,
        library.after,
        rotation_vectors(library.rotation),
        match,
        literal,
    )


@row
def apart(a: Float32s, b: Float32s, sum_all: bool) -> float:
    """Return the sum over nodes of the squared distance [BL^2] of two shapes, or its maximum."""
    total = most = 0.0
    for n in range(NODES):
        x = np.float64(a[0, n]) - np.float64(b[0, n])
        y = np.float64(a[1, n]) - np.float64(b[1, n])
        z = np.float64(a[2, n]) - np.float64(b[2, n])
        square = x * x + y * y + z * z
        total += square
        most = max(most, square)
    return total if sum_all else most


@row
def _nearest(shape: Float32s, entry: int, first: int, length: int) -> int:
    """Return the frame, of `length` from entry `first`, whose shape is nearest to `entry`'s."""
    best, least = 0, np.inf
    for frame in range(length):
        total = apart(shape[entry], shape[first + frame], True)
        if total < least:
            best, least = frame, total
    return best


@row
def _fill_match(
    shape: Float32s,
    start: Int32s,
    length: Int32s,
    loops: Int8s,
    segment: Int32s,
    match: Int32s,
) -> None:
    for species in range(segment.shape[0]):
        for pattern in range(segment.shape[1]):
            into = segment[species, pattern]
            if into < 0 or loops[into] == 0:
                continue
            for other in range(segment.shape[1]):
                leaving = segment[species, other]
                if leaving >= 0:
                    for entry in range(start[leaving], start[leaving] + length[leaving]):
                        match[entry, pattern] = _nearest(shape, entry, start[into], length[into])
