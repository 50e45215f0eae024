"""Rubble: small stones and bits of shell about the rocks and on the sand; seen only, nothing touches them.

One piece a rock and one a square of open sand. A piece holds its largest stones first: the farther it is, the fewer
are drawn.
"""

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s
from components.camera import Camera
from components.terrain import Terrain
from systems.view.draw_ground import boxes_seen
from systems.view.draw_rocks import SIZES, normals
from systems.view.keep import kept, named
from systems.view.mesh import Mesh
from systems.view.program import load_program
from systems.view.shade import ground_light, ground_under
from systems.view.stone import Sphere, crags, split_octahedron

A_PIECE: Final = 72
"""Stones in a piece."""
SQUARE: Final = 7.0
"""[m] side of a square of open sand that has a piece of its own."""
NEAR: Final = 4.5
"""[m] to which all stones of a piece are drawn."""
FARTHEST: Final = 24.0
"""[m] beyond which none is."""
_SHAPES: Final = 12
_SHELLS: Final = 0.22
"""Part of the stones that are bits of shell, flat and pale."""


class Stones(NamedTuple):
    """Where stones lie, p pieces of A_PIECE, the largest of each piece first."""

    place: Float64s
    "[m], on the sand, (p, A_PIECE, 3)"
    size: Float64s
    "half a stone's length [m], (p, A_PIECE)"


def lay(terrain: Terrain) -> Stones:
    """Return the stones of `terrain`: a piece for each rock, then one for each square of its sand."""
    rng = np.random.default_rng(1825)
    pieces = [_about_rock(rng, terrain, rock) for rock in range(len(terrain.rock_radii))]
    reach = min(terrain.radius, 30.0)
    along = np.arange(-reach, reach, SQUARE)
    pieces += [_on_sand(rng, np.array([x, y])) for x in along for y in along]
    place = np.stack([flat for flat, _ in pieces])
    size = np.stack([sizes for _, sizes in pieces])
    height = ground_under(terrain, place.reshape(-1, 2)).reshape(place.shape[:2])
    return Stones(np.concatenate((place, height[..., None]), axis=-1), size)


def _sizes(rng: np.random.Generator, largest: float) -> Float64s:
    return np.asarray(np.sort(np.minimum(0.016 / rng.random(A_PIECE) ** 0.62, largest))[::-1])


def _about_rock(rng: np.random.Generator, terrain: Terrain, rock: int) -> tuple[Float64s, Float64s]:
    """Return the places (A_PIECE, 2) and sizes of the stones about a rock's foot."""
    centre, radii = terrain.rock_centre[rock], terrain.rock_radii[rock]
    size = _sizes(rng, 0.16 * float(radii.min()) + 0.03)
    sunk = (ground_under(terrain, centre[None, :2])[0] - centre[2]) / radii[2]
    wide = np.sqrt(max(1.0 - sunk * sunk, 0.1))
    # In handfuls, as currents leave them.
    heap = rng.uniform(0, 2 * np.pi, 7)[rng.integers(0, 7, A_PIECE)]
    angle = np.where(rng.random(A_PIECE) < 0.7, heap, rng.uniform(0, 2 * np.pi, A_PIECE))
    angle = angle + 0.22 * rng.standard_normal(A_PIECE)
    gap = (
        wide * 1.0
        + (0.6 * size + rng.exponential(0.22, A_PIECE) * radii[:2].mean()) / radii[:2].mean()
    )
    local = np.stack((np.cos(angle), np.sin(angle)), axis=1) * gap[:, None] * radii[:2]
    c, s = terrain.rock_axes[rock]
    return centre[:2] + local @ np.array([[c, s], [-s, c]]), size


def _on_sand(rng: np.random.Generator, corner: Float64s) -> tuple[Float64s, Float64s]:
    """Return the places and sizes of the stones on a square of sand: mostly in a few drifts."""
    drift = rng.uniform(0, SQUARE, (4, 2))[rng.integers(0, 4, A_PIECE)]
    drift = drift + 0.5 * rng.standard_normal((A_PIECE, 2))
    loose = rng.random(A_PIECE) < 0.45
    place = np.where(loose[:, None], rng.uniform(0, SQUARE, (A_PIECE, 2)), drift)
    return corner + place, 0.75 * _sizes(rng, 0.075)


