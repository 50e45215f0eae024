"""Singularities: the sources, holes, whirlwinds and currents that stir the water (papers/002, section 2), and their
key frames (papers/002, section 5.2).

The table is state; key frames are constants that a level gives, one track a singularity, listed by where each begins.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from math import floor, isfinite
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.kernels import row
from components.table import Table, column

FREE: Final = -1
"""`attached` of a singularity that stands where it is put, or moves by its key frames."""

SUBMARINE: Final = -2
"""`attached` of a singularity that the submarine carries."""

NOBODY: Final = -3
"""`attached` of a singularity whose species has no fish in the water."""


class SingularityKind(IntEnum):
    """What a singularity does to the water (papers/002, eqs. 2-5)."""

    SOURCE = 0
    HOLE = 1
    WHIRLWIND = 2
    DIRECTIONAL = 3


class SingularityTable(Table):
    """One row a singularity."""

    id: Int64s = column(np.int64, fill=-1)
    "stable id, never used again, (capacity,)"
    kind: Int32s = column(np.int32)
    "`SingularityKind`, (capacity,)"
    position: Float64s = column(np.float64, 3)
    "[m] the centre C, world axes, (capacity, 3)"
    axis: Float64s = column(np.float64, 3)
    "unit vector: a whirlwind's R, a current's v; unused by others, (capacity, 3)"
    intensity: Float64s = column(np.float64)
    "Phi [m^3/s], a current's [m/s]; the sign turns a source into a hole, (capacity,)"
    most: Float64s = column(np.float64, fill=1)
    "Phi_max [m/s], the speed in the centre; unused by currents, (capacity,)"
    reach: Float64s = column(np.float64, fill=np.inf)
    "R [m] beyond which nothing is felt, inf for everywhere; full strength up to .71 R, (capacity,)"
    softening: Float64s = column(np.float64)
    "e [m] within which the direction fades out, so that fibres rest at a hole, (capacity,)"
    wave_number: Float64s = column(np.float64)
    "[turns/m] of a current's waves along its axis, 0 for none, (capacity,)"
    frequency: Float64s = column(np.float64)
    "[turns/s] at which a current's waves travel, 0 for none, (capacity,)"
    amplitude: Float64s = column(np.float64)
    "of a current's waves, as a part of its intensity, (capacity,)"
    phase: Float64s = column(np.float64)
    "[turns] of a current's waves at tick 0 in the origin, (capacity,)"
    attached: Int64s = column(np.int64, fill=FREE)
    "id of the fish that carries it, FREE, SUBMARINE or NOBODY, (capacity,)"
    carrier: Int32s = column(np.int32, fill=-1)
    "row of the species whose fish of the lowest id carries it, -1 for none, (capacity,)"
    offset: Float64s = column(np.float64, 3)
    "[m] from what carries it, in the carrier's body axes, (capacity, 3)"
    carried_axis: Float64s = column(np.float64, 3)
    "unit vector: `axis` in the carrier's body axes, (capacity, 3)"
    drive: Float64s = column(np.float64)
    "[m/s] of a jet at the engine's full throttle, 0 where no engine drives it, (capacity,)"
    there: Int8s = column(np.int8, fill=1)
    "0 while nobody carries it: then it does nothing, (capacity,)"
    track: Int32s = column(np.int32, fill=-1)
    "row of its key frames in `KeyFrames`, -1 for none, (capacity,)"


@dataclass(frozen=True)
class Track:
    """One singularity's key frames as content gives them."""

    seconds: Sequence[float]
    "[s] from the dive's start, rising"
    positions: Sequence[Sequence[float]]
    "[m], one (x, y, z) a frame"
    intensities: Sequence[float]
    "Phi, one a frame"
    smooth: bool = True
    "whether values ease from frame to frame, else straight lines; neither passes a frame's value"
    loop: bool = False
    "whether the last frame is the first of the next round"

    def __post_init__(self) -> None:
        """Raise ValueError where the frames make no track."""
        number = len(self.seconds)
        if number == 0 or len(self.positions) != number or len(self.intensities) != number:
            raise ValueError("a track needs a time, a position and an intensity in each key frame")
        values = (*self.seconds, *self.intensities, *(x for p in self.positions for x in p))
        if not all(map(isfinite, values)):
            raise ValueError("a key frame's time, position and intensity are finite numbers")
        for frame, (before, after) in enumerate(
            zip(self.seconds, self.seconds[1:], strict=False), start=2
        ):
            if after <= before:
                raise ValueError(
                    f"key frame {frame} at {after:g} s must come after {before:g} s, the one before"
                )
        if self.loop and number < 2:
            raise ValueError("a loop needs two key frames or more")


