"""One level's triangles in a vertex array, and the buffer of instance records (FINDINGS 8: one of each a level)."""

from ctypes import byref, c_uint, c_void_p

import numpy as np

from components.arrays import AnyArray, Float32s
from systems.view.cull import RECORD
from systems.view.fish_levels import Level


class FishMesh:
    """One level's triangles and the records of the fishes drawn with it."""

    def __init__(self, level: Level, start: int) -> None:
        from pyglet import gl

        self._array, self._buffers, self._count = c_uint(), (c_uint * 3)(), 0
        self._body, self._fins = level.body.size, level.fins.size
        gl.glGenVertexArrays(1, byref(self._array))
        gl.glGenBuffers(3, self._buffers)
        gl.glBindVertexArray(self._array)
        numbers = np.arange(start, start + len(level.table), dtype=np.float32)
        triangles = np.concatenate((level.body.ravel(), level.fins.ravel()))
        self._fill(gl.GL_ARRAY_BUFFER, 0, numbers)
        gl.glEnableVertexAttribArray(0)
        gl.glVertexAttribPointer(0, 1, gl.GL_FLOAT, gl.GL_FALSE, 0, c_void_p(0))
        self._fill(gl.GL_ELEMENT_ARRAY_BUFFER, 1, triangles)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffers[2])
        for k in range(RECORD // 4):
            gl.glEnableVertexAttribArray(1 + k)
            place = c_void_p(16 * k)
            gl.glVertexAttribPointer(1 + k, 4, gl.GL_FLOAT, gl.GL_FALSE, 4 * RECORD, place)
            gl.glVertexAttribDivisor(1 + k, 1)
        gl.glBindVertexArray(0)

    def upload(self, records: Float32s) -> None:
        """Take the records (n, 20) of the fishes to draw."""
        from pyglet import gl

        self._count = len(records)
        if self._count:
            gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffers[2])
            data = records.ctypes.data
            gl.glBufferData(gl.GL_ARRAY_BUFFER, records.nbytes, data, gl.GL_STREAM_DRAW)

    def draw(self, fins: bool) -> None:
        """Draw the fins or the bodies of all fishes taken."""
        from pyglet import gl

        gl.glBindVertexArray(self._array)
        size, start = (self._fins, self._body) if fins else (self._body, 0)
        gl.glDrawElementsInstanced(
            gl.GL_TRIANGLES, size, gl.GL_UNSIGNED_INT, c_void_p(4 * start), self._count
        )

    def delete(self) -> None:
        """Free the buffers."""
        from pyglet import gl

        gl.glDeleteBuffers(3, self._buffers)
        gl.glDeleteVertexArrays(1, byref(self._array))

    def _fill(self, target: int, buffer: int, values: AnyArray) -> None:
        from pyglet import gl

        gl.glBindBuffer(target, self._buffers[buffer])
        gl.glBufferData(target, values.nbytes, values.ctypes.data, gl.GL_STATIC_DRAW)
