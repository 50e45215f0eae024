"""The uniform block `Frame`: camera, sun and water of one view, read by every shader (FINDINGS 8).

Updated once per camera and target; `shaders/frame.glsl` declares the same block.
"""

from ctypes import byref, c_uint
from dataclasses import dataclass
from math import cos, radians, sin, sqrt
from typing import Final

import numpy as np

from components.arrays import Float32s, Float64s
from components.camera import Camera
from systems.view.context import ensure_context
from systems.view.program import FRAME_BINDING
from systems.view.water_maps import WaterMaps

NEAR: Final = 0.06
"""[m] nearest drawn."""
FAR: Final = 240.0
"""[m] farthest drawn: nothing shows through so much water."""
WATER_INDEX: Final = 1.333
"""Refractive index of sea water over air's."""
FLOATS: Final = 16 + 7 * 4
"""Numbers in the block: a matrix and seven vec4."""


@dataclass(frozen=True)
class Look:
    """What a level says of its water and sun."""

    visibility: float = 22.0
    "[m] at which things fade into the water"
    caustics: float = 1.0
    "strength of the net of light on the ground; 0 draws none"
    waves: float = 1.0
    "size of the surface's waves, a factor"
    depth: float = 12.0
    "[m] of the deepest ground, a positive number"
    sun_elevation: float = 55.0
    "[deg] over the horizon, seen in air"
    sun_azimuth: float = 60.0
    "[deg] from +x towards +y"
    sun_strength: float = 1.0
    "a factor; 1 is a clear noon"

    def sun(self) -> tuple[float, float, float]:
        """Return the unit vector towards the sun as light travels under water (Snell)."""
        across = cos(radians(self.sun_elevation)) / WATER_INDEX
        azimuth = radians(self.sun_azimuth)
        return across * cos(azimuth), across * sin(azimuth), sqrt(1.0 - across * across)


def view_projection(camera: Camera, aspect: float) -> Float64s:
    """Return the (4, 4) matrix from world [m] to clip space, for column vectors."""
    axes = np.stack((camera.right, camera.up, camera.forward))
    view = np.concatenate((axes, -(axes @ camera.eye)[:, None]), axis=1)
    matrix = np.zeros((4, 4))
    matrix[0] = view[0] / (camera.slope * aspect)
    matrix[1] = view[1] / camera.slope
    matrix[2] = view[2] * ((FAR + NEAR) / (FAR - NEAR))
    matrix[2, 3] -= 2.0 * FAR * NEAR / (FAR - NEAR)
    matrix[3] = view[2]
    return matrix


def frame_values(camera: Camera, width: int, height: int, seconds: float, look: Look) -> Float32s:
    """Return the block's numbers in std140 order, (44,) float32."""
    aspect = width / height
    values = np.empty(FLOATS, np.float32)
    values[:16] = view_projection(camera, aspect).T.ravel()
    values[16:20] = (*camera.eye, seconds)
    values[20:24] = (*camera.forward, 0.0)
    values[24:28] = (*camera.right, camera.slope * aspect)
    values[28:32] = (*camera.up, camera.slope)
    values[32:36] = (*look.sun(), look.sun_strength)
    values[36:40] = (look.visibility, look.caustics, look.waves, look.depth)
    values[40:44] = (width, height, 1.0 / width, 1.0 / height)
    return values


class FrameBlock:
    """The uniform buffer of the block `Frame`, and the water's maps that go with it.

    `smooth` maps cost software GL a fifth of a frame. `update` leaves both bound: uniform buffer
    binding 3 and the texture units of `SAMPLER_UNITS`.
    """

    def __init__(self, smooth: bool = True) -> None:
        ensure_context()
        from pyglet import gl

        self._maps = WaterMaps(smooth)
        self._buffer = c_uint()
        gl.glGenBuffers(1, byref(self._buffer))
        gl.glBindBuffer(gl.GL_UNIFORM_BUFFER, self._buffer)
        gl.glBufferData(gl.GL_UNIFORM_BUFFER, FLOATS * 4, None, gl.GL_STREAM_DRAW)

    def update(
        self, camera: Camera, width: int, height: int, seconds: float, look: Look
    ) -> Float32s:
        """Write the block for `camera` and a target of width x height [px]; return its numbers."""
        from pyglet import gl

        values = frame_values(camera, width, height, seconds, look)
        gl.glBindBuffer(gl.GL_UNIFORM_BUFFER, self._buffer)
        gl.glBufferSubData(gl.GL_UNIFORM_BUFFER, 0, values.nbytes, values.ctypes.data)
        gl.glBindBufferBase(gl.GL_UNIFORM_BUFFER, FRAME_BINDING, self._buffer)
        self._maps.bind()
        return values

    def delete(self) -> None:
        """Free the buffer and the maps."""
        from pyglet import gl

        gl.glDeleteBuffers(1, byref(self._buffer))
        self._maps.delete()
