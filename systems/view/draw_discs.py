"""Draws the oral discs of anemones, each on the last node of its foot (papers/002, 3.1)."""

from collections.abc import Sequence
from ctypes import c_uint, c_void_p
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float32s, Float64s
from components.flora import Disc
from components.garden import Garden
from systems.view.cull import View
from systems.view.program import load_program, uniform_location

LOOKS_UNIT: Final = 1
RECORD: Final = 16
"""Numbers of a disc's record: middle, radius; side, mouth; direction, look; chance, sky, sun, dome."""
SECTORS: Final = (36, 16, 7)
"""Corners around a disc at each level of detail, the finest first."""
PIXELS: Final = (60.0, 15.0)
"""[px] of radius above which each level but the last is drawn."""
_BUFFERS: Final = 2 * len(SECTORS) + 1
"""Corners and triangles of each level, and the records."""
LEAST_PIXELS: Final = 1.0
"""[px] below which it is left out."""
_RINGS: Final = (
    ((-1.0, -0.30, 0.03), (-0.25, -0.12, 0.2), (0.0, 0.035, 0.8)),
    (
        (0.12, 0.02, 0.9),
        (0.5, 0.0, 0.55),
        (0.94, 0.012, 0.4),
        (1.025, 0.005, 0.5),
        (1.04, -0.09, 0.42),
    ),
)
"""Part of the way from mouth to rim, height over the radius, how open to light: inside the mouth; the disc."""


def disc_mesh(sectors: int) -> tuple[Float32s, NDArray[np.uint32]]:
    """Return corners (n, 4), as shaders/disc.vert.glsl reads them, and triangles."""
    rings = [ring for part in _RINGS for ring in part]
    turns = np.arange(sectors + 1) / sectors
    corners = [(way, turn, height, light) for way, height, light in rings for turn in turns]
    first = np.arange(len(rings) - 1)[:, None] * (sectors + 1) + np.arange(sectors)[None, :]
    a, b, c, d = first, first + 1, first + sectors + 1, first + sectors + 2
    quads = np.stack((a, c, d, a, d, b), axis=-1)
    return np.array(corners, np.float32), quads.ravel().astype(np.uint32)


def dome_of(garden: Garden, disc: Disc) -> float:
    """Return how high the middle of a disc stands over its rim, in its radii, as the tentacles rooted on it tell."""
    tentacles = disc.tuft + 1
    if tentacles >= len(garden.plant) or garden.plant[tentacles] != garden.plant[disc.tuft]:
        return 0.0
    foot = garden.points(garden.fibre(disc.tuft, disc.fibre)).astype(np.float64)
    ahead = _unit(foot[-1:] - foot[-2:-1])[0]
    fibres = slice(garden.first_fibre[tentacles], garden.first_fibre[tentacles + 1])
    roots = garden.position[garden.first_row[fibres], :, garden.lane[fibres]] - foot[-1]
    high = roots @ ahead / disc.radius
    fall = 1.0 - np.maximum((roots**2).sum(axis=1) / disc.radius**2 - high**2, 0.0)
    return float(np.clip(high @ fall / max(fall @ fall, 1e-6), -1.0, 1.0))


