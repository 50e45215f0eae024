"""Spiral phyllotaxis by collision (Fowler, Prusinkiewicz and Battjes 1992; papers/002, 3.1; FINDINGS 9).

Each primordium goes into the direction of the next multiple of the golden angle, as near the mouth as those before it
let it stand.
"""

from functools import lru_cache
from typing import Final

import numpy as np

from components.arrays import Float64s

GOLDEN_DEG: Final = 137.508
"""[deg] from one primordium to the next."""

_REJECTIONS: Final = 100


@lru_cache(maxsize=64)
def phyllotaxis(radius: float, mouth: float, base: float) -> Float64s:
    """Return where primordia of radius `base` stand on a disc around a mouth [m], (n, 2), innermost first as they come.

    None overlap, none reach beyond the disc or into the mouth; none at all where the ring between is narrower than one.
    """
    found = np.empty((_most(radius, mouth, base), 2))
    count = rejected = turn = 0
    while rejected < _REJECTIONS and count < len(found):
        angle = np.radians(GOLDEN_DEG) * turn
        way = np.array([np.cos(angle), np.sin(angle)])
        r = _nearest(found[:count], way, mouth + base, 2.0 * base)
        turn += 1
        if r + base > radius:
            rejected += 1
            continue
        found[count] = r * way
        count += 1
    placed = found[:count].copy()
    placed.setflags(write=False)
    return placed


def _most(radius: float, mouth: float, base: float) -> int:
    """Return more than can ever stand there: the ring's area over a primordium's."""
    if base <= 0.0 or radius <= mouth:
        return 0
    return int((radius * radius - mouth * mouth) / (base * base)) + 1


def _nearest(placed: Float64s, way: Float64s, start: float, apart: float) -> float:
    """Return the least distance from `start` on in the direction `way` that is `apart` [m] from all that stand."""
    along = placed @ way
    room2 = apart * apart - ((placed * placed).sum(1) - along * along)
    close = room2 > 0.0
    half = np.sqrt(room2[close])
    low, high = along[close] - half, along[close] + half
    r = start
    for at in np.argsort(low):
        if low[at] >= r:
            break
        r = max(r, float(high[at]))
    return r
