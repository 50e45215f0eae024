"""Lines of sight: whether rock or ground stands between two points (papers/000, 3.2; papers/004).

Along the line only those places are looked at that lie below the highest ground or rock of their square.
"""

from math import sqrt

from components.arrays import Float64s
from components.ground import Terrain, ground_height, rock_square, to_rock
from components.kernels import row


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


@row
def in_sight(
    terrain: Terrain, ax: float, ay: float, az: float, bx: float, by: float, bz: float
) -> bool:
    """Return whether nothing of rock or ground stands between the points a and b [m].

    The line sinks one way: what it meets, it meets beside a sample that lies below the roof.
    """
    dx, dy, dz = bx - ax, by - ay, bz - az
    steps = int(2.0 * sqrt(dx * dx + dy * dy) / terrain.cell) + 1
    tested = -1
    for k in range(steps + 1):
        t = k / steps
        x, y, z = ax + t * dx, ay + t * dy, az + t * dz
        square = rock_square(terrain, x, y)
        if z > terrain.roof[square]:
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
