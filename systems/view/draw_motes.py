"""Plankton motes: soft points that drift past the eye; seen only, never simulated (FINDINGS 8)."""

from ctypes import byref, c_uint
from typing import Final

import numpy as np

from systems.view.program import load_program

MOTES: Final = 900
"""Motes in the box around the eye that follows it, wrapping."""


class DrawMotes:
    """`number` points whose places follow from their own seeds, the time and the eye."""

    def __init__(self, number: int = MOTES) -> None:
        from pyglet import gl

        self._program = load_program("mote.vert.glsl", "mote.frag.glsl")
        self._number = number
        seeds = np.random.default_rng(4).random((number, 4)).astype(np.float32)
        self._array, self._buffer = c_uint(), c_uint()
        gl.glGenVertexArrays(1, byref(self._array))
        gl.glGenBuffers(1, byref(self._buffer))
        gl.glBindVertexArray(self._array)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffer)
        gl.glBufferData(gl.GL_ARRAY_BUFFER, seeds.nbytes, seeds.ctypes.data, gl.GL_STATIC_DRAW)
        gl.glEnableVertexAttribArray(0)
        gl.glVertexAttribPointer(0, 4, gl.GL_FLOAT, gl.GL_FALSE, 0, 0)
        gl.glBindVertexArray(0)

    def draw(self) -> None:
        """Add the motes' light to what stands there; drawn last, hidden by what is nearer."""
        from pyglet import gl

        gl.glUseProgram(self._program.id)
        gl.glBindVertexArray(self._array)
        gl.glEnable(gl.GL_PROGRAM_POINT_SIZE)
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_ONE, gl.GL_ONE)
        gl.glDepthMask(False)
        gl.glDrawArrays(gl.GL_POINTS, 0, self._number)
        gl.glDepthMask(True)
        gl.glDisable(gl.GL_BLEND)
        gl.glDisable(gl.GL_PROGRAM_POINT_SIZE)

    def delete(self) -> None:
        """Free the points."""
        from pyglet import gl

        gl.glDeleteVertexArrays(1, byref(self._array))
        gl.glDeleteBuffers(1, byref(self._buffer))
