"""The schooling rule as numpy and scipy would have it, one k-d tree a species, for benches of our own kernels.

Each fish sees the nearest 8 of its species within a radius and the 300 degree cone; it keeps apart, swims as they swim
and stays with them (papers/004 after Reynolds 1987), as systems/mind/behave/school.py does without shoals and places.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from components.arrays import Float64s, Int32s, Int64s

NEIGHBOURS: Final = 8
ASKED: Final = 24
"""Neighbours asked of the tree, itself among them: enough that 8 of about 12 in radius are in the cone."""

BLIND: Final = 0.75
"""Squared cosine of half the cone behind a fish in which it sees nothing."""

SEPARATION, ELBOW, COHESION, FLATTEN = 2.2, 1.4, 0.45, 0.8


def neighbours(position: Float64s, heading: Float64s, radius: float) -> tuple[Int64s, Float64s]:
    """Return the nearest 8 in view and their distances [m], (N, 8) each, N and inf for none; places are (N, 3) [m]."""
    number = len(position)
    far, near = cKDTree(position).query(position, ASKED, distance_upper_bound=radius)
    padded = np.concatenate((position, np.zeros((1, 3))))
    away = padded[near] - position[:, None]
    along = np.einsum("nkc,nc->nk", away, heading)
    seen = (along >= 0.0) | (along * along < BLIND * far * far)
    seen &= (near != np.arange(number)[:, None]) & (near < number)
    far = np.where(seen, far, np.inf)
    order = np.argsort(far, axis=1, kind="stable")[:, :NEIGHBOURS]
    far = np.take_along_axis(far, order, axis=1)
    return np.where(np.isfinite(far), np.take_along_axis(near, order, axis=1), number), far


def directions(position: Float64s, heading: Float64s, radius: float, spacing: Float64s) -> Float64s:
    """Return the wanted directions, not of unit length, (N, 3), of one species; `spacing` (N,) [m] is kept."""
    near, far = neighbours(position, heading, radius)
    found = near < len(position)
    padded = np.concatenate((position, np.zeros((1, 3))))
    courses = np.concatenate((heading, np.zeros((1, 3))))
    away = np.where(found[..., None], padded[near] - position[:, None], 0.0)
    distance = np.where(found, far, 1.0) + 1e-9
    push = np.where(found, np.maximum(1.0 - distance / (ELBOW * spacing[:, None]), 0.0), 0.0)
    apart = -((push / distance)[..., None] * away).sum(axis=1)
    middle = away.sum(axis=1)
    apart[:, 2] *= FLATTEN
    middle[:, 2] /= FLATTEN
    share = (1.0 / (found.sum(axis=1) + 1.0))[:, None]
    course = share * (heading + courses[near].sum(axis=1))
    wanted: Float64s = course + SEPARATION * apart + COHESION * (share / spacing[:, None]) * middle
    return wanted


def schooling_step(
    position: Float64s,
    heading: Float64s,
    species: Int32s,
    radius: Float64s,
    spacing: Float64s,
    schooling: NDArray[np.bool_],
) -> Float64s:
    """Return the wanted directions of every fish, (N, 3); `radius` [m] and `schooling` are per species, (S,)."""
    wanted = heading.copy()
    for kind in np.flatnonzero(schooling):
        group = np.flatnonzero(species == kind)
        if len(group):
            wanted[group] = directions(
                position[group], heading[group], float(radius[kind]), spacing[group]
            )
    return wanted
