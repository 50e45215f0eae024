"""The submarine that the player pilots (papers/000, 8.2)."""

from typing import Final

import numpy as np

from components.arrays import Float64s
from components.table import Table, column

HULL_RADIUS: Final = 0.9
"""[m] of the sphere that stands for the hull in collisions."""


class SubmarineTable(Table):
    """One row a submarine."""

    position: Float64s = column(np.float64, 3)
    "[m] of the cockpit's eye, world axes, (capacity, 3)"
    velocity: Float64s = column(np.float64, 3)
    "[m/s], world axes, (capacity, 3)"
    yaw: Float64s = column(np.float64)
    "[rad] heading from +x towards +y, (capacity,)"
    pitch: Float64s = column(np.float64)
    "[rad] nose up, (capacity,)"
    yaw_rate: Float64s = column(np.float64)
    "[rad/s], (capacity,)"
    pitch_rate: Float64s = column(np.float64)
    "[rad/s], (capacity,)"
    throttle: Float64s = column(np.float64)
    "engine setting, -1 full reverse to 1 full ahead, (capacity,)"
    last_position: Float64s = column(np.float64, 3)
    "[m] position a tick ago, for interpolation, (capacity, 3)"
    last_yaw: Float64s = column(np.float64)
    "[rad] yaw a tick ago, (capacity,)"
    last_pitch: Float64s = column(np.float64)
    "[rad] pitch a tick ago, (capacity,)"
