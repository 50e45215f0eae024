"""The shapes of stone: spheres chipped flat by blows, ledged, creased and cracked (FINDINGS 8).

A shape is the deviation from the unit sphere, in radii, at points of it: rocks scale it by their radii.
"""

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s

LUMPS: Final = 0.08
"""Largest deviation from the ellipsoid that fishes and submarine collide with, in radii."""
_BLOWS: Final = 30
"""Flat facets that a rock is chipped to."""


class Sphere(NamedTuple):
    """A triangulated unit sphere."""

    points: Float64s
    "(n, 3)"
    sides: NDArray[np.int64]
    "anticlockwise seen from outside, (m, 3)"


def split_octahedron(times: int) -> Sphere:
    """Return the octahedron whose sides are split in four as often as `times` says."""
    points = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], float)
    sides = np.array(
        [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    )
    sphere = Sphere(points, sides)
    for _ in range(times):
        sphere = _split(*sphere)
    return sphere


def _split(points: Float64s, sides: NDArray[np.int64]) -> Sphere:
    edges = np.sort(np.concatenate((sides[:, [0, 1]], sides[:, [1, 2]], sides[:, [2, 0]])), axis=1)
    unique, number = np.unique(edges, axis=0, return_inverse=True)
    middle = points[unique].sum(axis=1)
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    ab, bc, ca = (number.reshape(3, -1) + len(points)).astype(np.int64)
    a, b, c = sides.T
    corners = ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))
    return Sphere(
        np.concatenate((points, middle)), np.concatenate([np.stack(t, axis=1) for t in corners])
    )


def crags(rng: np.random.Generator, at: Float64s) -> Float64s:
    """Return the deviation at points of the unit sphere, (n, 3): -LUMPS to LUMPS, (n,)."""
    bent = at + 0.07 * waves(rng, at, 3.1)[:, None]
    shape = chipped(rng, bent) + 0.012 * waves(rng, at, 2.3) + 0.020 * _ledges(rng, bent)
    shape += 0.016 * (np.abs(waves(rng, at, 7.0)) - 0.4) + 0.010 * waves(rng, at, 14.0)
    crack = waves(rng, bent, 4.2) / 0.07
    shape -= 0.06 * np.exp(-crack * crack)
    return np.asarray(np.clip(shape, -0.999 * LUMPS, 0.999 * LUMPS))


def chipped(rng: np.random.Generator, at: Float64s) -> Float64s:
    """Return how far flat facets cut into a sphere a little larger than the unit sphere, (n,)."""
    normal = rng.standard_normal((_BLOWS, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    far = rng.uniform(0.86, 1.03, _BLOWS)
    facing = np.maximum(at @ normal.T, 0.2)
    reach = np.minimum(far / facing, 1.0 + 2.0 * LUMPS)
    # A soft minimum rounds the edges a little, as years of sand do.
    soft = -np.log(np.exp(-130.0 * (reach - 1.0)).sum(axis=1)) / 130.0
    return np.asarray(np.minimum(soft, 0.9 * LUMPS) + 0.02)


def waves(rng: np.random.Generator, at: Float64s, frequency: float) -> Float64s:
    """Return smooth noise of about `frequency` radians a radius, -1 to 1, at points (n, 3), (n,)."""
    total = np.zeros(len(at))
    for _ in range(5):
        axis = rng.standard_normal(3)
        axis *= frequency * rng.uniform(0.7, 1.4) / np.linalg.norm(axis)
        total += np.sin(at @ axis + rng.uniform(0, 2 * np.pi))
    return np.asarray(total / 3.0)


def _ledges(rng: np.random.Generator, at: Float64s) -> Float64s:
    """Return steps of tilted strata: each bulges and falls back sharply, -1 to 1, (n,)."""
    axis = np.array([*(0.45 * rng.standard_normal(2)), 1.0])
    height = at @ (axis / np.linalg.norm(axis)) * rng.uniform(3.0, 5.0)
    height += 0.35 * waves(rng, at, 2.6)
    part = height - np.floor(height)
    return np.asarray(1.6 * np.minimum(part, 4.0 * (1.0 - part)) - 0.7)


def hollows(sphere: Sphere, shape: Float64s, times: int = 5) -> Float64s:
    """Return how far each point lies in a hollow of `shape`, (n,): above 0 in crevices, below on edges."""
    pairs = [sphere.sides[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]
    a, b = np.concatenate(pairs).T
    number = len(shape)
    around = np.bincount(a, minlength=number)
    smooth = shape
    for _ in range(times):
        smooth = 0.5 * smooth + 0.5 * np.bincount(a, smooth[b], number) / around
    return np.asarray((smooth - shape) / LUMPS)
