"""Lines of sight: whether rock or ground stands between two points (papers/000, 3.2; papers/004).

Along the line only those places are looked at that lie below the highest ground or rock of their square.
"""

from math import ceil, floor, sqrt
from typing import Final

from components.arrays import Float64s
from components.ground import Terrain, ground_height, to_rock
from components.kernels import inlined, row
from components.rocks import SQUARE

_NEVER: Final = 1e30


@row
def _rock_hides(
    terrain: Terrain, rock: int, ax: float, ay: float, az: float, bx: float, by: float, bz: float
) -> bool:
    """Return whether the segment from a to b meets a rock, a unit sphere in its scaled axes."""
    u, v, w = to_rock(terrain, rock, ax, ay, az)
    s, t, q = to_rock(terrain, rock, bx, by, bz)
    ra, rb, rc = (
        terrain.rock_radii[rock, 0],
        terrain.rock_radii[rock, 1],
        terrain.rock_radii[rock, 2],
    )
    s, t, q = (s - u) / ra, (t - v) / rb, (q - w) / rc
    u, v, w = u / ra, v / rb, w / rc
    along = s * s + t * t + q * q
    near = min(max(-(u * s + v * t + w * q) / (along + 1e-30), 0.0), 1.0)
    u, v, w = u + near * s, v + near * t, w + near * q
    return bool(u * u + v * v + w * w < 1.0)


@inlined
def _borders(a: float, d: float, at: int, extent: float) -> tuple[float, float]:
    """Return the share of a line from a to a + d [m] at which it leaves the row of squares `at`, and that of a side.

    Both are beyond 1 for a line that stays in its row.
    """
    if d == 0.0:
        return _NEVER, _NEVER
    a_metre = 1.0 / d
    border = (at + 1 if d > 0.0 else at) * SQUARE - extent
    return (border - a) * a_metre, SQUARE * abs(a_metre)


@inlined
def _hidden_by_ground(
    terrain: Terrain, begin: float, end: float, top: float,
    ax: float, ay: float, az: float, dx: float, dy: float, dz: float,
) -> bool:  # fmt: skip
    """Return whether one of the line's places between the shares `begin` and `end` lies in the ground.

    They are half a cell of the height field apart.
    """
    share = 1.0 / (int(2.0 * sqrt(dx * dx + dy * dy) / terrain.cell) + 1)
    t = ceil(begin / share) * share
    while t <= end:
        z = az + t * dz
        if z <= top and z < ground_height(
            terrain.height, terrain.extent, terrain.cell, ax + t * dx, ay + t * dy
        ):
            return True
        t += share
    return False


@row
def in_sight(
    terrain: Terrain, ax: float, ay: float, az: float, bx: float, by: float, bz: float
) -> bool:
    """Return whether nothing of rock or ground stands between the points a and b [m].

    The line goes from square to square (Amanatides and Woo 1987); one below whose top it never dips is passed at once.
    """
    dx, dy, dz = bx - ax, by - ay, bz - az
    last, extent = terrain.rock_squares - 1, terrain.extent
    i, j = floor((ax + extent) / SQUARE), floor((ay + extent) / SQUARE)
    border_x, wide_x = _borders(ax, dx, i, extent)
    border_y, wide_y = _borders(ay, dy, j, extent)
    begin = 0.0
    while begin < 1.0:
        end = min(border_x, border_y, 1.0)
        square = min(max(i, 0), last) * (last + 1) + min(max(j, 0), last)
        top = terrain.top[square]
        if az + begin * dz <= top or az + end * dz <= top:
            if _hidden_by_ground(terrain, begin, end, top, ax, ay, az, dx, dy, dz):
                return False
            for at in range(terrain.rock_first[square], terrain.rock_first[square + 1]):
                if _rock_hides(terrain, terrain.rock_list[at], ax, ay, az, bx, by, bz):
                    return False
        begin = end
        if border_x <= border_y:
            i, border_x = i + (1 if dx > 0.0 else -1), border_x + wide_x
        else:
            j, border_y = j + (1 if dy > 0.0 else -1), border_y + wide_y
    return True


@row
def sees(terrain: Terrain, a: Float64s, b: Float64s) -> bool:
    """Return whether nothing of rock or ground stands between the points a and b [m], (3,) each."""
    return in_sight(terrain, a[0], a[1], a[2], b[0], b[1], b[2])
