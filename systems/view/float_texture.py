"""A texture of float32 texels that shaders fetch by number: what a buffer texture would be, which pyglet cannot name
(FINDINGS 8)."""

from ctypes import byref, c_uint

import numpy as np

from components.arrays import Float32s


class FloatTexture:
    """RGBA32F texels, `width` a row; it grows as it has to, to `most` rows."""

    def __init__(self, width: int, most: int) -> None:
        from pyglet import gl

        self.width = width
        self._most, self._rows = most, 0
        self._texture = c_uint()
        gl.glGenTextures(1, byref(self._texture))

    def whole_rows(self, texels: int) -> int:
        """Return as many texels as fill the rows that so many need."""
        return -(-texels // self.width) * self.width

    def upload(self, texels: Float32s) -> None:
        """Replace the first rows by texels, (rows, width, 4). Raise ValueError for more rows than there can be."""
        from pyglet import gl

        rows = len(texels)
        if rows > self._most:
            raise ValueError(f"{rows} rows of texels: this OpenGL has {self._most}")
        gl.glActiveTexture(gl.GL_TEXTURE0)
        gl.glBindTexture(gl.GL_TEXTURE_2D, self._texture)
        if rows > self._rows:
            self._rows = min(max(rows, 2 * self._rows), self._most)
            gl.glTexImage2D(
                *(gl.GL_TEXTURE_2D, 0, gl.GL_RGBA32F, self.width, self._rows, 0),
                *(gl.GL_RGBA, gl.GL_FLOAT, None),
            )
            for name in (gl.GL_TEXTURE_MIN_FILTER, gl.GL_TEXTURE_MAG_FILTER):
                gl.glTexParameteri(gl.GL_TEXTURE_2D, name, gl.GL_NEAREST)
        data = np.ascontiguousarray(texels, np.float32)
        gl.glTexSubImage2D(
            *(gl.GL_TEXTURE_2D, 0, 0, 0, self.width, rows, gl.GL_RGBA, gl.GL_FLOAT),
            data.ctypes.data,
        )

    def bind(self, unit: int) -> None:
        """Bind the texture to a unit."""
        from pyglet import gl

        gl.glActiveTexture(gl.GL_TEXTURE0 + unit)
        gl.glBindTexture(gl.GL_TEXTURE_2D, self._texture)
        gl.glActiveTexture(gl.GL_TEXTURE0)

    def delete(self) -> None:
        """Free the texture."""
        from pyglet import gl

        gl.glDeleteTextures(1, byref(self._texture))
