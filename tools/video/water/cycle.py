"""One clean cycle out of some filmed beats: closed, level, straight, and free of noise (FINDINGS 1 and 4).

All beats of a bout are fitted at once by a drift and four harmonics, so the cycle closes by itself: the drift is the
gap that is removed, the mean is what levels it. Speed is that of the travel; a fish that holds station in a current is
taken to go as far in a beat as its tail sweeps, over a Strouhal number of .3.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s
from tools.video.water.beats import Bout
from tools.video.water.film import STATIONS, Film, angles, places, weights

HARMONICS: Final = 4
_OF_TRAVEL: Final = 2
"""Harmonics of the whole body's surge and sway, which is less than a beat's noise beyond them."""

STATION_STRIDE: Final = 0.2
"""[BL] in a beat below which a fish is taken to hold station."""

STROUHAL: Final = 0.3
"""Sweep over stride that is assumed of a fish that holds station: what steady swimmers keep to."""

SLIP: Final = 0.36
"""Way aside over way ahead from which a current carries a fish, 20 degrees: it cannot swim so."""

_FRAMES_A_HARMONIC: Final = 2.5
_FINE: Final = 240


@dataclass(frozen=True)
class Cycle:
    """A beat, straight ahead, as harmonics of its phase."""

    frequency: float
    "beats a second"
    stride: float
    "[BL] a beat"
    assumed: bool
    "whether `stride` was assumed, for the fish held station, or was carried aside"
    bends: Float64s
    "cosine and sine of each harmonic of where the parts of the axis point, to the left [rad], (40, 4, 2)"
    surge: Float64s
    "the same of the body's middle, ahead [BL], (2, 2)"
    sway: Float64s
    "and to its left [BL], (2, 2)"
    weight: Float64s
    "each part's share of the mass, (40,)"
    residual: float
    "part of the film's motion that is none of this, 0 to 1"

    @property
    def speed(self) -> float:
        """Speed [BL/s]."""
        return self.stride * self.frequency

    def lines(self, phase: Float64s) -> Float64s:
        """Return the axis at phases (n,) [turns], from 0 on, nose to tail: x ahead, y left [BL], (n, 41, 2)."""
        pointing = _wave(self.bends, phase)
        steps = np.stack((np.cos(pointing), np.sin(pointing)), axis=-1) / (STATIONS - 1)
        line = np.zeros((len(phase), STATIONS, 2))
        line[:, 1:] = -np.cumsum(steps, axis=1)
        middle = np.einsum("j,njc->nc", self.weight, 0.5 * (line[:, 1:] + line[:, :-1]))
        at = np.stack(
            (self.stride * phase + _wave(self.surge, phase), _wave(self.sway, phase)), axis=-1
        )
        placed: Float64s = line + (at - middle)[:, None, :]
        return placed

    def sweep(self) -> float:
        """Return how far the tail's tip goes from side to side [BL]."""
        tail = self.lines(np.arange(_FINE) / _FINE)[:, -1, 1]
        return float(tail.max() - tail.min())

    def head_sweep(self) -> float:
        """Return how far the nose goes from side to side [BL]."""
        nose = self.lines(np.arange(_FINE) / _FINE)[:, 0, 1]
        return float(nose.max() - nose.min())

    def wavelength(self) -> float:
        """Return the length of the wave of bending over the rear half [BL], below 0 where it runs forwards."""
        half = self.bends[STATIONS // 2 :, 0]
        lag = np.unwrap(np.arctan2(half[:, 1], half[:, 0]))
        steps = np.arange(len(lag)) / (STATIONS - 1)
        strength = np.sqrt((half**2).sum(axis=1))
        slope = float(np.polyfit(steps, lag, 1, w=strength)[0])
        return 2.0 * np.pi / slope if slope else float("inf")


def _wave(terms: Float64s, phase: Float64s) -> Float64s:
    """Return sums of harmonics, `terms` (..., k, 2), at phases (n,) [turns], (n, ...)."""
    turns = 2.0 * np.pi * phase[:, None] * np.arange(1, terms.shape[-2] + 1)
    basis = np.stack((np.cos(turns), np.sin(turns)), axis=-1)
    found: Float64s = np.tensordot(basis, terms, axes=((1, 2), (-2, -1)))
    return found


def cycle(film: Film, bout: Bout) -> Cycle:
    """Return the cycle of a bout's beats."""
    span = slice(bout.first, bout.stop)
    good = film.good[span].astype(np.float64)
    count = bout.stop - bout.first
    times = (np.arange(count, dtype=np.float64) - 0.5 * count) / film.rate
    pointing = -angles(film)[span]
    most = min(HARMONICS, int(film.rate / (_FRAMES_A_HARMONIC * bout.frequency)))
    bends, drift, residual = _fitted(pointing, times, good, bout.frequency, max(most, 1))
    share = weights(film)
    heading = share @ drift
    stride, aside, surge, sway = _travel(
        places(film)[span] * (1.0, -1.0), heading, times, good, bout.frequency, film.rate
    )
    made = Cycle(bout.frequency, stride, False, bends, surge, sway, share, residual)
    if stride >= STATION_STRIDE and abs(aside) < SLIP * stride:
        return made
    return Cycle(bout.frequency, made.sweep() / STROUHAL, True, bends, surge, sway, share, residual)


def _fitted(
    signals: Float64s, times: Float64s, good: Float64s, frequency: float, count: int
) -> tuple[Float64s, Float64s, float]:
    """Return the harmonics of signals (F, n), (n, 4, 2); their drift, (n, F); the part of the variance left over.

    Harmonics beyond `count` are nought.
    """
    turns = 2.0 * np.pi * frequency * times[:, None] * np.arange(1, count + 1)
    drift = np.stack((np.ones_like(times), times), axis=-1)
    basis = np.concatenate((drift, np.cos(turns), np.sin(turns)), axis=1)
    terms = np.linalg.lstsq(basis * good[:, None], signals * good[:, None], rcond=None)[0]
    rest = ((signals - basis @ terms) * good[:, None]).var()
    whole = ((signals - drift @ terms[:2]) * good[:, None]).var()
    found = np.zeros((signals.shape[1], HARMONICS, 2))
    found[:, :count, 0], found[:, :count, 1] = terms[2 : 2 + count].T, terms[2 + count :].T
    return found, (drift @ terms[:2]).T, float(rest / max(whole, 1e-300))


def _travel(
    at: Float64s, heading: Float64s, times: Float64s, good: Float64s, frequency: float, rate: float
) -> tuple[float, float, Float64s, Float64s]:
    """Return the stride ahead and aside [BL] and the harmonics of surge and sway, of places (F, 2) [BL], y to the left.

    They are seen along the slowly drifting `heading` (F,) [rad]: steps are turned into it, and their harmonics summed
    up again.
    """
    middle = 0.5 * (heading[1:] + heading[:-1])
    steps = np.diff(at, axis=0) * rate
    ahead = steps[:, 0] * np.cos(middle) + steps[:, 1] * np.sin(middle)
    aside = steps[:, 1] * np.cos(middle) - steps[:, 0] * np.sin(middle)
    both = np.stack((ahead, aside), axis=-1)
    sound = good[1:] * good[:-1]
    terms, drift, _ = _fitted(both, 0.5 * (times[1:] + times[:-1]), sound, frequency, _OF_TRAVEL)
    # The integral of a cos + b sin of k w t is (a sin - b cos) / (k w).
    rates = 2.0 * np.pi * frequency * np.arange(1, _OF_TRAVEL + 1)
    summed = (
        np.stack((-terms[:, :_OF_TRAVEL, 1], terms[:, :_OF_TRAVEL, 0]), axis=-1) / rates[:, None]
    )
    ahead_mean, aside_mean = (drift.mean(axis=1) / frequency).tolist()
    return ahead_mean, aside_mean, summed[0], summed[1]
