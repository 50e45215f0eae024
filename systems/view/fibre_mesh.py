"""Triangles of one fibre at each level of detail, and the records of the fibres drawn with them (papers/002, 3).

A mesh knows no fibre: its vertices say which ring they belong to, counted from the tip so that a fibre of fewer rings
draws fewer of the same triangles.
"""

from ctypes import byref, c_uint, c_void_p
from math import cos, pi, sin
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import AnyArray, Float32s
from systems.view.fibre_levels import CAPS, FLAT, MOST_RINGS, SIDES

RECORD: Final = 8
"""Numbers of a fibre's record: ring of its tip, girth [m], look, chance; length [m], sky and sun that reach it, how
much wider it is drawn."""


def fibre_mesh(shape: int, level: int) -> tuple[Float32s, NDArray[np.uint32], int]:
    """Return corners (n, 4), triangles, and how many indices the cap has; then each band of rings has as many.

    A corner: ring from the tip; turn around the ring or place across it, 0 to 1; way beyond the ring and part of its
    radius that is left: a cap rounds the tip.
    """
    sides, caps = SIDES[shape][level], CAPS[shape][level]
    closed = sides > 2 and shape != FLAT
    columns = sides + 1 if closed else sides
    turns = np.arange(columns) / (columns - 1)
    bent = [0.5 * pi * (caps - k) / caps for k in range(caps)]
    rings = [(0.0, sin(angle), cos(angle)) for angle in bent]
    rings += [(float(ring), 0.0, 1.0) for ring in range(MOST_RINGS)]
    corners = [(ring, turn, along, left) for ring, along, left in rings for turn in turns]
    first = np.arange(len(rings) - 1)[:, None] * columns + np.arange(columns - 1)[None, :]
    a, b, c, d = first, first + 1, first + columns, first + columns + 1
    # Anticlockwise from outside: the tip's side, a and b, comes before the root's, c and d.
    quads = np.stack((a, c, d, a, d, b), axis=-1)
    pointed = quads[0, :, :3] if caps else np.zeros((0, 3), quads.dtype)
    rest = quads[1 if caps else 0 :]
    indices = np.concatenate((pointed.ravel(), rest.ravel())).astype(np.uint32)
    head = pointed.size + max(caps - 1, 0) * rest[0].size
    return np.array(corners, np.float32), indices, head


class FibreMesh:
    """The triangles of one shape at one level, on the GPU, drawn once for each record."""

    def __init__(self, shape: int, level: int, records: c_uint) -> None:
        """`records` is the buffer of all fibres' records."""
        from pyglet import gl

        corners, indices, self._head = fibre_mesh(shape, level)
        self._band = (len(indices) - self._head) // (MOST_RINGS - 1)
        self._array, self._buffers, self._records = c_uint(), (c_uint * 2)(), records
        gl.glGenVertexArrays(1, byref(self._array))
        gl.glGenBuffers(2, self._buffers)
        gl.glBindVertexArray(self._array)
        self._fill(gl.GL_ARRAY_BUFFER, 0, corners)
        gl.glEnableVertexAttribArray(0)
        gl.glVertexAttribPointer(0, 4, gl.GL_FLOAT, gl.GL_FALSE, 0, c_void_p(0))
        self._fill(gl.GL_ELEMENT_ARRAY_BUFFER, 1, indices)
        for k in range(RECORD // 4):
            gl.glEnableVertexAttribArray(1 + k)
            gl.glVertexAttribDivisor(1 + k, 1)
        gl.glBindVertexArray(0)

    def draw(self, first: int, number: int, rings: int) -> None:
        """Draw the fibres of `number` records from `first` on, of so many rings each."""
        from pyglet import gl

        gl.glBindVertexArray(self._array)
        # GL 3.3 has no base instance: the records' place is told anew.
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._records)
        for k in range(RECORD // 4):
            place = c_void_p(4 * RECORD * first + 16 * k)
            gl.glVertexAttribPointer(1 + k, 4, gl.GL_FLOAT, gl.GL_FALSE, 4 * RECORD, place)
        count = self._head + (rings - 1) * self._band
        gl.glDrawElementsInstanced(gl.GL_TRIANGLES, count, gl.GL_UNSIGNED_INT, c_void_p(0), number)

    def delete(self) -> None:
        """Free the buffers."""
        from pyglet import gl

        gl.glDeleteBuffers(2, self._buffers)
        gl.glDeleteVertexArrays(1, byref(self._array))

    def _fill(self, target: int, buffer: int, values: AnyArray) -> None:
        from pyglet import gl

        gl.glBindBuffer(target, self._buffers[buffer])
        gl.glBufferData(target, values.nbytes, values.ctypes.data, gl.GL_STATIC_DRAW)
