"""Spheres listed by the squares of the sea, seen from above, that they reach: what concerns a point is found at once.

Singularities and the caps of anemones are few and fishes are many: a fish reads the list of its own square (papers/002,
section 5.1 culls the same way). Lists name spheres in rising order, so sums over them are those over all, to the bit.
"""

from math import floor
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int32s
from components.kernels import inlined, row

SIDE: Final = 32
"""Squares a side."""


class SphereGrid(NamedTuple):
    """Rows of spheres by square."""

    extent: float
    "[m] half the side of what is covered; squares at the border serve what lies beyond"
    first: Int32s
    "where the list of square i SIDE + j begins, (SIDE^2 + 1,)"
    listed: Int32s
    "rows of spheres, square by square; there may be room behind the last"


@inlined
def _line(extent: float, x: float) -> int:
    """Return the row or column of squares in which a coordinate [m] lies."""
    at = (x + extent) * (0.5 * SIDE / extent)
    return floor(min(max(at, 0.0), SIDE - 1.0))


@inlined
def square_at(grid: SphereGrid, x: float, y: float) -> int:
    """Return the square whose list serves (x, y) [m]."""
    return _line(grid.extent, x) * SIDE + _line(grid.extent, y)


@inlined
def lists_none(grid: SphereGrid, x: float, y: float) -> bool:
    """Say whether no sphere is listed for (x, y) [m]."""
    square = square_at(grid, x, y)
    return bool(grid.first[square] == grid.first[square + 1])


@inlined
def _span(extent: float, centre: Float64s, k: int, reach: float) -> tuple[int, int, int, int]:
    """Return the first and last row and column of squares that sphere k may reach."""
    x, y, far = centre[k, 0], centre[k, 1], reach * 1.0001 + 1e-6
    return (
        _line(extent, x - far),
        _line(extent, x + far),
        _line(extent, y - far),
        _line(extent, y + far),
    )


@row
def fill_lists(grid: SphereGrid, centre: Float64s, reach: Float64s) -> int:
    """List spheres as `list_spheres` does; return the room that needs: where `listed` has less, only that is right."""
    extent, first, listed = grid
    for square in range(SIDE * SIDE + 1):
        first[square] = 0
    needed = 0
    for k in range(len(reach)):
        if reach[k] > 0.0:
            a, b, c, d = _span(extent, centre, k, reach[k])
            for i in range(a, b + 1):
                for j in range(c, d + 1):
                    first[i * SIDE + j] += 1
            needed += (b - a + 1) * (d - c + 1)
    if needed > len(listed):
        return needed
    end = 0
    for square in range(SIDE * SIDE + 1):
        end += first[square]
        first[square] = end
    for back in range(len(reach)):
        k = len(reach) - 1 - back
        if reach[k] > 0.0:
            a, b, c, d = _span(extent, centre, k, reach[k])
            for i in range(a, b + 1):
                for j in range(c, d + 1):
                    first[i * SIDE + j] -= 1
                    listed[first[i * SIDE + j]] = k
    return needed


def list_spheres(grid: SphereGrid, centre: Float64s, reach: Float64s) -> SphereGrid:
    """Return the grid with these spheres listed: `centre` [m], (n, 3), no NaN; `reach` [m], (n,), inf for everywhere.

    Spheres without reach are left out. It writes into `grid` where there is room.
    """
    needed = fill_lists(grid, centre, reach)
    if needed > len(grid.listed):
        grid = grid._replace(listed=np.zeros(2 * needed, np.int32))
        fill_lists(grid, centre, reach)
    return grid


def sphere_grid(extent: float) -> SphereGrid:
    """Return a grid that covers the square of half side `extent` [m] and lists nothing."""
    return SphereGrid(float(extent), np.zeros(SIDE * SIDE + 1, np.int32), np.zeros(64, np.int32))


def empty(grid: SphereGrid) -> bool:
    """Return whether it lists nothing."""
    return int(grid.first[-1]) == 0
