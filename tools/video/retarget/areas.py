"""Areas of triangles in the plane, by which flips are told."""

import numpy as np

from components.arrays import Float64s, Int64s


def signed_areas(points: Float64s, triangles: Int64s) -> Float64s:
    """Return the area of each triangle, negative where its corners run the other way, (n,)."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    u, v = b - a, c - a
    return np.asarray(0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]))
