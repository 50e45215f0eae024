"""Avoiding fishes: leave the line on which the two would meet (papers/004); the submarine is one too."""

from math import sqrt
from typing import Final

from components.arrays import Float64s, Int64s
from components.kernels import inlined, row
from systems.mind.crowd import Crowd
from systems.mind.perceive import HORIZON

_SWERVE: Final = 1.2
_FOLLOWING: Final = 0.5
_CREEP: Final = 0.3
_ROOM: Final = 0.6
"""[BL] within which neighbours are in each other's way."""
_JOSTLE: Final = 2.0


@row
def _following(crowd: Crowd, me: int, other: int) -> float:
    """Return the throttle: a fish that comes up behind another slows to its speed."""
    alike = (
        crowd.hx[me] * crowd.hx[other]
        + crowd.hy[me] * crowd.hy[other]
        + crowd.hz[me] * crowd.hz[other]
    )
    ahead = (
        (crowd.x[other] - crowd.x[me]) * crowd.hx[me]
        + (crowd.y[other] - crowd.y[me]) * crowd.hy[me]
        + (crowd.z[other] - crowd.z[me]) * crowd.hz[me]
    )
    if alike < _FOLLOWING or ahead <= 0.0:
        return 1.0
    share: float = crowd.speed[other] / (crowd.speed[me] + 1e-9)
    return max(_CREEP, min(1.0, share))


@row
def avoid_fish(
    crowd: Crowd, me: int, other: int, when: float, out: Float64s
) -> tuple[int, float, float]:
    """Write the wanted direction, (3,); return gear, urgency, throttle. They meet in `when` seconds.

    A fish swerves from where the other will be; a dead heat is settled by the ids.
    """
    side = 1.0 if crowd.id[me] < crowd.id[other] else -1.0
    s, t = crowd.speed[other] * when, crowd.speed[me] * when
    x = crowd.x[me] - crowd.x[other] + t * crowd.hx[me] - s * crowd.hx[other]
    y = crowd.y[me] - crowd.y[other] + t * crowd.hy[me] - s * crowd.hy[other]
    z = crowd.z[me] - crowd.z[other] + t * crowd.hz[me] - s * crowd.hz[other]
    z += 0.1 * side * crowd.length[me]
    swerve = _SWERVE / (sqrt(x * x + y * y + z * z) + 1e-9)
    out[0] = crowd.hx[me] + swerve * x
    out[1] = crowd.hy[me] + swerve * y
    out[2] = crowd.hz[me] + swerve * z
    soon = 1.0 - when / HORIZON
    throttle = _following(crowd, me, other)
    gear = 2 if soon > 0.6 and throttle == 1.0 else 1
    return gear, 0.3 + 0.55 * soon, throttle


@row
def avoid_submarine(
    crowd: Crowd, me: int, away: Float64s, when: float, out: Float64s
) -> tuple[int, float, float]:
    """Write the wanted direction away from the submarine at the offset `away` [m], (3,)."""
    far = sqrt(away[0] * away[0] + away[1] * away[1] + away[2] * away[2]) + 1e-9
    soon = 1.0 - when / HORIZON
    push = (0.8 + soon) / far
    out[0] = 0.7 * crowd.hx[me] + push * away[0]
    out[1] = 0.7 * crowd.hy[me] + push * away[1]
    out[2] = 0.7 * crowd.hz[me] + 0.5 * push * away[2]
    return (2 if soon > 0.4 else 1), 0.3 + 0.5 * soon, 1.0


@inlined
def jostle(
    crowd: Crowd, me: int, near: Int64s, distance: Float64s, found: int, out: Float64s
) -> None:
    """Lean the wanted direction, (3,), away from neighbours who are too near for a body, whatever drives it.

    `near` are places in the crowd, `distance` squares [m^2], nearest first: `found` of each. Without this a school
    that flees, or is shut in by predators, is pressed into itself.
    """
    room = _ROOM * crowd.length[me]
    if found == 0 or distance[0] >= room * room:
        return
    x = y = z = 0.0
    for k in range(found):
        if distance[k] >= room * room:
            break
        other, push = near[k], 1.0 / (sqrt(distance[k]) + 1e-9) - 1.0 / room
        x += push * (crowd.x[me] - crowd.x[other])
        y += push * (crowd.y[me] - crowd.y[other])
        z += push * (crowd.z[me] - crowd.z[other])
    size = _JOSTLE * sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2])
    out[0], out[1], out[2] = out[0] + size * x, out[1] + size * y, out[2] + size * z
