"""Interpolates fibres from their guides: fifty that bend make thousands that are drawn (papers/002, section 5.4).

Directions are blended and lengths rebuilt, so followers no more stretch than their guides do. Where the guides point
so differently that their mean is short, the nearest alone is followed (FINDINGS 9).
"""

from math import sqrt
from typing import Final

import numba
import numpy as np

from components.arrays import Float32s
from components.fibre import LANES, Followers, Strands
from components.garden import Garden
from components.kernels import loop, row

_0, _1, _LOST = np.float32(0.0), np.float32(1.0), np.float32(0.25)
_GUIDES: Final = 3


@row
def _follow_fibre(
    strands: Strands, followers: Followers, position: Float32s, group: int, lane: int
) -> None:
    first, nodes = followers.bundle[group, 0], followers.bundle[group, 1]
    root, weight, guide = followers.root, followers.weight, followers.guide
    x, y, z = root[group, 0, lane], root[group, 1, lane], root[group, 2, lane]
    for g in range(_GUIDES):
        share, row, beside = (
            weight[group, g, lane],
            guide[group, g, lane] // LANES,
            guide[group, g, lane] % LANES,
        )
        x = x + share * strands.position[row, 0, beside]
        y = y + share * strands.position[row, 1, beside]
        z = z + share * strands.position[row, 2, beside]
    position[first, 0, lane], position[first, 1, lane], position[first, 2, lane] = x, y, z
    behind = len(strands.length)
    for node in range(1, nodes):
        dx, dy, dz = _0, _0, _0
        for g in range(_GUIDES):
            share, row, beside = (
                weight[group, g, lane],
                guide[group, g, lane] // LANES + node,
                guide[group, g, lane] % LANES,
            )
            dx = dx + share * strands.direction[row, 0, beside]
            dy = dy + share * strands.direction[row, 1, beside]
            dz = dz + share * strands.direction[row, 2, beside]
        q = dx * dx + dy * dy + dz * dz
        if not q > _LOST:
            row, beside = guide[group, 0, lane] // LANES + node, guide[group, 0, lane] % LANES
            dx = strands.direction[row, 0, beside]
            dy = strands.direction[row, 1, beside]
            dz = strands.direction[row, 2, beside]
            q = dx * dx + dy * dy + dz * dz
        at = first + node
        size = followers.length[at - behind, lane] / sqrt(q)
        x, y, z = x + size * dx, y + size * dy, z + size * dz
        position[at, 0, lane], position[at, 1, lane], position[at, 2, lane] = x, y, z


@loop
def _follow_all(strands: Strands, followers: Followers, position: Float32s) -> None:
    for group in numba.prange(len(followers.bundle)):
        for lane in range(LANES):
            _follow_fibre(strands, followers, position, group, lane)


def follow(garden: Garden) -> None:
    """Write the nodes of the garden's followers, from where its guides are now."""
    if len(garden.followers.bundle):
        _follow_all(garden.strands, garden.followers, garden.position)
