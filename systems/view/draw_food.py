"""Draws food that drifts: specks of plankton, soft points lit like all else (papers/004's particles).

One record a particle: place, length and a chance of its own. Those beyond some metres are too small to see.
"""

from ctypes import byref, c_uint
from typing import Final

import numpy as np

from components.arrays import Float32s
from components.camera import Camera
from components.food import FoodTable
from systems.view.program import load_program

FARTHEST: Final = 14.0
"""[m] from the eye beyond which a particle is not drawn."""
_LENGTH: Final = 0.018
"""[m] of a particle of a twentieth of a gram."""
_MEAL: Final = 0.05


def seen_food(food: FoodTable, camera: Camera, alpha: float, now: int) -> Float32s:
    """Return place [m], length [m] and chance of the particles in the water before the camera, (n, 5), farthest first.

    They stand `alpha` of the way from the last tick to `now`.
    """
    count = food.count
    last, place = food.last_position[:count], food.position[:count]
    ways = place - camera.eye
    far = np.einsum("ij,ij->i", ways, ways)
    seen = (far < FARTHEST**2) & (ways @ camera.forward > 0.0) & (food.returns[:count] <= now)
    chosen = np.flatnonzero(seen)
    chosen = chosen[np.argsort(-far[chosen], kind="stable")]
    records = np.empty((len(chosen), 5), np.float32)
    records[:, :3] = last[chosen] + alpha * (place[chosen] - last[chosen])
    records[:, 4] = chosen * 0.6180339887498949 % 1.0
    records[:, 3] = _LENGTH * np.cbrt(food.meal[chosen] / _MEAL)
    return records


class DrawFood:
    """Draws a level's food. Reads its table; writes to the GPU only."""

    def __init__(self) -> None:
        from pyglet import gl

        self._program = load_program("food.vert.glsl", "food.frag.glsl")
        self._array, self._buffer = c_uint(), c_uint()
        gl.glGenVertexArrays(1, byref(self._array))
        gl.glGenBuffers(1, byref(self._buffer))
        gl.glBindVertexArray(self._array)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffer)
        gl.glEnableVertexAttribArray(0)
        gl.glVertexAttribPointer(0, 4, gl.GL_FLOAT, gl.GL_FALSE, 20, 0)
        gl.glEnableVertexAttribArray(1)
        gl.glVertexAttribPointer(1, 1, gl.GL_FLOAT, gl.GL_FALSE, 20, 16)
        gl.glBindVertexArray(0)

    def draw(self, food: FoodTable, camera: Camera, alpha: float, now: int) -> None:
        """Draw what `camera` sees of the food over what stands there; `alpha` and `now` as in `seen_food`."""
        from pyglet import gl

        records = seen_food(food, camera, alpha, now)
        if not len(records):
            return
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, self._buffer)
        gl.glBufferData(gl.GL_ARRAY_BUFFER, records.nbytes, records.ctypes.data, gl.GL_STREAM_DRAW)
        gl.glUseProgram(self._program.id)
        gl.glBindVertexArray(self._array)
        gl.glEnable(gl.GL_PROGRAM_POINT_SIZE)
        gl.glEnable(gl.GL_DEPTH_TEST)
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
        gl.glDepthMask(False)
        gl.glDrawArrays(gl.GL_POINTS, 0, len(records))
        gl.glDepthMask(True)
        gl.glDisable(gl.GL_BLEND)
        gl.glDisable(gl.GL_PROGRAM_POINT_SIZE)
        gl.glBindVertexArray(0)

    def delete(self) -> None:
        """Free the points."""
        from pyglet import gl

        gl.glDeleteVertexArrays(1, byref(self._array))
        gl.glDeleteBuffers(1, byref(self._buffer))
