"""Warp: how a fish leaves one segment for another (papers/000, section 5.2 and appendix A).

The new segment plays on at once, and the difference of shape and velocity fades by a smoothstep; or, as the appendix is
printed, the fish stays in place while its shape runs straight to the new one's.
"""

from math import floor, sqrt
from typing import Final

from components.kernels import inlined, row
from components.motor import PACES
from components.repertoire import Pattern
from systems.motor.columns import Bodies, Motors
from systems.motor.track import Track, apart

WARP_STEP: Final = 0.03
"""[BL] that the fading offset may move a node in a tick: appendix A's M_max."""

SHORTEST_WARP: Final = 4
"""[ticks]"""

SMOOTHSTEP_SLOPE: Final = 1.5


@row
def _switch_at_rate(i: int, motor: Motors, track: Track, wanted: int, old: int, to: int) -> None:
    """Carry the speed of a fish that plays at another rate into the gear `wanted`, and the shape between two entries.

    What was shown is now the new segment's shape with the whole of the offset, so that a tick knows but one segment.
    """
    part, after = motor.part[i], track.after[old]
    motor.warp_part[i] = part
    motor.part[i] = motor.last_part[i] = 0.0
    motor.last_shape_row[i] = to
    motor.last_warp_weight[i] = 1.0
    leaving, ratio = motor.segment[i], 1.0
    if track.loops[leaving] == 1 and track.loops[wanted] == 1:
        pace = motor.pace[i]
        carried = pace * (track.speed[leaving] / track.speed[wanted])
        carried = max(PACES[0], min(PACES[1], carried))
        ratio = track.speed[wanted] / track.speed[leaving] if carried == 0.0 else pace / carried
        motor.pace[i] = carried
    for k in range(3):
        was = track.translation[old, k]
        was += part * (track.translation[after, k] - was)
        motor.glide[i, k] = ratio * was - track.translation[to, k]


@row
def switch(i: int, motor: Motors, track: Track, wanted: int) -> None:
    """Leave the segment being played for `wanted`: set up the warp that leads there."""
    old = motor.shape_row[i]
    part, after = motor.part[i], track.after[old]
    frame = track.match[after if part > 0.5 else old, track.pattern[wanted]]
    to = track.start[wanted] + frame
    gap = apart(track.shape[old], track.shape[to], False)
    if part > 0.0:
        gap = max(gap, apart(track.shape[after], track.shape[to], False))
    gap = sqrt(gap)
    motor.warp_from[i] = old
    motor.warp_part[i] = 0.0
    motor.warp_to[i] = to
    slope, shortest = (1.0, 1) if track.literal else (SMOOTHSTEP_SLOPE, SHORTEST_WARP)
    motor.warp_length[i] = max(shortest, floor(gap * (slope / WARP_STEP)) + 1)
    motor.warp_age[i] = 0
    for k in range(3):
        motor.glide[i, k] = track.translation[old, k] - track.translation[to, k]
    if motor.pace[i] != 1.0 or motor.throttle[i] != 1.0:
        _switch_at_rate(i, motor, track, wanted, old, to)
    motor.segment[i] = wanted
    motor.frame[i] = (frame + track.loops[wanted]) % track.length[wanted]
    motor.held[i] = 0


@inlined
def change(i: int, fish: Bodies, motor: Motors, track: Track) -> None:
    """Change segment where control asks for it or a turn has ended, unless a warp is under way."""
    segment, wanted = motor.segment[i], motor.wanted[i]
    ended = motor.frame[i] >= track.length[segment]
    if ended and wanted == segment:
        wanted = track.segment[fish.species[i], Pattern.SWIM_MEDIUM.value]
        motor.wanted[i] = wanted
    if wanted >= 0 and wanted != segment and motor.warp_length[i] == 0:
        switch(i, motor, track, wanted)
    elif ended:
        motor.frame[i] = track.length[segment] - 1


@inlined
def fade(i: int, motor: Motors) -> float:
    """Return the weight of this tick's offset, 1 when the warp begins to 0 at its end."""
    length = motor.warp_length[i]
    if length == 0:
        motor.warp_weight[i] = 0.0
        return 0.0
    age = motor.warp_age[i] + 1
    motor.warp_age[i] = age
    weight = 0.0
    if age < length:
        done = age / length
        weight = 1.0 - done * done * (3.0 - 2.0 * done)
    else:
        motor.warp_length[i] = 0
    motor.warp_weight[i] = weight
    return weight


@row
def wait(i: int, fish: Bodies, motor: Motors) -> None:
    """Glide as appendix A is printed: stay in place while the shape runs straight to the new segment's."""
    age = motor.warp_age[i] + 1
    motor.warp_age[i] = age
    motor.warp_weight[i] = 1.0 - age / motor.warp_length[i]
    if age == motor.warp_length[i]:
        motor.warp_length[i] = 0
        motor.warp_weight[i] = 0.0
    motor.shape_row[i] = motor.warp_to[i]
    for j in range(3):
        fish.last_position[i, j] = fish.position[i, j]
        for k in range(3):
            fish.last_rotation[i, j, k] = fish.rotation[i, j, k]
