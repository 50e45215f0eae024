"""The nearest of a kind: so many pass a fish's attention, and no more (FINDINGS 5; papers/000, 3.2)."""

from typing import Final, TypeAlias

import numpy as np

from components.arrays import Float64s, Int32s, Int64s
from components.kernels import inlined
from systems.mind.attention import MOST_AROUND, NEIGHBOURS, NO_DANGER, Attention

_SLOTS: Final = MOST_AROUND - 1

Nearest: TypeAlias = tuple[float, float, float, float, float, float, float, float]
"""The nearest of a kind, nearest first: squared distances [m^2] whose last bits say who."""

NOBODY: Final = (NO_DANGER,) * NEIGHBOURS


@inlined
def name(square: float, slot: int) -> float:
    """Return a squared distance [m^2] with the slot in its last eleven bits, a part in 10^12."""
    bits = np.float64(square).view(np.int64)
    return float(np.int64((bits & ~_SLOTS) | slot).view(np.float64))


@inlined
def keep(nearest: Nearest, key: float) -> Nearest:
    """Let a `name` sink to its place among the nearest, without a branch: of a dozen each may be (FINDINGS 5)."""
    a, b, c, d, e, f, g, h = nearest
    a, key = min(a, key), max(a, key)
    b, key = min(b, key), max(b, key)
    c, key = min(c, key), max(c, key)
    d, key = min(d, key), max(d, key)
    e, key = min(e, key), max(e, key)
    f, key = min(f, key), max(f, key)
    g, key = min(g, key), max(g, key)
    return a, b, c, d, e, f, g, min(h, key)


@inlined
def list_nearest(
    nearest: Nearest, found: int, who: Int32s, square: Float64s, near: Int64s, distance: Float64s
) -> int:
    """List the nearest, at most `found`, by place and squared distance, (NEIGHBOURS,) each; return how many.

    `who` are the places by slot, `square` [m^2] the squares.
    """
    for k in range(NEIGHBOURS):
        slot = np.float64(nearest[k]).view(np.int64) & _SLOTS
        near[k], distance[k] = who[slot], square[slot]
    return min(found, NEIGHBOURS)


@inlined
def insert(other: int, square: float, near: Int64s, distance: Float64s, found: int) -> int:
    """Insert `other` among the nearest, (NEIGHBOURS,) each; return how many are kept. The first come stays."""
    if found == NEIGHBOURS and square >= distance[NEIGHBOURS - 1]:
        return found
    at = min(found, NEIGHBOURS - 1)
    while at > 0 and square < distance[at - 1]:
        near[at], distance[at] = near[at - 1], distance[at - 1]
        at -= 1
    near[at], distance[at] = other, square
    return min(found + 1, NEIGHBOURS)


@inlined
def nearest_of_kind(
    many: int, attention: Attention, piece: int, near: Int64s, distance: Float64s
) -> int:
    """List the nearest of the `many` of its kind that are seen, nearest first, (NEIGHBOURS,) each; return how many."""
    square, company, nearest = attention.square[piece], attention.company[piece], NOBODY
    for at in range(many):
        nearest = keep(nearest, name(square[company[at]], company[at]))
    return list_nearest(nearest, many, attention.around[piece], square, near, distance)
