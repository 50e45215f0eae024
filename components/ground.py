"""The ground and the bounds of the world: a height field, implicit rocks, home points, a cylinder
and the surface.

Fishes and submarine test the same numbers that the view draws (papers/000, 6.2). Axes: z up, the
surface at z = 0. Every kernel here takes the whole `Terrain`, but for the ground's, which the view
calls with the height field alone.
"""

from collections.abc import Sequence
from math import ceil, floor, sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int32s
from components.kernels import inlined, row
from components.rocks import (
    ROCK_REACH,
    ROOF_REACH,
    SQUARE,
    Rock,
    list_rocks,
    pack_rocks,
    squares_around,
)

STRAY: Final = 1.2
"""[m] that fishes swim about their home point."""


class Terrain(NamedTuple):
    """The static world, as kernels read it. H grid points a side, K rocks, P home points."""

    radius: float
    "[m] of the cylinder that bounds the world, around the z axis"
    depth: float
    "[m] of the deepest ground, a positive number"
    cell: float
    "[m] between grid points of the height field"
    height: Float64s
    "[m] z of the ground at grid point (i, j): x = -extent + i cell, y = -extent + j cell, (H, H)"
    extent: float
    "[m] half the side of the height field; larger than the radius"
    rock_centre: Float64s
    "[m], (K, 3)"
    rock_radii: Float64s
    "[m] semi-axes of an ellipsoid, (K, 3)"
    rock_axes: Float64s
    "rotation of the rock about z: cosine and sine of its yaw, (K, 2)"
    home: Float64s
    "[m] home points, and how far about them their fishes stray, (P, 4)"
    home_species: Int32s
    "row in the species table of who lives there, (P,)"
    rock_squares: int
    "squares a side, from -extent"
    rock_first: Int32s
    "where the list of square i rock_squares + j begins, (rock_squares^2 + 1,)"
    rock_list: Int32s
    "rocks within `ROCK_REACH` of each square, square by square"
    roof: Float64s
    "[m] z above which neither ground nor rock is within `ROOF_REACH` of a square, (rock_squares^2,)"
    top: Float64s
    "[m] z above which neither ground nor rock is in a square, (rock_squares^2,)"

    def with_rocks(self, rocks: Sequence[Rock]) -> "Terrain":
        """Return this world with these rocks and no others. Raise ValueError for a radius <= 0."""
        centre, radii, axes = pack_rocks(rocks)
        side, first, listed = list_rocks(centre, radii, axes, self.extent)
        return self._replace(
            rock_centre=centre,
            rock_radii=radii,
            rock_axes=axes,
            rock_squares=side,
            rock_first=first,
            rock_list=listed,
            roof=self._highest(ROOF_REACH, side, centre, radii, axes),
            top=self._highest(0.0, side, centre, radii, axes),
        )

    def _highest(
        self, reach: float, side: int, centre: Float64s, radii: Float64s, axes: Float64s
    ) -> Float64s:
        """Return the highest ground or rock within `reach` [m] of each square, (side^2,)."""
        last = len(self.height) - 1
        # Squares at the border also serve what lies beyond the grid.
        strips = [
            slice(
                min(max(floor((i * SQUARE - reach) / self.cell), 0), last),
                min(ceil(((i + 1) * SQUARE + reach) / self.cell) + 1, last + 1),
            )
            for i in range(side)
        ]
        high = np.stack([self.height[strip].max(axis=0) for strip in strips])
        highest = np.stack([high[:, strip].max(axis=1) for strip in strips], axis=1)
        np.maximum(highest, -self.depth, out=highest)
        first, end = squares_around(centre, radii, axes, self.extent, side, reach)
        for (i, j), (k, m), top in zip(first, end + 1, centre[:, 2] + radii[:, 2], strict=True):
            np.maximum(highest[i:k, j:m], top, out=highest[i:k, j:m])
        return np.ascontiguousarray(highest).reshape(-1)

    def with_homes(
        self, homes: Sequence[tuple[tuple[float, ...], int]], stray: Sequence[float] = ()
    ) -> "Terrain":
        """Return this world with these home points: ((x, y) or (x, y, z) [m], species row) each.

        A point without z stands on the ground. `stray` [m]: how far about each its fishes swim, `STRAY` if not
        given.
        """
        points = np.full((len(homes), 4), STRAY)
        points[: len(stray), 3] = stray
        for point, (at, _) in zip(points, homes, strict=True):
            point[: len(at)] = at
            if len(at) == 2:
                point[2] = ground_height(self.height, self.extent, self.cell, point[0], point[1])
        return self._replace(
            home=points, home_species=np.array([kind for _, kind in homes], np.int32)
        )


