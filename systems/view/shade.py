"""Light that rocks take from the sand around them: baked once per vertex, for soft contact and shadow."""

import numpy as np

from components.arrays import Float64s
from components.terrain import Terrain

CONTACT: float = 0.6
"""Distance from a rock, in its radii, within which the sand is darker."""


def in_rock_axes(points: Float64s, terrain: Terrain, rock: int) -> Float64s:
    """Return `points` [m], (n, 3), in units of the rock's radii along its axes, (n, 3)."""
    return turned(points - terrain.rock_centre[rock], terrain, rock)


def turned(vectors: Float64s, terrain: Terrain, rock: int) -> Float64s:
    """Return `vectors` [m], (..., 3), in units of the rock's radii along its axes."""
    c, s = terrain.rock_axes[rock]
    x = c * vectors[..., 0] + s * vectors[..., 1]
    y = c * vectors[..., 1] - s * vectors[..., 0]
    axes = np.stack((x, y, vectors[..., 2]), axis=-1)
    return np.asarray(axes / terrain.rock_radii[rock])


def ground_light(points: Float64s, terrain: Terrain, sun: Float64s) -> Float64s:
    """Return how much sky and how much sun reach `points` [m], (n, 3): 0 to 1, (n, 2)."""
    sky = np.ones(len(points))
    lit = np.ones(len(points))
    # A shadow is as long as the rock is high, slanted as the light is.
    slant = float(np.hypot(sun[0], sun[1]) / max(sun[2], 0.1))
    for rock in range(len(terrain.rock_radii)):
        reach = (1.7 + 2.4 * slant) * float(terrain.rock_radii[rock].max())
        away = np.abs(points[:, :2] - terrain.rock_centre[rock, :2]).max(axis=1)
        near = np.flatnonzero(away < reach)
        at = in_rock_axes(points[near], terrain, rock)
        gap = np.sqrt((at**2).sum(axis=1)) - 1.0
        sky[near] *= 0.35 + 0.65 * np.clip(gap / CONTACT, 0.0, 1.0) ** 0.7
        lit[near] *= _sunlit(at, turned(sun, terrain, rock))
    return np.stack((sky, lit), axis=1)


def _sunlit(at: Float64s, sun: Float64s) -> Float64s:
    """Return 1 where the ray towards the sun misses the unit sphere well, .15 where it enters it."""
    direction = sun / np.sqrt(sun @ sun)
    along = -(at @ direction)
    closest = np.sqrt(np.maximum((at**2).sum(axis=1) - along**2, 0.0))
    hidden = np.clip((1.12 - closest) / 0.3, 0.0, 1.0) * np.clip(along / 0.25 + 1.0, 0.0, 1.0)
    return np.asarray(1.0 - 0.85 * hidden)
