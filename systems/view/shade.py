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


def ground_under(terrain: Terrain, points: Float64s) -> Float64s:
    """Return the ground's height [m] under `points` [m], (n, 2 or 3), between the grid's, (n,)."""
    last = len(terrain.height) - 2
    at = (points[:, :2] + terrain.extent) / terrain.cell
    low = np.clip(np.floor(at).astype(np.int64), 0, last)
    u, v = np.clip(at - low, 0.0, 1.0).T
    i, j = low.T
    h = terrain.height
    near = h[i, j] * (1 - u) + h[i + 1, j] * u
    return np.asarray(near * (1 - v) + (h[i, j + 1] * (1 - u) + h[i + 1, j + 1] * u) * v)


def ground_light(points: Float64s, terrain: Terrain, sun: Float64s, apart: int = -1) -> Float64s:
    """Return how much sky and how much sun reach `points` [m], (n, 3), past the rocks: 0 to 1, (n, 2).

    The rock `apart` takes nothing away.
    """
    sky = np.ones(len(points))
    lit = np.ones(len(points))
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    # A shadow is as long as the rock is high, slanted as the light is.
    slant = float(np.hypot(sun[0], sun[1]) / max(sun[2], 0.1))
    for rock in range(len(terrain.rock_radii)):
        reach = (1.7 + 2.4 * slant) * float(terrain.rock_radii[rock].max())
        centre = terrain.rock_centre[rock, :2]
        if rock == apart or (np.maximum(low - centre, centre - high) > reach).any():
            continue
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
