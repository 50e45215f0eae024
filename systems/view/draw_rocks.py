"""Rocks: the terrain's ellipsoids as craggy stone, dressed in algae and coralline crust (FINDINGS 8).

The crags stay within `LUMPS` of the ellipsoid that fishes and submarine collide with.
"""

from collections.abc import Sequence
from typing import Final

import numpy as np

from components.arrays import Float64s, Int64s
from components.camera import Camera
from components.terrain import Terrain
from systems.view.draw_ground import boxes_seen
from systems.view.keep import kept, named
from systems.view.mesh import Mesh
from systems.view.program import load_program
from systems.view.shade import ground_light, ground_under
from systems.view.stone import LUMPS, Sphere, crags, hollows, split_octahedron

SUBDIVISIONS: Final = (5, 4, 3, 2)
"""How often the octahedron is split at each level of detail, the closest first."""
PIXELS: Final = (150.0, 55.0, 16.0)
"""[px] of radius on the target above which each level but the last is drawn."""
SIZES: Final = (3, 3, 4)
"""Numbers in a vertex: position [m]; unit normal; height over the sand [m], hollow, sky and sun that reach it."""


def rock_mesh(terrain: Terrain, rock: int, sphere: Sphere, sun: Float64s) -> Float64s:
    """Return the vertices of a rock's points, (n, 10), as SIZES says."""
    rng = np.random.default_rng((1809, rock))
    shape = crags(rng, sphere.points)
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
    """All rocks of one terrain; `sun` is the unit vector towards the sun, for their shadows."""

    def __init__(
        self, terrain: Terrain, sun: tuple[float, float, float], defines: Sequence[str] = ()
    ) -> None:
        self._program = load_program("rock.vert.glsl", "rock.frag.glsl", defines)
        self._reach = terrain.rock_radii.max(axis=1, initial=0.0) * (1.0 + LUMPS)
        self._centre = terrain.rock_centre
        spheres = [split_octahedron(times) for times in SUBDIVISIONS]
        rocks = range(len(terrain.rock_radii))

        def vertices() -> list[Float64s]:
            light = np.asarray(sun)
            meshes = [
                rock_mesh(terrain, rock, sphere, light) for sphere in spheres for rock in rocks
            ]
            return [np.concatenate([*meshes, np.zeros((1, sum(SIZES)))]).astype(np.float32)]

        (drawn,) = kept(named(__file__, terrain, sun), vertices)
        sizes = [len(sphere.points) for sphere in spheres for _ in rocks]
        bases = np.concatenate(([0], np.cumsum(sizes, dtype=np.int64)))[: len(sizes)]
        self._bases = bases.reshape(len(spheres), -1).astype(np.int32)
        lists = [sphere.sides.ravel() for sphere in spheres]
        self._counts = np.array([len(numbers) for numbers in lists], np.int32)
        self._starts = np.concatenate(([0], np.cumsum(self._counts[:-1], dtype=np.int64)))
        self._mesh = Mesh(
            drawn.astype(np.float32, copy=False), SIZES, np.concatenate(lists).astype(np.uint32)
        )

    def draw(self, camera: Camera, aspect: float, height: int) -> None:
        """Draw the rocks that `camera` sees on a target `height` [px] high."""
        from pyglet import gl

        reach = self._reach[:, None]
        seen = boxes_seen(self._centre - reach, self._centre + reach, camera, aspect)
        far = np.linalg.norm(self._centre - camera.eye, axis=1)
        # The nearest first: what they hide is not shaded.
        order = np.argsort(far - self._reach)
        rows = order[seen[order]]
        level = self._levels(rows, far[rows], camera.slope, height)
        gl.glUseProgram(self._program.id)
        gl.glEnable(gl.GL_CULL_FACE)
        self._mesh.draw(self._counts[level], self._starts[level], self._bases[level, rows])
        gl.glDisable(gl.GL_CULL_FACE)

    def _levels(self, rows: Int64s, far: Float64s, slope: float, height: int) -> Int64s:
        pixels = self._reach[rows] / np.maximum(far, 0.1) * height / (2.0 * slope)
        return np.asarray((pixels[:, None] < PIXELS).sum(axis=1))

    def delete(self) -> None:
        """Free the mesh."""
        self._mesh.delete()
