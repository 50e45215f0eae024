"""Lines and areas that change every frame: curves on a panel, cones drawn into the sea."""

from ctypes import byref, c_uint
from typing import Any, Final

import numpy as np
from pyglet import gl
from pyglet.graphics.shader import Shader, ShaderProgram

from components.arrays import Float32s, Float64s
from reefgame.screens.theme import Colour

_VERTEX: Final = """#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 edge;
layout(location = 2) in vec4 paint;
uniform vec2 size;
out vec2 across;
out vec4 inside;
void main() {
    gl_Position = vec4(2.0 * position / size - 1.0, 0.0, 1.0);
    across = edge;
    inside = paint;
}
"""
_FRAGMENT: Final = """#version 330 core
in vec2 across;
in vec4 inside;
out vec4 colour;
void main() {
    colour = vec4(inside.rgb, inside.a * clamp(across.y - abs(across.x) + 0.5, 0.0, 1.0));
}
"""
_FLOATS: Final = 8
_SOFT: Final = 1.0
_NO_EDGE: Final = 1e4


class Strokes:
    """Gathers lines and triangles in pixels, then paints them all at once, in the order they came."""

    _program: ShaderProgram | None = None

    def __init__(self) -> None:
        if Strokes._program is None:
            Strokes._program = ShaderProgram(
                Shader(_VERTEX, "vertex"), Shader(_FRAGMENT, "fragment")
            )
        self._pieces: list[Float32s] = []
        self._array, self._buffer = c_uint(), c_uint()
        gl.glGenVertexArrays(1, byref(self._array))
        gl.glGenBuffers(1, byref(self._buffer))
        gl.glBindVertexArray(self._array)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffer)
        for at, (count, offset) in enumerate(((2, 0), (2, 8), (4, 16))):
            gl.glEnableVertexAttribArray(at)
            gl.glVertexAttribPointer(at, count, gl.GL_FLOAT, gl.GL_FALSE, 4 * _FLOATS, offset)
        gl.glBindVertexArray(0)

    def lines(self, begin: Float64s, end: Float64s, colour: Colour, width: float) -> None:
        """Add lines from begin to end [px], (n, 2) each, `width` [px] wide."""
        way = end - begin
        size = np.maximum(np.hypot(way[:, 0], way[:, 1]), 1e-6)
        half = 0.5 * width + _SOFT
        aside = np.stack((-way[:, 1], way[:, 0]), axis=1) * (half / size)[:, None]
        corners = (begin - aside, begin + aside, end + aside, end - aside)
        points = np.stack([corners[at] for at in (0, 1, 2, 0, 2, 3)], axis=1).reshape(-1, 2)
        across = np.tile((-half, half, half, -half, half, -half), len(begin))
        self._add(points, across, 0.5 * width, colour)

    def path(self, points: Float64s, colour: Colour, width: float) -> None:
        """Add a line through points [px], (n, 2)."""
        if len(points) > 1:
            self.lines(points[:-1], points[1:], colour, width)

    def fill(self, triangles: Float64s, colour: Colour) -> None:
        """Add triangles [px], (n, 3, 2)."""
        self._add(triangles.reshape(-1, 2), np.zeros(3 * len(triangles)), _NO_EDGE, colour)

    def draw(self, width: int, height: int) -> None:
        """Paint what was added over the bound framebuffer of width x height [px], and forget it."""
        pieces, self._pieces = self._pieces, []
        if not pieces or Strokes._program is None:
            return
        data = np.ascontiguousarray(np.concatenate(pieces), np.float32)
        program: Any = Strokes._program
        program.use()
        program["size"] = (float(width), float(height))
        gl.glDisable(gl.GL_DEPTH_TEST)
        gl.glDisable(gl.GL_CULL_FACE)
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
        gl.glBindVertexArray(self._array)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffer)
        gl.glBufferData(gl.GL_ARRAY_BUFFER, data.nbytes, data.ctypes.data, gl.GL_STREAM_DRAW)
        gl.glDrawArrays(gl.GL_TRIANGLES, 0, len(data))
        gl.glBindVertexArray(0)
        program.stop()

    def delete(self) -> None:
        """Free the buffer."""
        gl.glDeleteVertexArrays(1, byref(self._array))
        gl.glDeleteBuffers(1, byref(self._buffer))

    def _add(self, points: Float64s, across: Float64s, half: float, colour: Colour) -> None:
        piece = np.empty((len(points), _FLOATS), np.float32)
        piece[:, :2], piece[:, 2], piece[:, 3] = points, across, half
        piece[:, 4:] = np.array(colour, np.float32) / 255.0
        self._pieces.append(piece)
