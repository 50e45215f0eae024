"""Gradient noise that is the same to the last bit everywhere: hashed gradients and a quintic fade
(FINDINGS 6).

After Perlin 1985 and 2002; the gradients come from `components.chance`, so a seed names one
landscape.
"""

from math import floor, sqrt

import numpy as np

from components.chance import NOISE, draw
from components.kernels import row


@row
def fade(t: float) -> float:
    """Return Perlin's quintic step from 0 at t = 0 to 1 at t = 1, flat at both ends."""
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0)


@row
def _slope(seed: int, i: int, j: int, x: float, y: float) -> float:
    bits = draw(seed, NOISE, i, j)
    gx = np.float64(bits & np.uint64(0xFFFFFF)) * (1.0 / 8388608.0) - 1.0
    gy = np.float64((bits >> np.uint64(24)) & np.uint64(0xFFFFFF)) * (1.0 / 8388608.0) - 1.0
    return (gx * x + gy * y) / (sqrt(gx * gx + gy * gy) + 1e-9)


@row
def noise(seed: int, x: float, y: float) -> float:
    """Return gradient noise at (x, y), about -0.7 to 0.7, zero at whole numbers."""
    i, j = floor(x), floor(y)
    u, v = x - i, y - j
    a, b = _slope(seed, i, j, u, v), _slope(seed, i + 1, j, u - 1.0, v)
    c, d = _slope(seed, i, j + 1, u, v - 1.0), _slope(seed, i + 1, j + 1, u - 1.0, v - 1.0)
    s, t = fade(u), fade(v)
    low, high = a + s * (b - a), c + s * (d - c)
    return low + t * (high - low)


@row
def octaves(seed: int, x: float, y: float, number: int) -> float:
    """Return `number` octaves of noise, each twice as fine and half as high: about -1 to 1."""
    total, weight, scale, height = 0.0, 0.0, 1.0, 1.0
    for octave in range(number):
        total += height * noise(seed + octave, x * scale, y * scale)
        weight += height
        scale *= 2.0
        height *= 0.5
    return total / (0.7 * weight)
