"""Kalman smoothing of places over frames, bridges over frames that failed, and in-betweens (papers/003, section 5.3).

A place moves at a velocity that changes by chance; the filter runs forwards, the smoother (Rauch, Tung and Striebel)
backwards. What was not seen is bridged, and frames between two frames are frames that were not seen. `noise` is the
measurement's variance over the acceleration's, [frames^3]; a motion of angular frequency w a frame keeps
1 / (1 + noise w^4) of its amplitude.
"""

from typing import Final

import numpy as np

from components.arrays import Float64s
from tools.video.images import Bools

KEPT: Final = 0.998
"""Part of the tail beat's amplitude that smoothing leaves."""
LEAST_NOISE, MOST_NOISE = 0.001, 30.0
IN_BETWEENS: Final = 5
_VAGUE: Final = 1e8


def noise_for(period: float) -> float:
    """Return the noise that leaves KEPT of a beat's amplitude whose period is so many frames."""
    w = 2.0 * np.pi / max(period, 2.0)
    return float(np.clip((1.0 / KEPT - 1.0) / w**4, LEAST_NOISE, MOST_NOISE))


def smoothed(values: Float64s, seen: Bools, noise: float, step: float = 1.0) -> Float64s:
    """Return values (n, ...) smoothed over the first axis; those not `seen` (n,) are bridged.

    `step` is the time from one to the next [frames]. Raise ValueError where nothing is seen.
    """
    if not seen.any():
        raise ValueError("nothing is seen in any frame")
    flat = values.reshape(len(values), -1)
    states, spreads, ahead = _filtered(np.where(seen[:, None], flat, 0.0), seen, noise, step)
    return _backwards(states, spreads, ahead, step)[:, 0].reshape(values.shape)


def in_between(values: Float64s, noise: float, count: int = IN_BETWEENS) -> Float64s:
    """Return values (n, ...) with `count` more between each two, ((n - 1) (count + 1) + 1, ...)."""
    spread = np.zeros(((len(values) - 1) * (count + 1) + 1, *values.shape[1:]))
    seen = np.zeros(len(spread), np.bool_)
    spread[:: count + 1], seen[:: count + 1] = values, True
    return smoothed(spread, seen, noise, 1.0 / (count + 1))


def _model(step: float) -> tuple[Float64s, Float64s]:
    move = np.array([[1.0, step], [0.0, 1.0]])
    chance = np.array([[step**3 / 3.0, step**2 / 2.0], [step**2 / 2.0, step]])
    return move, chance


def _filtered(
    flat: Float64s, seen: Bools, noise: float, step: float
) -> tuple[Float64s, Float64s, Float64s]:
    """Return the filter's states (n, 2, m), their covariances (n, 2, 2), and those predicted before each frame."""
    move, chance = _model(step)
    states, spreads = np.zeros((len(flat), 2, flat.shape[1])), np.zeros((len(flat), 2, 2))
    ahead = np.zeros((len(flat), 2, 2))
    state, spread = np.zeros((2, flat.shape[1])), np.diag([_VAGUE, _VAGUE])
    first = int(np.argmax(seen))
    state[0] = flat[first]
    for k, value in enumerate(flat):
        if k:
            state, spread = move @ state, move @ spread @ move.T + chance
        ahead[k] = spread
        if seen[k]:
            gain = spread[:, 0] / (spread[0, 0] + noise)
            state = state + gain[:, None] * (value - state[0])
            spread = spread - np.outer(gain, spread[0])
        states[k], spreads[k] = state, spread
    return states, spreads, ahead


def _backwards(states: Float64s, spreads: Float64s, ahead: Float64s, step: float) -> Float64s:
    """Return the smoothed states (n, 2, m)."""
    move, _ = _model(step)
    later = states.copy()
    for k in range(len(states) - 2, -1, -1):
        gain = np.linalg.solve(ahead[k + 1], move @ spreads[k]).T
        later[k] += gain @ (later[k + 1] - move @ states[k])
    return later
