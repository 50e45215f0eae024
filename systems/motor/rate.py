"""Rate: a swim played faster or slower than captured, between the gears' speeds (papers/000, section 4.2).

A tick then plays entries and shares of entries; `part` of the motor table is how far the last one is played.
Below the lowest rate strides shrink until the fish stands, and turn round until it backs.
"""

from typing import Final

from components.clock import TICK_SECONDS
from components.kernels import inlined, row
from components.motor import PACES, RATES
from components.rotation import Axes, Vector, axes_of, turned
from systems.motor.columns import Bodies, Motors
from systems.motor.go_on import go_on
from systems.motor.track import Track

BRAKING: Final = 1.5 * TICK_SECONDS
"""Most that the pace falls in a tick: a cruising fish stands after .7 s, as the muscle model's fins brake it."""

GAINING: Final = 1.5 * TICK_SECONDS
"""Most that the pace rises in a tick."""

SETTLING: Final = 0.02
"""[entries] a tick by which a fish back at pace 1 is early or late until it plays whole entries again."""


@inlined
def _advance_pace(i: int, motor: Motors, loops: bool) -> tuple[float, float, float]:
    """Bring the pace nearer to the throttle. Return it, where the tick ends, counted in entries from the start of the
    one begun, and the stride over the captured one.

    A turn is played as captured. A fish back at pace 1 settles onto whole entries first.
    """
    pace, part = motor.pace[i], motor.part[i]
    wanted = max(PACES[0], min(PACES[1], motor.throttle[i])) if loops else 1.0
    pace += max(-BRAKING, min(GAINING, wanted - pace))
    rate, stride = 1.0, pace
    if loops:
        rate = max(RATES[0], min(RATES[1], pace))
        stride = pace / rate
    end = part + rate
    if loops and pace == 1.0 and part != 0.0:
        early = part < 0.5
        pace = 1.0 - SETTLING if early else 1.0 + SETTLING
        end = max(1.0, end - SETTLING) if early else min(2.0, end + SETTLING)
    motor.pace[i] = pace
    return pace, end, stride


@inlined
def _in_axes(axes: Axes, u: float, v: float, w: float) -> tuple[float, float, float]:
    """Return the vector (u, v, w) of a frame whose `axes` are given."""
    x, y, z = axes
    return (
        x[0] * u + y[0] * v + z[0] * w,
        x[1] * u + y[1] * v + z[1] * w,
        x[2] * u + y[2] * v + z[2] * w,
    )


@row
def play_entries(
    segment: int, frame: int, begun: float, end: float, size: float, track: Track
) -> tuple[int, float, Vector, Axes]:
    """Play the segment from `begun` behind the start of entry `frame` to `end` behind it. Return entry and part there,
    the way and the axes there, both in the body's axes as they were.

    Of entry k the fish plays the share f of M = exp(w) as exp(f w), and that of t in the axes at the entry's start:
    shares add up to the whole entry, so that cycles close as captured at any rate.
    """
    first, length, loops = track.start[segment], track.length[segment], track.loops[segment]
    t, turn = track.translation[first + frame], track.turn[first + frame]
    share = min(end, 1.0) - begun
    far = size * share
    x, y, z = turned(t[0], t[1], t[2], -begun * turn[0], -begun * turn[1], -begun * turn[2])
    x, y, z = far * x, far * y, far * z
    axes = axes_of(share * turn[0], share * turn[1], share * turn[2])
    while end >= 1.0:
        end -= 1.0
        frame = 0 if frame + 1 == length and loops else frame + 1
        if end > 0.0:
            t, turn = track.translation[first + frame], track.turn[first + frame]
            share = min(end, 1.0)
            far = size * share
            u, v, w = _in_axes(axes, far * t[0], far * t[1], far * t[2])
            x, y, z = x + u, y + v, z + w
            a, b, c = axes_of(share * turn[0], share * turn[1], share * turn[2])
            axes = _in_axes(axes, *a), _in_axes(axes, *b), _in_axes(axes, *c)
    return frame, end, (x, y, z), axes


@row
def play_at_rate(i: int, fish: Bodies, motor: Motors, track: Track, weight: float) -> None:
    """Play what the pace asks for, shares of entries and all, as move plays one entry at pace 1."""
    segment, begun = motor.segment[i], motor.part[i]
    pace, end, stride = _advance_pace(i, motor, track.loops[segment] == 1)
    size = fish.length[i]
    frame, part, way, axes = play_entries(segment, motor.frame[i], begun, end, stride * size, track)
    offset, glide = pace * size * weight, motor.glide[i]
    x, y, z = way
    x, y, z = x + offset * glide[0], y + offset * glide[1], z + offset * glide[2]
    go_on(i, x, y, z, axes[0], axes[1], fish, motor)
    motor.last_part[i] = begun
    motor.frame[i], motor.part[i] = frame, part
    motor.shape_row[i] = track.start[segment] + (frame if frame > 0 else track.length[segment]) - 1
