"""Soft dark rings on the sand about rocks and plants: finer than light baked into the seabed's grid can be."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from components.camera import Camera
from components.terrain import Terrain
from systems.view.draw_ground import boxes_seen
from systems.view.mesh import Mesh
from systems.view.program import load_program
from systems.view.shade import ground_under

AROUND: Final = 40
"""Points of a ring."""
RINGS: Final = (
    (0.80, 0.0, 0.72),
    (1.02, 0.0, 0.70),
    (1.10, 0.04, 0.36),
    (1.28, 0.10, 0.12),
    (1.6, 0.2, 0.0),
)
"""Rings from the inside: times the rock's outline on the sand, metres more, darkness there."""
FEET: Final = ((0.0, 1.0), (0.92, 1.0), (1.1, 0.55), (1.45, 0.18), (2.1, 0.0))
"""Rings of a plant from the inside: times the radius of its foot, part of its darkness there."""
FARTHEST: Final = 13.0
"""[m] to which they are drawn: the seabed has its full grid there."""

NO_FEET: Final = np.zeros((0, 4))


def ring_mesh(terrain: Terrain, rock: int, sun: Float64s) -> Float64s:
    """Return place [m] and darkness of the points of a rock's rings, (rings * AROUND, 4), ring after ring."""
    angle = np.arange(AROUND) * (2.0 * np.pi / AROUND)
    local = np.stack((np.cos(angle), np.sin(angle)), axis=1) * terrain.rock_radii[rock, :2]
    c, s = terrain.rock_axes[rock]
    outline = local @ np.array([[c, s], [-s, c]])
    centre = terrain.rock_centre[rock]
    scale = np.full(AROUND, 0.9)
    for _ in range(3):
        ground = ground_under(terrain, centre[:2] + outline * scale[:, None])
        sunk = (ground - centre[2]) / terrain.rock_radii[rock, 2]
        scale = np.sqrt(np.clip(1.0 - sunk * sunk, 0.0, 1.0))
    away = outline / np.linalg.norm(outline, axis=1, keepdims=True)
    # Wider on the side that the sun leaves dark.
    lee = 1.0 - 0.6 * away @ sun[:2]
    rings = []
    for times, metres, dark in RINGS:
        reach = 1.0 + (times - 1.0) * lee if times > 1.0 else np.full(AROUND, times)
        flat = centre[:2] + outline * (scale * reach)[:, None] + away * (metres * lee)[:, None]
        height = ground_under(terrain, flat) + 0.004
        rings.append(np.column_stack((flat, height, np.where(scale > 0.05, dark, 0.0))))
    return np.concatenate(rings)


def foot_mesh(terrain: Terrain, foot: Float64s, sun: Float64s) -> Float64s:
    """Return place [m] and darkness of a plant's rings, (rings * AROUND, 4); `foot` as DrawContact says."""
    angle = np.arange(AROUND) * (2.0 * np.pi / AROUND)
    away = np.stack((np.cos(angle), np.sin(angle)), axis=1)
    lee = 1.0 - 0.6 * away @ sun[:2]
    rings = []
    for times, part in FEET:
        reach = foot[2] * (1.0 + (times - 1.0) * lee if times > 1.0 else np.full(AROUND, times))
        flat = foot[:2] + away * reach[:, None]
        height = ground_under(terrain, flat) + 0.004
        rings.append(np.column_stack((flat, height, np.full(AROUND, part * foot[3]))))
    return np.concatenate(rings)


def ring_sides() -> NDArray[np.uint32]:
    """Return the triangles between the rings, (n,) vertex numbers, anticlockwise from above."""
    inner = np.arange((len(RINGS) - 1) * AROUND)
    beside = inner // AROUND * AROUND + (inner + 1) % AROUND
    outer, outer_beside = inner + AROUND, beside + AROUND
    sides = np.stack((inner, outer, outer_beside, inner, outer_beside, beside), axis=-1)
    return sides.ravel().astype(np.uint32)


class DrawContact:
    """The rings of all rocks of one terrain; `sun` is the unit vector towards the sun.

    `feet` are those of plants on the sand: place [m], radius [m], darkness, (n, 4).
    """

    def __init__(
        self, terrain: Terrain, sun: tuple[float, float, float], feet: Float64s = NO_FEET
    ) -> None:
        self._program = load_program("contact.vert.glsl", "contact.frag.glsl")
        rocks = range(len(terrain.rock_radii))
        rings = [ring_mesh(terrain, rock, np.asarray(sun)) for rock in rocks]
        rings += [foot_mesh(terrain, foot, np.asarray(sun)) for foot in feet]
        places = np.concatenate([*rings, np.zeros((1, 4))])
        self._low = np.array([ring[:, :3].min(axis=0) for ring in rings]).reshape(-1, 3)
        self._high = np.array([ring[:, :3].max(axis=0) for ring in rings]).reshape(-1, 3)
        sides = ring_sides()
        self._size, self._step = len(sides), len(RINGS) * AROUND
        self._mesh = Mesh(places.astype(np.float32), (3, 1), sides)

    def draw(self, camera: Camera, aspect: float) -> None:
        """Darken the sand that was drawn before about the rocks that `camera` sees."""
        from pyglet import gl

        nearest = np.clip(camera.eye, self._low, self._high)
        far = np.sqrt(((nearest - camera.eye) ** 2).sum(axis=1))
        rows = np.flatnonzero(boxes_seen(self._low, self._high, camera, aspect) & (far < FARTHEST))
        gl.glUseProgram(self._program.id)
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_ZERO, gl.GL_ONE_MINUS_SRC_ALPHA)
        gl.glEnable(gl.GL_POLYGON_OFFSET_FILL)
        gl.glPolygonOffset(-2.0, -8.0)
        gl.glDepthMask(False)
        pieces = np.full(len(rows), self._size, np.int32)
        bases = (rows * self._step).astype(np.int32)
        self._mesh.draw(pieces, np.zeros(len(rows), np.int64), bases)
        gl.glDepthMask(True)
        gl.glDisable(gl.GL_POLYGON_OFFSET_FILL)
        gl.glDisable(gl.GL_BLEND)

    def delete(self) -> None:
        """Free the mesh."""
        self._mesh.delete()
