"""Avoiding static obstacles: swing round by the way out that the antenna felt (papers/000, 6.2).

Head-on a fish brakes, and backs up where it is too near to turn. To which side it swings it decides once.
"""

from typing import Final

from components.arrays import Float64s
from components.kernels import row

_HEAD_ON: Final = 0.15
_SIDESTEP: Final = 0.5
_BRAKE_FROM: Final = 0.3
_BRAKE_OVER: Final = 0.5
_FACING: Final = 0.4
_SQUARELY: Final = 0.4
_TELLING: Final = 0.1
_CALM: Final = 0.3
_EDGE: Final = 0.55
"""Urgency at contact stays below that of a fast start: those are for dear life."""


@row
def choose_side(
    hx: float, hy: float, normal: Float64s, demand: Float64s, again: bool, identity: int
) -> float:
    """Return the side, 1 or -1, to which a fish that swims along h swings round an obstacle.

    `again` says that it is at it already: then it keeps to the side of its `demand`, (3,), so that it gets out
    of corners. Head-on chance decides, by its id.
    """
    along = normal[0] * hy - normal[1] * hx
    if again:
        along = normal[0] * demand[1] - normal[1] * demand[0]
    if along * along < _TELLING * _TELLING:
        return 1.0 if identity & 1 else -1.0
    return 1.0 if along > 0.0 else -1.0


@row
def avoid_static_obstacle(
    hx: float, hy: float, hz: float, normal: Float64s, near: float, side: float, out: Float64s
) -> tuple[int, float, float]:
    """Write the wanted direction, (3,), for a fish that swims along h; return gear, urgency, throttle.

    It keeps what of its way runs along the obstacle, on its `side`, 1 or -1, and adds the way out, the unit
    `normal`, (3,), the more the nearer: `near` is 0 where alarm begins, 1 at contact.
    """
    nx, ny, nz = normal[0], normal[1], normal[2]
    into = hx * nx + hy * ny + hz * nz
    x, y, z = hx - into * nx, hy - into * ny, hz - into * nz
    wrong = side * (nx * y - ny * x)
    if x * x + y * y + z * z < _HEAD_ON:
        x, y = x - side * _SIDESTEP * ny - 1e-3 * nz, y + side * _SIDESTEP * nx
    elif wrong < 0.0:
        x, y = x + 2.0 * wrong * side * ny, y - 2.0 * wrong * side * nx
    push = 0.3 + 0.9 * near
    out[0], out[1], out[2] = x + push * nx, y + push * ny, z + push * nz
    squarely = min(max((-into - _FACING) / _SQUARELY, 0.0), 1.0)
    closely = min(max((near - _BRAKE_FROM) / _BRAKE_OVER, 0.0), 1.0)
    return 1, _CALM + _EDGE * near, 1.0 - 1.2 * squarely * closely
