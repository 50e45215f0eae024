"""Lines of sight: whether rock or ground stands between two points (papers/000, 3.2; papers/004).

Along the line only those places are looked at that lie below the highest ground or rock of their square.
"""

from math import floor, sqrt

from components.arrays import Float64s
from components.ground import Terrain, ground_height, rock_square, to_rock
from components.kernels import inlined, row
from components.rocks import SQUARE


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
def _leaves(a: float, d: float, extent: float, at: float) -> float:
    """Return the share of a line from a to a + d [m] at which it leaves the row of squares that holds `at` [m]."""
    if d == 0.0:
        return 1.0
    square = floor((at + extent) / SQUARE)
    border = (square + 1.0 if d > 0.0 else square) * SQUARE - extent
    return (border - a) / d


@row
def in_sight(
    terrain: Terrain, ax: float, ay: float, az: float, bx: float, by: float, bz: float
) -> bool:
    """Return whether nothing of rock or ground stands between the points a and b [m].

    The line sinks one way: what it meets, it meets beside a sample that lies below the roof. A square over whose roof
    the line enters and leaves is passed at once.
    """
    dx, dy, dz = bx - ax, by - ay, bz - az
    steps = int(2.0 * sqrt(dx * dx + dy * dy) / terrain.cell) + 1
    tested, k = -1, 0
    while k <= steps:
        t = k / steps
        x, y, z = ax + t * dx, ay + t * dy, az + t * dz
        k += 1
        square = rock_square(terrain, x, y)
        if z > terrain.roof[square]:
            after = min(_leaves(ax, dx, terrain.extent, x), _leaves(ay, dy, terrain.extent, y), 1.0)
            if az + after * dz > terrain.roof[square]:
                k = max(k, int(after * steps) + 1)
            continue
        if z < ground_height(terrain.height, terrain.extent, terrain.cell, x, y):
            return False
        if square != tested:
            tested = square
            for at in range(terrain.rock_first[square], terrain.rock_first[square + 1]):
                if _rock_hides(terrain, terrain.rock_list[at], ax, ay, az, bx, by, bz):
                    return False
    return True


@row
def sees(terrain: Terrain, a: Float64s, b: Float64s) -> bool:
    """Return whether nothing of rock or ground stands between the points a and b [m], (3,) each."""
    return in_sight(terrain, a[0], a[1], a[2], b[0], b[1], b[2])
