"""Bends fibres towards their equilibrium in the flow, on one backend or another (papers/002, section 4).

The kernel stands twice, in fibres_numba.py and in fibres.cl; both give the same bits. What is not seen need not be
bent: it eases into its place when it comes into view.
"""

from itertools import pairwise
from typing import Final, Protocol

import numpy as np

from components.arrays import AnyArray, Float32s, Int32s
from components.garden import Garden
from systems.sea.fibres_numba import F, bend_bundles, bend_in_parallel
from systems.sea.follow import follow
from systems.sea.gather import Lists, gather

LEAST_NODES: Final = 512
"""Nodes below which a parallel launch takes longer than it saves."""

SETTLING: Final = 0.3
"""[s] tau, in which a fibre comes 63 % of the way."""


class Bender(Protocol):
    """What bends a garden: numba's twin here, or systems/sea/fibres_opencl.py."""

    @property
    def name(self) -> str:
        """Return `opencl` or `numba`."""

    @property
    def note(self) -> str:
        """Return one line that says why this bends and not what was asked for; empty where it is that."""

    def step(
        self, garden: Garden, packed: Float32s, seconds: float, seen: AnyArray | None = None
    ) -> None:
        """Bend the garden's fibres for `seconds` in the flow of `packed` (`components.field.pack`), (n, 16).

        `seen` says of each clump, (clumps,) bool, whether it is to be bent at all; None bends all.
        """


def part_of(seconds: float) -> float:
    """Return 1 - e^(-h / tau), the part of its way that a fibre goes in h [s]: from 0 to 1, float32."""
    return F(1.0 - float(np.exp(-max(seconds, 0.0) / SETTLING)))


def turns(garden: Garden, seen: AnyArray | None) -> list[Int32s]:
    """Return the bundles to bend at once, what carries before what it carries."""
    bundles = np.arange(garden.depths[-1], dtype=np.int32)
    turns = [bundles[begin:end] for begin, end in pairwise(garden.depths)]
    if seen is None:
        return turns
    wanted = seen[garden.strands.bundle[:, 2]]
    return [bundles[wanted[bundles]] for bundles in turns]


class NumbaBender:
    """Bends with numba, in parallel or not; reads and writes a garden's `strands` and `followers`."""

    name = "numba"
    note = ""

    def __init__(self, parallel: bool = True, culled: bool = True) -> None:
        self._parallel = parallel
        self._culled = culled
        self._lists: Lists | None = None

    def step(
        self, garden: Garden, packed: Float32s, seconds: float, seen: AnyArray | None = None
    ) -> None:
        """Bend the garden's fibres, those of the clumps that are `seen`; see `Bender`."""
        lists = gather(garden.clump_sphere, packed, self._lists, self._culled)
        self._lists = lists
        part = part_of(seconds)
        parallel = self._parallel and garden.strands.length.size >= LEAST_NODES
        bend = bend_in_parallel if parallel else bend_bundles
        for bundles in turns(garden, seen):
            bend(garden.strands, garden.rocks, packed, lists, bundles, part)
        follow(garden)