@inlined
def ground(
    height: Float64s, extent: float, cell: float, x: float, y: float
) -> tuple[float, float, float]:
    """Return the ground's z [m] at (x, y), bilinear, and its slopes dz/dx and dz/dy."""
    last = height.shape[0] - 1
    u = min(max((x + extent) / cell, 0.0), last - 1e-9)
    v = min(max((y + extent) / cell, 0.0), last - 1e-9)
    i, j = int(u), int(v)
    u -= i
    v -= j
    a, b, c, d = height[i, j], height[i + 1, j], height[i, j + 1], height[i + 1, j + 1]
    low, high = a + u * (b - a), c + u * (d - c)
    dx = ((b - a) * (1.0 - v) + (d - c) * v) / cell
    return low + v * (high - low), dx, (high - low) / cell


@inlined
def ground_height(height: Float64s, extent: float, cell: float, x: float, y: float) -> float:
    """Return the ground's z [m] at (x, y): continuous, and the same that the view draws."""
    return ground(height, extent, cell, x, y)[0]


@row
def ground_normal(
    height: Float64s, extent: float, cell: float, x: float, y: float
) -> tuple[float, float, float]:
    """Return the ground's unit normal at (x, y), from central differences: continuous."""
    east = ground(height, extent, cell, x + cell, y)[0]
    west = ground(height, extent, cell, x - cell, y)[0]
    north = ground(height, extent, cell, x, y + cell)[0]
    south = ground(height, extent, cell, x, y - cell)[0]
    dx, dy = (east - west) / (2.0 * cell), (north - south) / (2.0 * cell)
    size = sqrt(dx * dx + dy * dy + 1.0)
    return -dx / size, -dy / size, 1.0 / size


@row
def rock_distance(terrain: Terrain, rock: int, x: float, y: float, z: float) -> float:
    """Return the distance [m] to a rock, negative inside: exact sign, approximate size."""
    return rock_clearance(terrain, rock, x, y, z)[0]


@inlined
def rock_clearance(
    terrain: Terrain, rock: int, x: float, y: float, z: float
) -> tuple[float, float, float, float]:
    """Return k0 (k0 - 1) / k1, with k0 = |p / r| and k1 = |p / r^2|, and its gradient's direction."""
    a, b, c = terrain.rock_radii[rock, 0], terrain.rock_radii[rock, 1], terrain.rock_radii[rock, 2]
    u, v, w = to_rock(terrain, rock, x, y, z)
    k0 = sqrt((u / a) * (u / a) + (v / b) * (v / b) + (w / c) * (w / c))
    gu, gv, gw = u / (a * a), v / (b * b), w / (c * c)
    k1 = sqrt(gu * gu + gv * gv + gw * gw)
    if k1 < 1e-12:
        return -min(a, min(b, c)), 0.0, 0.0, 1.0
    cosine, sine = terrain.rock_axes[rock, 0], terrain.rock_axes[rock, 1]
    nx, ny = (cosine * gu - sine * gv) / k1, (sine * gu + cosine * gv) / k1
    return k0 * (k0 - 1.0) / k1, nx, ny, gw / k1


