"""The ground and the bounds of the world: a height field, implicit rocks, home points, a cylinder and the surface.

Fishes and submarine test the same numbers that the view draws (papers/000, 6.2). Axes: z up, the surface at z = 0.
"""

from dataclasses import dataclass
from typing import NamedTuple

from components.arrays import Float64s, Int32s


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
    "[m] home points, (P, 3)"
    home_species: Int32s
    "row in the species table of who lives there, (P,)"


@dataclass(frozen=True)
class Rock:
    """A rock as content gives it: an ellipsoid turned about z."""

    centre: tuple[float, float, float]
    radii: tuple[float, float, float]
    yaw_deg: float = 0.0
