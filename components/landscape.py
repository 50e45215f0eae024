"""How a level's ground is made: a shallow bowl with dunes that rises to the rim, and rocks listed
by squares.

The rim's slope shows the diver where the world ends before the cylinder of papers/000, 6.2 does.
"""

from collections.abc import Sequence
from math import ceil, sqrt
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.ground import Terrain, ground_height
from components.kernels import row
from components.noise import fade, octaves
from components.rocks import Rock

TOP: Final = -2.0
"""[m] z that no ground passes."""

_CELL: Final = 0.5
_LARGEST_GRID: Final = 256


@row
def _shape(
    height: Float64s,
    cell: float,
    radius: float,
    depth: float,
    relief: float,
    feature: float,
    seed: int,
) -> None:
    n = len(height)
    for i in range(n):
        for j in range(n):
            x, y = (i - 0.5 * (n - 1)) * cell, (j - 0.5 * (n - 1)) * cell
            out = sqrt(x * x + y * y) / radius
            rise = fade(min(max((out - 0.4) / 0.95, 0.0), 1.0))
            dunes = octaves(seed, x / feature, y / feature, 4) * 0.5 + 0.5
            z = -depth + rise * 0.9 * (depth + TOP) + relief * dunes * (1.0 - 0.4 * rise)
            height[i, j] = min(max(z, -depth), TOP)


def build_terrain(
    radius: float,
    depth: float,
    relief: float,
    feature: float,
    seed: int,
    rocks: Sequence[Rock] = (),
    homes: Sequence[tuple[float, ...]] = (),
    home_species: Sequence[int] = (),
) -> Terrain:
    """Return the world of a level: `relief` [m] is the dunes' height, `feature` [m] their size.

    Raise ValueError where radius, feature or a rock's radius is no positive number, or depth is
    under 3 m.
    """
    if not (radius > 0 and depth >= 3.0 and feature > 0 and relief >= 0):
        raise ValueError("a world needs radius > 0, depth >= 3 m, feature > 0 and relief >= 0")
    extent = 1.5 * float(radius)
    cells = min(_LARGEST_GRID, ceil(2.0 * extent / _CELL))
    cell = 2.0 * extent / cells
    height = np.empty((cells + 1, cells + 1))
    _shape(height, cell, float(radius), float(depth), float(relief), float(feature), int(seed))
    nothing, indices = np.zeros((0, 3)), np.zeros(0, np.int32)
    bare = Terrain(
        radius=float(radius),
        depth=float(depth),
        cell=cell,
        height=height,
        extent=extent,
        rock_centre=nothing,
        rock_radii=nothing,
        rock_axes=np.zeros((0, 2)),
        home=np.zeros((0, 4)),
        home_species=indices,
        rock_squares=1,
        rock_first=np.zeros(2, np.int32),
        rock_list=indices,
        roof=np.zeros(1),
        top=np.zeros(1),
    )
    return bare.with_rocks(rocks).with_homes(list(zip(homes, home_species, strict=True)))


def rock_on_ground(
    terrain: Terrain,
    at: tuple[float, float],
    radii: tuple[float, float, float],
    yaw_deg: float = 0.0,
    buried: float = 0.35,
) -> Rock:
    """Return the rock at (x, y) [m] that has the part `buried` of its height in the ground."""
    z = ground_height(terrain.height, terrain.extent, terrain.cell, at[0], at[1])
    return Rock((at[0], at[1], z + radii[2] * (1.0 - 2.0 * buried)), radii, yaw_deg)
