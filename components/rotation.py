"""Rotations as 3x3 matrices whose columns are body axes: small kernels on one (3, 3) view
(papers/000, eqs. 1-4, 10).

They use + - * / and sqrt alone, so every machine computes the same bits.
"""

from math import sqrt
from typing import TypeAlias

from components.arrays import Float64s
from components.kernels import inlined, row

Vector: TypeAlias = tuple[float, float, float]
Axes: TypeAlias = tuple[Vector, Vector, Vector]
"""The columns of a rotation: x, y and z of a body."""


@inlined
def turned(
    x: float, y: float, z: float, u: float, v: float, w: float
) -> tuple[float, float, float]:
    """Return the vector (x, y, z) turned by the rotation vector (u, v, w) [rad].

    Rodrigues' formula by series: exact to 1e-9 below 0.4 rad.
    """
    q = u * u + v * v + w * w
    a = 1.0 - q * (1.0 / 6.0) * (1.0 - q * 0.05 * (1.0 - q * (1.0 / 42.0)))
    b = 0.5 - q * (1.0 / 24.0) * (1.0 - q * (1.0 / 30.0) * (1.0 - q * (1.0 / 56.0)))
    cx, cy, cz = v * z - w * y, w * x - u * z, u * y - v * x
    dx, dy, dz = v * cz - w * cy, w * cx - u * cz, u * cy - v * cx
    return x + a * cx + b * dx, y + a * cy + b * dy, z + a * cz + b * dz


@inlined
def axes_of(u: float, v: float, w: float) -> Axes:
    """Return the axes x, y and z turned by the rotation vector (u, v, w) [rad], as exact as `turned`."""
    q = u * u + v * v + w * w
    a = 1.0 - q * (1.0 / 6.0) * (1.0 - q * 0.05 * (1.0 - q * (1.0 / 42.0)))
    b = 0.5 - q * (1.0 / 24.0) * (1.0 - q * (1.0 / 30.0) * (1.0 - q * (1.0 / 56.0)))
    uv, uw, vw = b * u * v, b * u * w, b * v * w
    return (
        (1.0 - b * (v * v + w * w), uv + a * w, uw - a * v),
        (uv - a * w, 1.0 - b * (u * u + w * w), vw + a * u),
        (uw + a * v, vw - a * u, 1.0 - b * (u * u + v * v)),
    )


@row
def multiply(r: Float64s, m: Float64s) -> None:
    """R <- R M: turn the body by a step given in its own axes (eq. 10 as FINDINGS 1 corrects it)."""
    for j in range(3):
        x, y, z = r[j, 0], r[j, 1], r[j, 2]
        r[j, 0] = x * m[0, 0] + y * m[1, 0] + z * m[2, 0]
        r[j, 1] = x * m[0, 1] + y * m[1, 1] + z * m[2, 1]
        r[j, 2] = x * m[0, 2] + y * m[1, 2] + z * m[2, 2]


@inlined
def set_axes(r: Float64s, ax: float, ay: float, az: float, bx: float, by: float, bz: float) -> None:
    """Set R to the rotation nearest to x = a and y = b, for a and b nearly unit and square.

    One step of Newton's method for each length: an error of 1e-3 becomes 1e-6, and calls that
    follow one another leave none.
    """
    scale = 1.5 - 0.5 * (ax * ax + ay * ay + az * az)
    ax, ay, az = ax * scale, ay * scale, az * scale
    along = ax * bx + ay * by + az * bz
    bx, by, bz = bx - along * ax, by - along * ay, bz - along * az
    scale = 1.5 - 0.5 * (bx * bx + by * by + bz * bz)
    bx, by, bz = bx * scale, by * scale, bz * scale
    r[0, 0], r[0, 1], r[0, 2] = ax, bx, ay * bz - az * by
    r[1, 0], r[1, 1], r[1, 2] = ay, by, az * bx - ax * bz
    r[2, 0], r[2, 1], r[2, 2] = az, bz, ax * by - ay * bx


@row
def orthonormalise(r: Float64s) -> None:
    """Make R a rotation again: x keeps its direction, y its plane with x, z = x cross y.

    Where x and y have no length or one direction, R becomes the unit matrix.
    """
    ax, ay, az = r[0, 0], r[1, 0], r[2, 0]
    bx, by, bz = r[0, 1], r[1, 1], r[2, 1]
    a = sqrt(ax * ax + ay * ay + az * az)
    b = sqrt(bx * bx + by * by + bz * bz)
    if a > 1e-150 and b > 1e-150:
        ax, ay, az, bx, by, bz = ax / a, ay / a, az / a, bx / b, by / b, bz / b
        along = ax * bx + ay * by + az * bz
        bx, by, bz = bx - along * ax, by - along * ay, bz - along * az
        b = sqrt(bx * bx + by * by + bz * bz)
        if b > 1e-9:
            set_axes(r, ax, ay, az, bx / b, by / b, bz / b)
            return
    set_axes(r, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)


@row
def between(last: Float64s, now: Float64s, alpha: float, out: Float64s) -> None:
    """Set `out` to the rotation the fraction `alpha` of the way from `last` to `now`, (3, 3) each.

    The columns x and y are interpolated and made a rotation again: over the few degrees of a tick
    it differs from the great arc by less than 1e-4 rad.
    """
    for j in range(3):
        for c in range(2):
            out[j, c] = last[j, c] + alpha * (now[j, c] - last[j, c])
    orthonormalise(out)
