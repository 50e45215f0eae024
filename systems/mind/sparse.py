"""A coarse grid for what is few and is perceived from afar: fishes that hunt, and food (FINDINGS 5).

Its cells are as wide as the world is where there are few of a kind, and at least a given width where there are many;
what lies within a cell's width is found in 27 cells, nine runs.
"""

from math import ceil
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int32s
from components.ground import Terrain
from components.kernels import inlined, row

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
    size: Float64s
    "[m] length of each fish that hunts; of the others it is not told"
    kind: Int32s
    "species of each fish that hunts; of the others it is not told"
    step: Int32s
    "each which of all is listed, so that no run of cells lists more than `LONGEST_RUN`, (1,)"


@row
def divide_coarsely(
    radius: float, depth: float, number: int, least: float
) -> tuple[float, int, int]:
    """Return a cell's side [m], at least `least` if the world is as wide, cells a side and layers.


    `radius` and `depth` [m] are the world's.
    """
    wide, side = 2.0 * radius, 1
    while side < _MOST_SIDE and wide / (side + 1) >= least:
        layers = max(1, ceil(depth * side / wide))
        if 27 * number <= WANTED * side * side * layers:
            break
        side += 1
    return wide / side, side, max(1, ceil(depth * side / wide))


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
    room: Sparse, depth: float, least: float, number: int, whole: int,
    x: Float64s, y: Float64s, z: Float64s, what: Int32s, keys: Int32s,
) -> tuple[float, int, int, int]:  # fmt: skip
    """Put `number` points that `what` names, in its order, into cells at least `least` [m] wide.

    By the `whole` number that there is in the world, about, goes the cells' size. Return the cells' side [m], cells a
    side, layers and `number`, which `room` does not know yet. `depth` [m] is the world's; `keys` is scratch.
    """
    cell, side, layers = divide_coarsely(room.extent, depth, whole, least)
    first = room.first
    sparse = divided(room, (cell, side, layers, number))
    first[: side * side * layers + 2] = 0
    for k in range(number):
        i, j, h = _index(sparse, x[what[k]], y[what[k]], z[what[k]])
        keys[k] = (i * side + j) * layers + h
        first[keys[k] + 2] += 1
    for at in range(side * side * layers):
        first[at + 2] += first[at + 1]
    longest = 0
    for column in range(side * side):
        at = column * layers
        longest = max(longest, first[at + layers + 1] - first[at + 1])
    sparse.step[0] = longest // LONGEST_RUN + 1
    for k in range(number):
        at, named = first[keys[k] + 1], what[k]
        first[keys[k] + 1] += 1
        room.x[at], room.y[at], room.z[at] = x[named], y[named], z[named]
        room.what[at] = named
    return cell, side, layers, number


@inlined
def divided(room: Sparse, cells: tuple[float, int, int, int]) -> Sparse:
    """Return `room` as `sort_sparse` says that it is divided."""
    cell, side, layers, number = cells
    return Sparse(
        cell, room.extent, side, layers, number, room.first, room.x, room.y, room.z, room.what, room.size,
        room.kind, room.step,
    )  # fmt: skip


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


def make_sparse(terrain: Terrain, capacity: int) -> Sparse:
    """Return room for `capacity` points of a world."""
    layers = max(1, ceil(terrain.depth * _MOST_SIDE / (2.0 * terrain.radius)))
    first = np.zeros(_MOST_SIDE * _MOST_SIDE * layers + 2, np.int32)
    x, y, z, size = (np.zeros(capacity) for _ in range(4))
    what, kind, step = (
        np.zeros(capacity, np.int32),
        np.zeros(capacity, np.int32),
        np.ones(1, np.int32),
    )
    return Sparse(0.0, terrain.radius, 0, 0, 0, first, x, y, z, what, size, kind, step)
