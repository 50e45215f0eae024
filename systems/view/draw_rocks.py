"""Rocks: the terrain's ellipsoids as craggy stone, dressed in algae and coralline crust (FINDINGS 8).

The crags stay within `LUMPS` of the ellipsoid that fishes and submarine collide with.
"""

from collections.abc import Sequence
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.camera import Camera
from components.terrain import Terrain
from systems.view.keep import named
from systems.view.program import load_program
from systems.view.shade import ground_light, ground_under
from systems.view.stone import Sphere, crags, hollows
from systems.view.stone_meshes import StoneMeshes

SIZES: Final = (3, 3, 4)
"""Numbers in a vertex: position [m]; unit normal; height over the sand [m], hollow, sky and sun that reach it."""


def rock_mesh(terrain: Terrain, rock: int, sphere: Sphere, sun: Float64s) -> Float64s:
    """Return the vertices of a rock's points, (n, 10), as SIZES says."""
    shape = crags(np.random.default_rng((1809, rock)), sphere.points)
    return stone_vertices(terrain, rock, sphere, shape, sun)


def stone_vertices(
    terrain: Terrain, rock: int, sphere: Sphere, shape: Float64s, sun: Float64s
) -> Float64s:
    """Return the vertices of a rock whose surface deviates by `shape`, (n,) in radii, from its ellipsoid, (n, 10)."""
    local = sphere.points * (1.0 + shape)[:, None] * terrain.rock_radii[rock]
    c, s = terrain.rock_axes[rock]
    world = np.stack(
        (c * local[:, 0] - s * local[:, 1], s * local[:, 0] + c * local[:, 1], local[:, 2]), axis=1
    )
    points = world + terrain.rock_centre[rock]
    over = points[:, 2] - ground_under(terrain, points)
    hollow = hollows(sphere, shape) if len(points) > 500 else np.zeros(len(points))
    light = ground_light(points, terrain, sun, apart=rock)
    return np.concatenate(
        (points, normals(points, sphere), over[:, None], hollow[:, None], light), axis=1
    )


def normals(points: Float64s, sphere: Sphere) -> Float64s:
    """Return the unit normals of closed meshes of `points` [m], (..., n, 3), alike."""
    a, b, d = (points[..., corner, :] for corner in sphere.sides.T)
    face = np.cross(b - a, d - a)
    # All triangles of a point side by side: as many columns as the most that any point has.
    corner = sphere.sides.T.ravel()
    order = np.argsort(corner, kind="stable")
    number = np.bincount(corner)
    first = np.cumsum(number) - number
    summed = np.zeros_like(points)
    for k in range(number.max()):
        has = np.flatnonzero(number > k)
        summed[..., has, :] += face[..., order[first[has] + k] % len(sphere.sides), :]
    return np.asarray(summed / np.linalg.norm(summed, axis=-1, keepdims=True))


class DrawRocks:
    """Rocks of one terrain, all or those of the indices `rocks`; `sun` is the unit vector towards the sun."""

    def __init__(
        self,
        terrain: Terrain,
        sun: tuple[float, float, float],
        defines: Sequence[str] = (),
        rocks: Sequence[int] | None = None,
    ) -> None:
        chosen = range(len(terrain.rock_radii)) if rocks is None else rocks
        light = np.asarray(sun)
        self._program = load_program("rock.vert.glsl", "rock.frag.glsl", defines)
        self._meshes = StoneMeshes(
            terrain,
            chosen,
            SIZES,
            lambda rock, sphere: rock_mesh(terrain, rock, sphere, light),
            named(__file__, terrain, sun, tuple(chosen)),
        )

    def draw(self, camera: Camera, aspect: float, height: int) -> None:
        """Draw the rocks that `camera` sees on a target `height` [px] high."""
        from pyglet import gl

        gl.glUseProgram(self._program.id)
        self._meshes.draw(camera, aspect, height)

    def delete(self) -> None:
        """Free the mesh."""
        self._meshes.delete()
