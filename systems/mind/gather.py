"""Gathering: the fishes around a cell, side by side, for all who stand in the cell (FINDINGS 5)."""

from typing import Final

from components.arrays import Int32s, Int64s
from components.kernels import inlined, row
from systems.mind.attention import MOST_AROUND, Attention
from systems.mind.crowd import Crowd
from systems.mind.grid import REACH, Plan

_SHORT: Final = 24
_FEW: Final = 160


@inlined
def reach_of(plan: Plan, sight: float, length: float) -> float:
    """Return how far [m] a fish tells its neighbours apart: in a crowd only so many of its lengths."""
    return min(sight, plan.cell, REACH * length) if plan.crowded else min(sight, plan.cell)


@inlined
def first_not_above(layer: Int32s, begin: int, end: int, value: int) -> int:
    """Return the first place in begin..end whose layer is at least `value`."""
    while begin < end:
        middle = (begin + end) // 2
        if layer[middle] < value:
            begin = middle + 1
        else:
            end = middle
    return begin


@inlined
def layers_between(layer: Int32s, begin: int, end: int, low: int, high: int) -> tuple[int, int]:
    """Return the run within begin..end whose layers are at least `low` and less than `high`."""
    if end - begin > _SHORT:
        begin = first_not_above(layer, begin, end, low)
        return begin, first_not_above(layer, begin, end, high)
    # Counting a few mispredicts nothing.
    first = last = begin
    for k in range(begin, end):
        first += layer[k] < low
        last += layer[k] < high
    return first, last


@inlined
def find_runs(plan: Plan, crowd: Crowd, column: int, layer: int, runs: Int64s) -> int:
    """Write begin and end of each run of fishes in the 27 cells around a cell; return how many."""
    cx, cy = column // plan.columns, column % plan.columns
    found = 0
    for x in range(max(cx - 1, 0), min(cx + 2, plan.columns)):
        for y in range(max(cy - 1, 0), min(cy + 2, plan.columns)):
            begin = crowd.first[x * plan.columns + y]
            end = crowd.first[x * plan.columns + y + 1]
            if begin == end:
                continue
            begin, end = layers_between(crowd.layer, begin, end, layer - 1, layer + 2)
            if end > begin:
                runs[2 * found], runs[2 * found + 1] = begin, end
                found += 1
    return found


@inlined
def _put(crowd: Crowd, k: int, number: int, attention: Attention, piece: int) -> None:
    """Put the fish at the place k of the crowd at `number` of those around."""
    attention.around_x[piece, number] = crowd.x[k]
    attention.around_y[piece, number] = crowd.y[k]
    attention.around_z[piece, number] = crowd.z[k]
    attention.around[piece, number] = k
    attention.kinds[piece, number] = crowd.species[k]


@row
def _gather_many(
    plan: Plan, crowd: Crowd, column: int, layer: int, attention: Attention, piece: int
) -> int:
    """Gather where many stand above each other; of more than `MOST_AROUND` every second, third, ... ."""
    runs = attention.runs[piece]
    number_of_runs = find_runs(plan, crowd, column, layer, runs)
    total = number = 0
    for run in range(number_of_runs):
        total += runs[2 * run + 1] - runs[2 * run]
    step = 1 if total <= MOST_AROUND else total // MOST_AROUND + 1
    for run in range(number_of_runs):
        for k in range(runs[2 * run], runs[2 * run + 1], step):
            if number < MOST_AROUND:
                _put(crowd, k, number, attention, piece)
                number += 1
    return number


@inlined
def gather(
    plan: Plan, crowd: Crowd, column: int, layer: int, attention: Attention, piece: int
) -> int:
    """Put the fishes of the 27 cells around a cell side by side; return how many are looked at.

    Columns beside each other lie side by side in the crowd: three strips, of which each fish is tried without a branch.
    """
    side, cx, cy = plan.columns, column // plan.columns, column % plan.columns
    west, east = max(cx - 1, 0), min(cx + 2, side)
    south, north = max(cy - 1, 0), min(cy + 2, side)
    total = number = 0
    for x in range(west, east):
        total += crowd.first[x * side + north] - crowd.first[x * side + south]
    if total > _FEW:
        return _gather_many(plan, crowd, column, layer, attention, piece)
    for x in range(west, east):
        for k in range(crowd.first[x * side + south], crowd.first[x * side + north]):
            _put(crowd, k, number, attention, piece)
            number += (crowd.layer[k] >= layer - 1) & (crowd.layer[k] <= layer + 1)
    return number
