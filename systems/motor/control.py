"""Control: the secondary controller between mind and motor system (papers/000 section 6.1), and the
careful steering of section 6.2.

A mind demands a direction, a gear and an urgency. Control turns them into a segment of the
repertoire (a turn towards a direction far to the side, else the swim of the gear) and into a small
rotation a tick, which aligns the body's x axis with the direction. Angles are taken from half
tangents, so nothing here needs trigonometry.
"""

from math import sqrt
from typing import Final, NamedTuple

import numba
import numpy as np

from components import chance
from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.clock import TICK_SECONDS, Clock
from components.fish import FishTable, Population
from components.kernels import inlined, loop, row
from components.motor import MotorTable
from components.repertoire import Pattern, RepertoireLibrary

PARALLEL_FROM: Final = 500
CHUNKS: Final = 64

TURN_FROM: Final = 0.61
"""[rad] to the side, 35 degrees, from which a turn segment is worth while."""

TURN_SHARE: Final = 0.6
"""... and the share of the segment's own turn from which it is."""

TURN_DONE: Final = 0.15
"""[rad] left to turn at which a turn segment is broken off."""

REST_TICKS: Final = 24
"""[ticks] of swimming between two turns, and between two changes of gear, at leisure."""

URGENT_REST_TICKS: Final = 6

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

LEISURE: Final = 0.25
"""Urgency below which a fish may play another gear than it is asked for."""

MOOD_TICKS: Final = 150
"""[ticks] that a mood lasts at least."""

MOOD_SPREAD: Final = 128
"""[ticks] of which a share, drawn by the fish's id, comes on top; a power of two."""

HABIT: Final = 1 << 40
"""Where the stream of segments, elsewhere counted by ticks, holds each fish's habits."""


class Swimmers(NamedTuple):
    """The columns of the fish and motor tables that control reads, and last those it writes."""

    id: Int64s
    species: Int32s
    rotation: Float64s
    heading: Float64s
    gear: Int8s
    urgency: Float64s
    segment: Int32s
    held: Int32s
    warp_length: Int32s
    wanted: Int32s
    steer: Float64s


class Gaits(NamedTuple):
    """The columns of the library that control reads."""

    segment: Int32s
    pattern: Int8s
    speed: Float64s
    turn: Float64s


def swimmers(fish: FishTable, motor: MotorTable) -> Swimmers:
    """Return the columns that control reads and writes; stale when the tables grow."""
    return Swimmers(
        *(getattr(fish if hasattr(fish, name) else motor, name) for name in Swimmers._fields)
    )


@inlined
def half_tangent_angle(sine: float, cosine: float) -> float:
    """Return the angle [rad] of a sine and a cosine: to 0.01 rad up to a quarter turn either way,
    and a quarter turn's value beyond."""
    half = sine / (1.0 + cosine) if cosine > 0.0 else (1.0 if sine >= 0.0 else -1.0)
    return 2.0 * half / (1.0 + 0.28125 * half * half)


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


@inlined
def mood(seed: int, tick: int, identity: int) -> int:
    """Return the gear that a fish at leisure prefers to the one asked for: -1, 0 or 1 beside it.

    Each fish draws a new one every few seconds, at ticks of its own, so that no school swims in
    lockstep (6.1's recommendation to switch at random).
    """
    habit = chance.draw(seed, chance.SEGMENT, HABIT, identity)
    lasts = MOOD_TICKS + int(habit & np.uint64(MOOD_SPREAD - 1))
    started = (tick + int((habit >> np.uint64(16)) & np.uint64(0xFFFF))) // lasts
    drawn = chance.uniform(seed, chance.SEGMENT, started, identity)
    return -1 if drawn < 0.2 else (1 if drawn > 0.85 else 0)


@inlined
def _swim(gear: int, hurry: float, seed: int, tick: int, identity: int) -> int:
    """Return the pattern of the swim for a demanded gear: at leisure slow and medium may change."""
    if hurry < LEISURE and gear < Pattern.SWIM_FAST.value:
        gear = max(0, min(Pattern.SWIM_MEDIUM.value, gear + mood(seed, tick, identity)))
    return Pattern.SWIM_SLOW.value + max(0, min(Pattern.SWIM_FAST.value, gear))


@inlined
def _pick(
    segments: Int32s, gaits: Gaits, current: int, swim: int, yaw: float, held: int, hurry: float
) -> int:
    """Return the segment to play: a turn far from the direction, else the swim, not too soon."""
    rested = held >= REST_TICKS or (hurry > 0.5 and held >= URGENT_REST_TICKS)
    if gaits.pattern[current] >= Pattern.TURN_LEFT.value:
        left = gaits.pattern[current] == Pattern.TURN_LEFT.value
        on = yaw > TURN_DONE if left else yaw < -TURN_DONE
        return current if on else int(segments[swim])
    side = int(segments[Pattern.TURN_LEFT.value if yaw > 0.0 else Pattern.TURN_RIGHT.value])
    if side >= 0 and rested and abs(yaw) > max(TURN_FROM, TURN_SHARE * abs(gaits.turn[side])):
        return side
    return int(segments[swim]) if rested or hurry > 0.5 else current


@row
def control_rows(first: int, last: int, fish: Swimmers, gaits: Gaits, seed: int, tick: int) -> None:
    """Control the fishes of rows first to last - 1."""
    for i in range(first, last):
        r, g, steer = fish.rotation[i], fish.heading[i], fish.steer[i]
        hurry = max(0.0, min(1.0, fish.urgency[i]))
        current = fish.segment[i]
        yaw = _yaw_left(r, g, steer[2])
        swim = _swim(fish.gear[i], hurry, seed, tick, fish.id[i])
        segments = gaits.segment[fish.species[i]]
        wanted = _pick(segments, gaits, current, swim, yaw, fish.held[i], hurry)
        fish.wanted[i] = wanted if wanted >= 0 else current
        speed = min(1.0, abs(gaits.speed[current]) / FULL_STEERING_SPEED)
        share = LEAST_STEERING + (1.0 - LEAST_STEERING) * speed
        turning = gaits.pattern[current] >= Pattern.TURN_LEFT.value
        if turning or fish.warp_length[i] > 0:
            share *= GENTLE
        _steer(r, steer, yaw, _pitch_left(r, g), hurry, share)


@loop
def control_parallel(count: int, fish: Swimmers, gaits: Gaits, seed: int, tick: int) -> None:
    """Control `count` fishes on all threads, to the same bits as `control_rows`."""
    for chunk in numba.prange(CHUNKS):
        first, last = chunk * count // CHUNKS, (chunk + 1) * count // CHUNKS
        control_rows(first, last, fish, gaits, seed, tick)


class Control:
    """Reads heading, gear, urgency, segment, held, warp, rotation, species, id, the library and the
    clock; writes the wanted segment and steer."""

    def __init__(self, population: Population, library: RepertoireLibrary, clock: Clock) -> None:
        self.population = population
        self.clock = clock
        self.gaits = Gaits(*(getattr(library, name) for name in Gaits._fields))

    def __call__(self) -> None:
        """Choose segment and steering of every fish for this tick."""
        count = self.population.count
        fish = swimmers(self.population.fish, self.population.motor)
        seed, tick = int(self.clock.seed[0]), self.clock.now
        if count < PARALLEL_FROM:
            control_rows(0, count, fish, self.gaits, seed, tick)
        else:
            control_parallel(count, fish, self.gaits, seed, tick)
