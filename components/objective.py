"""What the player is asked to do, and how far it is done."""

from dataclasses import dataclass

import numpy as np

from components.arrays import Int8s, Int32s, Int64s
from components.table import Table, column


@dataclass(frozen=True)
class Photograph:
    """Objective: `count` fishes of a species in one frame, each within a distance."""

    species: int
    "row in the species table"
    count: int
    within: float
    "[m]"


class ObjectiveTable(Table):
    """One row an objective of the level."""

    best: Int32s = column(np.int32)
    "most fishes that one photograph counted, (capacity,)"
    latest: Int32s = column(np.int32, fill=-1)
    "fishes that the latest photograph counted, -1 before the first, (capacity,)"
    shots: Int32s = column(np.int32)
    "photographs taken, (capacity,)"
    framed: Int32s = column(np.int32)
    "fishes that a photograph taken now would count; judged ten times a second, (capacity,)"
    won_at: Int64s = column(np.int64, fill=-1)
    "tick of success, -1 before, (capacity,)"
    score: Int32s = column(np.int32)
    "points, 0 until success, (capacity,)"
    done: Int8s = column(np.int8)
    "1 after success, (capacity,)"
