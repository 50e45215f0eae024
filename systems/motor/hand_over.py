"""Hand-over between replay and live physics: shape, position, heading and speed are kept (papers/000, 9.1).

Physics takes over the nodes that replay shows, and their speeds from the ticks before and after. Replay takes the fish
back at the entry that it has kept in phase all along, and what differs of shape and speed fades as in any change of
segment, from the slot's row of the library.
"""

from math import floor, sqrt
from typing import Final

import numpy as np

from components.arrays import Float32s, Float64s
from components.body import NODES
from components.clock import TICKS_PER_SECOND
from components.kernels import row
from components.live import ENTERING, FREE, LEAVING, LIVE
from components.motor import PACES, RATES
from components.rotation import turned
from systems.motor.biomechanics import SUBSTEPS
from systems.motor.columns import Bodies, Motors
from systems.motor.live_step import Slots, rate_of
from systems.motor.strokes import Strokes
from systems.motor.track import Track, apart
from systems.motor.warp import SMOOTHSTEP_SLOPE

LEAVING_STEP: Final = 0.012
"""[BL] that the fading offset may move a node in a tick after a hand-back."""

LEAVING_MISS: Final = 0.009
"""[BL] by which a node may move otherwise than replay would move it, in the tick after a hand-back: its drift in the
tick before, and SWING of its distance."""

SWING: Final = 0.4
"""Half the square of how far [rad] the fastest beat comes in a tick: what swings about replay's place, and stands there
now, parts by so much of its swing in the next tick."""

SHORTEST_LEAVING: Final = 8
"""[ticks]"""

BEHIND: Final = 0.5 + 0.5 / SUBSTEPS
"""Share of the last tick's speed in the speed that physics begins with: it stands for the last substep."""


@row
def at_rate(i: int, motor: Motors) -> bool:
    """Return whether the fish swims with whole strides: muscles know no shorter ones, in which replay brakes."""
    fit: bool = RATES[0] <= motor.pace[i] <= RATES[1]
    return fit


@row
def may_enter(i: int, motor: Motors, track: Track, strokes: Strokes) -> bool:
    """Return whether the fish swims plainly: no turn, no warp, no braking."""
    segment = motor.segment[i]
    if track.loops[segment] == 0 or strokes.known[segment] == 0 or not at_rate(i, motor):
        return False
    settled: bool = motor.warp_length[i] == 0 and motor.last_warp_weight[i] == 0.0
    return settled


@row
def _between(shape: Float32s, after: Float32s, part: float, n: int, k: int) -> float:
    """Return a coordinate of a node that is shown `part` of the way between two shapes by planes, (3, 24)."""
    d = np.float64(shape[k, n])
    return d + part * (np.float64(after[k, n]) - d)


@row
def _along_world(
    r: Float64s, at: int, part: float, n: int, track: Track
) -> tuple[float, float, float]:
    """Return node `n`, `part` of the way from entry `at` to the next, along world axes [BL]."""
    shape, after = track.shape[at], track.shape[track.after[at]]
    u = _between(shape, after, part, n, 0)
    v = _between(shape, after, part, n, 1)
    w = _between(shape, after, part, n, 2)
    return (
        r[0, 0] * u + r[0, 1] * v + r[0, 2] * w,
        r[1, 0] * u + r[1, 1] * v + r[1, 2] * w,
        r[2, 0] * u + r[2, 1] * v + r[2, 2] * w,
    )


@row
def _way(i: int, fish: Bodies, k: int) -> float:
    """Return how far the fish went in the last tick along a world axis [BL]."""
    return float((fish.position[i, k] - fish.last_position[i, k]) / fish.length[i])


@row
def enter(s: int, i: int, slots: Slots, fish: Bodies, motor: Motors, track: Track) -> None:
    """Let slot `s` take the fish of row `i` as replay shows it: its nodes, and their speeds behind.

    Fine steering turns a live fish as a whole, so it has no part in the speeds.
    """
    at, last = motor.shape_row[i], motor.last_shape_row[i]
    p, q, v = motor.steer[i, 0], motor.steer[i, 1], motor.steer[i, 2]
    shape, after = track.shape[at], track.shape[track.after[at]]
    for n in range(NODES):
        for k in range(3):
            slots.shape[s, 0, n, k] = np.float32(_between(shape, after, motor.part[i], n, k))
        x, y, z = _along_world(fish.rotation[i], at, motor.part[i], n, track)
        a, b, c = _along_world(fish.last_rotation[i], last, motor.last_part[i], n, track)
        a, b, c = turned(a - _way(i, fish, 0), b - _way(i, fish, 1), c - _way(i, fish, 2), p, q, v)
        slots.nodes[s, n, 0], slots.nodes[s, n, 1], slots.nodes[s, n, 2] = x, y, z
        speed = slots.velocity[s, n]
        speed[0] = TICKS_PER_SECOND * (x - a)
        speed[1] = TICKS_PER_SECOND * (y - b)
        speed[2] = TICKS_PER_SECOND * (z - c)
    slots.stage[s] = ENTERING
    slots.offset[s] = 0.0


@row
def begin(s: int, i: int, slots: Slots, fish: Bodies, motor: Motors, track: Track) -> None:
    """Mix the speeds behind with those ahead, in the tick that replay has just played."""
    at, ahead = motor.shape_row[i], 1.0 - BEHIND
    p, q, v = motor.steer[i, 0], motor.steer[i, 1], motor.steer[i, 2]
    for n in range(NODES):
        x, y, z = _along_world(fish.rotation[i], at, motor.part[i], n, track)
        x, y, z = turned(x, y, z, -p, -q, -v)
        speed, now = slots.velocity[s, n], slots.nodes[s, n]
        x, y, z = x + _way(i, fish, 0), y + _way(i, fish, 1), z + _way(i, fish, 2)
        speed[0] = BEHIND * speed[0] + ahead * TICKS_PER_SECOND * (x - now[0])
        speed[1] = BEHIND * speed[1] + ahead * TICKS_PER_SECOND * (y - now[1])
        speed[2] = BEHIND * speed[2] + ahead * TICKS_PER_SECOND * (z - now[2])
    slots.stage[s] = LIVE


