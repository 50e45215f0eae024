"""Films with known truth, without a picture: a captured swim's axis as a camera above would have measured it."""

from typing import Final

import numpy as np

from components.arrays import Float64s
from components.body import Body
from components.segment import Segment
from tools.capture.report.silhouette import silhouette_of
from tools.video.water.film import STATIONS, Film

PIXELS: Final = 300.0
"""Length of a fish that does not swim."""


def filmed(
    body: Body,
    segment: Segment,
    frames: int = 120,
    rate: float = 60.0,
    noise: float = 0.0,
    circling: float = 0.0,
    holds_station: bool = False,
    heading: float = 0.3,
) -> Film:
    """Return `frames` frames of a fish that swims `segment` over and over; noise in px, circling in rad/s."""
    chance = np.random.default_rng(3)
    line = centre_lines(body, segment, int(frames * 60.0 / rate) + 4, holds_station)
    ticks = np.arange(frames) * 60.0 / rate
    before = np.floor(ticks).astype(int)
    part = (ticks - before)[:, None, None]
    axis = (1.0 - part) * line[before] + part * line[before + 1]
    axis = _resampled(axis)
    angle = heading + circling / rate * np.arange(frames, dtype=np.float64)
    axis = _circled(axis, angle)
    axis = PIXELS * axis * (1.0, -1.0) + (500.0, 300.0) + noise * chance.normal(size=axis.shape)
    at = np.linspace(0.0, 1.0, STATIONS)
    width = PIXELS * np.interp(at, (0.0, *body.station, 1.0), (0.0, *body.half_width, 0.0))
    return Film(rate, axis, np.tile(width, (frames, 1)), np.ones(frames, bool))


def centre_lines(
    body: Body, segment: Segment, frames: int, holds_station: bool = False
) -> Float64s:
    """Return the centre line at each tick, x ahead, y left [BL], (frames, 41, 2)."""
    middle = silhouette_of(body).middle
    rotation, origin, lines = _mean_course(segment), np.zeros(3), []
    for k in range(frames):
        entry = k % len(segment.shape)
        origin = origin + rotation @ segment.translation[entry]
        rotation = rotation @ segment.rotation[entry]
        flat = middle @ segment.shape[entry].astype(np.float64)
        place = origin + flat @ rotation.T
        lines.append(np.stack((place[:, 0], -place[:, 2]), axis=-1))
    found = np.array(lines)
    if holds_station:
        whole = len(segment.shape)
        stride = float(np.diff([found[0, 20, 0], found[whole, 20, 0]])[0]) / whole
        found[:, :, 0] -= stride * np.arange(frames)[:, None]
    return found


def _mean_course(segment: Segment) -> Float64s:
    """Return the rotation with which a segment begins whose travel runs along x."""
    rotation, way = np.eye(3), np.zeros(3)
    for k in range(len(segment.translation)):
        way = way + rotation @ segment.translation[k]
        rotation = rotation @ segment.rotation[k]
    yaw = np.arctan2(-way[2], way[0])
    cos, sin = np.cos(-yaw), np.sin(-yaw)
    # About y, so that (way_x, -way_z) turns by -yaw.
    return np.array([[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]])


def _circled(axis: Float64s, angle: Float64s) -> Float64s:
    """Return axes whose course bends: steps of the middle and shapes are turned by `angle` (F,)."""
    cos, sin = np.cos(angle), np.sin(angle)
    turn = np.stack((np.stack((cos, -sin), -1), np.stack((sin, cos), -1)), 1)
    middle = axis.mean(axis=1)
    shape = np.einsum("fij,fsj->fsi", turn, axis - middle[:, None])
    steps = np.einsum("fij,fj->fi", 0.5 * (turn[1:] + turn[:-1]), np.diff(middle, axis=0))
    place = np.concatenate((middle[:1], middle[:1] + np.cumsum(steps, axis=0)))
    placed: Float64s = shape + place[:, None]
    return placed


def _resampled(axis: Float64s) -> Float64s:
    found = np.empty_like(axis)
    for frame, line in enumerate(axis):
        along = np.concatenate(
            ([0.0], np.cumsum(np.sqrt((np.diff(line, axis=0) ** 2).sum(axis=1))))
        )
        at = np.linspace(0.0, along[-1], STATIONS)
        found[frame] = np.stack([np.interp(at, along, line[:, i]) for i in (0, 1)], axis=-1)
    return found
