"""Control: the secondary controller between mind and motor system (papers/000 section 6.1), and the
careful steering of section 6.2.

A mind demands a direction, a gear, an urgency and a throttle (systems/motor/rate.py). Control turns them
into a segment of the repertoire (a gradual or a sharp turn towards a direction far to the side, a fast
start for dear life, else the swim of the gear) and into a small rotation a tick, which aligns the body's
x axis, or where a turn will have brought it, with the direction. Angles are taken from half tangents, so
nothing here needs trigonometry.
"""

from math import sqrt
from typing import Final, NamedTuple

import numba

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.clock import TICK_SECONDS, Clock
from components.fish import Population
from components.kernels import Launch, inlined, loop, row
from components.repertoire import Pattern, RepertoireLibrary
from components.table import Columns
from systems.motor.choose import (
    HALF_TURN,
    Gaits,
    after,
    draw_mood,
    gaits,
    pick,
    swim_of_gear,
)

PARALLEL_FROM: Final = 500
CHUNKS: Final = 64

YAW_RATE: Final = (0.8, 2.5)
"""[rad/s] of fine steering at most, at leisure and in danger."""

PITCH_RATE: Final = (0.5, 1.3)
"""[rad/s]"""

STEEPEST: Final = 0.6427876096865393
"""Sine of the steepest climb and dive, 40 degrees."""

EAGERNESS: Final = (1.8, 4.0)
"""[1/s]: rate of steering over the angle left, at leisure and in danger."""

RESPONSE: Final = (TICK_SECONDS / 0.2, TICK_SECONDS / 0.1)
"""Share a tick by which the rate nears what is asked for: no jerks, and the beat's own yaw is not
fought; with `EAGERNESS` it settles without swinging."""

GENTLE: Final = 0.5
"""Share of the rates that is left in a warp or in a turn segment, which turns by itself."""

FULL_STEERING_SPEED: Final = 1.5
"""[BL/s] from which steering is at its best; a slow fish turns slowly."""

LEAST_STEERING: Final = 0.4
"""Share of the rates that is left without any speed."""


class Controlled(NamedTuple):
    """The columns of the fish and motor tables that control reads, and last those it writes."""

    id: Int64s
    species: Int32s
    rotation: Float64s
    heading: Float64s
    gear: Int8s
    urgency: Float64s
    throttle: Float64s
    pace: Float64s
    segment: Int32s
    held: Int32s
    frame: Int32s
    warp_length: Int32s
    wanted: Int32s
    mood: Int8s
    mood_until: Int32s
    steer: Float64s


@inlined
def half_tangent_angle(sine: float, cosine: float) -> float:
    """Return the angle [rad] of a sine and a cosine, to 0.01 rad, within half a turn either way."""
    half = sine / (1.0 + abs(cosine))
    near = 2.0 * half / (1.0 + 0.28125 * half * half)
    if cosine > 0.0:
        return near
    return HALF_TURN - near if sine >= 0.0 else -HALF_TURN - near


@inlined
def _yaw_left(r: Float64s, g: Float64s, turning: float) -> float:
    """Return the angle [rad], left positive, from x to the direction g in the horizontal plane.

    Where g lies behind, a fish that already turns goes on to the same side. Near the vertical, where
    there is no bearing, the angle fades.
    """
    level = sqrt((r[0, 0] * r[0, 0] + r[1, 0] * r[1, 0]) * (g[0] * g[0] + g[1] * g[1])) + 1e-12
    cosine = (r[0, 0] * g[0] + r[1, 0] * g[1]) / level
    sine = (r[0, 0] * g[1] - r[1, 0] * g[0]) / level
    if cosine < -0.8 and abs(turning) > 1e-4:
        sine = turning
    return half_tangent_angle(sine, cosine) * min(1.0, 5.0 * level)


@inlined
def _limited(value: float, most: float) -> float:
    return max(-most, min(most, value))


@inlined
def _pitch_left(r: Float64s, g: Float64s) -> float:
    """Return the angle [rad], nose up positive, from x's climb to g's, itself kept below 40 degrees."""
    return _limited(g[2], STEEPEST) - float(r[2, 0])


