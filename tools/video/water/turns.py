"""Turns out of a film: where the slow heading swings round and the fish swims on (papers/000, 4.2; FINDINGS 1b).

A turn is taken as it was filmed, to the left or mirrored; its ends need not meet the cruise, for whoever leaves one
segment for another is warped there (systems/motor/warp.py).
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from components.arrays import Float64s
from components.body import Body
from components.clock import TICKS_PER_SECOND
from components.segment import Pattern, Segment, mean_speed
from components.trigonometry import DEGREE
from tools.capture.bend import JOINT_LIMIT, SHARP_LEAST, largest_joint
from tools.capture.cut import cut
from tools.capture.measure import TURN_RANGE_DEG, turn_text
from tools.video.water.beats import Bout
from tools.video.water.film import STATIONS, Film, angles, places, weights
from tools.video.water.lattice import recording_of

LEAST: Final = TURN_RANGE_DEG[0] * DEGREE
"""[rad] from which a swing is a turn."""


class Pace(NamedTuple):
    """How a fish turns."""

    least: float
    "[rad/s] of the slow heading from which it does"
    longest: float
    "[s] that such a turn lasts at most"


GENTLE: Final = Pace(15.0 * DEGREE, 2.0)
QUICK: Final = Pace(45.0 * DEGREE, 1.2)

SHORTEST: Final = 0.25
"""[s] that a turn lasts."""

SLOWEST: Final = 0.1
"""[BL/s] ahead that a fish keeps in a turn."""

JUMP: Final = 6.0
JUMP_LEAST: Final = 0.005
"""Times a usual step, and [BL] beside it, beyond which a step is a jump."""

NEAR: Final = 0.03
"""[BL] from the cruise's shape at which a turn may end."""

GRADUAL: Final = 25.0 * DEGREE
"""[rad] that a gradual turn had best turn."""

ASTRAY: Final = 0.5
"""Part of a turn by which that of a fish's way through the water may differ from it."""

_MARGIN: Final = 0.25
"""Beats before and after that belong to a turn."""


class Swing(NamedTuple):
    """A stretch of film in which the fish turns."""

    first: int
    "frame"
    stop: int
    "the frame after its last"
    turn: float
    "change of the slow heading, to the left [rad]"


class Turns(NamedTuple):
    """What a film gives of turns."""

    taken: list[tuple[Segment, str, Swing]]
    "the gradual, then the sharp one, each with its figures and where it is"
    refused: dict[int, str]
    "why others were not taken, by the frame that they begin with"


def swings(film: Film, frequency: float, pace: Pace) -> list[Swing]:
    """Return the turns of a pace that a film shows, of a fish that beats its tail so often a second."""
    heading = slow_heading(film, frequency)
    turning = np.gradient(heading) * film.rate
    found = []
    margin = round(_MARGIN * film.rate / frequency)
    for side in (1.0, -1.0):
        for first, stop in _runs(side * turning > pace.least):
            begin, end = max(0, first - margin), min(len(heading), stop + margin)
            seconds = (end - begin) / film.rate
            if SHORTEST <= seconds <= pace.longest and film.good[begin:end].all():
                found.append(Swing(begin, end, float(heading[end - 1] - heading[begin])))
    return found


def turns_within(film: Film, frequency: float, bout: Bout) -> bool:
    """Return whether a fish turns while it beats its tail as in a bout."""
    return any(
        swing.first < bout.stop and bout.first < swing.stop and abs(swing.turn) >= LEAST
        for pace in (GENTLE, QUICK)
        for swing in swings(film, frequency, pace)
    )


