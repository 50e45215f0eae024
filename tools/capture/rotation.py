"""Small rotations by + - * / sqrt alone, so that a repertoire's bytes are the same on every machine (FINDINGS 6)."""

from math import sqrt

from components.arrays import Float64s
from components.kernels import row


@row
def multiply(left: Float64s, right: Float64s, out: Float64s) -> None:
    """Write the product of two (3, 3) matrices into `out`, which may be neither of them."""
    for i in range(3):
        for j in range(3):
            out[i, j] = (
                left[i, 0] * right[0, j] + left[i, 1] * right[1, j] + left[i, 2] * right[2, j]
            )


@row
def rotation_vector(rotation: Float64s, vector: Float64s) -> None:
    """Write log R [rad] (3,) of a rotation of less than half a radian: axis times angle.

    The sine's length s gives the angle by the series of asin(s) / s.
    """
    vector[0] = 0.5 * (rotation[2, 1] - rotation[1, 2])
    vector[1] = 0.5 * (rotation[0, 2] - rotation[2, 0])
    vector[2] = 0.5 * (rotation[1, 0] - rotation[0, 1])
    q = vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]
    stretch = 1.0 + q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0))))
    for axis in range(3):
        vector[axis] *= stretch


@row
def rotation_from(x: float, y: float, z: float, out: Float64s) -> None:
    """Write exp of a small rotation vector [rad] into `out` (3, 3): a unit quaternion by series of the half angle."""
    q = 0.25 * (x * x + y * y + z * z)
    scale = 0.5 * (1.0 - q / 6.0 * (1.0 - q / 20.0 * (1.0 - q / 42.0)))
    w = 1.0 - q / 2.0 * (1.0 - q / 12.0 * (1.0 - q / 30.0 * (1.0 - q / 56.0)))
    x, y, z = scale * x, scale * y, scale * z
    size = 1.0 / sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w * size, x * size, y * size, z * size
    out[0, 0], out[0, 1], out[0, 2] = (
        1 - 2 * (y * y + z * z),
        2 * (x * y - w * z),
        2 * (x * z + w * y),
    )
    out[1, 0], out[1, 1], out[1, 2] = (
        2 * (x * y + w * z),
        1 - 2 * (x * x + z * z),
        2 * (y * z - w * x),
    )
    out[2, 0], out[2, 1], out[2, 2] = (
        2 * (x * z - w * y),
        2 * (y * z + w * x),
        1 - 2 * (x * x + y * y),
    )
