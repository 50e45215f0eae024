"""A target: a mesh with its control points, ready to be moved (papers/003, sections 3.2 and 5, eqs. 7 to 12)."""

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s, Int64s
from components.fault import FaultError
from tools.video.retarget.fin import Fin
from tools.video.retarget.skeleton import Skeleton, angle_of, bones, skeleton_of

Texture: TypeAlias = NDArray[np.uint8]
"""Red, green, blue and opacity, (height, width, 4)."""


class ModelError(FaultError):
    """A picture, mesh or name cannot serve as target: one line that names it and says what is wrong."""


@dataclass(frozen=True)
class Target:
    """A model in its rest pose. Local frame: x to its right, y ahead, z up; the centre at 0."""

    name: str
    vertices: Float64s
    "(V, 3); z is 0 where the model is a picture"
    triangles: Int64s
    "(F, 3)"
    uv: Float64s
    "places in the texture [px], x right and y down, (V, 2)"
    texture: Texture
    controls: Float64s
    "body control points, as in skeleton.py, (21, 2)"
    fins: tuple[Fin | None, Fin | None]
    "left and right; None where the model has none"
    solid: bool = False
    "whether it is a body that light shades, not a picture"

    @property
    def skeleton(self) -> Skeleton:
        """L of algorithm 1."""
        return skeleton_of(self.controls)

    @property
    def rest_angles(self) -> Float64s:
        """M_0 of section 6.2: the angles of the rest pose [rad], (22,); a right angle for a fin that is not there."""
        sides = [
            0.5 * np.pi if fin is None else float(angle_of(fin.tip - fin.top)) for fin in self.fins
        ]
        return np.concatenate((angle_of(bones(self.controls)), np.array(sides)))
