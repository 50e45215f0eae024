"""Clamped uniform B-spline bases, tabulated once (papers/000, 7.2).

"Order 3" of the paper is the degree: bodies are bicubic. A basis is a matrix from control points to points of the
curve.
"""

import numpy as np

from components.arrays import Float64s


def knots(points: int, degree: int) -> Float64s:
    """Return the clamped uniform knot vector on [0, 1] of `points` control points."""
    inner = np.linspace(0.0, 1.0, points - degree + 1)
    return np.concatenate((np.zeros(degree), inner, np.ones(degree)))


def greville(points: int, degree: int = 3) -> Float64s:
    """Return the parameter at which each control point acts most, (points,)."""
    t = knots(points, degree)
    return np.array([t[i + 1 : i + degree + 1].mean() for i in range(points)])


def basis(at: Float64s, points: int, degree: int = 3) -> Float64s:
    """Return the basis at the parameters `at` in [0, 1], (len(at), points); rows sum to 1 (Cox and de Boor)."""
    t = knots(points, degree)
    at = np.clip(np.asarray(at, np.float64), 0.0, 1.0)[:, None]
    inside = np.minimum(at, 1.0 - 1e-12)
    table = ((inside >= t[None, :-1]) & (inside < t[None, 1:])).astype(np.float64)
    for k in range(1, degree + 1):
        table = _raised(table, t, at, k)
    return table


def slope(at: Float64s, points: int, degree: int = 3) -> Float64s:
    """Return the basis' derivative with respect to the parameter, (len(at), points)."""
    t = knots(points, degree)
    lower = basis(at, points - 1, degree - 1)
    gaps = degree / (t[degree + 1 : degree + points] - t[1:points])
    table = np.zeros((len(lower), points))
    table[:, 1:] += lower * gaps
    table[:, :-1] -= lower * gaps
    return table


def _raised(table: Float64s, t: Float64s, at: Float64s, k: int) -> Float64s:
    count = table.shape[1] - 1
    rise, fall = t[k : k + count] - t[:count], t[k + 1 : k + 1 + count] - t[1 : 1 + count]
    up = np.divide(1.0, rise, out=np.zeros(count), where=rise > 0)
    down = np.divide(1.0, fall, out=np.zeros(count), where=fall > 0)
    high = t[k + 1 : k + 1 + count]
    raised: Float64s = (at - t[:count]) * up * table[:, :-1] + (high - at) * down * table[:, 1:]
    return raised
