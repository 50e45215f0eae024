"""Makes one motion of all frames' features: what only the whole clip can tell is settled here (Algorithm 2).

The tail's fork and the fish's length are the clip's; frames that differ too much fail; failed frames are bridged, all
are smoothed; then angles and lengths of the bones are measured.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s, Int8s
from tools.video.beats import NONE, Beat, beat_of, tail_swing
from tools.video.contour import evenly
from tools.video.faults import LENGTH, Fault
from tools.video.features import Features
from tools.video.images import Bools
from tools.video.midline import FIRST, LAST, STATIONS, whole_axis
from tools.video.motion import LOWER, UPPER, Motion, angle_of, lengths_of
from tools.video.pectorals import along_axis, courses
from tools.video.smooth import noise_for, smoothed

_FEWEST: Final = 3
_ROOT: Final = (0.25, 0.36)
"""[BL] of a fin's junctions from the head where no frame shows the fin."""
_LAID: Final = 0.12
"""[BL] that a folded fin's tip lies behind its root."""
_DOUBT: Final = 2.0
"""Contrast over T at which a mask is beyond doubt."""


@dataclass(frozen=True)
class Assembled:
    """A motion, and what it was made of."""

    motion: Motion
    fault: Int8s
    "of every frame of the clip, (frames,)"
    raw_axis: Float64s
    "as measured, before smoothing [px shown], nan where nothing was, (frames, 41, 2)"
    beat: Beat
    forked: bool


def raw_axes(features: Sequence[Features], scale: float) -> tuple[Float64s, bool]:
    """Return the axes of all frames [px shown], (n, 41, 2), nan where there is none, and whether the tail is forked."""
    ends = np.full((len(features), 3, 2), np.nan)
    for k, found in enumerate(features):
        if found.ends is not None:
            ends[k] = found.ends
    good = np.array([found.fault == Fault.NONE for found in features])
    seen = ~np.isnan(ends[:, 2, 0])
    forked = bool(good.any() and seen[good].mean() > 0.5)
    tails = _tails(features, ends, seen) if forked else ends[:, 1]
    axes = np.full((len(features), STATIONS, 2), np.nan)
    for k, found in enumerate(features):
        if found.spine is not None:
            axes[k] = whole_axis(ends[k, 0], found.spine, tails[k])
    return axes / scale, forked


def _tails(features: Sequence[Features], ends: Float64s, seen: Bools) -> Float64s:
    """Return the middle between the lobes; where a frame hides one, the tail's end less what they usually differ by."""
    course = np.zeros((len(features), 2))
    for k, found in enumerate(features):
        if found.spine is not None:
            away = found.spine[-1] - found.spine[-5]
            course[k] = away / max(float(np.hypot(*away)), 1e-9)
    less = float(np.median(((ends[seen, 2] - ends[seen, 1]) * course[seen]).sum(axis=1)))
    return np.where(seen[:, None], ends[:, 2], ends[:, 1] + less * course)


def assemble(
    features: Sequence[Features],
    rate: float,
    size: tuple[int, int],
    scale: float,
    provenance: dict[str, str],
) -> Assembled | None:
    """Return the motion of a clip's frames; `size` [px] as shown, `scale` working pixels per pixel shown.

    None where fewer than three frames are good.
    """
    fault = np.array([found.fault for found in features], np.int8)
    axes, forked = raw_axes(features, scale)
    good = fault == Fault.NONE
    if good.sum() < _FEWEST:
        return None
    long = lengths_of(axes)
    usual = float(np.median(long[good]))
    fault[good & (np.abs(long - usual) > LENGTH * usual)] = Fault.LENGTH
    good = fault == Fault.NONE
    if good.sum() < _FEWEST:
        return None
    at = np.flatnonzero(good)
    chosen = slice(int(at[0]), int(at[-1]) + 1)
    beat = beat_of(tail_swing(np.where(good[:, None, None], axes, 0.0)), good)
    measured = _Measured(list(features[chosen]), axes[chosen], good[chosen], scale)
    noise = noise_for(beat.period) if beat != NONE else noise_for(2.0)
    sure = _confidence(features[chosen], good[chosen], long[chosen], usual)
    motion = measured.motion(noise, rate, int(at[0]), size, sure, fault[chosen], provenance)
    return Assembled(motion, fault, axes, beat, forked)