def slow_heading(film: Film, frequency: float) -> Float64s:
    """Return the heading to the left, each beat's swing averaged out of it [rad], (F,)."""
    whole = -angles(film) @ weights(film)
    window = max(1, round(film.rate / frequency))
    if window >= len(whole):
        return np.full(len(whole), float(whole.mean()))
    padded = np.pad(whole, (window // 2, window - 1 - window // 2), mode="edge")
    smooth: Float64s = np.convolve(padded, np.full(window, 1.0 / window), mode="valid")
    return smooth


def turns_of(film: Film, frequency: float, body: Body, cruise: Segment) -> Turns:
    """Return the gradual and the sharp turn of a film, where it has any.

    The gradual one turns by about 25 degrees, the sharp one as far as possible; no joint bends too far in either.
    """
    most = TURN_RANGE_DEG[1] * DEGREE
    refused: dict[int, str] = {}
    gentle, quick = (
        list(_tries(film, frequency, pace, body, cruise, refused)) for pace in (GENTLE, QUICK)
    )
    gradual = [one for one in gentle if LEAST <= one.net < most]
    sharp = [one for one in quick if one.net >= SHARP_LEAST]
    taken = []
    if gradual:
        taken.append(
            _named(Pattern.TURN_LEFT, min(gradual, key=lambda one: abs(one.net - GRADUAL)))
        )
    if sharp:
        taken.append(_named(Pattern.TURN_SHARP_LEFT, max(sharp, key=lambda one: one.net)))
    return Turns(taken, refused)


class _Try(NamedTuple):
    """A swing cut as a turn to the left."""

    segment: Segment
    gap: float
    "of its last shape from the nearest of the cruise [BL]"
    net: float
    "[rad]"
    swing: Swing


def _named(pattern: Pattern, best: _Try) -> tuple[Segment, str, Swing]:
    segment = replace(best.segment, pattern=pattern)
    return segment, turn_text(segment, best.gap), best.swing


def _tries(
    film: Film,
    frequency: float,
    pace: Pace,
    body: Body,
    cruise: Segment,
    refused: dict[int, str],
) -> Iterator[_Try]:
    """Yield each swing of a pace that can be taken, up to where the fish is most nearly in its beat again.

    Why others cannot is written into `refused`.
    """
    for swing in swings(film, frequency, pace):
        if abs(swing.turn) < LEAST:
            continue
        made = _try(film, frequency, swing, body, cruise)
        if isinstance(made, str):
            refused[swing.first] = made
        else:
            yield made


def _try(film: Film, frequency: float, swing: Swing, body: Body, cruise: Segment) -> _Try | str:
    """Return a swing cut as a turn, or why it cannot be."""
    if not _goes_where_it_heads(film, frequency, swing):
        return "its way does not turn with it: the camera goes along, or the current changes"
    beat = round(film.rate / frequency)
    line = _lines(film, swing.first, min(swing.stop + beat, len(film.axis)))
    run = recording_of(line * (1.0, -1.0) if swing.turn < 0.0 else line, body)
    if largest_joint(run.nodes) > JOINT_LIMIT:
        return "it bends further than a body of the game can"
    whole = cut(run, Pattern.TURN_LEFT, 0, len(line) - 1, False)
    gaps = np.array([np.abs(cruise.shape - s).max(axis=(1, 2)).min() for s in whole.shape])
    early = min(round((swing.stop - swing.first) / film.rate * TICKS_PER_SECOND), len(gaps)) - 1
    near = np.flatnonzero(gaps[early:] <= max(NEAR, 1.2 * float(gaps[early:].min())))
    length = early + int(near[0]) + 1
    made = cut(run, Pattern.TURN_LEFT, 0, length, False)
    if _jumps(made):
        return "it leaps, as where frames are missing"
    if mean_speed(made) < SLOWEST:
        return "it does not go ahead"
    turned = swing._replace(stop=swing.first + round(length * film.rate / TICKS_PER_SECOND) + 1)
    return _Try(made, float(gaps[length - 1]), _net(film, frequency, turned), turned)


def _goes_where_it_heads(film: Film, frequency: float, swing: Swing) -> bool:
    """Return whether a fish that swings round goes another way then, as one must that swims."""
    half, at = max(1, round(0.5 * film.rate / frequency)), places(film) * (1.0, -1.0)
    way = [
        at[min(frame + half, len(at) - 1)] - at[max(frame - half, 0)]
        for frame in (swing.first, swing.stop)
    ]
    across = way[0][0] * way[1][1] - way[0][1] * way[1][0]
    turned = float(np.arctan2(across, way[0] @ way[1]))
    off = turned - swing.turn
    off -= 2.0 * np.pi * round(off / (2.0 * np.pi))
    return bool(abs(off) <= ASTRAY * abs(swing.turn))


def _jumps(segment: Segment) -> bool:
    """Return whether a fish is suddenly elsewhere, as where frames of the film are missing."""
    steps = np.sqrt((segment.translation**2).sum(axis=1))
    return bool(steps.max() > JUMP * (float(np.median(steps)) + JUMP_LEAST))


def _net(film: Film, frequency: float, swing: Swing) -> float:
    """Return how far a swing turns the slow heading [rad]."""
    heading = slow_heading(film, frequency)
    return abs(float(heading[min(swing.stop, len(heading)) - 1] - heading[swing.first]))


def _lines(film: Film, first: int, stop: int) -> Float64s:
    """Return the axis at each tick from a frame to another, the picture's y upwards [BL], (n, 41, 2)."""
    span = slice(first, stop)
    seconds = np.arange(stop - first) / film.rate
    ticks = np.arange(int(seconds[-1] * TICKS_PER_SECOND) + 1) / TICKS_PER_SECOND
    pointing = CubicSpline(seconds, -angles(film)[span])(ticks)
    at = CubicSpline(seconds, places(film)[span] * (1.0, -1.0))(ticks)
    steps = np.stack((np.cos(pointing), np.sin(pointing)), axis=-1) / (STATIONS - 1)
    line = np.zeros((len(ticks), STATIONS, 2))
    line[:, 1:] = -np.cumsum(steps, axis=1)
    middle = np.einsum("j,njc->nc", weights(film), 0.5 * (line[:, 1:] + line[:, :-1]))
    placed: Float64s = line + (at - middle)[:, None, :]
    return placed


def _runs(flags: "np.ndarray[tuple[int, ...], np.dtype[np.bool_]]") -> Iterator[tuple[int, int]]:
    """Yield where runs of True begin, and the place after their ends."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], flags.astype(np.int8), [0]))))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)
