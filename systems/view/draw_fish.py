"""Draws all fishes: one record a fish, the rest is on the GPU (DESIGN 5; papers/000, 5.3, 7; FINDINGS 8).

Textures: the repertoires' shapes, the vertices' weights and the skins; none is wider than this OpenGL allows. Bodies
come first, then fins, blended, from the farthest to the nearest.
"""

from collections.abc import Sequence
from ctypes import byref, c_int, c_uint
from typing import Any, Final

import numpy as np

from components.arrays import Float32s
from components.body import NODES
from components.camera import Camera
from components.fish import Population
from components.repertoire import RepertoireLibrary
from components.species import Species
from systems.view.context import ensure_context
from systems.view.cull import Culling, view_of
from systems.view.fish_levels import WINDOW, Level, levels_for
from systems.view.fish_mesh import FishMesh
from systems.view.program import load_program, uniform_location
from systems.view.skin_canvas import SIZE
from systems.view.skin_texture import skin_texels

SHAPES_UNIT, WEIGHTS_UNIT, SKINS_UNIT = 0, 1, 2
_SMALLEST_MIP: Final = 5
_PASSES: Final = (
    ("CLOSE",),
    ("FAR",),
    ("CARD",),
    ("FINS", "CLOSE"),
)


def wrapped(texels: Float32s, widest: int) -> Float32s:
    """Return items of texels (n, k, 4), packed whole into rows of a texture: (rows, items a row * k, 4).

    Raise ValueError where they do not fit into `widest` x `widest` texels.
    """
    count, size, _ = texels.shape
    a_row = widest // size
    rows = max(1, -(-count // a_row))
    if rows > widest:
        raise ValueError(f"{count} items of {size} texels do not fit a {widest} x {widest} texture")
    padded = np.zeros((rows * a_row, size, 4), np.float32)
    padded[:count] = texels
    return padded.reshape(rows, a_row * size, 4)


class DrawFish:
    """Draws a population's fishes. Reads its fish and motor tables and the library; writes to the GPU only.

    `species` in the order of their rows; `library` holds their shapes. `draw` expects the `Frame` block up to date.
    """

    def __init__(self, species: Sequence[Species], library: RepertoireLibrary) -> None:
        ensure_context()
        from pyglet import gl

        widest = c_int()
        gl.glGetIntegerv(gl.GL_MAX_TEXTURE_SIZE, byref(widest))
        self.cull = Culling(np.array([s.skin.shine for s in species]), library.after)
        self._textures = (c_uint * 3)()
        gl.glGenTextures(3, self._textures)
        self.widest = widest.value
        side = min(self.widest, 4096)
        self._library = library
        levels = [levels_for(s.body) for s in species]
        self._upload_shapes(library, side)
        self._upload_weights(levels, side)
        self._upload_skins(species)
        self._programs = [self._program(defines, side) for defines in _PASSES]
        self._meshes = [FishMesh(level, start) for level, start in self._starts(levels[0])]

    def draw(
        self,
        population: Population,
        camera: Camera,
        alpha: float,
        seconds: float,
        target_height: float,
        visibility: float,
        aspect: float | None = None,
        fins: bool = True,
    ) -> None:
        """Draw what `camera` sees into the bound framebuffer, `alpha` of the way from the last tick to now.

        `seconds` moves the paired fins; `visibility` [m] is the water's. Without `aspect` the viewport's is taken. Fins
        let through what was drawn before them: where the water follows, leave `fins` out and call `draw_fins` after it.
        """
        from pyglet import gl

        self.select(population, camera, alpha, seconds, target_height, visibility, aspect)
        if not self.cull.counts.any():
            return
        self.bind_textures()
        self._upload_spare()
        for level, mesh in enumerate(self._meshes):
            mesh.upload(self.cull.records(level))
        gl.glEnable(gl.GL_DEPTH_TEST)
        gl.glDisable(gl.GL_BLEND)
        gl.glEnable(gl.GL_CULL_FACE)
        for level in (0, 1):
            self._draw_pass(level, level, fins=False)
        gl.glDisable(gl.GL_CULL_FACE)
        self._draw_pass(2, 2, fins=False)
        self._finish()
        if fins:
            self.draw_fins()

    def select(
        self,
        population: Population,
        camera: Camera,
        alpha: float,
        seconds: float,
        target_height: float,
        visibility: float,
        aspect: float | None = None,
    ) -> None:
        """Choose what `camera` sees, at which level of detail, and write the records: `draw` without drawing."""
        shape = _viewport_aspect() if aspect is None else aspect
        self.cull(population, view_of(camera, target_height, shape, visibility), alpha, seconds)

    def draw_fins(self) -> None:
        """Draw the blended fins of the fishes that `draw` drew last, from the farthest to the nearest."""
        from pyglet import gl

        if not self.cull.counts[:2].any():
            return
        self.bind_textures()
        gl.glEnable(gl.GL_DEPTH_TEST)
        gl.glDisable(gl.GL_CULL_FACE)
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
        gl.glDepthMask(gl.GL_FALSE)
        for level in (1, 0):
            self._draw_pass(level, 3, fins=True)
        gl.glDepthMask(gl.GL_TRUE)
        gl.glDisable(gl.GL_BLEND)
        self._finish()

    @staticmethod
    def _finish() -> None:
        from pyglet import gl

        gl.glBindVertexArray(0)
        gl.glUseProgram(0)

    def delete(self) -> None:
        """Free textures, buffers and programs."""
        from pyglet import gl

        gl.glDeleteTextures(3, self._textures)
        for mesh in self._meshes:
            mesh.delete()
        for program in self._programs:
            program.delete()

    def _draw_pass(self, level: int, program: int, fins: bool) -> None:
        from pyglet import gl

        if self.cull.counts[level]:
            gl.glUseProgram(self._programs[program].id)
            self._meshes[level].draw(fins)

    def bind_textures(self) -> None:
        """Bind shapes, weights and skins to their units, 0 to 2."""
        from pyglet import gl

        targets = (gl.GL_TEXTURE_2D, gl.GL_TEXTURE_2D, gl.GL_TEXTURE_2D_ARRAY)
        for unit, (target, texture) in enumerate(zip(targets, self._textures, strict=True)):
            gl.glActiveTexture(gl.GL_TEXTURE0 + unit)
            gl.glBindTexture(target, texture)
        gl.glActiveTexture(gl.GL_TEXTURE0)

    def _program(self, defines: Sequence[str], side: int) -> Any:
        from pyglet import gl

        sizes = (f"SHAPES_A_ROW {side // NODES}", f"VERTICES_A_ROW {side // WINDOW}")
        program = load_program("fish.vert.glsl", "fish.frag.glsl", (*defines, *sizes))
        gl.glUseProgram(program.id)
        values = {
            "shapes": SHAPES_UNIT,
            "weights": WEIGHTS_UNIT,
            "skins": SKINS_UNIT,
            "vertices": self.vertices,
        }
        for name, value in values.items():
            gl.glUniform1i(uniform_location(program, name), value)
        gl.glUseProgram(0)
        return program

    def _upload_shapes(self, library: RepertoireLibrary, side: int) -> None:
        shape = library.shape
        texels = np.zeros((max(len(shape), 1), NODES, 4), np.float32)
        texels[: len(shape), :, :3] = shape
        texels[: len(shape), :, 3] = library.after[:, None]
        self._shapes = wrapped(texels, side)
        self._upload_table(SHAPES_UNIT, self._shapes)

    def _upload_spare(self) -> None:
        """Bring the rows of the texture that hold the library's spare shapes up to date: fishes in live physics."""
        from pyglet import gl

        spare, shape = self._library.spare, self._library.shape
        if not spare:
            return
        a_row = self._shapes.shape[1] // NODES
        first = len(shape) - spare
        top = first // a_row
        changed = self._shapes[top:]
        items = changed.reshape(-1, NODES, 4)
        items[first - top * a_row : len(shape) - top * a_row, :, :3] = shape[first:]
        gl.glActiveTexture(gl.GL_TEXTURE0 + SHAPES_UNIT)
        gl.glTexSubImage2D(
            *(gl.GL_TEXTURE_2D, 0, 0, top, changed.shape[1], changed.shape[0]),
            *(gl.GL_RGBA, gl.GL_FLOAT, changed.ctypes.data),
        )

    def _upload_weights(self, levels: Sequence[Sequence[Level]], side: int) -> None:
        tables = [level.table for species in levels for level in species]
        self.vertices = sum(len(level.table) for level in levels[0])
        self._upload_table(WEIGHTS_UNIT, wrapped(np.concatenate(tables), side))

    def _upload_table(self, unit: int, texels: Float32s) -> None:
        from pyglet import gl

        rows, columns, _ = texels.shape
        gl.glActiveTexture(gl.GL_TEXTURE0 + unit)
        gl.glBindTexture(gl.GL_TEXTURE_2D, self._textures[unit])
        gl.glTexImage2D(
            *(gl.GL_TEXTURE_2D, 0, gl.GL_RGBA32F, columns, rows, 0, gl.GL_RGBA, gl.GL_FLOAT),
            np.ascontiguousarray(texels).ctypes.data,
        )
        for name in (gl.GL_TEXTURE_MIN_FILTER, gl.GL_TEXTURE_MAG_FILTER):
            gl.glTexParameteri(gl.GL_TEXTURE_2D, name, gl.GL_NEAREST)

    def _upload_skins(self, species: Sequence[Species]) -> None:
        from pyglet import gl

        target = gl.GL_TEXTURE_2D_ARRAY
        picture = np.stack([skin_texels(s.skin, s.body) for s in species])
        gl.glActiveTexture(gl.GL_TEXTURE0 + SKINS_UNIT)
        gl.glBindTexture(target, self._textures[SKINS_UNIT])
        gl.glTexImage3D(
            *(target, 0, gl.GL_RGBA8, SIZE, SIZE, len(species), 0, gl.GL_RGBA),
            *(gl.GL_UNSIGNED_BYTE, picture.ctypes.data),
        )
        gl.glTexParameteri(target, gl.GL_TEXTURE_MAX_LEVEL, _SMALLEST_MIP)
        gl.glTexParameteri(target, gl.GL_TEXTURE_MIN_FILTER, gl.GL_LINEAR_MIPMAP_LINEAR)
        gl.glTexParameteri(target, gl.GL_TEXTURE_MAG_FILTER, gl.GL_LINEAR)
        for name in (gl.GL_TEXTURE_WRAP_S, gl.GL_TEXTURE_WRAP_T):
            gl.glTexParameteri(target, name, gl.GL_CLAMP_TO_EDGE)
        gl.glGenerateMipmap(target)

    @staticmethod
    def _starts(levels: Sequence[Level]) -> list[tuple[Level, int]]:
        starts = np.cumsum([0, *(len(level.table) for level in levels)])
        return list(zip(levels, starts[:-1].tolist(), strict=True))


def _viewport_aspect() -> float:
    from pyglet import gl

    viewport = (c_int * 4)()
    gl.glGetIntegerv(gl.GL_VIEWPORT, viewport)
    return float(viewport[2]) / max(float(viewport[3]), 1.0)
