"""Rate: a swim played faster or slower than captured, between the gears' speeds (papers/000, section 4.2).

A tick then plays entries and shares of entries; `part` of the motor table is how far the last one is played.
Below the lowest rate strides shrink until the fish stands, and turn round until it backs.
"""

from typing import Final

from components.arrays import Float64s
from components.clock import TICK_SECONDS
from components.kernels import inlined, row
from components.motor import PACES, RATES
from components.rotation import set_axes, turned
from systems.motor.balance import righting, roll
from systems.motor.columns import Bodies, Motors
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
def _turn_body(r: Float64s, u: float, v: float, w: float) -> None:
    """R <- R exp(u, v, w), a rotation vector [rad] in body axes."""
    ax, ay, az, bx, by, bz = r[0, 0], r[1, 0], r[2, 0], r[0, 1], r[1, 1], r[2, 1]
    p = ax * u + bx * v + r[0, 2] * w
    q = ay * u + by * v + r[1, 2] * w
    s = az * u + bz * v + r[2, 2] * w
    ax, ay, az = turned(ax, ay, az, p, q, s)
    bx, by, bz = turned(bx, by, bz, p, q, s)
    set_axes(r, ax, ay, az, bx, by, bz)


@inlined
def _shift_body(r: Float64s, o: Float64s, u: float, v: float, w: float) -> None:
    """o <- o + R (u, v, w) [m]."""
    for j in range(3):
        o[j] += r[j, 0] * u + r[j, 1] * v + r[j, 2] * w


@row
def play_entries(
    segment: int, frame: int, begun: float, end: float, size: float, track: Track,
    r: Float64s, o: Float64s,
) -> tuple[int, float]:  # fmt: skip
    """Play the segment from `begun` behind the start of entry `frame` to `end` behind it. Return entry and part there.

    Of entry k the fish plays the share f of M = exp(w) as exp(f w), and that of t in the axes at the entry's start:
    shares add up to the whole entry, so that cycles close as captured at any rate.
    """
    first, length, loops = track.start[segment], track.length[segment], track.loops[segment]
    while end > 0.0:
        t, turn = track.translation[first + frame], track.turn[first + frame]
        share = min(end, 1.0) - begun
        far = size * share
        u, v, w = turned(t[0], t[1], t[2], -begun * turn[0], -begun * turn[1], -begun * turn[2])
        _shift_body(r, o, far * u, far * v, far * w)
        _turn_body(r, share * turn[0], share * turn[1], share * turn[2])
        if end < 1.0:
            return frame, end
        end -= 1.0
        begun = 0.0
        frame = 0 if frame + 1 == length and loops else frame + 1
    return frame, 0.0


@inlined
def _balance(i: int, r: Float64s, motor: Motors) -> None:
    """Take this tick's part out of the mean roll, then steer."""
    c = righting(i, motor, roll(r[2, 0], r[2, 1], r[2, 2]))
    bx, by, bz = r[0, 1] - c * r[0, 2], r[1, 1] - c * r[1, 2], r[2, 1] - c * r[2, 2]
    p, q, s = motor.steer[i, 0], motor.steer[i, 1], motor.steer[i, 2]
    ax, ay, az = turned(r[0, 0], r[1, 0], r[2, 0], p, q, s)
    bx, by, bz = turned(bx, by, bz, p, q, s)
    set_axes(r, ax, ay, az, bx, by, bz)


@row
def play_at_rate(i: int, fish: Bodies, motor: Motors, track: Track, weight: float) -> None:
    """Play what the pace asks for, shares of entries and all, as move plays one entry at pace 1."""
    segment, begun = motor.segment[i], motor.part[i]
    pace, end, stride = _advance_pace(i, motor, track.loops[segment] == 1)
    r, o, size = fish.rotation[i], fish.position[i], fish.length[i]
    for j in range(3):
        fish.last_position[i, j] = o[j]
        for k in range(3):
            fish.last_rotation[i, j, k] = r[j, k]
    motor.last_part[i] = begun
    glide, offset = motor.glide[i], pace * size * weight
    _shift_body(r, o, offset * glide[0], offset * glide[1], offset * glide[2])
    frame, part = play_entries(segment, motor.frame[i], begun, end, stride * size, track, r, o)
    _balance(i, r, motor)
    motor.frame[i], motor.part[i] = frame, part
    motor.shape_row[i] = track.start[segment] + (frame if frame > 0 else track.length[segment]) - 1
