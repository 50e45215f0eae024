"""A motion without a clip: a wave that runs down the body and fins that beat, for trials, tests and benches."""

from dataclasses import replace
from typing import Final

import numpy as np

from tools.video.contour import evenly
from tools.video.motion import Motion, rebuilt_axis
from tools.video.retarget.intermediate import IntermediateMotion
from tools.video.retarget.skeleton import ANGLES, BONES, HEAD, LOW, UP, sampled_axis, skeleton_of

_WAVES: Final = 0.95
"""Waves on the body at a time."""
_STATIONS: Final = 41
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


def example_clip_motion(frames: int) -> Motion:
    """Return `example_motion` as a clip would have given it."""
    played = example_motion(frames)
    controls = sampled_axis(np.array([[0.0, 0.4], [0.0, -0.6]]), 0.4) * played.length
    lengths = np.broadcast_to(skeleton_of(controls).lengths, (frames, BONES))
    motion = Motion(
        rate=played.rate,
        first=0,
        size=(960, 544),
        centre=played.centre + np.array([480.0, 272.0]),
        direction=played.direction,
        head_angle=played.angles[:, UP],
        tail_angle=played.angles[:, BONES - 1],
        up_angle=played.angles[:, :UP],
        low_angle=played.angles[:, HEAD : BONES - 1],
        fin_angle=played.angles[:, BONES:],
        head_length=lengths[:, UP],
        tail_length=lengths[:, BONES - 1],
        up_length=lengths[:, :UP],
        low_length=lengths[:, HEAD : BONES - 1],
        fin_length=np.full((frames, 2), 0.2 * played.length),
        junction=np.zeros((frames, 4, 2)),
        folded=np.zeros((frames, 2), np.bool_),
        axis=np.zeros((frames, _STATIONS, 2), np.float32),
        half_width=np.full((frames, _STATIONS), 0.08 * played.length, np.float32),
        confidence=np.ones(frames),
        fault=np.zeros(frames, np.int8),
        provenance={"clip": "none: a wave by formula"},
    )
    axis = np.stack([evenly(line, _STATIONS) for line in rebuilt_axis(motion)])
    junction = np.repeat(axis[:, [10, 10, 15, 15]], 1, axis=0)
    return replace(motion, axis=axis.astype(np.float32), junction=junction)