class DrawDiscs:
    """Draws a garden's discs. Reads its nodes; writes to the GPU only.

    `light` is of its tufts, `side` of its fibres.
    """

    def __init__(
        self,
        garden: Garden,
        discs: Sequence[Disc],
        light: Float32s,
        side: Float32s,
        defines: Sequence[str] = (),
    ) -> None:
        from pyglet import gl

        self._garden = garden
        fibre = np.array([garden.fibre(disc.tuft, disc.fibre) for disc in discs], np.int64)
        self._first, self._lane = garden.first_row[fibre], garden.lane[fibre]
        self._last = self._first + garden.nodes[fibre] - 1
        self._side = side[fibre].astype(np.float64)
        self._constant = np.zeros((len(discs), RECORD), np.float32)
        for row, disc in enumerate(discs):
            chance = 0.7548776662466927 * row
            # It covers the end of the foot, however wide that is.
            radius = max(disc.radius, float(garden.radius[self._last[row], self._lane[row]]))
            self._constant[row, 3], self._constant[row, 7] = radius, disc.mouth / radius
            self._constant[row, 11:13] = disc.look, chance - np.floor(chance)
            self._constant[row, 13:15] = light[disc.tuft]
            self._constant[row, 15] = dome_of(garden, disc)
        self._program = load_program("disc.vert.glsl", "fibre.frag.glsl", defines)
        gl.glUseProgram(self._program.id)
        gl.glUniform1i(uniform_location(self._program, "looks"), LOOKS_UNIT)
        gl.glUseProgram(0)
        self._buffers, self._arrays = (c_uint * _BUFFERS)(), (c_uint * len(SECTORS))()
        gl.glGenBuffers(_BUFFERS, self._buffers)
        gl.glGenVertexArrays(len(SECTORS), self._arrays)
        self._counts = [self._build(level) for level in range(len(SECTORS))]

    def records(self, rows: NDArray[np.intp]) -> Float32s:
        """Return the records of discs, (n, RECORD), as their feet stand now."""
        position, records = self._garden.position, self._constant[rows]
        first, last, lane = self._first[rows], self._last[rows], self._lane[rows]
        top = position[last, :, lane].astype(np.float64)
        below = position[np.maximum(last - 1, first), :, lane]
        ahead = _unit(top - below)
        side = self._side[rows]
        side = _unit(side - (side * ahead).sum(axis=1, keepdims=True) * ahead)
        records[:, 0:3], records[:, 4:7], records[:, 8:11] = top, side, ahead
        return records

    def draw(self, view: View) -> None:
        """Draw the discs seen in `view`; the texture of looks is bound."""
        from pyglet import gl

        place = self._garden.position[self._last, :, self._lane].astype(np.float64)
        away = place - view.eye
        far = np.maximum(np.linalg.norm(away, axis=1), 0.05)
        pixels = self._constant[:, 3] * view.pixels / far
        seen = (away @ view.axes[2] > -self._constant[:, 3]) & (far < view.reach)
        seen &= pixels > LEAST_PIXELS
        gl.glUseProgram(self._program.id)
        gl.glDisable(gl.GL_CULL_FACE)
        levels = (pixels[:, None] < PIXELS).sum(axis=1)
        for level in range(len(SECTORS)):
            rows = np.flatnonzero(seen & (levels == level))
            if len(rows):
                self._draw_level(level, self.records(rows))

    def _draw_level(self, level: int, records: Float32s) -> None:
        from pyglet import gl

        gl.glBindVertexArray(self._arrays[level])
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffers[_BUFFERS - 1])
        gl.glBufferData(gl.GL_ARRAY_BUFFER, records.nbytes, records.ctypes.data, gl.GL_STREAM_DRAW)
        gl.glDrawElementsInstanced(
            gl.GL_TRIANGLES, self._counts[level], gl.GL_UNSIGNED_INT, c_void_p(0), len(records)
        )

    def _build(self, level: int) -> int:
        from pyglet import gl

        corners, indices = disc_mesh(SECTORS[level])
        gl.glBindVertexArray(self._arrays[level])
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffers[2 * level])
        gl.glBufferData(gl.GL_ARRAY_BUFFER, corners.nbytes, corners.ctypes.data, gl.GL_STATIC_DRAW)
        gl.glEnableVertexAttribArray(0)
        gl.glVertexAttribPointer(0, 4, gl.GL_FLOAT, gl.GL_FALSE, 0, c_void_p(0))
        gl.glBindBuffer(gl.GL_ELEMENT_ARRAY_BUFFER, self._buffers[2 * level + 1])
        gl.glBufferData(
            gl.GL_ELEMENT_ARRAY_BUFFER, indices.nbytes, indices.ctypes.data, gl.GL_STATIC_DRAW
        )
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffers[_BUFFERS - 1])
        for k in range(RECORD // 4):
            gl.glEnableVertexAttribArray(1 + k)
            gl.glVertexAttribPointer(
                1 + k, 4, gl.GL_FLOAT, gl.GL_FALSE, 4 * RECORD, c_void_p(16 * k)
            )
            gl.glVertexAttribDivisor(1 + k, 1)
        gl.glBindVertexArray(0)
        return indices.size

    def delete(self) -> None:
        """Free buffers and program."""
        from pyglet import gl

        gl.glDeleteBuffers(_BUFFERS, self._buffers)
        gl.glDeleteVertexArrays(len(SECTORS), self._arrays)
        self._program.delete()


def _unit(vectors: Float64s) -> Float64s:
    size = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.asarray(vectors / np.maximum(size, 1e-12))
