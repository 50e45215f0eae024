"""Many lumps of stone at several levels of detail in one mesh: which of them are seen, and how finely (FINDINGS 8)."""

from collections.abc import Callable, Sequence
from typing import Final

import numpy as np

from components.arrays import Float64s, Int64s
from components.camera import Camera
from components.terrain import Terrain
from systems.view.draw_ground import boxes_seen
from systems.view.keep import kept
from systems.view.mesh import Mesh
from systems.view.stone import LUMPS, Sphere, split_octahedron

SUBDIVISIONS: Final = (5, 4, 3, 2)
"""How often the octahedron is split at each level of detail, the closest first."""
PIXELS: Final = (150.0, 55.0, 16.0)
"""[px] of radius on the target above which each level but the last is drawn."""


class StoneMeshes:
    """The meshes of some of a terrain's `rocks`, by index; `mesh_of` returns the vertices of one, (n, sum of sizes).

    They are kept under `name` (`systems.view.keep.named`).
    """

    def __init__(
        self,
        terrain: Terrain,
        rocks: Sequence[int],
        sizes: Sequence[int],
        mesh_of: Callable[[int, Sphere], Float64s],
        name: str,
    ) -> None:
        chosen = np.asarray(rocks, np.int64)
        self._reach = terrain.rock_radii[chosen].max(axis=1, initial=0.0) * (1.0 + LUMPS)
        self._centre = terrain.rock_centre[chosen]
        spheres = [split_octahedron(times) for times in SUBDIVISIONS]

        def vertices() -> list[Float64s]:
            meshes = [mesh_of(rock, sphere) for sphere in spheres for rock in rocks]
            return [np.concatenate([*meshes, np.zeros((1, sum(sizes)))]).astype(np.float32)]

        (drawn,) = kept(name, vertices)
        points = [len(sphere.points) for sphere in spheres for _ in rocks]
        bases = np.concatenate(([0], np.cumsum(points, dtype=np.int64)))[: len(points)]
        self._bases = bases.reshape(len(spheres), -1).astype(np.int32)
        lists = [sphere.sides.ravel() for sphere in spheres]
        self._counts = np.array([len(numbers) for numbers in lists], np.int32)
        self._starts = np.concatenate(([0], np.cumsum(self._counts[:-1], dtype=np.int64)))
        self._mesh = Mesh(
            drawn.astype(np.float32, copy=False), sizes, np.concatenate(lists).astype(np.uint32)
        )

    def draw(self, camera: Camera, aspect: float, height: int) -> None:
        """Draw those that `camera` sees on a target `height` [px] high with the program in use."""
        from pyglet import gl

        reach = self._reach[:, None]
        seen = boxes_seen(self._centre - reach, self._centre + reach, camera, aspect)
        far = np.linalg.norm(self._centre - camera.eye, axis=1)
        # The nearest first: what they hide is not shaded.
        order = np.argsort(far - self._reach)
        rows = order[seen[order]]
        level = self._levels(rows, far[rows], camera.slope, height)
        gl.glEnable(gl.GL_CULL_FACE)
        self._mesh.draw(self._counts[level], self._starts[level], self._bases[level, rows])
        gl.glDisable(gl.GL_CULL_FACE)

    def _levels(self, rows: Int64s, far: Float64s, slope: float, height: int) -> Int64s:
        pixels = self._reach[rows] / np.maximum(far, 0.1) * height / (2.0 * slope)
        return np.asarray((pixels[:, None] < PIXELS).sum(axis=1))

    def delete(self) -> None:
        """Free the mesh."""
        self._mesh.delete()
