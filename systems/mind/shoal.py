"""Shoals: what a fish sees of many of its kind farther off than it tells one from another.

Their number, mean place and mean heading over squares of the plan, summed in whole numbers so that the order of
summation cannot matter.
"""

from typing import Final, TypeAlias

import numba

from components.arrays import Float64s, Int8s
from components.kernel_turns import first_turn, next_turn
from components.kernels import inlined, loop, row
from systems.mind.crowd import Crowd
from systems.mind.grid import Plan

FIXED: Final = 65536.0
"""Whole numbers to a metre, or to a unit of heading, in the sums."""

Sums: TypeAlias = tuple[int, int, int, int, int, int, int]
"""Number, x, y, z and heading of a shoal, by `FIXED` but the first."""

NO_SHOAL: Final = (0, 0, 0, 0, 0, 0, 0)


@row
def _sum_strip(strip: int, plan: Plan, schooling: Int8s, crowd: Crowd) -> None:
    """Sum the shoals over one strip of squares, which no other strip touches."""
    crowd.shoal[:, strip * plan.squares : (strip + 1) * plan.squares] = 0
    begin = crowd.first[strip * plan.block * plan.columns]
    end = crowd.first[min((strip + 1) * plan.block, plan.columns) * plan.columns]
    kind = square = column = here = -1
    number = x = y = z = u = v = w = 0
    for k in range(begin, end + 1):
        if k < end and crowd.column[k] != column:
            column = crowd.column[k]
            here = strip * plan.squares + crowd.column[k] % plan.columns // plan.block
        if k == end or here != square or crowd.species[k] != kind:
            if number > 0 and schooling[kind] != 0:
                sums = crowd.shoal[kind, square]
                sums[0] += number
                sums[1], sums[2], sums[3] = sums[1] + x, sums[2] + y, sums[3] + z
                sums[4], sums[5], sums[6] = sums[4] + u, sums[5] + v, sums[6] + w
            if k == end:
                return
            kind, square = crowd.species[k], here
            number = x = y = z = u = v = w = 0
        number += 1
        x, y, z = (
            x + int(crowd.x[k] * FIXED),
            y + int(crowd.y[k] * FIXED),
            z + int(crowd.z[k] * FIXED),
        )
        u, v = u + int(crowd.hx[k] * FIXED), v + int(crowd.hy[k] * FIXED)
        w += int(crowd.hz[k] * FIXED)


@row
def sum_serially(plan: Plan, schooling: Int8s, crowd: Crowd) -> None:
    """Sum the shoals of a crowd's stretch on this thread; `schooling` is per species, (S,)."""
    for strip in range(crowd.stretch[2], crowd.stretch[3]):
        _sum_strip(strip, plan, schooling, crowd)


@loop
def sum_on_all(plan: Plan, schooling: Int8s, crowd: Crowd) -> None:
    """Sum the shoals of a crowd's stretch on all threads; `schooling` is per species, (S,)."""
    turns, first, end = first_turn(), crowd.stretch[2], crowd.stretch[3]
    for share in numba.prange(end - first):
        strip = first + next_turn(turns, share, end - first)
        while strip < end:
            _sum_strip(strip, plan, schooling, crowd)
            strip = first + next_turn(turns, share, end - first)


@inlined
def square_of(plan: Plan, column: int) -> int:
    """Return the square of the plan in which a column lies."""
    strip = column // plan.columns // plan.block
    return strip * plan.squares + column % plan.columns // plan.block


@row
def sum_around(plan: Plan, crowd: Crowd, kind: int, square: int) -> Sums:
    """Return the sums of a kind over the nine squares around a square."""
    side = plan.squares
    cx, cy = square // side, square % side
    number = x = y = z = u = v = w = 0
    for i in range(max(cx - 1, 0), min(cx + 2, side)):
        for j in range(max(cy - 1, 0), min(cy + 2, side)):
            sums = crowd.shoal[kind, i * side + j]
            number += int(sums[0])
            x, y, z = x + int(sums[1]), y + int(sums[2]), z + int(sums[3])
            u, v, w = u + int(sums[4]), v + int(sums[5]), w + int(sums[6])
    return number, x, y, z, u, v, w


@inlined
def see_shoal(crowd: Crowd, me: int, sums: Sums, sight: float, shoal: Float64s) -> float:
    """Write offset [m] and mean heading of one's own kind, (6,), of whom `sum_around` told; return how many.

    None where their middle is out of `sight` [m]. The fish itself is left out.
    """
    number = sums[0] - 1
    if number <= 0:
        return 0.0
    whole = number * FIXED
    dx = (sums[1] - int(crowd.x[me] * FIXED)) / whole - crowd.x[me]
    dy = (sums[2] - int(crowd.y[me] * FIXED)) / whole - crowd.y[me]
    dz = (sums[3] - int(crowd.z[me] * FIXED)) / whole - crowd.z[me]
    if dx * dx + dy * dy + dz * dz > sight * sight:
        return 0.0
    shoal[0], shoal[1], shoal[2] = dx, dy, dz
    shoal[3] = (sums[4] - int(crowd.hx[me] * FIXED)) / whole
    shoal[4] = (sums[5] - int(crowd.hy[me] * FIXED)) / whole
    shoal[5] = (sums[6] - int(crowd.hz[me] * FIXED)) / whole
    return float(number)
