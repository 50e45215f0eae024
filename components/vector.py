"""Directions as three floats: the small arithmetic that minds and motors share."""

from math import sqrt

from components.arrays import Float64s
from components.kernels import inlined


@inlined
def point(out: Float64s, x: float, y: float, z: float) -> None:
    """Write the unit vector along (x, y, z) into `out`, (3,); leave it where there is no length."""
    size = sqrt(x * x + y * y + z * z)
    if size > 1e-9:
        out[0], out[1], out[2] = x / size, y / size, z / size


@inlined
def level_off(out: Float64s, steepest: float) -> None:
    """Turn the unit vector `out`, (3,), so that |z| is at most `steepest`, its bearing kept."""
    if -steepest <= out[2] <= steepest:
        return
    z = steepest if out[2] > 0.0 else -steepest
    level = sqrt(out[0] * out[0] + out[1] * out[1])
    if level < 1e-9:
        return
    scale = sqrt(1.0 - z * z) / level
    out[0], out[1], out[2] = out[0] * scale, out[1] * scale, z
