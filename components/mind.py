"""What each fish attends to, wants and intends, and why (papers/004; papers/000 sections 3.2 and
6).

The rows stand in step with `FishTable`'s (components/fish.py).
"""

from enum import IntEnum
from typing import Final

import numpy as np

from components.arrays import Float64s, Int8s, Int64s
from components.table import Table, column


class Role(IntEnum):
    """The three types of artificial fish (papers/004)."""

    PREY = 0
    PREDATOR = 1
    PACIFIST = 2


class Intention(IntEnum):
    """What a fish is about; each has a behaviour routine of its own in systems/mind/behave."""

    WANDER = 0
    AVOID_OBSTACLE = 1
    AVOID_FISH = 2
    SCHOOL = 3


SUBMARINE: Final = -2
"""What the focus holds where the submarine is attended to."""


class MindTable(Table):
    """The mind of each fish, one row each."""

    intention: Int8s = column(np.int8)
    "an `Intention`, (capacity,)"
    focus: Int64s = column(np.int64, fill=-1)
    "stable id of the fish attended to, -1 for none, `SUBMARINE` for the submarine, (capacity,)"
    since: Int64s = column(np.int64)
    "tick at which the intention began, (capacity,)"
    thought_at: Int64s = column(np.int64, fill=-1_000_000)
    "tick of the last thought, (capacity,)"
    wander_until: Int64s = column(np.int64)
    "tick at which a wanderer picks a new direction, (capacity,)"
    wander: Float64s = column(np.float64, 3)
    "unit direction of a wanderer, world axes, (capacity, 3)"
