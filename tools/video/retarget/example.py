"""A motion without a clip: a wave that runs down the body and fins that beat, for trials, tests and benches."""

from typing import Final

import numpy as np

from tools.video.retarget.intermediate import IntermediateMotion
from tools.video.retarget.skeleton import ANGLES, BONES, HEAD, LOW, UP

_WAVES: Final = 0.95
"""Waves on the body at a time."""
_LEFT, _RIGHT = 3.9, 5.5
"""[rad] at which fins rest."""


def example_motion(
    frames: int,
    sweep: float = 0.2,
    fin_sweep: float = 0.6,
    rate: float = 30.0,
    length: float = 300.0,
) -> IntermediateMotion:
    """Return a fish that swims in a circle: bends grow to a tail's sweep from side to side of `sweep` [BL].

    `fin_sweep` [rad] is how far fins beat to each side of their rest, `length` the fish's [px].
    """
    time = np.arange(frames) / rate
    # Place of each bone's middle along the body, 0 at the head.
    ahead = 0.4 * (1.0 - (np.arange(UP + 1) + 0.5) / (UP + 1))
    behind = 0.4 + 0.6 * (np.arange(LOW + 1) + 0.5) / (LOW + 1)
    s = np.concatenate((ahead, behind))
    phase = 2.0 * np.pi * (2.0 * time[:, None] - _WAVES * s)
    grown = 0.5 * sweep * (0.25 - 0.5 * s + 1.25 * s**2)
    slope = 2.0 * np.pi * _WAVES * grown * np.cos(phase) - 0.5 * sweep * (2.5 * s - 0.5) * np.sin(
        phase
    )
    angles = np.empty((frames, ANGLES))
    angles[:, :BONES] = np.where(np.arange(BONES) < HEAD, 0.5, 1.5) * np.pi + np.arctan(slope)
    beat = fin_sweep * np.sin(2.0 * np.pi * 1.5 * time)
    angles[:, BONES], angles[:, BONES + 1] = _LEFT - beat, _RIGHT + beat
    turn = 0.6 * time
    centre = 1.5 * length * np.stack((np.sin(turn), np.cos(turn)), axis=1)
    return IntermediateMotion(centre, turn, angles, length, rate)
