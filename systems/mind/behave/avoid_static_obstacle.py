"""Avoiding static obstacles: swing round by the way out that the antenna felt (papers/000, 6.2).

Head-on a fish brakes, and backs up where it is too near to turn. To which side it swings it decides once.
"""

from typing import Final

from components.arrays import Float64s
from components.kernels import row

_HEAD_ON: Final = 0.15
_SIDESTEP: Final = 0.5
_OUT: Final = 0.3
_BRAKE_FROM: Final = 0.3
_BRAKE_OVER: Final = 0.5
_FACING: Final = 0.4
_SQUARELY: Final = 0.4
_TELLING: Final = 0.1
_CALM: Final = 0.3
_EDGE: Final = 0.55
"""Urgency at contact stays below that of a fast start: those are for dear life."""


@row
def choose_side(hx: float, hy: float, normal: Float64s, before: int, identity: int) -> int:
    """Return the side, 1 left of the way out `normal`, (3,), or -1, to which a fish that swims along h swings.

    It keeps to the side that it chose `before`, if not 0, and so gets out of corners. Head-on the id decides.
    """
    if before != 0:
        return before
    along = normal[0] * hy - normal[1] * hx
    if along * along < _TELLING * _TELLING:
        return 1 if identity & 1 else -1
    return 1 if along > 0.0 else -1


@row
def avoid_static_obstacle(
    hx: float, hy: float, hz: float, normal: Float64s, near: float, side: int, out: Float64s
) -> tuple[int, float, float]:
    """Write the wanted direction, (3,), for a fish that swims along h; return gear, urgency, throttle.

    It keeps what of its way runs along the obstacle, on its `side`, 1 or -1, and adds the way out, the unit
    `normal`, (3,), the more the nearer: `near` is 0 where alarm begins, 1 at contact. Where that lies on the other
    side, as in corners, it turns on as it did.
    """
    nx, ny, nz = normal[0], normal[1], normal[2]
    into = hx * nx + hy * ny + hz * nz
    x, y, z = hx - into * nx, hy - into * ny, hz - into * nz
    if x * x + y * y + z * z < _HEAD_ON:
        x, y = x - side * _SIDESTEP * ny - 1e-3 * nz, y + side * _SIDESTEP * nx
    push = 0.3 + 0.9 * near
    x, y, z = x + push * nx, y + push * ny, z + push * nz
    if into < 0.0 and side * (hx * y - hy * x) > 0.0:
        x, y = side * hy + _OUT * nx, -side * hx + _OUT * ny
    out[0], out[1], out[2] = x, y, z
    squarely = min(max((-into - _FACING) / _SQUARELY, 0.0), 1.0)
    closely = min(max((near - _BRAKE_FROM) / _BRAKE_OVER, 0.0), 1.0)
    return 1, _CALM + _EDGE * near, 1.0 - 1.2 * squarely * closely
