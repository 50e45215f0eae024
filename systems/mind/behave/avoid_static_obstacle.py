"""Avoiding static obstacles: swing round by the way out that the antenna felt (papers/000, 6.2)."""

from typing import Final

from components.arrays import Float64s
from components.kernels import row

_HEAD_ON: Final = 0.15
_SIDESTEP: Final = 0.5


@row
def avoid_static_obstacle(
    hx: float, hy: float, hz: float, normal: Float64s, near: float, side: float, out: Float64s
) -> tuple[int, float]:
    """Write the wanted direction, (3,), for a fish that swims along h; return gear and urgency.

    It keeps what of its way runs along the obstacle and adds the way out, the more the nearer:
    `near` is 0 where alarm begins, 1 at contact. Head-on it turns to its `side`, 1 or -1.
    """
    nx, ny, nz = normal[0], normal[1], normal[2]
    into = hx * nx + hy * ny + hz * nz
    x, y, z = hx - into * nx, hy - into * ny, hz - into * nz
    if x * x + y * y + z * z < _HEAD_ON:
        x, y = x - side * _SIDESTEP * ny - 1e-3 * nz, y + side * _SIDESTEP * nx
    push = 0.3 + 0.9 * near
    out[0], out[1], out[2] = x + push * nx, y + push * ny, z + push * nz
    return 1, 0.3 + 0.7 * near