def _confidence(
    features: Sequence[Features], good: Bools, length: Float64s, usual: float
) -> Float64s:
    contrast = np.array([found.contrast for found in features])
    clear = np.clip((contrast - 1.0) / (_DOUBT - 1.0), 0.0, 1.0)
    like = 1.0 - 0.5 * np.abs(length / usual - 1.0) / LENGTH
    return np.where(good, (0.5 + 0.5 * clear) * like, 0.0)


class _Measured:
    """The frames from the first good one to the last, smoothed part by part."""

    def __init__(self, features: list[Features], axes: Float64s, good: Bools, scale: float) -> None:
        self._features, self._axes, self._good, self._scale = features, axes, good, scale

    def motion(
        self,
        noise: float,
        rate: float,
        first: int,
        size: tuple[int, int],
        confidence: Float64s,
        fault: Int8s,
        provenance: dict[str, str],
    ) -> Motion:
        """Return the motion, smoothed with this noise."""
        axis = self._smooth_axis(noise)
        direction = self._direction(noise)
        centre, up, low = _controls(axis, self._part_ahead(axis))
        tips, junctions, folded = self._fins(axis, noise)
        head, tail = axis[:, :1], axis[:, -1:]
        above = np.concatenate((centre[:, None], up, head), axis=1)
        below = np.concatenate((centre[:, None], low, tail), axis=1)
        up_step, low_step = np.diff(above, axis=1), np.diff(below, axis=1)
        up_angle, low_angle = angle_of(up_step, direction), angle_of(low_step, direction)
        up_length, low_length = np.hypot(*up_step.T).T, np.hypot(*low_step.T).T
        fin_step = tips - junctions[:, :2]
        return Motion(
            rate=rate,
            first=first,
            size=size,
            centre=centre,
            direction=direction,
            head_angle=up_angle[:, -1],
            tail_angle=low_angle[:, -1],
            up_angle=up_angle[:, :-1],
            low_angle=low_angle[:, :-1],
            fin_angle=angle_of(fin_step, direction),
            head_length=up_length[:, -1],
            tail_length=low_length[:, -1],
            up_length=up_length[:, :-1],
            low_length=low_length[:, :-1],
            fin_length=np.hypot(fin_step[..., 0], fin_step[..., 1]),
            junction=junctions,
            folded=folded,
            axis=axis.astype(np.float32),
            half_width=self._half_width(noise).astype(np.float32),
            confidence=confidence,
            fault=fault,
            provenance=provenance,
        )

    def _smooth_axis(self, noise: float) -> Float64s:
        rough = smoothed(self._axes, self._good, noise)
        return np.stack([evenly(line, STATIONS) for line in rough])

    def _direction(self, noise: float) -> Float64s:
        ahead = np.array([(0.0, 0.0) if f.ahead is None else f.ahead for f in self._features])
        angle = np.zeros(len(ahead))
        angle[self._good] = np.unwrap(np.arctan2(-ahead[self._good, 1], ahead[self._good, 0]))
        return smoothed(angle, self._good, noise)

    def _part_ahead(self, axis: Float64s) -> float:
        """Return where along the axis the barycentre lies, 0 head to 1 tail: one place for the clip."""
        parts = []
        for k in np.flatnonzero(self._good).tolist():
            centre = self._features[k].centre
            if centre is not None:
                away = axis[k] - centre / self._scale
                parts.append(int(np.argmin((away**2).sum(axis=1))) / (STATIONS - 1))
        return float(np.clip(np.median(parts), 0.2, 0.8))

    def _half_width(self, noise: float) -> Float64s:
        """Return half-widths at all stations, nought at both ends [px shown], (n, 41)."""
        width = np.zeros((len(self._features), STATIONS))
        for k, found in enumerate(self._features):
            if found.half_width is not None:
                width[k, FIRST:LAST] = found.half_width / self._scale
        rising = np.sqrt(np.arange(FIRST) / FIRST)
        width[:, :FIRST] = rising * width[:, FIRST : FIRST + 1]
        width[:, LAST:] = width[:, LAST - 1 : LAST]
        return np.maximum(smoothed(width, self._good, noise), 0.0)

    def _fins(self, axis: Float64s, noise: float) -> tuple[Float64s, Float64s, Bools]:
        """Return tips (n, 2, 2), junctions (n, 4, 2) [px shown] and which fins are folded (n, 2)."""
        found = np.full((len(axis), 6, 2), np.nan)
        for k, features in enumerate(self._features):
            if self._good[k] and features.fins is not None:
                found[k] = features.fins / self._scale
        folded = np.isnan(found[:, :2, 0])
        local = np.full((len(axis), 6, 2), np.nan)
        for k in np.flatnonzero(~folded.all(axis=1)).tolist():
            seen = ~np.isnan(found[k, :, 0])
            local[k, seen] = np.stack(
                along_axis(found[k, seen], axis[k], courses(axis[k])), axis=-1
            )
        whole = np.stack([self._side(found, local, axis, side) for side in (0, 1)], axis=1)
        smooth = smoothed(whole, self._good, noise)
        junctions = smooth[:, (0, 1, 0, 1), (1, 1, 2, 2)]
        return smooth[:, :, 0], junctions, folded

    def _side(self, found: Float64s, local: Float64s, axis: Float64s, side: int) -> Float64s:
        """Return tip, top and bottom junction of a side in all frames, guessed where it is folded, (n, 3, 2)."""
        rows = [side, 2 + side, 4 + side]
        places, seen = found[:, rows].copy(), ~np.isnan(found[:, side, 0])
        sign = 1.0 if side == 0 else -1.0
        if seen.any():
            top, bottom = (float(np.median(local[seen, row, 0])) for row in rows[1:])
        else:
            top, bottom = (part * (STATIONS - 1) for part in _ROOT)
        laid = min(bottom + _LAID * (STATIONS - 1), STATIONS - 1.0)
        for k in np.flatnonzero(~seen).tolist():
            at = np.array([laid, top, bottom])
            places[k] = self._on_edge(k, axis[k], at, sign)
        return places

    def _on_edge(self, k: int, axis: Float64s, at: Float64s, sign: float) -> Float64s:
        """Return places on the body's left (sign 1) or right edge at stations `at` of frame k, (m, 2)."""
        course = courses(axis)
        left = np.stack((-course[:, 1], course[:, 0]), axis=-1)
        found = self._features[k].half_width
        width = np.zeros(STATIONS)
        if found is not None:
            width[FIRST:LAST] = found / self._scale
        edge = axis + sign * width[:, None] * left
        stations = np.arange(STATIONS)
        return np.stack([np.interp(at, stations, edge[:, i]) for i in (0, 1)], axis=-1)


def _controls(axis: Float64s, part: float) -> tuple[Float64s, Float64s, Float64s]:
    """Return centre (n, 2), upper (n, u, 2) and lower points (n, l, 2) of axes (n, 41, 2), the centre at `part`."""
    at = np.concatenate(
        (
            [part],
            part * (1.0 - np.arange(1, UPPER + 1) / (UPPER + 1)),
            part + (1.0 - part) * np.arange(1, LOWER + 1) / (LOWER + 1),
        )
    ) * (STATIONS - 1)
    low = np.floor(at).astype(np.intp)
    share = (at - low)[:, None]
    places = axis[:, low] * (1.0 - share) + axis[:, np.minimum(low + 1, STATIONS - 1)] * share
    return places[:, 0], places[:, 1 : UPPER + 1], places[:, UPPER + 1 :]
