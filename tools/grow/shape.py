"""Fibres at rest as every plant needs them: curved chains with a radius at each node, and what one part of a plant is.

All in a plant's own axes, at scale 1: z away from what it stands on, the root of the plant in the origin.
"""

from typing import Final, NamedTuple, TypeAlias

import numpy as np

from components.arrays import Float64s, Int32s
from components.flora import Limb

Chance: TypeAlias = np.random.Generator

_WAVE: Final = 0.35
"""Share of a fibre's variety that waves sideways [rad]."""


class Carried(NamedTuple):
    """Which nodes of an earlier part carry the fibres of a part."""

    part: int
    "index among the plant's parts"
    fibre: Int32s
    "(F,)"
    node: Int32s
    "(F,)"


class Part(NamedTuple):
    """Fibres of one kind of a plant: what becomes a `components.fibre.Tuft`."""

    name: str
    "key of its look"
    points: Float64s
    "[m] (F, N, 3)"
    radii: Float64s
    "[m] (F, N)"
    limb: Limb
    carried: Carried | None = None
    guides: int | None = None
    "index of the part that these are interpolated from"


def unit(vectors: Float64s) -> Float64s:
    """Return the vectors (..., 3) with length 1; upright where they have none."""
    size = np.linalg.norm(vectors, axis=-1, keepdims=True)
    found: Float64s = np.where(size > 1e-9, vectors / np.maximum(size, 1e-9), (0.0, 0.0, 1.0))
    return found


def leaning(azimuth: Float64s, angle: Float64s) -> tuple[Float64s, Float64s]:
    """Return directions `angle` from z towards `azimuth` [rad], (F,), and normals that lead further down."""
    c, s = np.cos(angle), np.sin(angle)
    x, y = np.cos(azimuth), np.sin(azimuth)
    return np.stack([s * x, s * y, c], axis=-1), np.stack([c * x, c * y, -s], axis=-1)


def curved(
    roots: Float64s, ways: Float64s, sides: Float64s, length: Float64s, limb: Limb, chance: Chance
) -> Float64s:
    """Return fibres that start at roots [m] in directions `ways` and curl towards `sides`, (F, N, 3).

    `ways` and `sides` are unit vectors, (F, 3), at right angles; `length` [m], (F,). Each differs a little.
    """
    count, segments = len(roots), limb.nodes - 1
    along = (np.arange(segments) + 0.5) / max(segments, 1)
    curl = np.radians(limb.curl) * (1.0 + limb.variety * chance.uniform(-1.0, 1.0, count))
    curl = curl + 0.5 * limb.variety * chance.standard_normal(count)
    bend = curl[:, None] * along
    phase, turns = chance.uniform(0.0, 2.0 * np.pi, count), chance.uniform(0.5, 1.2, count)
    wave = np.sin(phase[:, None] + 2.0 * np.pi * turns[:, None] * along)
    wave *= _WAVE * limb.variety * 2.0 * along
    across = np.cross(ways, sides)
    step = np.cos(bend)[..., None] * ways[:, None] + np.sin(bend)[..., None] * sides[:, None]
    step = unit(step + np.tan(wave)[..., None] * across[:, None])
    points = np.empty((count, limb.nodes, 3))
    points[:, 0] = roots
    if segments:
        points[:, 1:] = np.cumsum(step * (length / segments)[:, None, None], axis=1)
        points[:, 1:] += roots[:, None]
    return points


def lengths(limb: Limb, at: Float64s, chance: Chance) -> Float64s:
    """Return lengths [m], (F,): `at`, 0 to 1, lies between the limb's two, with its variety."""
    low, high = limb.length
    vary = 1.0 + 0.4 * limb.variety * chance.uniform(-1.0, 1.0, len(at))
    found: Float64s = (low + (high - low) * at) * vary
    return found


def thickness(limb: Limb, scale: Float64s) -> Float64s:
    """Return the radii at a limb's nodes [m], (F, N), for fibres so many times as thick, (F,)."""
    at = np.linspace(0.0, 1.0, limb.nodes)
    profile = np.interp(at, np.linspace(0.0, 1.0, len(limb.radii)), limb.radii)
    return scale[:, None] * profile


def scattered(count: int, across: float, chance: Chance) -> Float64s:
    """Return places within a circle [m], (count, 2), evenly dense but in no pattern."""
    out = across * np.sqrt((np.arange(count) + chance.uniform(0.2, 0.8, count)) / max(count, 1))
    turn = np.radians(137.508) * np.arange(count) + chance.uniform(-0.4, 0.4, count)
    return np.stack([out * np.cos(turn), out * np.sin(turn)], axis=1)


def on_fibres(points: Float64s, fibre: Int32s, at: Float64s) -> tuple[Float64s, Float64s, Int32s]:
    """Return places [m] and directions `at` (0 root, 1 tip) along fibres of (P, N, 3), and the nearest nodes, (F,)."""
    segments = points.shape[1] - 1
    first = np.minimum((at * segments).astype(np.int32), segments - 1)
    low, high = points[fibre, first], points[fibre, first + 1]
    place = low + (at * segments - first)[:, None] * (high - low)
    node = np.minimum(np.rint(at * segments).astype(np.int32), segments)
    return place, unit(high - low), node
