"""Cuts segments out of recordings: where a beat begins, what an entry holds, and how a cycle closes (FINDINGS 1)."""

from math import sqrt
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.kernels import row, serial
from components.repertoire import Pattern, Segment
from tools.capture.record import Recording
from tools.capture.rotation import multiply, rotation_from, rotation_vector

MOTIONLESS: Final = 1e-6
"""[BL] a beat below which a fish is taken to stand still."""


@serial
def _entries(
    nodes: Float64s,
    origin: Float64s,
    rotation: Float64s,
    first: int,
    turn: Float64s,
    travel: Float64s,
    shape: Float64s,
) -> None:
    """Write M, t and d (eqs. 6-8, corrected) of the entries from frame `first` on."""
    for k in range(len(turn)):
        now, then = rotation[first + k], rotation[first + k + 1]
        for i in range(3):
            for j in range(3):
                turn[k, i, j] = (
                    now[0, i] * then[0, j] + now[1, i] * then[1, j] + now[2, i] * then[2, j]
                )
        _into_axes(now, origin[first + k], origin[first + k + 1], travel[k])
        for node in range(nodes.shape[1]):
            _into_axes(then, origin[first + k + 1], nodes[first + k + 1, node], shape[k, node])


@row
def _into_axes(rotation: Float64s, origin: Float64s, point: Float64s, out: Float64s) -> None:
    x, y, z = point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]
    for i in range(3):
        out[i] = rotation[0, i] * x + rotation[1, i] * y + rotation[2, i] * z


@serial
def _close(turn: Float64s, scratch: Float64s, vector: Float64s) -> float:
    """Spread the turn left over by a cycle evenly: each M times exp(-log Q / N). Return the angle [rad] it was."""
    product, following, share = scratch[0], scratch[1], scratch[2]
    product[:] = turn[0]
    for k in range(1, len(turn)):
        multiply(product, turn[k], following)
        product[:] = following
    rotation_vector(product, vector)
    inverse = -1.0 / len(turn)
    rotation_from(inverse * vector[0], inverse * vector[1], inverse * vector[2], share)
    for k in range(len(turn)):
        multiply(turn[k], share, following)
        turn[k] = following
    return sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2])


def cut(recording: Recording, pattern: Pattern, first: int, length: int, loops: bool) -> Segment:
    """Return the segment of `length` entries that starts at frame `first`; a loop turns by nothing over a cycle."""
    turn, travel = np.zeros((length, 3, 3)), np.zeros((length, 3))
    shape = np.zeros((length, *recording.nodes.shape[1:]))
    _entries(recording.nodes, recording.origin, recording.rotation, first, turn, travel, shape)
    if loops:
        scratch, vector = np.zeros((3, 3, 3)), np.zeros(3)
        for _ in range(4):  # the shares do not commute with M, so a little is left each time
            _close(turn, scratch, vector)
    return Segment(pattern, loops, turn, travel, shape.astype(np.float32))


def course(recording: Recording, first: int, period: int) -> tuple[float, float]:
    """Return the level direction of travel over the beat that starts at frame `first`, a unit vector (x, y).

    Raise ValueError where the fish gets nowhere.
    """
    step = recording.origin[first + period] - recording.origin[first]
    size = sqrt(step[0] * step[0] + step[1] * step[1])
    if not size > MOTIONLESS:
        raise ValueError("the fish does not swim: it stays where it is")
    return float(step[0]) / size, float(step[1]) / size


def beat_start(recording: Recording, period: int) -> float:
    """Return the frame, with its fraction, at which the last whole beat's yaw rises through the course.

    It lies in [F - 2 period - 3, F - period - 1], so that a beat's entries follow it; the search spans a frame more
    than a beat on either side, lest a crossing at a frame slip between two beats. Raise ValueError where the yaw never
    rises through the course: such a fish does not swim.
    """
    start = len(recording.origin) - 2 * period - 3
    x, y = course(recording, start, period)
    ahead = recording.rotation[start : start + period + 3, :, 0]
    aside = x * ahead[:, 1] - y * ahead[:, 0]
    for k in range(period + 2):
        if aside[k] < 0.0 <= aside[k + 1]:
            return start + k + float(aside[k] / (aside[k] - aside[k + 1]))
    raise ValueError("the fish does not swim: its heading never crosses its course")


def shape_gap(recording: Recording, one: int, other: int) -> float:
    """Return the largest coordinate by which the shapes of two frames differ in body axes [BL]."""
    return float(np.abs(body_shape(recording, one) - body_shape(recording, other)).max())


def body_shape(recording: Recording, frame: int) -> Float64s:
    """Return the nodes of a frame in body axes [BL], (23, 3)."""
    shape = np.zeros(recording.nodes.shape[1:])
    origin = recording.origin[frame]
    for node, place in enumerate(recording.nodes[frame]):
        _into_axes(recording.rotation[frame], origin, place, shape[node])
    return shape
