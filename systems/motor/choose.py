"""Choice of the segment to play: swims by gear and mood, turns by how far aside the direction lies (papers/000, 6.1).

A gradual turn serves from 45 degrees on, a sharp one beyond 60 or in danger, a fast start for dear life beyond 70. What
is left of a turn is known at each of its entries, so that one which would lead past the direction is broken off.
"""

from typing import Final, NamedTuple

import numpy as np

from components import chance
from components.arrays import Float64s, Int8s, Int32s
from components.kernels import inlined
from components.repertoire import Pattern, RepertoireLibrary, turn_left_over

TURN_FROM: Final = 0.79
"""[rad] to the side, 45 degrees, from which a turn segment is worth while; below, a fish steers finely (6.2)."""

TURN_SHARE: Final = 0.6
"""... and the share of the segment's own turn from which it is."""

SHARP_FROM: Final = 1.05
"""[rad] to the side, 60 degrees, from which a turn is sharp; in danger every turn is."""

DANGER: Final = 0.5
"""Urgency above which a fish is in danger."""

START_FROM: Final = 1.22
"""[rad] to the side, 70 degrees, from which a fish in mortal danger makes a fast start ..."""

MORTAL: Final = 0.9
"""... and the urgency from which danger is."""

TURN_MISS: Final = 0.2
"""[rad] by which a turn segment's end may miss the direction more than breaking it off now would."""

REST_TICKS: Final = 24
"""[ticks] of swimming between two turns, and between two changes of gear, at leisure."""

URGENT_REST_TICKS: Final = 6

LEISURE: Final = 0.25
"""Urgency below which a fish may play another gear than it is asked for."""

MOOD_TICKS: Final = 150
"""[ticks] that a mood lasts at least."""

MOOD_SPREAD: Final = 128
"""[ticks] of which a share, drawn by the fish's id, comes on top; a power of two."""

HALF_TURN: Final = 3.141592653589793
"""[rad]"""


class Gaits(NamedTuple):
    """The columns of the library that the choice reads."""

    segment: Int32s
    pattern: Int8s
    speed: Float64s
    turn: Float64s
    start: Int32s
    length: Int32s
    left: Float64s
    "how far a segment turns from an entry on to its end [rad], 0 in swims, (E,)"


def gaits(library: RepertoireLibrary) -> Gaits:
    """Return the columns of `library` that the choice reads, and what is left of each turn."""
    left = np.zeros(len(library.rotation))
    for first, length, loops in zip(library.start, library.length, library.loops, strict=True):
        if not loops:
            span = slice(first, first + length)
            turn_left_over(np.ascontiguousarray(library.rotation[span]), left[span])
    return Gaits(
        library.segment,
        library.pattern,
        library.speed,
        library.turn,
        library.start,
        library.length,
        left,
    )


@inlined
def draw_mood(seed: int, tick: int, identity: int) -> tuple[int, int]:
    """Return the gear that a fish at leisure prefers to the one asked for, -1, 0 or 1 beside it, and until which tick.

    Each fish draws a new one every few seconds, at ticks of its own, so that no school swims in
    lockstep (6.1's recommendation to switch at random).
    """
    drawn = chance.draw(seed, chance.SEGMENT, tick, identity)
    until = tick + MOOD_TICKS + int(drawn & np.uint64(MOOD_SPREAD - 1))
    share = np.float64(drawn >> np.uint64(11)) * (1.0 / 9007199254740992.0)
    return -1 if share < 0.2 else (1 if share > 0.85 else 0), until


@inlined
def swim_of_gear(gear: int, hurry: float, free: bool, mood: int) -> int:
    """Return the pattern of the swim for a demanded gear: at leisure slow and medium may change, as the mood is.

    A fish that is not `free`, for it is asked for a speed of its own, keeps to the gear.
    """
    if free and hurry < LEISURE and gear < Pattern.SWIM_FAST.value:
        gear = max(0, min(Pattern.SWIM_MEDIUM.value, gear + mood))
    return Pattern.SWIM_SLOW.value + max(0, min(Pattern.SWIM_FAST.value, gear))


@inlined
def after(yaw: float, left: float) -> float:
    """Return the angle [rad] that is left to the direction when a turn will have turned by `left` more."""
    rest = yaw - left
    if rest > HALF_TURN:
        return rest - 2.0 * HALF_TURN
    return rest + 2.0 * HALF_TURN if rest < -HALF_TURN else rest


@inlined
def _worthwhile(gaits: Gaits, segment: int, far: float, least: float) -> bool:
    """Return whether a turn segment, if there is one, serves a direction so far to the side."""
    return segment >= 0 and far > max(least, TURN_SHARE * abs(gaits.turn[segment]))


@inlined
def _turn_for(segments: Int32s, gaits: Gaits, yaw: float, held: int, hurry: float) -> int:
    """Return the turn that a direction to the side asks for, -1 for none: the widest that serves."""
    aside, far = (0 if yaw > 0.0 else 1), abs(yaw)
    start = int(segments[Pattern.FAST_START_LEFT.value + aside])
    if hurry >= MORTAL and held >= REST_TICKS and _worthwhile(gaits, start, far, START_FROM):
        return start
    sharp = int(segments[Pattern.TURN_SHARP_LEFT.value + aside])
    if _worthwhile(gaits, sharp, far, TURN_FROM if hurry > DANGER else SHARP_FROM):
        return sharp
    turn = int(segments[Pattern.TURN_LEFT.value + aside])
    return turn if _worthwhile(gaits, turn, far, TURN_FROM) else -1


@inlined
def pick(
    segments: Int32s, gaits: Gaits, current: int, swim: int, yaw: float, frame: int, held: int,
    hurry: float,
) -> int:  # fmt: skip
    """Return the segment to play: a turn far from the direction, else the swim, not too soon.

    A turn is broken off where its end would miss the direction by more than it misses it now.
    """
    rested = held >= REST_TICKS or (hurry > DANGER and held >= URGENT_REST_TICKS)
    if gaits.pattern[current] >= Pattern.TURN_LEFT.value:
        if frame >= gaits.length[current]:
            return int(segments[swim])
        end = after(yaw, gaits.left[gaits.start[current] + frame])
        return current if abs(end) < abs(yaw) + TURN_MISS else int(segments[swim])
    turn = _turn_for(segments, gaits, yaw, held, hurry) if rested else -1
    if turn >= 0:
        return turn
    return int(segments[swim]) if rested or hurry > DANGER else current
