"""The tail's beat: how often, by a sinusoid fitted to the whole clip (FINDINGS 4: a single cycle errs by 1 %)."""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s
from tools.video.images import Bools

_FEWEST: Final = 6
LEAST_AMPLITUDE: Final = 0.006
"""[lengths] of a tail's swing, below which it is noise."""
LEAST_CERTAINTY: Final = 0.3
_LONGEST: Final = 1.25
"""Longest period over the clip's length."""


class Beat(NamedTuple):
    """The tail beat of a clip."""

    period: float
    "[frames], nan where the tail does not beat"
    amplitude: float
    "half of what the tail sweeps, in the unit of what was given"
    beats: float
    "how many the clip holds"
    certainty: float
    "part of the tail's sideways motion that the sinusoid explains, 0 to 1"


NONE: Final = Beat(float("nan"), 0.0, 0.0, 0.0)


def tail_swing(axis: Float64s) -> Float64s:
    """Return how far the tail tip lies aside of the line of the fore body, in lengths, (n,); axis (n, 41, 2)."""
    course = axis[:, 0] - axis[:, axis.shape[1] // 2]
    course = course / np.maximum(np.hypot(course[:, 0], course[:, 1]), 1e-9)[:, None]
    away = axis[:, -1] - axis[:, 0]
    length = np.sqrt((np.diff(axis, axis=1) ** 2).sum(axis=2)).sum(axis=1)
    swing: Float64s = (course[:, 0] * away[:, 1] - course[:, 1] * away[:, 0]) / np.maximum(
        length, 1e-9
    )
    return swing


def beat_of(swing: Float64s, seen: Bools) -> Beat:
    """Return the beat of a sideways motion (n,), by the frames that are `seen` (n,)."""
    at = np.flatnonzero(seen).astype(np.float64)
    if len(at) < _FEWEST:
        return NONE
    value = swing[seen]
    span = float(at[-1] - at[0] + 1.0)
    periods = np.geomspace(2.5, max(_LONGEST * span, 5.0), 400)
    # A period is told apart from its neighbours by the phase that it gains over the clip: so fine must the search be.
    rates = np.arange(1.0 / periods[-1], 1.0 / periods[0], 0.1 / span)
    left = np.array([_unexplained(at, value, rate) for rate in rates])
    rate = float(rates[int(np.argmin(left))])
    fine = rate + np.linspace(-0.12, 0.12, 61) / span
    fine = fine[fine > 0.0]
    left = np.array([_unexplained(at, value, r) for r in fine])
    best = int(np.argmin(left))
    rate = _between(fine, left, best)
    whole = float(((value - value.mean()) ** 2).sum())
    if whole <= 0.0:
        return NONE
    amplitude = _amplitude(at, value, rate)
    certainty = 1.0 - float(left[best]) / whole
    if amplitude < LEAST_AMPLITUDE or certainty < LEAST_CERTAINTY:
        return NONE
    return Beat(1.0 / rate, amplitude, span * rate, certainty)


def _columns(at: Float64s, rate: float) -> Float64s:
    phase = 2.0 * np.pi * rate * at
    ramp = (at - at.mean()) / max(len(at), 1)
    return np.stack((np.cos(phase), np.sin(phase), np.ones_like(at), ramp), axis=-1)


def _unexplained(at: Float64s, value: Float64s, rate: float) -> float:
    """Return the sum of squares that a sinusoid of this rate [1/frame], an offset and a drift leave."""
    columns = _columns(at, rate)
    found = np.linalg.lstsq(columns, value, rcond=None)[0]
    return float(((value - columns @ found) ** 2).sum())


def _amplitude(at: Float64s, value: Float64s, rate: float) -> float:
    found = np.linalg.lstsq(_columns(at, rate), value, rcond=None)[0]
    return float(np.hypot(found[0], found[1]))


def _between(rates: Float64s, left: Float64s, best: int) -> float:
    """Return the rate at the bottom of the parabola through the best and its neighbours."""
    if not 0 < best < len(rates) - 1:
        return float(rates[best])
    before, at, after = (float(v) for v in left[best - 1 : best + 2])
    bow = before - 2.0 * at + after
    step = float(rates[1] - rates[0])
    return float(rates[best]) + (0.5 * step * (before - after) / bow if bow > 0.0 else 0.0)
