"""Beats of the tail: how often, and where in the film they are steadiest (FINDINGS 4, Into the water).

The signal is the bend of the rear against the front, which no turn of the whole fish enters. Frequency and steadiness
of each bout are those of the sinusoid that explains most of it (tools/video/beats.py).
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s
from tools.video.beats import beat_of
from tools.video.images import Bools
from tools.video.water.film import Film, FilmError, angles

FEWEST_BEATS: Final = 1.4
"""Beats that a film must show."""

BOUT_BEATS: Final = 4.0
"""Beats over which a bout is looked at ..."""

_HOP: Final = 0.5
"""... and from one bout to the next."""

MOST_BOUTS: Final = 120
"""Bouts of a long film that are looked at, evenly spread."""

FEWEST_FRAMES: Final = 4.5
"""Frames that a beat must last: fewer do not tell one shape from the next."""

LEAST_SWING: Final = 0.02
"""[rad] of bend, as a standard deviation, below which a fish does not swim."""

STEADY: Final = 0.8
"""Part of the bend that one sinusoid must explain in a bout that is used."""


_GUESSES: Final = 6
"""Peaks of the spectrum at which beats are looked for."""


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


def bouts(film: Film) -> list[Bout]:
    """Return overlapping bouts of some beats each, steadiest first. Raise FilmError where the fish does not swim."""
    signal, good = bend(film), film.good
    if not good.any() or float(np.std(signal[good])) < LEAST_SWING:
        raise FilmError("the fish hardly bends: there is no beat of the tail to take")
    for typical in _typical(signal, good.astype(np.float64), film.rate):
        found = _bouts(signal, good, film.rate, typical)
        if found and found[0].steadiness >= STEADY:
            return found
    raise FilmError(
        "no beats of the tail follow one another evenly: nothing can be cut out of this motion"
    )


def _bouts(signal: Float64s, good: Bools, rate: float, typical: float) -> list[Bout]:
    """Return bouts, steadiest first, of a signal with about `typical` beats a second."""
    frames = min(len(signal), round(BOUT_BEATS * rate / typical))
    hop = max(1, round(_HOP * rate / typical), (len(signal) - frames) // MOST_BOUTS)
    found = []
    for first in range(0, len(signal) - frames + 1, hop):
        span = slice(first, first + frames)
        if good[span].mean() < STEADY or float(np.std(signal[span])) < LEAST_SWING:
            continue
        beat = beat_of(signal[span], good[span])
        if beat.beats >= FEWEST_BEATS and beat.period >= FEWEST_FRAMES:
            found.append(Bout(first, first + frames, rate / beat.period, beat.certainty))
    return sorted(found, key=lambda bout: -bout.steadiness)


def _typical(signal: Float64s, good: Float64s, rate: float) -> list[float]:
    """Return about how many beats a second a long signal has: by its spectrum, whatever its phase does.

    The likeliest comes first; a turn bends a fish slowly and further than its beats do, and may hide them.
    """
    frames = min(len(signal), 512)
    power, size = np.zeros(4 * 512 // 2 + 1), 4 * 512
    for first in range(0, len(signal) - frames + 1, max(1, frames // 2)):
        part = signal[first : first + frames] * 1.0
        times = np.linspace(-1.0, 1.0, frames)
        part -= np.polyval(np.polyfit(times, part, 2), times)
        power += (
            np.abs(np.fft.rfft(part * good[first : first + frames] * np.hanning(frames), size)) ** 2
        )
    rates = np.fft.rfftfreq(size, 1.0 / rate)
    fits = (rates >= FEWEST_BEATS * rate / frames) & (rates <= rate / FEWEST_FRAMES)
    if not fits.any():
        raise FilmError(
            f"{len(signal)} frames are too few: {FEWEST_BEATS:g} beats of the tail are needed"
        )
    strength = np.where(fits, power, 0.0)
    peaks = 1 + np.flatnonzero((strength[1:-1] >= strength[:-2]) & (strength[1:-1] > strength[2:]))
    likely = peaks[np.argsort(-strength[peaks])][:_GUESSES].tolist()
    best = int(np.argmax(strength))
    return [float(rates[k]) for k in dict.fromkeys([best, *likely])]
