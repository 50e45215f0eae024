"""Beats of the tail: how often, and where in the film they are steadiest (FINDINGS 4, Into the water).

The signal is the bend of the rear against the front, which no turn of the whole fish enters. Its frequency is that of
the sinusoid which, beside a slow drift, leaves least of it.
"""

from typing import Final, NamedTuple

import numpy as np
from scipy.optimize import minimize_scalar

from components.arrays import Float64s
from tools.video.water.film import Film, FilmError, angles

FEWEST_BEATS: Final = 1.4
"""Beats that a film must show."""

BOUT_BEATS: Final = 4.0
"""Beats over which a bout is looked at ..."""

_HOP: Final = 0.5
"""... and from one bout to the next."""

_FEWEST_FRAMES: Final = 4.5
"""Frames that a beat must last: fewer do not tell one shape from the next."""

LEAST_SWING: Final = 0.02
"""[rad] of bend, as a standard deviation, below which a fish does not swim."""

STEADY: Final = 0.8
"""Part of the bend that one sinusoid must explain in a bout that is used."""


class Bout(NamedTuple):
    """Some beats that follow one another."""

    first: int
    "frame"
    stop: int
    "the frame after its last"
    frequency: float
    "beats a second"
    steadiness: float
    "part of the bend's variance that one sinusoid explains, 0 to 1"


def bend(film: Film) -> Float64s:
    """Return the angle [rad] of the rear against the front in each frame, (F,)."""
    found = angles(film)
    rear: Float64s = found[:, 28:].mean(axis=1) - found[:, 4:18].mean(axis=1)
    return rear


def frequency_of(signal: Float64s, good: Float64s, rate: float, near: float | None = None) -> tuple[float, float]:
    """Return the beats a second of a signal (F,), and the part of its variance that they explain.

    `good` (F,) weighs frames. With `near`, only frequencies within .4 to 2.2 times it are looked at. Raise FilmError
    where the signal is too short.
    """
    seconds = len(signal) / rate
    lowest, highest = FEWEST_BEATS / seconds, rate / _FEWEST_FRAMES
    if near is not None:
        lowest, highest = max(lowest, 0.4 * near), min(highest, 2.2 * near)
    if not lowest < highest:
        raise FilmError(
            f"{len(signal)} frames are too few: {FEWEST_BEATS:g} beats of the tail are needed"
        )
    times = np.arange(len(signal)) / rate - 0.5 * seconds
    grid = np.arange(lowest, highest, 0.1 / seconds)
    left = [_left(f, times, signal, good) for f in grid]
    at = int(np.argmin(left))
    step = 0.1 / seconds
    found = minimize_scalar(
        lambda f: _left(f, times, signal, good),
        bounds=(max(lowest, grid[at] - step), min(highest, grid[at] + step)),
        method="bounded",
        options={"xatol": 1e-6 * grid[at]},
    )
    return float(found.x), 1.0 - min(float(found.fun), left[at])


def _left(frequency: float, times: Float64s, signal: Float64s, good: Float64s) -> float:
    """Return the part of a signal's variance about its drift that a sinusoid of `frequency` leaves."""
    drift = np.stack((np.ones_like(times), times, times * times), axis=-1) * good[:, None]
    wave = 2.0 * np.pi * frequency * times
    both = np.stack((np.cos(wave), np.sin(wave)), axis=-1) * good[:, None]
    weighed = signal * good
    away = weighed - drift @ np.linalg.lstsq(drift, weighed, rcond=None)[0]
    full = np.concatenate((drift, both), axis=1)
    rest = weighed - full @ np.linalg.lstsq(full, weighed, rcond=None)[0]
    return float((rest**2).sum() / max(float((away**2).sum()), 1e-300))


def bouts(film: Film) -> list[Bout]:
    """Return overlapping bouts of some beats each, steadiest first. Raise FilmError where the fish does not swim."""
    signal, good = bend(film), film.good.astype(np.float64)
    if not film.good.any() or float(np.std(signal[film.good])) < LEAST_SWING:
        raise FilmError("the fish hardly bends: there is no beat of the tail to take")
    typical = _typical(signal, good, film.rate)
    frames = min(len(signal), round(BOUT_BEATS * film.rate / typical))
    hop = max(1, round(_HOP * film.rate / typical))
    found = []
    for first in range(0, len(signal) - frames + 1, hop):
        span = slice(first, first + frames)
        if good[span].mean() < STEADY or float(np.std(signal[span])) < LEAST_SWING:
            continue
        own, steady = frequency_of(signal[span], good[span], film.rate, typical)
        found.append(Bout(first, first + frames, own, steady))
    found.sort(key=lambda bout: -bout.steadiness)
    if not found or found[0].steadiness < STEADY:
        raise FilmError("no beats of the tail follow one another evenly: nothing can be cut out of this motion")
    return found


def _typical(signal: Float64s, good: Float64s, rate: float) -> float:
    """Return about how many beats a second a long signal has: by its spectrum, whatever its phase does."""
    frames = min(len(signal), 512)
    power, size = np.zeros(4 * 512 // 2 + 1), 4 * 512
    for first in range(0, len(signal) - frames + 1, max(1, frames // 2)):
        part = signal[first : first + frames] * 1.0
        times = np.linspace(-1.0, 1.0, frames)
        part -= np.polyval(np.polyfit(times, part, 2), times)
        power += np.abs(np.fft.rfft(part * good[first : first + frames] * np.hanning(frames), size)) ** 2
    rates = np.fft.rfftfreq(size, 1.0 / rate)
    fits = (rates >= FEWEST_BEATS * rate / frames) & (rates <= rate / _FEWEST_FRAMES)
    if not fits.any():
        raise FilmError(f"{len(signal)} frames are too few: {FEWEST_BEATS:g} beats of the tail are needed")
    return float(rates[fits][np.argmax(power[fits])])
