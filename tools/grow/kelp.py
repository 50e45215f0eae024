"""Kelp: long stipes that rise to the light, fronds along them and gas bladders at the fronds' roots."""

from typing import Final

import numpy as np

from components.flora import Kelp, Limb
from tools.grow.phyllotaxis import GOLDEN_DEG
from tools.grow.shape import (
    Carried,
    Chance,
    Part,
    curved,
    leaning,
    lengths,
    on_fibres,
    scattered,
    thickness,
)

_BARE: Final = 0.12
"""Share of a stipe, from its root, that has no fronds."""

_BLADDER_NODES: Final = 4
_TOP: Final = 0.3
"""[m] that the longest stipe stays below the surface."""


def nodes(kelp: Kelp) -> int:
    """Return how many nodes one plant has."""
    each = kelp.frond.nodes + (_BLADDER_NODES if kelp.bladder else 0)
    return kelp.stipes * (kelp.stipe.nodes + kelp.fronds * each)


def grow(kelp: Kelp, chance: Chance, headroom: float) -> list[Part]:
    """Return stipes, fronds and bladders. No stipe is longer than `headroom` [m] to the surface allows."""
    stipes = _stipes(kelp, chance, max(headroom - _TOP, _TOP))
    if not kelp.fronds:
        return [stipes]
    fronds, ways = _fronds(kelp, stipes, chance)
    return [stipes, fronds, *([_bladders(kelp, fronds, ways)] if kelp.bladder else [])]


def _stipes(kelp: Kelp, chance: Chance, most: float) -> Part:
    limb, count = kelp.stipe, kelp.stipes
    roots = np.column_stack([scattered(count, kelp.across, chance), np.zeros(count)])
    outwards = chance.uniform(0.0, 2.0 * np.pi, count)
    ways, sides = leaning(outwards, chance.uniform(0.0, 0.15, count))
    long = np.minimum(lengths(limb, chance.uniform(0.0, 1.0, count), chance), most)
    points = curved(roots, ways, sides, long, limb, chance)
    return Part("stipe", points, thickness(limb, chance.uniform(0.85, 1.1, count)), limb)


def _fronds(kelp: Kelp, stipes: Part, chance: Chance) -> "tuple[Part, np.ndarray]":
    limb, count = kelp.frond, kelp.stipes * kelp.fronds
    fibre = np.repeat(np.arange(kelp.stipes, dtype=np.int32), kelp.fronds)
    step = (np.arange(count) % kelp.fronds + 0.5) / kelp.fronds
    place, _, node = on_fibres(stipes.points, fibre, _BARE + (1.0 - _BARE) * step)
    azimuth = np.radians(GOLDEN_DEG) * np.arange(count) + chance.uniform(-0.4, 0.4, count)
    rise = np.radians(kelp.rise) * (1.0 + limb.variety * chance.uniform(-0.5, 0.5, count))
    ways, sides = leaning(azimuth, rise)
    # Fronds are shorter towards the tip of the stipe.
    long = lengths(limb, 1.0 - step, chance)
    roots = place + 2.5 * kelp.bladder * ways
    carried = Carried(0, fibre, node)
    points = curved(roots, ways, sides, long, limb, chance)
    return Part("frond", points, thickness(limb, long / limb.length[1]), limb, carried), ways


def _bladders(kelp: Kelp, fronds: Part, ways: "np.ndarray") -> Part:
    """Return a short, thick fibre between each frond and its stipe."""
    r = kelp.bladder
    limb = Limb(_BLADDER_NODES, (3.0 * r, 3.0 * r), (0.25 * r, r, r, 0.3 * r), 0.0)
    limb = limb._replace(modulus=kelp.stipe.modulus * 10.0, exponent=kelp.stipe.exponent)
    along = np.linspace(-2.5 * r, 0.5 * r, _BLADDER_NODES)
    points = fronds.points[:, :1] + along[None, :, None] * ways[:, None]
    return Part("bladder", points, thickness(limb, np.ones(len(points))), limb, fronds.carried)
