"""Rocks: the terrain's ellipsoids with lumps and hollows, dressed in algae and coralline crust (FINDINGS 8).

The lumps stay within `LUMPS` of the ellipsoid that fishes and submarine collide with.
"""

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s, Int64s
from components.camera import Camera
from components.terrain import Terrain
from systems.view.draw_ground import boxes_seen
from systems.view.mesh import Mesh
from systems.view.program import load_program

LUMPS: Final = 0.08
"""Largest deviation from the ellipsoid, in radii."""
SUBDIVISIONS: Final = (4, 3, 2)
"""How often the octahedron is split at each level of detail, the closest first."""
PIXELS: Final = (110.0, 18.0)
"""[px] of radius on the target above which the first and the second level are drawn."""


def split_octahedron(times: int) -> tuple[Float64s, NDArray[np.int64]]:
    """Return the unit sphere's points, (n, 3), and outward triangles, (m, 3)."""
    points = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], float)
    sides = np.array(
        [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    )
    for _ in range(times):
        points, sides = _split(points, sides)
    return points, sides


def _split(points: Float64s, sides: NDArray[np.int64]) -> tuple[Float64s, NDArray[np.int64]]:
    edges = np.sort(np.concatenate((sides[:, [0, 1]], sides[:, [1, 2]], sides[:, [2, 0]])), axis=1)
    unique, number = np.unique(edges, axis=0, return_inverse=True)
    middle = points[unique].sum(axis=1)
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    ab, bc, ca = (number.reshape(3, -1) + len(points)).astype(np.int64)
    a, b, c = sides.T
    corners = ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))
    return np.concatenate((points, middle)), np.concatenate([np.stack(t, axis=1) for t in corners])


def lumps(rng: np.random.Generator, sphere: Float64s) -> Float64s:
    """Return the deviation at points of the unit sphere, (n, 3): -LUMPS to LUMPS, (n,)."""
    total = np.zeros(len(sphere))
    for frequency, weight in ((1.6, 1.0), (3.3, 0.7), (6.5, 0.4)):
        for _ in range(4):
            axis = rng.standard_normal(3)
            axis *= frequency / np.linalg.norm(axis)
            # A folded sine has creases, as weathered stone does.
            wave = np.sin(sphere @ axis + rng.uniform(0, np.pi))
            total += weight * (np.sqrt(wave**2 + 0.02) - 0.66)
    return np.asarray(LUMPS * np.tanh(-total))


def rock_mesh(terrain: Terrain, rock: int, sphere: Float64s, sides: NDArray[np.int64]) -> Float64s:
    """Return position [m], unit normal and height over the sand [m] of a rock's points, (n, 7)."""
    rng = np.random.default_rng((1809, rock))
    local = sphere * (1.0 + lumps(rng, sphere))[:, None] * terrain.rock_radii[rock]
    c, s = terrain.rock_axes[rock]
    world = np.stack(
        (c * local[:, 0] - s * local[:, 1], s * local[:, 0] + c * local[:, 1], local[:, 2]), axis=1
    )
    points = world + terrain.rock_centre[rock]
    a, b, d = points[sides[:, 0]], points[sides[:, 1]], points[sides[:, 2]]
    face = np.cross(b - a, d - a)
    normal = np.zeros_like(points)
    for corner in range(3):
        np.add.at(normal, sides[:, corner], face)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    over = points[:, 2] - ground_under(terrain, points)
    return np.concatenate((points, normal, over[:, None]), axis=1)


def ground_under(terrain: Terrain, points: Float64s) -> Float64s:
    """Return the ground's height [m] under `points` [m], (n, 3), between the grid's, (n,)."""
    last = len(terrain.height) - 2
    at = (points[:, :2] + terrain.extent) / terrain.cell
    low = np.clip(np.floor(at).astype(np.int64), 0, last)
    u, v = np.clip(at - low, 0.0, 1.0).T
    i, j = low.T
    h = terrain.height
    near = h[i, j] * (1 - u) + h[i + 1, j] * u
    return np.asarray(near * (1 - v) + (h[i, j + 1] * (1 - u) + h[i + 1, j + 1] * u) * v)


class DrawRocks:
    """All rocks of one terrain."""

    def __init__(self, terrain: Terrain, defines: Sequence[str] = ()) -> None:
        self._program = load_program("rock.vert.glsl", "rock.frag.glsl", defines)
        self._reach = terrain.rock_radii.max(axis=1, initial=0.0) * (1.0 + LUMPS)
        self._centre = terrain.rock_centre
        spheres = [split_octahedron(times) for times in SUBDIVISIONS]
        rocks = range(len(terrain.rock_radii))
        meshes = [rock_mesh(terrain, rock, *sphere) for sphere in spheres for rock in rocks]
        vertices = np.concatenate([*meshes, np.zeros((1, 7))]).astype(np.float32)
        sizes = [len(mesh) for mesh in meshes]
        bases = np.concatenate(([0], np.cumsum(sizes, dtype=np.int64)))[: len(sizes)]
        self._bases = bases.reshape(len(spheres), -1).astype(np.int32)
        lists = [sides.ravel() for _, sides in spheres]
        self._counts = np.array([len(numbers) for numbers in lists], np.int32)
        self._starts = np.concatenate(([0], np.cumsum(self._counts[:-1], dtype=np.int64)))
        self._mesh = Mesh(vertices, (3, 3, 1), np.concatenate(lists).astype(np.uint32))

    def draw(self, camera: Camera, aspect: float, height: int) -> None:
        """Draw the rocks that `camera` sees on a target `height` [px] high."""
        from pyglet import gl

        reach = self._reach[:, None]
        seen = boxes_seen(self._centre - reach, self._centre + reach, camera, aspect)
        rows = np.flatnonzero(seen)
        level = self._levels(rows, camera, height)
        gl.glUseProgram(self._program.id)
        gl.glEnable(gl.GL_CULL_FACE)
        self._mesh.draw(self._counts[level], self._starts[level], self._bases[level, rows])
        gl.glDisable(gl.GL_CULL_FACE)

    def _levels(self, rows: Int64s, camera: Camera, height: int) -> Int64s:
        far = np.linalg.norm(self._centre[rows] - camera.eye, axis=1)
        pixels = self._reach[rows] / np.maximum(far, 0.1) * height / (2.0 * camera.slope)
        return np.asarray((pixels < PIXELS[0]).astype(np.int64) + (pixels < PIXELS[1]))

    def delete(self) -> None:
        """Free the mesh."""
        self._mesh.delete()
