"""Lifts an axis to the 23 nodes of our body lattice, and a cycle to a segment of a repertoire (papers/000, 4.1).

The filmed fish swims level, so a ring stands upright across its axis; the segment is cut as capture cuts its own.
"""

from dataclasses import replace
from math import floor
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.body import NODE_HEIGHT, NODES, RINGS, Body
from components.clock import TICKS_PER_SECOND
from components.segment import Pattern, Segment
from systems.motor.body_frame import body_frame
from tools.capture.cut import cut
from tools.capture.measure import SwimFigures, measure_swim
from tools.capture.record import Recording
from tools.video.water.cycle import Cycle

TOLERANCE: Final = 0.003
"""Part by which the frequency of a loop may differ from the filmed one: beats last no whole number of ticks."""

MOST_BEATS: Final = 12
_FINE: Final = 240
_ACROSS: Final = 0.04
"""[BL] on either side of a ring between which the axis gives its direction."""


def nodes_of(line: Float64s, body: Body) -> Float64s:
    """Return the nodes of a body on axes (n, 41, 2), x ahead, y left; world axes, z up [BL], (n, 23, 3)."""
    nodes = np.zeros((len(line), NODES, 3))
    nodes[:, 0, :2] = line[:, 0]
    for ring in range(RINGS):
        at = body.station[ring]
        middle = _at(line, at)
        ahead = _at(line, max(0.0, at - _ACROSS)) - _at(line, min(1.0, at + _ACROSS))
        ahead /= np.sqrt((ahead**2).sum(axis=1))[:, None]
        left = np.stack((-ahead[:, 1], ahead[:, 0]), axis=-1)
        height, width = NODE_HEIGHT * body.half_height[ring], body.half_width[ring]
        # Ring order: top-left, top-right, bottom-right, bottom-left.
        for node, (up, side) in enumerate(((1, 1), (1, -1), (-1, -1), (-1, 1)), start=1 + 4 * ring):
            nodes[:, node, :2] = middle + side * width * left
            nodes[:, node, 2] = up * height
    nodes[:, 21, :2] = nodes[:, 22, :2] = line[:, -1]
    nodes[:, 21, 2], nodes[:, 22, 2] = body.tail_span, -body.tail_span
    return nodes


def _at(line: Float64s, station: float) -> Float64s:
    """Return the point of each axis at an arc length [BL], (n, 2)."""
    steps = line.shape[1] - 1
    before = min(floor(station * steps), steps - 1)
    part = station * steps - before
    found: Float64s = (1.0 - part) * line[:, before] + part * line[:, before + 1]
    return found


def recording_of(line: Float64s, body: Body) -> Recording:
    """Return a body's run along axes (n, 41, 2), a frame each, with its body axes."""
    nodes = nodes_of(line, body)
    made = Recording(nodes, np.zeros((len(nodes), 3)), np.zeros((len(nodes), 3, 3)))
    for frame in range(len(nodes)):
        body_frame(nodes[frame], made.origin[frame], made.rotation[frame])
    return made


def loop_length(frequency: float) -> tuple[int, int]:
    """Return how many beats a loop holds, and how many entries: the fewest beats that keep the frequency."""
    found = [(1, max(3, round(TICKS_PER_SECOND / frequency)))]
    for beats in range(1, MOST_BEATS + 1):
        entries = max(3, round(beats * TICKS_PER_SECOND / frequency))
        off = abs(beats * TICKS_PER_SECOND / entries / frequency - 1.0)
        if off <= TOLERANCE:
            return beats, entries
        found.append((beats, entries))
    return min(found, key=lambda one: abs(one[0] * TICKS_PER_SECOND / one[1] / frequency - 1.0))


def loop_of(cycle: Cycle, body: Body, pattern: Pattern) -> Segment:
    """Return a cycle as a segment that loops, from where the yaw rises through the course."""
    beats, entries = loop_length(cycle.frequency)
    phase = _rising(cycle, body) + beats * np.arange(entries + 1) / entries
    return cut(recording_of(cycle.lines(phase), body), pattern, 0, entries, True)


def _rising(cycle: Cycle, body: Body) -> float:
    """Return the phase [turns] at which the body's yaw rises through its course."""
    run = recording_of(cycle.lines(np.arange(_FINE + 1) / _FINE), body)
    yaw = run.rotation[:, 1, 0]
    for k in range(_FINE):
        if yaw[k] < 0.0 <= yaw[k + 1]:
            return (k + float(yaw[k] / (yaw[k] - yaw[k + 1]))) / _FINE
    return 0.0


def figures_of(cycle: Cycle, body: Body) -> SwimFigures:
    """Return what a cycle amounts to, held against living fishes."""
    run = recording_of(cycle.lines(np.arange(_FINE + 2) / _FINE), body)
    beat = cut(run, Pattern.SWIM_MEDIUM, 0, _FINE, True)
    return replace(measure_swim(run, beat, 0), speed=cycle.speed, frequency=cycle.frequency)
