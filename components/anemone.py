"""Anemones as play knows them: a ball that their tentacles fill at rest, the cap (papers/002, section 1).

Contact is judged against the cap, never the bent nodes, so that simulation truth does not depend on what bends them.
Who lives in anemones is not stung (`SenseTable.at_home`); all others are, and who is small enough is held and eaten.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s, Int64s
from components.table import Table, column


class Cap(NamedTuple):
    """One anemone."""

    centre: tuple[float, float, float]
    "[m] of the ball"
    radius: float
    "[m] of the ball"
    stings: bool = True
    holds: float = 0.0
    "[m] length of the largest fish that it holds and eats; 0: none"


class AnemoneTable(Table):
    """One row an anemone, in the order of the level's plants. Its first four columns never change during a dive."""

    centre: Float64s = column(np.float64, 3)
    "[m] of the cap, (capacity, 3)"
    radius: Float64s = column(np.float64)
    "[m] of the cap, (capacity,)"
    stings: Int8s = column(np.int8)
    "1 where its tentacles sting, (capacity,)"
    holds: Float64s = column(np.float64)
    "[m] length of the largest fish that it holds and eats, 0 for none, (capacity,)"
    prey: Int64s = column(np.int64, fill=-1)
    "stable id of the fish that it holds, -1 for none, (capacity,)"
    since: Int64s = column(np.int64)
    "tick at which it took that fish, (capacity,)"
    sated_until: Int64s = column(np.int64)
    "tick until which it digests and takes no other, (capacity,)"


def anemone_table(caps: Sequence[Cap]) -> AnemoneTable:
    """Return the table of these anemones, each with nothing in its tentacles."""
    table = AnemoneTable(count=len(caps))
    for row, cap in enumerate(caps):
        table.centre[row], table.radius[row] = cap.centre, cap.radius
        table.stings[row], table.holds[row] = cap.stings, cap.holds
    return table
