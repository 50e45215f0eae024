"""Sea fans and soft corals: a stem that branches again and again, flat or round, with polyps at the ends."""

from typing import Final

import numpy as np

from components.arrays import Float64s
from components.flora import Coral
from tools.grow.phyllotaxis import GOLDEN_DEG
from tools.grow.shape import (
    Carried,
    Chance,
    Part,
    curved,
    leaning,
    lengths,
    on_fibres,
    thickness,
    unit,
)

_LOWEST: Final = 0.28
"""Place of the lowest branch along its parent."""

_BLOOM_DEG: Final = 65.0
"""[deg] from the branch at which the outermost polyps of its end stand."""


def nodes(coral: Coral) -> int:
    """Return how many nodes one has."""
    branches = [coral.branches**order for order in range(coral.orders + 1)]
    return int(coral.stem.nodes * sum(branches) + branches[-1] * coral.polyps * coral.polyp.nodes)


def grow(coral: Coral, chance: Chance) -> list[Part]:
    """Return the stem, a part for each order of branches, and the polyps."""
    parts = [_stem(coral, chance)]
    for order in range(coral.orders):
        parts.append(_branches(coral, parts, order, chance))
    if coral.polyps:
        parts.append(_polyps(coral, parts, chance))
    return parts


def _stem(coral: Coral, chance: Chance) -> Part:
    limb = coral.stem
    way, side = leaning(chance.uniform(0.0, 2.0 * np.pi, 1), np.zeros(1))
    if coral.flat:
        side = np.array([[1.0, 0.0, 0.0]])
    long = lengths(limb, chance.uniform(0.0, 1.0, 1), chance)
    points = _flattened(coral, curved(np.zeros((1, 3)), way, side, long, limb, chance))
    return Part("branch", points, thickness(limb, np.ones(1)), limb)


def _branches(coral: Coral, parts: list[Part], order: int, chance: Chance) -> Part:
    parents, each = parts[-1], coral.branches
    count = len(parents.points) * each
    fibre = np.repeat(np.arange(len(parents.points), dtype=np.int32), each)
    step = np.arange(count) % each
    at = _LOWEST + (0.96 - _LOWEST) * (step + chance.uniform(0.2, 0.8, count)) / each
    place, along, node = on_fibres(parents.points, fibre, at)
    ways, sides = _ways(coral, along, step, order, chance)
    parent = np.linalg.norm(np.diff(parents.points, axis=1), axis=2).sum(1)[fibre]
    long = parent * coral.shrink * (1.15 - 0.5 * at) * chance.uniform(0.85, 1.15, count)
    points = _flattened(coral, curved(place, ways, sides, long, coral.stem, chance))
    thick = thickness(coral.stem, np.full(count, coral.shrink ** (order + 1)))
    return Part("branch", points, thick, coral.stem, Carried(len(parts) - 1, fibre, node))


def _ways(
    coral: Coral, along: Float64s, step: "np.ndarray", order: int, chance: Chance
) -> tuple[Float64s, Float64s]:
    """Return directions of branches that leave parents, and the way back to the light that they curl, (F, 3) each."""
    count = len(along)
    across, over = _frame(along, coral.flat)
    turn = np.pi * (step + order) if coral.flat else np.radians(GOLDEN_DEG) * np.arange(count)
    if not coral.flat:
        turn = turn + chance.uniform(-0.5, 0.5, count)
    out = np.cos(turn)[:, None] * across + np.sin(turn)[:, None] * over
    spread = np.radians(coral.spread) * chance.uniform(0.8, 1.2, count)
    ways = unit(np.cos(spread)[:, None] * along + np.sin(spread)[:, None] * out)
    return ways, unit(along - (along * ways).sum(1)[:, None] * ways)


def _frame(along: Float64s, flat: bool) -> tuple[Float64s, Float64s]:
    """Return two unit vectors across directions, (F, 3) each; the first in the plane of a fan."""
    normal = np.array([0.0, 1.0, 0.0]) if flat else np.array([0.31, 0.95, 0.05])
    across = unit(np.cross(normal, along))
    return across, np.cross(along, across)


def _flattened(coral: Coral, points: Float64s) -> Float64s:
    """Return a fan's fibres nearly in its plane; others as they are."""
    roots = points[:, :1]
    return roots + (points - roots) * (1.0, 0.15, 1.0) if coral.flat else points


def _polyps(coral: Coral, parts: list[Part], chance: Chance) -> Part:
    """Return the polyps: a bouquet at the end of each last branch."""
    ends, limb = parts[-1], coral.polyp
    count = len(ends.points) * coral.polyps
    fibre = np.repeat(np.arange(len(ends.points), dtype=np.int32), coral.polyps)
    node = np.full(count, ends.points.shape[1] - 1, np.int32)
    along = unit(ends.points[:, -1] - ends.points[:, -2])[fibre]
    across, over = _frame(along, False)
    step = (np.arange(count) % coral.polyps + 0.5) / coral.polyps
    turn = np.radians(GOLDEN_DEG) * np.arange(count) + chance.uniform(-0.4, 0.4, count)
    out = np.cos(turn)[:, None] * across + np.sin(turn)[:, None] * over
    lean = np.radians(_BLOOM_DEG) * np.sqrt(step)
    ways = np.cos(lean)[:, None] * along + np.sin(lean)[:, None] * out
    sides = np.cos(lean)[:, None] * out - np.sin(lean)[:, None] * along
    long = lengths(limb, chance.uniform(0.0, 1.0, count), chance)
    points = curved(ends.points[fibre, -1], ways, sides, long, limb, chance)
    thick = thickness(limb, np.ones(count))
    return Part("polyp", points, thick, limb, Carried(len(parts) - 1, fibre, node))