class KeyFrames(NamedTuple):
    """The tracks of a level, as kernels read them. T tracks, M frames in all."""

    first: Int32s
    "where the frames of each track begin, (T + 1,)"
    seconds: Float64s
    "[s], (M,)"
    value: Float64s
    "x, y, z [m] and Phi, (M, 4)"
    slope: Float64s
    "of the values at smooth frames [1/s], (M, 4)"
    smooth: Int8s
    "1 where values ease from frame to frame, (T,)"
    loop: Int8s
    "1 where the last frame is the first of the next round, (T,)"


def pack_tracks(tracks: Sequence[Track]) -> KeyFrames:
    """Return the tracks as kernels read them."""
    first = np.zeros(len(tracks) + 1, np.int32)
    first[1:] = np.cumsum([len(track.seconds) for track in tracks])
    seconds, value, slope = np.zeros(first[-1]), np.zeros((first[-1], 4)), np.zeros((first[-1], 4))
    for index, track in enumerate(tracks):
        here = slice(first[index], first[index + 1])
        seconds[here] = track.seconds
        value[here, :3], value[here, 3] = track.positions, track.intensities
        if track.smooth:
            slope[here] = _slopes(seconds[here], value[here], track.loop)
    flags = np.array([(track.smooth, track.loop) for track in tracks], np.int8).reshape(-1, 2)
    return KeyFrames(first, seconds, value, slope, flags[:, 0].copy(), flags[:, 1].copy())


def _slopes(seconds: Float64s, value: Float64s, loop: bool) -> Float64s:
    """Return slopes [1/s], (n, 4), of the monotone cubic: 0 at each extreme, else the harmonic mean of both sides'.

    So a smooth track never passes beyond a frame's value (Fritsch and Carlson 1980).
    """
    slope = np.zeros_like(value)
    if len(seconds) < 2:
        return slope
    rise = np.diff(value, axis=0) / np.diff(seconds)[:, None]
    before, after = rise[:-1], rise[1:]
    if loop:
        before, after = np.concatenate([rise[-1:], rise]), np.concatenate([rise, rise[:1]])
    product, total = before * after, before + after
    mean = np.where(product > 0.0, 2.0 * product / np.where(product > 0.0, total, 1.0), 0.0)
    if loop:
        return mean
    slope[1:-1] = mean
    return slope


@row
def key_frame(keys: KeyFrames, track: int, seconds: float) -> tuple[float, float, float, float]:
    """Return x, y, z [m] and Phi of a track at a time [s]: held before its first and after its last frame."""
    a, b = keys.first[track], keys.first[track + 1] - 1
    start, end = keys.seconds[a], keys.seconds[b]
    t = seconds
    if keys.loop[track]:
        t -= floor((t - start) / (end - start)) * (end - start)
    t = min(max(t, start), end)
    k = a
    while k < b - 1 and keys.seconds[k + 1] <= t:
        k += 1
    if k == b:
        return keys.value[k, 0], keys.value[k, 1], keys.value[k, 2], keys.value[k, 3]
    h = keys.seconds[k + 1] - keys.seconds[k]
    u = (t - keys.seconds[k]) / h
    return (
        _between(keys, track, k, 0, h, u),
        _between(keys, track, k, 1, h, u),
        _between(keys, track, k, 2, h, u),
        _between(keys, track, k, 3, h, u),
    )


@row
def _between(keys: KeyFrames, track: int, frame: int, part: int, h: float, u: float) -> float:
    """Return a value at the part u of the h [s] from a frame to the next: Hermite's cubic, or a line."""
    p, q = keys.value[frame, part], keys.value[frame + 1, part]
    if not keys.smooth[track]:
        return float(p + u * (q - p))
    m, n = h * keys.slope[frame, part], h * keys.slope[frame + 1, part]
    left = 1.0 - u
    eased = u * u * (3.0 - 2.0 * u)
    return float(p + eased * (q - p) + u * left * (left * m - u * n))


@row
def play_tracks(
    keys: KeyFrames,
    track: Int32s,
    attached: Int64s,
    position: Float64s,
    intensity: Float64s,
    number: int,
    seconds: float,
) -> None:
    """Write intensity, and position where nothing carries it, of those of `number` singularities that have a track.

    Columns as in `SingularityTable`; `seconds` [s] from the dive's start.
    """
    for k in range(number):
        if track[k] >= 0:
            x, y, z, phi = key_frame(keys, track[k], seconds)
            intensity[k] = phi
            if attached[k] == FREE:
                position[k, 0], position[k, 1], position[k, 2] = x, y, z
