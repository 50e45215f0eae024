"""Open water and the surface seen from below, drawn last, where nothing else was (FINDINGS 8)."""

from collections.abc import Sequence
from ctypes import byref, c_uint

from systems.view.program import load_program


class DrawWater:
    """A full-screen triangle at the far plane, behind what was drawn before it."""

    def __init__(self, defines: Sequence[str] = ()) -> None:
        from pyglet import gl

        self._program = load_program("screen.vert.glsl", "water.frag.glsl", defines)
        self._array = c_uint()
        gl.glGenVertexArrays(1, byref(self._array))

    def draw(self) -> None:
        """Fill the pixels whose depth is still the far plane's; leave depth writing on."""
        from pyglet import gl

        gl.glUseProgram(self._program.id)
        gl.glBindVertexArray(self._array)
        gl.glDepthFunc(gl.GL_LEQUAL)
        gl.glDepthMask(False)
        gl.glDrawArrays(gl.GL_TRIANGLES, 0, 3)
        gl.glDepthMask(True)
        gl.glDepthFunc(gl.GL_LESS)

    def delete(self) -> None:
        """Free the vertex array; the program goes with this object."""
        from pyglet import gl

        gl.glDeleteVertexArrays(1, byref(self._array))
