"""Which bundle and lane each fibre of a garden has (components/fibre.py has the layout).

Bundles are ordered by depth of carrying, so that a foot is bent before the tentacles that stand on it; followers come
last, for they are blended when all else is bent.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from components.arrays import Int32s
from components.fibre import CARRIED, LANES, Tuft


class Plan(NamedTuple):
    """Which bundle and lane each fibre has."""

    first_fibre: Int32s
    of_fibre: Int32s
    "8 bundle + lane, (fibres,)"
    bundle: Int32s
    "first row, nodes, clump, flags, (bundles, 4); followers last"
    filled: Int32s
    "lanes that hold a fibre of their own, (bundles,)"
    clump: Int32s
    "of each tuft, -1 for followers, (tufts,)"
    depths: tuple[int, ...]
    rows: int
    bent_rows: int


def _depth(tufts: Sequence[Tuft], index: int) -> int:
    """Return how many carry what carries this tuft. Raise ValueError where one does not come before it."""
    depth, tuft = 0, tufts[index]
    while tuft.carriers is not None:
        above = tuft.carriers.tuft
        if not 0 <= above < index or tufts[above].guides is not None:
            raise ValueError(f"tuft {index} is carried by a tuft before it that bends by itself")
        fibre, node = np.asarray(tuft.carriers.fibre), np.asarray(tuft.carriers.node)
        if not ((fibre >= 0) & (fibre < tufts[above].fibres)).all():
            raise ValueError(f"tuft {index} is carried by fibres of tuft {above} that exist")
        if not ((node >= 0) & (node < tufts[above].nodes)).all():
            raise ValueError(f"tuft {index} is carried by nodes of tuft {above} that exist")
        index, tuft, depth = above, tufts[above], depth + 1
    return depth


def _checked_guides(tufts: Sequence[Tuft], index: int) -> None:
    tuft = tufts[index]
    guides = tuft.guides
    if guides is None:
        return
    if not 0 <= guides < index or tufts[guides].guides is not None or tuft.carriers is not None:
        raise ValueError(f"tuft {index} is guided by a tuft before it that bends by itself")
    if tufts[guides].nodes != tuft.nodes or not tufts[guides].fibres:
        raise ValueError(f"tuft {index} has as many nodes as its guides, and one guide or more")


def plan_bundles(tufts: Sequence[Tuft]) -> Plan:
    """Put fibres into bundles of eight, by depth; small tufts of one depth and node count share a bundle."""
    first_fibre = np.zeros(len(tufts) + 1, np.int32)
    first_fibre[1:] = np.cumsum([tuft.fibres for tuft in tufts])
    of_fibre = np.zeros(first_fibre[-1], np.int32)
    clump_of = np.full(len(tufts), -1, np.int32)
    keys = []
    for index, tuft in enumerate(tufts):
        _checked_guides(tufts, index)
        keys.append((tuft.guides is not None, _depth(tufts, index), tuft.nodes, index))
    bundles: list[tuple[int, int, int, int]] = []
    filled: list[int] = []
    starts: dict[tuple[bool, int], int] = {}
    row, clumps, shared = 0, 0, (-1, -1, -1)
    bent_rows = 0
    for following, depth, nodes, index in sorted(keys, key=lambda k: (k[0], k[1], k[3])):
        number = tufts[index].fibres
        starts.setdefault((following, depth), len(bundles))
        if not number:
            continue
        joins = shared == (following, depth, nodes) and filled[-1] + number <= LANES
        begin = LANES * (len(bundles) - 1) + filled[-1] if joins else LANES * len(bundles)
        of_fibre[first_fibre[index] : first_fibre[index + 1]] = begin + np.arange(number)
        if joins:
            filled[-1] += number
        else:
            for start in range(0, number, LANES):
                bundles.append((row, nodes, clumps, CARRIED * (depth > 0)))
                filled.append(min(LANES, number - start))
                row += nodes
            clumps += 1
        shared = (following, depth, nodes) if number < LANES else (-1, -1, -1)
        if not following:
            clump_of[index], bent_rows = clumps - 1, row
    ends = [starts[key] for key in sorted(starts) if not key[0]]
    last = next((starts[key] for key in sorted(starts) if key[0]), len(bundles))
    return Plan(
        first_fibre,
        of_fibre,
        np.array(bundles, np.int32).reshape(-1, 4),
        np.array(filled, np.int32),
        clump_of,
        (*ends, last) if ends else (0, last),
        row,
        bent_rows,
    )
