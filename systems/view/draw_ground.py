"""The seabed: tiles of the terrain's height field, coarser with distance, dressed as sand (FINDINGS 8).

Tiles of 16 x 16 cells share one vertex buffer. A tile next to a coarser one moves the vertices of
that edge onto the coarser one's, so no crack opens. An apron carries the ground on into the haze.
"""

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float32s, Float64s, Int64s
from components.camera import Camera
from components.terrain import Terrain
from systems.view.keep import kept, named
from systems.view.mesh import Mesh
from systems.view.program import load_program
from systems.view.shade import ground_light

TILE: Final = 16
"""Cells along a side of a tile."""
LEVELS: Final = 4
"""Levels of detail: level l draws every 2**l-th grid point."""
FINE_REACH: Final = 14.0
"""[m] to which the full grid is drawn; each coarser level reaches twice as far."""
APRON: Final = 160.0
"""[m] by which the apron reaches beyond the height field."""


class Tiles(NamedTuple):
    """Where the height field's tiles lie, T a side; z ranges over the tile's points."""

    low: Float64s
    "[m] least x, y, z, (T, T, 3)"
    high: Float64s
    "[m] greatest x, y, z, (T, T, 3)"
    base: Int64s
    "vertex of the tile's least corner, (T, T)"


def padded(terrain: Terrain) -> Float64s:
    """Return the heights [m] with the last row and column repeated to fill whole tiles."""
    extra = -(len(terrain.height) - 1) % TILE
    return np.pad(terrain.height, ((0, extra), (0, extra)), mode="edge")


def grid_points(terrain: Terrain, height: Float64s) -> Float64s:
    """Return the points [m] of a padded height field, (n, n, 3)."""
    along = -terrain.extent + terrain.cell * np.arange(len(height))
    return np.stack((*np.meshgrid(along, along, indexing="ij"), height), axis=-1)


def grid_normals(height: Float64s, cell: float) -> Float64s:
    """Return the unit normals of the height field [m], (n, n, 3)."""
    slope_x, slope_y = np.gradient(height, cell)
    normal = np.stack((-slope_x, -slope_y, np.ones_like(height)), axis=-1)
    return np.asarray(normal / np.linalg.norm(normal, axis=-1, keepdims=True))


def tile_indices(side: int, level: int, coarser: int) -> NDArray[np.int64]:
    """Return a tile's triangles at `level`, in a grid of `side` points a side, (m,) vertex numbers.

    `coarser` has bit 0, 1, 2, 3 set where the neighbour at -x, +x, -y, +y is one level coarser.
    """
    step = 1 << level
    at = np.arange(0, TILE + 1, step)
    i, j = np.meshgrid(at, at, indexing="ij")
    coarse = 2 * step
    for bit, edge in enumerate((i == 0, i == TILE, j == 0, j == TILE)):
        if coarser >> bit & 1:
            moved = j if bit < 2 else i
            moved[edge] = moved[edge] // coarse * coarse
    corner = i * side + j
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    triangles = np.stack((a, b, c, a, c, d), axis=-1).reshape(-1, 3)
    real = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
    return np.asarray(triangles[real].ravel())


def tile_bounds(points: Float64s) -> Tiles:
    """Return where the tiles of a padded grid of `points` [m], (n, n, 3), lie."""
    number = (len(points) - 1) // TILE
    first = np.arange(number) * TILE
    span = np.arange(TILE + 1)
    rows = first[:, None] + span
    blocks = points[rows[:, None, :, None], rows[None, :, None, :]]
    base = first[:, None] * len(points) + first[None, :]
    return Tiles(blocks.min(axis=(2, 3)), blocks.max(axis=(2, 3)), base)


def tile_levels(low: Float64s, high: Float64s, eye: Float64s) -> Int64s:
    """Return each tile's level of detail for an eye at (3,) [m]; neighbours differ by one at most."""
    nearest = np.clip(eye, low, high)
    far = np.sqrt(((nearest - eye) ** 2).sum(axis=-1))
    doubled = np.ceil(np.log2(np.maximum(far, 1e-3) / FINE_REACH))
    level: Int64s = np.clip(doubled, 0, LEVELS - 1).astype(np.int64)
    for _ in range(LEVELS):
        around = np.pad(level, 1, mode="edge")
        least = np.minimum.reduce(
            (around[:-2, 1:-1], around[2:, 1:-1], around[1:-1, :-2], around[1:-1, 2:])
        )
        level = np.minimum(level, least + 1)
    return level


