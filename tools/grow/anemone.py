"""Anemones: a wide fibre as foot, tentacles on its end in phyllotactic order (papers/002, 3.1, Fig. 6)."""

import numpy as np

from components.arrays import Float64s
from components.flora import Anemone
from tools.grow.phyllotaxis import phyllotaxis
from tools.grow.shape import Carried, Chance, Part, curved, leaning, lengths, thickness, unit

_JITTER = 0.3


def tentacles(anemone: Anemone) -> int:
    """Return how many tentacles stand on the disc."""
    return len(phyllotaxis(anemone.radius, anemone.mouth, anemone.base))


def nodes(anemone: Anemone) -> int:
    """Return how many nodes one has."""
    return anemone.foot.nodes + tentacles(anemone) * anemone.tentacle.nodes


def grow(anemone: Anemone, chance: Chance) -> list[Part]:
    """Return an anemone's foot and tentacles."""
    foot = _foot(anemone, chance)
    return [foot, _tentacles(anemone, foot, chance)] if tentacles(anemone) else [foot]


def _foot(anemone: Anemone, chance: Chance) -> Part:
    limb = anemone.foot
    way, side = leaning(chance.uniform(0.0, 2.0 * np.pi, 1), np.zeros(1))
    long = lengths(limb, chance.uniform(0.0, 1.0, 1), chance)
    points = curved(np.zeros((1, 3)), way, side, long, limb, chance)
    return Part("foot", points, thickness(limb, np.ones(1)), limb)


def _tentacles(anemone: Anemone, foot: Part, chance: Chance) -> Part:
    limb, top = anemone.tentacle, foot.points[0, -1]
    places = phyllotaxis(anemone.radius, anemone.mouth, anemone.base)
    count = len(places)
    out = np.linalg.norm(places, axis=1)
    at = (out - anemone.mouth) / (anemone.radius - anemone.mouth)
    high = anemone.dome * anemone.radius * (1.0 - (out / anemone.radius) ** 2)
    roots = np.column_stack([places, high])
    splay = np.radians(np.interp(at, (0.0, 1.0), anemone.splay))
    splay = splay + _JITTER * limb.variety * chance.standard_normal(count)
    azimuth = np.arctan2(places[:, 1], places[:, 0])
    azimuth = azimuth + 2.0 * _JITTER * limb.variety * chance.standard_normal(count)
    ways, sides = leaning(azimuth, splay)
    points = curved(roots, ways, sides, lengths(limb, at, chance), limb, chance)
    # They stand on the end of the foot, which leans as it curls.
    points = top + points @ _axes(unit(top - foot.points[0, -2]))
    thick = thickness(limb, chance.uniform(0.9, 1.05, count))
    carried = Carried(
        0, np.zeros(count, np.int32), np.full(count, foot.points.shape[1] - 1, np.int32)
    )
    return Part("tentacle", points, thick, limb, carried)


def _axes(up: Float64s) -> Float64s:
    """Return axes as rows, (3, 3), whose third is the unit vector `up`, turned as little as brings z there."""
    x, y, z = up
    lean = 1.0 / (1.0 + max(z, -0.99))
    first, second = (1.0 - x * x * lean, -x * y * lean, -x), (-x * y * lean, 1.0 - y * y * lean, -y)
    return np.array([first, second, up])
