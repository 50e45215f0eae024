"""Seagrass: blades of one patch, a few of which bend while the others are interpolated (papers/002, 5.3, 5.4)."""

import numpy as np

from components.flora import Seagrass
from tools.grow.shape import Chance, Part, curved, leaning, lengths, scattered, thickness


def nodes(grass: Seagrass) -> int:
    """Return how many nodes one patch has."""
    return grass.blades * grass.blade.nodes


def grow(grass: Seagrass, chance: Chance) -> list[Part]:
    """Return a patch's guides and the blades between them."""
    guides = min(grass.guides, grass.blades)
    parts = [_blades(grass, guides, chance)]
    if grass.blades > guides:
        parts.append(_blades(grass, grass.blades - guides, chance)._replace(guides=0))
    return parts


def _blades(grass: Seagrass, count: int, chance: Chance) -> Part:
    limb = grass.blade
    roots = np.column_stack([scattered(count, grass.across, chance), np.zeros(count)])
    lean = np.radians(grass.lean) * np.sqrt(chance.uniform(0.0, 1.0, count))
    outwards = np.arctan2(roots[:, 1], roots[:, 0]) + chance.uniform(-1.2, 1.2, count)
    ways, sides = leaning(outwards, lean)
    long = lengths(limb, chance.uniform(0.0, 1.0, count), chance)
    points = curved(roots, ways, sides, long, limb, chance)
    return Part("blade", points, thickness(limb, chance.uniform(0.8, 1.1, count)), limb)
