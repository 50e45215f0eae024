"""Static triangles on the GPU: one vertex array, one index buffer, many pieces in one call."""

from collections.abc import Sequence
from ctypes import byref, c_int, c_uint, c_void_p
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float32s

INDEX_BYTES: Final = 4


class Mesh:
    """Vertices of `sizes` float32 attributes (locations 0, 1, ...) and uint32 indices.

    vertices: (n, sum of sizes). Pieces are ranges of the indices moved by a base vertex.
    """

    def __init__(
        self, vertices: Float32s, sizes: Sequence[int], indices: NDArray[np.uint32]
    ) -> None:
        from pyglet import gl

        self._array, self._buffers = c_uint(), (c_uint * 2)()
        gl.glGenVertexArrays(1, byref(self._array))
        gl.glGenBuffers(2, self._buffers)
        gl.glBindVertexArray(self._array)
        data = np.ascontiguousarray(vertices, np.float32)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffers[0])
        gl.glBufferData(gl.GL_ARRAY_BUFFER, data.nbytes, data.ctypes.data, gl.GL_STATIC_DRAW)
        gl.glBindBuffer(gl.GL_ELEMENT_ARRAY_BUFFER, self._buffers[1])
        gl.glBufferData(
            gl.GL_ELEMENT_ARRAY_BUFFER, indices.nbytes, indices.ctypes.data, gl.GL_STATIC_DRAW
        )
        start = 0
        for location, size in enumerate(sizes):
            gl.glEnableVertexAttribArray(location)
            stride = 4 * sum(sizes)
            gl.glVertexAttribPointer(location, size, gl.GL_FLOAT, gl.GL_FALSE, stride, start * 4)
            start += size
        gl.glBindVertexArray(0)

    def draw(
        self, counts: NDArray[np.int32], starts: NDArray[np.int64], bases: NDArray[np.int32]
    ) -> None:
        """Draw pieces: `counts` indices from `starts`, `bases` added to each; all (pieces,)."""
        from pyglet import gl

        number = len(counts)
        if not number:
            return
        offsets = (c_void_p * number)(*(starts * INDEX_BYTES).tolist())
        gl.glBindVertexArray(self._array)
        gl.glMultiDrawElementsBaseVertex(
            gl.GL_TRIANGLES,
            (c_int * number)(*counts.tolist()),
            gl.GL_UNSIGNED_INT,
            offsets,
            number,
            (c_int * number)(*bases.tolist()),
        )

    def delete(self) -> None:
        """Free the buffers."""
        from pyglet import gl

        gl.glDeleteVertexArrays(1, byref(self._array))
        gl.glDeleteBuffers(2, self._buffers)
