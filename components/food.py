"""Food: particles that drift in the water and are eaten (papers/004; papers/002 calls the small ones plankton)."""

import numpy as np

from components.arrays import Float64s, Int32s, Int64s
from components.kernels import inlined
from components.table import Table, column

GONE = 1 << 62
"""The tick at which food that is not to come back comes back."""


class FoodTable(Table):
    """One row a particle. A level's food never changes in number: what was eaten is away until `returns`."""

    position: Float64s = column(np.float64, 3)
    "[m], world axes, (capacity, 3)"
    last_position: Float64s = column(np.float64, 3)
    "[m] a tick ago, (capacity, 3)"
    meal: Float64s = column(np.float64, fill=1.0)
    "grams of food in it; a fish's average meal is in `SenseTable.meal`, (capacity,)"
    patch: Int32s = column(np.int32)
    "which of the level's food patches it belongs to, (capacity,)"
    returns: Int64s = column(np.int64, fill=-1)
    "tick from which it is in the water; later than now where it was eaten, (capacity,)"
    eaten_by: Int64s = column(np.int64, fill=-1)
    "stable id of the fish that sucks it in, -1 for none, (capacity,)"


class PatchTable(Table):
    """One row a patch of food of the level, in the order of the file. It never changes during a dive."""

    around: Float64s = column(np.float64, 3)
    "[m] centre of the ball in which its particles appear, (capacity, 3)"
    within: Float64s = column(np.float64)
    "[m] radius of that ball, (capacity,)"
    drift: Float64s = column(np.float64, 3)
    "[m/s] of its particles, world axes, (capacity, 3)"
    returns_after: Int64s = column(np.int64)
    "[ticks] from being eaten to coming back, `GONE` for never, (capacity,)"


@inlined
def in_stomach(eaten: float, ate_at: int, now: int, digestion: float) -> float:
    """Return the meals still undigested of `eaten` at the last bite: n R(t) of papers/004; `digestion` in ticks."""
    return eaten * max(1.0 - (now - ate_at) / digestion, 0.0)
