"""Coral heads: the terrain's ellipsoids as living stone, grooved like a brain or lobed (issue: a richer reef).

They stay within `LUMPS` of the ellipsoid that fishes and submarine collide with, as rocks do.
"""

from collections.abc import Sequence
from typing import Final, Literal, TypeAlias

import numpy as np

from components.arrays import Float64s
from components.camera import Camera
from components.terrain import Terrain
from systems.view.draw_rocks import SIZES, stone_vertices
from systems.view.keep import named
from systems.view.program import load_program
from systems.view.stone import LUMPS, Sphere, waves
from systems.view.stone_meshes import StoneMeshes

Head: TypeAlias = Literal["brain_coral", "lobed_coral"]
HEADS: Final[tuple[Head, ...]] = ("brain_coral", "lobed_coral")
"""Looks as shaders/coral.frag.glsl numbers them."""
_LOBES: Final = {"brain_coral": 5, "lobed_coral": 34}
"""Lobes of a head."""


def lobes(rng: np.random.Generator, at: Float64s, number: int) -> Float64s:
    """Return the deviation at points of the unit sphere, (n, 3), of a head of so many lobes: -LUMPS to LUMPS, (n,)."""
    bent = at + 0.10 * waves(rng, at, 3.0)[:, None]
    bent /= np.linalg.norm(bent, axis=1, keepdims=True)
    step = np.arange(number) + 0.5
    high, turn = 1.0 - 2.0 * step / number, 2.399963 * step
    flat = np.sqrt(1.0 - high * high)
    middle = np.stack((flat * np.cos(turn), flat * np.sin(turn), high), axis=1)
    middle += rng.normal(0.0, 0.6 / np.sqrt(number), middle.shape)
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    # A lobe is a dome about its middle; between two of them lies a crease.
    near = np.sort(np.maximum(2.0 - 2.0 * (bent @ middle.T), 0.0), axis=1)[:, :2] * number / 4.0
    dome = 1.0 - np.minimum(near[:, 0], 1.6)
    crease = np.exp(-((np.sqrt(near[:, 1]) - np.sqrt(near[:, 0])) ** 2) / 0.02)
    shape = 0.052 * dome - 0.045 * crease + 0.016 * waves(rng, at, 2.0)
    return np.asarray(np.clip(shape, -0.999 * LUMPS, 0.999 * LUMPS))


def head_mesh(terrain: Terrain, rock: int, look: Head, sphere: Sphere, sun: Float64s) -> Float64s:
    """Return the vertices of a head, (n, 12): as draw_rocks.SIZES says, then its look and a chance of its own."""
    rng = np.random.default_rng((1812, rock))
    own = rng.random()
    vertices = stone_vertices(terrain, rock, sphere, lobes(rng, sphere.points, _LOBES[look]), sun)
    rest = np.tile((float(HEADS.index(look)), own), (len(vertices), 1))
    return np.concatenate((vertices, rest), axis=1)


class DrawCorals:
    """The coral heads of one terrain: `heads` says of rocks by index how they look; `sun` is the unit vector to it."""

    def __init__(
        self,
        terrain: Terrain,
        sun: tuple[float, float, float],
        heads: dict[int, Head],
        defines: Sequence[str] = (),
    ) -> None:
        light = np.asarray(sun)
        self._program = load_program("coral.vert.glsl", "coral.frag.glsl", defines)
        self._meshes = StoneMeshes(
            terrain,
            tuple(heads),
            (*SIZES, 2),
            lambda rock, sphere: head_mesh(terrain, rock, heads[rock], sphere, light),
            named(__file__, terrain, sun, tuple(heads.items())),
        )

    def draw(self, camera: Camera, aspect: float, height: int) -> None:
        """Draw the heads that `camera` sees on a target `height` [px] high."""
        from pyglet import gl

        gl.glUseProgram(self._program.id)
        self._meshes.draw(camera, aspect, height)

    def delete(self) -> None:
        """Free the mesh."""
        self._meshes.delete()
