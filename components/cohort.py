"""The groups of fishes that a level brings in, who is to replace the eaten, and the count of ids given so far."""

from typing import Final

import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.table import Table, column

NEVER: Final = 1 << 62
"""The tick of an event that does not come."""

AT_RANDOM: Final = -2.0
"""Hunger of a group of which the level does not say how hungry it comes."""


class CohortTable(Table):
    """One row a group of the level, in the order of the file."""

    species: Int32s = column(np.int32)
    "row in the species table, (capacity,)"
    number: Int32s = column(np.int32)
    "how many fishes come, (capacity,)"
    around: Float64s = column(np.float64, 3)
    "[m] centre of the ball in which they appear, world axes, (capacity, 3)"
    within: Float64s = column(np.float64)
    "[m] radius of that ball, (capacity,)"
    arrives: Int64s = column(np.int64)
    "tick at which they appear, (capacity,)"
    leaves: Int64s = column(np.int64, fill=NEVER)
    "tick at which they go, (capacity,)"
    present: Int8s = column(np.int8)
    "1 from arrival until they leave, (capacity,)"
    hunger: Float64s = column(np.float64, fill=AT_RANDOM)
    "how hungry they come, -1 to 1; `AT_RANDOM`: fed at different times, (capacity,)"
    restock: Int64s = column(np.int64, fill=NEVER)
    "[ticks] from a fish being eaten to another's coming, `NEVER` for none, (capacity,)"


class RestockTable(Table):
    """One row a fish that was eaten and that another is to replace."""

    cohort: Int32s = column(np.int32)
    "row of the eaten one's group in `CohortTable`, (capacity,)"
    due: Int64s = column(np.int64)
    "tick from which the other may come, (capacity,)"


class Roster(Table):
    """One row: the next stable id."""

    next_id: Int64s = column(np.int64)
    "no fish has had this id or a larger one, (capacity,)"

    def __init__(self) -> None:
        super().__init__(count=1)

    def take(self, number: int) -> Int64s:
        """Return `number` fresh ids, rising."""
        first = int(self.next_id[0])
        self.next_id[0] = first + number
        return np.arange(first, first + number, dtype=np.int64)