@row
def free(s: int, slots: Slots) -> None:
    """Let slot `s` hold no fish; nothing of the last one is left in the state."""
    slots.id[s], slots.stage[s], slots.entry[s], slots.side[s] = -1, FREE, 0, 0
    slots.shape[s] = np.float32(0.0)
    slots.nodes[s] = 0.0
    slots.velocity[s] = 0.0
    slots.travel[s] = 0.0
    slots.rest[s] = 0.0
    slots.offset[s] = 0.0


@row
def publish(s: int, first: int, slots: Slots, track: Track, shape: Float32s) -> None:
    """Copy the slot's two shapes to the library's rows from `first` on, and to its track."""
    for side in range(2):
        at = first + 2 * s + side
        for n in range(NODES):
            for k in range(3):
                shape[at, n, k] = slots.shape[s, side, n, k]
                track.shape[at, k, n] = slots.shape[s, side, n, k]
        for k in range(3):
            track.translation[at, k] = slots.travel[s, k]
        for pattern in range(track.match.shape[1]):
            track.match[at, pattern] = track.match[slots.entry[s], pattern]


@row
def shows(s: int, at: int, first: int) -> bool:
    """Return whether the library's row `at` is one of the slot's."""
    return first + 2 * s <= at < first + 2 * s + 2


@row
def show(s: int, i: int, first: int, slots: Slots, motor: Motors) -> None:
    """Let the fish of row `i` show the slot's shapes, without any offset."""
    motor.shape_row[i] = first + 2 * s + slots.side[s]
    motor.last_shape_row[i] = first + 2 * s + 1 - slots.side[s]
    motor.warp_weight[i] = motor.last_warp_weight[i] = 0.0


@row
def may_leave(s: int, i: int, slots: Slots, motor: Motors, track: Track) -> bool:
    """Return whether the fish of row `i` swims plainly at a steady pace, its nodes as fast as replay's."""
    segment, now = motor.segment[i], slots.side[s]
    wanted = max(PACES[0], min(PACES[1], motor.throttle[i]))
    if track.loops[segment] == 0 or motor.warp_length[i] != 0 or motor.pace[i] != wanted:
        return False
    entry, part = slots.entry[s], motor.part[i]
    place = entry - track.start[segment] + part - rate_of(i, motor)
    begun = floor(place)
    place -= begun
    before = track.start[segment] + begun % track.length[segment]
    for n in range(NODES):
        gap = drift = 0.0
        for k in range(3):
            shape, after = track.shape[entry], track.shape[track.after[entry]]
            way = slots.shape[s, now, n, k] - _between(shape, after, part, n, k)
            gap += way * way
            shape, after = track.shape[before], track.shape[track.after[before]]
            way -= slots.shape[s, 1 - now, n, k] - _between(shape, after, place, n, k)
            drift += way * way
        if sqrt(drift) + SWING * sqrt(gap) > LEAVING_MISS:
            return False
    return True


@row
def leave(s: int, i: int, first: int, slots: Slots, motor: Motors, track: Track) -> None:
    """Let the fish of row `i` replay from the next tick on; what differs of shape and speed fades."""
    entry, shown = slots.entry[s], first + 2 * s + slots.side[s]
    gap = sqrt(apart(track.shape[shown], track.shape[entry], False))
    motor.warp_from[i], motor.warp_part[i], motor.warp_to[i] = shown, 0.0, entry
    ticks = floor(gap * (SMOOTHSTEP_SLOPE / LEAVING_STEP)) + 1
    motor.warp_length[i] = max(SHORTEST_LEAVING, ticks)
    motor.warp_age[i] = 0
    for k in range(3):
        motor.glide[i, k] = slots.travel[s, k] - track.translation[entry, k]
    slots.stage[s] = LEAVING


@row
def left(s: int, i: int, slots: Slots, motor: Motors, track: Track) -> None:
    """Say of a fish that has left in this tick what it showed before it in replay's terms: its entry and all of the
    offset, so that a tick knows but one segment."""
    entry, part, now = slots.entry[s], motor.last_part[i], slots.side[s]
    shape, after = track.shape[entry], track.shape[track.after[entry]]
    for n in range(NODES):
        for k in range(3):
            ahead = _between(shape, after, part, n, k) - np.float64(shape[k, n])
            slots.shape[s, now, n, k] -= np.float32(ahead)
    motor.last_shape_row[i], motor.last_warp_weight[i] = entry, 1.0


@row
def fall_back(s: int, i: int, first: int, slots: Slots, motor: Motors, track: Track) -> None:
    """Let replay have a fish whose physics came to nothing this tick: it keeps its last shape, which then fades."""
    leave(s, i, first, slots, motor, track)
    motor.part[i], motor.warp_weight[i] = 0.0, 1.0
    motor.last_shape_row[i], motor.last_warp_weight[i] = motor.warp_from[i], 0.0


@row
def faded(s: int, i: int, first: int, motor: Motors) -> bool:
    """Return whether the fish of row `i` shows nothing of slot `s` any more, now or a tick ago."""
    if shows(s, motor.last_shape_row[i], first) or shows(s, motor.shape_row[i], first):
        return False
    weightless: bool = motor.warp_weight[i] == 0.0 and motor.last_warp_weight[i] == 0.0
    return not shows(s, motor.warp_from[i], first) or (weightless and motor.warp_length[i] == 0)