@inlined
def _blend(pair: tuple[float, float], urgency: float) -> float:
    return pair[0] + urgency * (pair[1] - pair[0])


@inlined
def _steer(
    r: Float64s, steer: Float64s, yaw: float, pitch: float, hurry: float, share: float
) -> None:
    """Bring the rotation vector of this tick nearer to what the angles left ask for (6.2).

    It turns about the vertical and about the level axis at the body's right, and so never rolls.
    """
    level = sqrt(r[0, 0] * r[0, 0] + r[1, 0] * r[1, 0]) + 1e-12
    right_x, right_y = r[1, 0] / level, -r[0, 0] / level
    eager = _blend(EAGERNESS, hurry)
    near = _blend(RESPONSE, hurry)
    most = share * _blend(YAW_RATE, hurry)
    turn = steer[2] + near * (_limited(eager * yaw, most) * TICK_SECONDS - steer[2])
    most = share * _blend(PITCH_RATE, hurry)
    lift = steer[0] * right_x + steer[1] * right_y
    lift += near * (_limited(eager * pitch, most) * TICK_SECONDS - lift)
    steer[0], steer[1], steer[2] = lift * right_x, lift * right_y, turn


@row
def control_rows(
    first: int, last: int, fish: Controlled, gaits: Gaits, seed: int, tick: int
) -> None:
    """Control the fishes of rows first to last - 1."""
    for i in range(first, last):
        r, g, steer = fish.rotation[i], fish.heading[i], fish.steer[i]
        hurry = max(0.0, min(1.0, fish.urgency[i]))
        current = fish.segment[i]
        yaw = _yaw_left(r, g, steer[2])
        free = fish.throttle[i] == 1.0
        if tick >= fish.mood_until[i]:
            fish.mood[i], fish.mood_until[i] = draw_mood(seed, tick, fish.id[i])
        swim = swim_of_gear(fish.gear[i], hurry, free, fish.mood[i])
        segments = gaits.segment[fish.species[i]]
        frame = fish.frame[i]
        wanted = pick(segments, gaits, current, swim, yaw, frame, fish.held[i], hurry)
        fish.wanted[i] = wanted if wanted >= 0 else current
        speed = min(1.0, abs(fish.pace[i] * gaits.speed[current]) / FULL_STEERING_SPEED)
        share = LEAST_STEERING + (1.0 - LEAST_STEERING) * speed
        turning = gaits.pattern[current] >= Pattern.TURN_LEFT.value
        if turning or fish.warp_length[i] > 0:
            share *= GENTLE
        if turning and frame < gaits.length[current]:
            yaw = after(yaw, gaits.left[gaits.start[current] + frame])
        _steer(r, steer, yaw, _pitch_left(r, g), hurry, share)


@loop
def control_parallel(count: int, fish: Controlled, gaits: Gaits, seed: int, tick: int) -> None:
    """Control `count` fishes on all threads, to the same bits as `control_rows`."""
    for chunk in numba.prange(CHUNKS):
        first, last = chunk * count // CHUNKS, (chunk + 1) * count // CHUNKS
        control_rows(first, last, fish, gaits, seed, tick)


class Control:
    """Reads heading, gear, urgency, throttle, pace, segment, held, warp, rotation, species, id, the library and the
    clock; writes moods, the wanted segment and steer."""

    def __init__(self, population: Population, library: RepertoireLibrary, clock: Clock) -> None:
        self.population = population
        self.clock = clock
        self.gaits = gaits(library)
        self.columns = Columns(Controlled, population.fish, population.motor)
        self._serially, self._in_parallel = Launch(control_rows), Launch(control_parallel)

    def __call__(self) -> None:
        """Choose segment and steering of every fish for this tick."""
        count, fish = self.population.count, self.columns()
        seed, tick = int(self.clock.seed[0]), self.clock.now
        if count < PARALLEL_FROM:
            self._serially(0, count, fish, self.gaits, seed, tick)
        else:
            self._in_parallel(count, fish, self.gaits, seed, tick)