def stone_mesh(stones: Stones, terrain: Terrain, sphere: Sphere, sun: Float64s) -> Float64s:
    """Return all stones' vertices, stone after stone, as SIZES says; for a hollow it has the tone, 0 to 1."""
    rng = np.random.default_rng(1835)
    shapes = np.stack(
        [sphere.points * (1 + 2.2 * crags(rng, sphere.points))[:, None] for _ in range(_SHAPES)]
    )
    place, size = stones.place.reshape(-1, 3), stones.size.ravel()
    number = len(size)
    shell = (rng.random(number) < _SHELLS) & (size < 0.05)
    radii = np.stack(
        (np.ones(number), rng.uniform(0.6, 0.95, number), rng.uniform(0.4, 0.75, number)), axis=1
    )
    radii[shell, 2] = 0.2
    local = shapes[rng.integers(0, _SHAPES, number)] * (radii * size[:, None])[:, None, :]
    yaw = rng.uniform(0, 2 * np.pi, number)
    c, s = np.cos(yaw)[:, None], np.sin(yaw)[:, None]
    tilt = rng.uniform(-0.5, 0.5, number)[:, None]
    turned = np.stack(
        (
            c * local[..., 0] - s * local[..., 1],
            s * local[..., 0] + c * local[..., 1],
            local[..., 2] + tilt * local[..., 0],
        ),
        axis=-1,
    )
    lift = np.where(shell, 0.12, 0.18)[:, None] * size[:, None]
    points = turned + place[:, None, :]
    points[..., 2] += lift
    upright = normals(points, sphere)
    light = ground_light(place, terrain, sun)
    tone = np.where(shell, 1.0, 0.75 * rng.random(number))
    rest = np.broadcast_to(
        np.stack((tone, light[:, 0], light[:, 1]), axis=1)[:, None, :], (*points.shape[:2], 3)
    )
    over = (points[..., 2] - place[:, None, 2])[..., None]
    return np.concatenate((points, upright, over, rest), axis=-1).reshape(-1, sum(SIZES))


class DrawRubble:
    """The small stones of one terrain; `sun` is the unit vector towards the sun."""

    def __init__(
        self, terrain: Terrain, sun: tuple[float, float, float], defines: Sequence[str] = ()
    ) -> None:
        self._program = load_program("rock.vert.glsl", "rock.frag.glsl", ("RUBBLE", *defines))
        sphere = split_octahedron(1)

        def vertices() -> list[Float64s]:
            stones = lay(terrain)
            mesh = stone_mesh(stones, terrain, sphere, np.asarray(sun))
            place = stones.place
            return [mesh.astype(np.float32), place.min(axis=1) - 0.2, place.max(axis=1) + 0.2]

        mesh, low, high = kept(named(__file__, terrain, sun), vertices)
        self._low, self._high = low.astype(np.float64), high.astype(np.float64)
        first = np.arange(A_PIECE) * len(sphere.points)
        numbers = (first[:, None] + sphere.sides.ravel()[None, :]).ravel()
        self._stone = sphere.sides.size
        self._bases = (np.arange(len(self._low)) * A_PIECE * len(sphere.points)).astype(np.int32)
        self._mesh = Mesh(mesh.astype(np.float32, copy=False), SIZES, numbers.astype(np.uint32))

    def draw(self, camera: Camera, aspect: float) -> None:
        """Draw the stones that `camera` sees."""
        from pyglet import gl

        nearest = np.clip(camera.eye, self._low, self._high)
        far = np.sqrt(((nearest - camera.eye) ** 2).sum(axis=1))
        part = np.clip(NEAR / np.maximum(far, NEAR), 0.0, 1.0) ** 1.5
        number = np.ceil(A_PIECE * part).astype(np.int32)
        seen = boxes_seen(self._low, self._high, camera, aspect) & (far < FARTHEST)
        counts = number[seen] * self._stone
        gl.glUseProgram(self._program.id)
        gl.glEnable(gl.GL_CULL_FACE)
        self._mesh.draw(counts, np.zeros(len(counts), np.int64), self._bases[seen])
        gl.glDisable(gl.GL_CULL_FACE)

    def delete(self) -> None:
        """Free the mesh."""
        self._mesh.delete()