def coarser_sides(level: Int64s) -> Int64s:
    """Return for each tile the bits of the neighbours that are coarser, as `tile_indices` wants."""
    around = np.pad(level, 1, mode="edge")
    sides = (around[:-2, 1:-1], around[2:, 1:-1], around[1:-1, :-2], around[1:-1, 2:])
    bits = np.zeros_like(level)
    for bit, side in enumerate(sides):
        bits |= (side > level).astype(np.int64) << bit
    return np.asarray(bits)


def boxes_seen(low: Float64s, high: Float64s, camera: Camera, aspect: float) -> NDArray[np.bool_]:
    """Return which boxes, [m] (..., 3), touch the frustum of `camera`; some that miss it pass."""
    middle, half = (low + high) / 2 - camera.eye, (high - low) / 2
    seen = np.ones(middle.shape[:-1], np.bool_)
    for axis, slope in ((camera.right, camera.slope * aspect), (camera.up, camera.slope)):
        for sign in (1.0, -1.0):
            plane = camera.forward * slope + sign * axis
            seen &= middle @ plane + half @ np.abs(plane) > 0
    return seen


def apron(points: Float64s) -> tuple[Float64s, NDArray[np.int64]]:
    """Return the apron's outer points [m], (m, 3), and triangles; inner points are the grid's border.

    Triangles are vertex numbers, (k,), of the grid's n * n vertices followed by the outer points.
    """
    side = len(points)
    number = np.arange(side * side).reshape(side, side)
    ring = np.concatenate((number[:-1, 0], number[-1, :-1], number[:0:-1, -1], number[0, :0:-1]))
    border = points.reshape(-1, 3)[ring]
    middle = points.reshape(-1, 3)[:, :2].mean(axis=0)
    away = border[:, :2] - middle
    away = away / np.linalg.norm(away, axis=1, keepdims=True)
    outer = border.copy()
    outer[:, :2] += APRON * away
    inside, outside = ring, side * side + np.arange(len(ring))
    after_in, after_out = np.roll(inside, -1), np.roll(outside, -1)
    triangles = np.stack((inside, outside, after_out, inside, after_out, after_in), axis=-1)
    return outer, triangles.ravel()


class DrawGround:
    """The seabed of one terrain; `sun` is the unit vector towards the sun, for rocks' shadows."""

    def __init__(
        self, terrain: Terrain, sun: tuple[float, float, float], defines: Sequence[str] = ()
    ) -> None:
        self._program = load_program("ground.vert.glsl", "ground.frag.glsl", defines)
        height = padded(terrain)
        points = grid_points(terrain, height)
        self._tiles = tile_bounds(points)
        outer, border = apron(points)
        self._pieces = self._build(terrain, points, outer, border, sun)

    def _build(
        self,
        terrain: Terrain,
        points: Float64s,
        outer: Float64s,
        border: Int64s,
        sun: tuple[float, float, float],
    ) -> tuple[NDArray[np.int32], Int64s]:
        """Fill the mesh; return how many indices each (level, coarser) has and where they start."""
        side = len(points)
        normal = grid_normals(points[..., 2], terrain.cell).reshape(-1, 3)
        (light,) = kept(
            named(__file__, terrain, sun),
            lambda: [ground_light(points.reshape(-1, 3), terrain, np.asarray(sun))],
        )
        inner = np.concatenate((points.reshape(-1, 3), normal, light), axis=1)
        beyond = np.concatenate(
            (outer, np.tile((0.0, 0.0, 1.0, 1.0, 1.0), (len(outer), 1))), axis=1
        )
        lists = [tile_indices(side, n, bits) for n in range(LEVELS) for bits in range(16)]
        lists.append(border)
        counts = np.array([len(numbers) for numbers in lists], np.int32)
        starts = np.concatenate(([0], np.cumsum(counts[:-1], dtype=np.int64)))
        vertices: Float32s = np.concatenate((inner, beyond)).astype(np.float32)
        self._mesh = Mesh(vertices, (3, 3, 2), np.concatenate(lists).astype(np.uint32))
        return counts, starts

    def draw(self, camera: Camera, aspect: float) -> None:
        """Draw the tiles that `camera` sees; the frame block is bound."""
        from pyglet import gl

        low, high, base = self._tiles
        level = tile_levels(low, high, camera.eye)
        seen = boxes_seen(low, high, camera, aspect)
        kind = (level * 16 + coarser_sides(level))[seen]
        kind = np.concatenate((kind, [LEVELS * 16]))
        counts, starts = self._pieces
        gl.glUseProgram(self._program.id)
        gl.glEnable(gl.GL_CULL_FACE)
        self._mesh.draw(counts[kind], starts[kind], np.append(base[seen], 0).astype(np.int32))
        gl.glDisable(gl.GL_CULL_FACE)

    def delete(self) -> None:
        """Free the mesh."""
        self._mesh.delete()
