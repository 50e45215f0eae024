"""Whether two bodies interpenetrate: boxes along the bodies' axes, by separating axes (Gottschalk and others 1996)."""

import numpy as np

from components.arrays import AnyArray, Float64s, Int64s
from reefgame.testing.observation import Observation


def overlapping(o: Observation, sample: int, first: Int64s, second: Int64s) -> AnyArray:
    """Return whether the bodies of each pair (first[k], second[k]) of fishes overlap in a sample, (P,)."""
    a, b = o.rotation[sample, first], o.rotation[sample, second]
    middle = o.position[sample] + o.middle[:, None] * o.rotation[sample, :, :, 0]
    between = middle[second] - middle[first]
    apart = np.zeros(len(first), bool)
    for axis in _axes(a, b):
        reach = _reach(a, o.box[first], axis) + _reach(b, o.box[second], axis)
        apart |= np.abs((between * axis).sum(axis=1)) > reach
    return ~apart


def _axes(a: Float64s, b: Float64s) -> list[Float64s]:
    """Return the fifteen axes that can separate two boxes, (P, 3) each; parallel edges give a null axis."""
    faces = [box[:, :, k] for box in (a, b) for k in range(3)]
    edges = [np.cross(a[:, :, i], b[:, :, j]) for i in range(3) for j in range(3)]
    return faces + [np.where(np.abs(e).max(axis=1, keepdims=True) < 1e-9, 0.0, e) for e in edges]


def _reach(rotation: Float64s, half: Float64s, axis: Float64s) -> Float64s:
    """Return how far each box, its half extents (P, 3), reaches along an axis from its middle, (P,)."""
    along = np.abs(np.einsum("pik,pi->pk", rotation, axis))
    reach: Float64s = (along * half).sum(axis=1)
    return reach