@inlined
def to_rock(
    terrain: Terrain, rock: int, x: float, y: float, z: float
) -> tuple[float, float, float]:
    """Return a point in a rock's own axes [m], from its centre."""
    cosine, sine = terrain.rock_axes[rock, 0], terrain.rock_axes[rock, 1]
    dx, dy = x - terrain.rock_centre[rock, 0], y - terrain.rock_centre[rock, 1]
    return cosine * dx + sine * dy, cosine * dy - sine * dx, z - terrain.rock_centre[rock, 2]


@inlined
def rock_square(terrain: Terrain, x: float, y: float) -> int:
    """Return the square whose list of rocks serves (x, y)."""
    last = terrain.rock_squares - 1
    i = min(max(floor((x + terrain.extent) / SQUARE), 0), last)
    j = min(max(floor((y + terrain.extent) / SQUARE), 0), last)
    return i * terrain.rock_squares + j


@inlined
def beyond(terrain: Terrain, rock: int, x: float, y: float, z: float, within: float) -> bool:
    """Return whether a rock is surely farther than `within` [m], by the sphere around it."""
    dx, dy = x - terrain.rock_centre[rock, 0], y - terrain.rock_centre[rock, 1]
    dz = z - terrain.rock_centre[rock, 2]
    a, b, c = terrain.rock_radii[rock, 0], terrain.rock_radii[rock, 1], terrain.rock_radii[rock, 2]
    room = max(a, max(b, c)) + within
    return bool(dx * dx + dy * dy + dz * dz > room * room)


@inlined
def is_clear(terrain: Terrain, x: float, y: float, z: float, within: float) -> bool:
    """Say without a call that `clearance` is more than `within` [m]; False where that needs a closer look."""
    square, far = rock_square(terrain, x, y), terrain.radius - within
    if not (-z > within and far > 0.0 and x * x + y * y < far * far):
        return False
    if z - terrain.roof[square] > within and within <= ROOF_REACH:
        return True
    h, dx, dy = ground(terrain.height, terrain.extent, terrain.cell, x, y)
    if not (z - h) * (1.0 / sqrt(dx * dx + dy * dy + 1.0)) > within:
        return False
    for k in range(terrain.rock_first[square], terrain.rock_first[square + 1]):
        rock = terrain.rock_list[k]
        near = not beyond(terrain, rock, x, y, z, within)
        if near and not rock_clearance(terrain, rock, x, y, z)[0] > within:
            return False
    return True


@row
def clearance(
    terrain: Terrain, x: float, y: float, z: float, within: float = ROCK_REACH
) -> tuple[float, float, float, float]:
    """Return the distance [m] to the nearest of ground, surface, rim and rocks, and the way out.

    The way is a unit vector; the distance is negative inside. What is farther than `within` [m], at
    most `ROCK_REACH`, may be missed: then the distance is some number that is larger.
    """
    square, far = rock_square(terrain, x, y), terrain.radius - within
    free = min(z - terrain.roof[square], -z)
    if free > within and within <= ROOF_REACH and far > 0.0 and x * x + y * y < far * far:
        return free, 0.0, 0.0, 1.0
    h, dx, dy = ground(terrain.height, terrain.extent, terrain.cell, x, y)
    nz = 1.0 / sqrt(dx * dx + dy * dy + 1.0)
    best, bx, by, bz = (z - h) * nz, -dx * nz, -dy * nz, nz
    if -z < best:
        best, bx, by, bz = -z, 0.0, 0.0, -1.0
    if x * x + y * y > far * far or far < 0.0:
        out = sqrt(x * x + y * y)
        if terrain.radius - out < best:
            best, bx, by, bz = terrain.radius - out, -x / (out + 1e-12), -y / (out + 1e-12), 0.0
    for k in range(terrain.rock_first[square], terrain.rock_first[square + 1]):
        if not beyond(terrain, terrain.rock_list[k], x, y, z, within):
            d, nx, ny, nz = rock_clearance(terrain, terrain.rock_list[k], x, y, z)
            if d < best:
                best, bx, by, bz = d, nx, ny, nz
    return best, bx, by, bz
