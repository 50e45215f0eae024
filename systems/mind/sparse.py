"""A coarse grid for what is few and is perceived from afar: fishes that hunt, and food (FINDINGS 5).

Its cells are as wide as the world is where there are few of a kind, and at least a given width where there are many;
what lies within a cell's width is found in 27 cells, nine runs.
"""

from collections.abc import Sequence
from math import ceil
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int32s
from components.ground import Terrain
from components.kernels import Launch, inlined, row

WANTED: Final = 48
"""How many, at most, lie in 27 cells on average, unless cells would get too narrow."""

LONGEST_RUN: Final = 512
"""Of a longer run every second, third, ... is perceived: a swarm costs no more than this."""

MOST_LISTED: Final = 16 * (LONGEST_RUN + 1)
"""Room for what `list_sparse` lists."""

_MOST_SIDE: Final = 64


class Sparse(NamedTuple):
    """What is few, in the order of coarse cells; (capacity,) each but `first`."""

    cell: float
    "[m] side of a cell: what is nearer than this is found"
    extent: float
    "[m] half the side of the plan"
    side: int
    "cells a side"
    layers: int
    "layers of cells, from the surface down"
    number: int
    "how many there are"
    first: Int32s
    "where each cell begins, (side^2 layers + 2,)"
    x: Float64s
    "[m]"
    y: Float64s
    "[m]"
    z: Float64s
    "[m]"
    what: Int32s
    "place in the crowd, or row in the table of food"
    step: Int32s
    "each which of all is listed, so that no run of cells lists more than `LONGEST_RUN`, (1,)"


def no_sparse() -> Sparse:
    """Return a grid of nothing."""
    zeros = np.zeros(0)
    return Sparse(
        1.0, 1.0, 1, 1, 0, np.zeros(3, np.int32), zeros, zeros, zeros, np.zeros(0, np.int32),
        np.ones(1, np.int32),
    )  # fmt: skip


def divide_coarsely(terrain: Terrain, number: int, least: float) -> tuple[float, int, int]:
    """Return a cell's side [m], at least `least` if the world is as wide, cells a side and layers."""
    wide, side = 2.0 * terrain.radius, 1
    while side < _MOST_SIDE and wide / (side + 1) >= least:
        layers = max(1, ceil(terrain.depth * side / wide))
        if 27 * number <= WANTED * side * side * layers:
            break
        side += 1
    return wide / side, side, max(1, ceil(terrain.depth * side / wide))


@inlined
def _index(sparse: Sparse, x: float, y: float, z: float) -> tuple[int, int, int]:
    last = sparse.side - 1
    return (
        min(max(int((x + sparse.extent) / sparse.cell), 0), last),
        min(max(int((y + sparse.extent) / sparse.cell), 0), last),
        min(max(int(-z / sparse.cell), 0), sparse.layers - 1),
    )


@row
def sort_sparse(
    sparse: Sparse, x: Float64s, y: Float64s, z: Float64s, what: Int32s, keys: Int32s
) -> None:
    """Put the `number` points that `what` names, in its order, into cells; `keys` is scratch, (capacity,)."""
    number, first = sparse.number, sparse.first
    first[: sparse.side * sparse.side * sparse.layers + 2] = 0
    for k in range(number):
        i, j, h = _index(sparse, x[what[k]], y[what[k]], z[what[k]])
        keys[k] = (i * sparse.side + j) * sparse.layers + h
        first[keys[k] + 2] += 1
    for cell in range(sparse.side * sparse.side * sparse.layers):
        first[cell + 2] += first[cell + 1]
    longest = 0
    for column in range(sparse.side * sparse.side):
        at = column * sparse.layers
        longest = max(longest, first[at + sparse.layers + 1] - first[at + 1])
    sparse.step[0] = longest // LONGEST_RUN + 1
    for k in range(number):
        at, named = first[keys[k] + 1], what[k]
        first[keys[k] + 1] += 1
        sparse.x[at], sparse.y[at], sparse.z[at] = x[named], y[named], z[named]
        sparse.what[at] = named


@inlined
def find_sparse_runs(
    sparse: Sparse, x: float, y: float, z: float, reach: float, runs: Int32s
) -> int:
    """Write begin and end of each run of the cells within `reach` [m] of a point; return how many.

    They are at most sixteen where `reach` is at most a cell and a half.
    """
    if sparse.number == 0:
        return 0
    i, j, low = _index(sparse, x - reach, y - reach, z + reach)
    last_i, last_j, high = _index(sparse, x + reach, y + reach, z - reach)
    found = 0
    for a in range(i, last_i + 1):
        for b in range(j, last_j + 1):
            at = (a * sparse.side + b) * sparse.layers
            begin, end = sparse.first[at + low], sparse.first[at + high + 1]
            if end > begin:
                runs[2 * found], runs[2 * found + 1] = begin, end
                found += 1
    return found


@inlined
def list_sparse(
    sparse: Sparse, x: float, y: float, z: float, reach: float, runs: Int32s, listed: Int32s
) -> int:
    """List who stands within `reach` [m], at most a cell and a half, of a point; return how many.

    All lists are in one order, and leave out the same: what is near two points is in both lists.
    """
    many, limit, step = 0, reach * reach, sparse.step[0]
    for run in range(find_sparse_runs(sparse, x, y, z, reach, runs)):
        begin = (runs[2 * run] + step - 1) // step * step
        for k in range(begin, runs[2 * run + 1], step):
            dx, dy, dz = sparse.x[k] - x, sparse.y[k] - y, sparse.z[k] - z
            listed[many] = k
            many += dx * dx + dy * dy + dz * dz <= limit
    return many


class SparseGrid:
    """Scratch: makes the grid of a few anew each tick."""

    def __init__(self, terrain: Terrain) -> None:
        self.terrain = terrain
        self.sparse = no_sparse()
        self._keys = np.zeros(0, np.int32)
        self._sort = Launch(sort_sparse)
        self._divided: tuple[int, float] = (-1, 0.0)
        self._division = (1.0, 1, 1)

    def sort(self, points: Sequence[Float64s], what: Int32s, number: int, least: float) -> Sparse:
        """Sort the `number` points that `what` names of x, y, z [m]; cells are at least `least` [m] wide."""
        if self._divided != (number, least):
            self._divided = number, least
            self._division = divide_coarsely(self.terrain, number, least)
        cell, side, layers = self._division
        old = self.sparse
        cells, room = side * side * layers + 2, len(old.what)
        if number > room:
            room = max(2 * room, number)
            old = old._replace(
                x=np.zeros(room), y=np.zeros(room), z=np.zeros(room), what=np.zeros(room, np.int32)
            )
            self._keys = np.zeros(room, np.int32)
        if cells > len(old.first):
            old = old._replace(first=np.zeros(2 * cells, np.int32))
        self.sparse = old._replace(
            cell=cell, extent=self.terrain.radius, side=side, layers=layers, number=number
        )
        self._sort(self.sparse, points[0], points[1], points[2], what, self._keys)
        return self.sparse
