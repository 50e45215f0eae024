"""Which fish the player is, if any, and how it is being steered.

The fish keeps its body, its motor system and its feelings; only what it is about comes from the player.
"""

import numpy as np

from components.arrays import Float64s, Int8s, Int64s
from components.table import Table, column


class AvatarTable(Table):
    """One row: the fish that the player is."""

    fish: Int64s = column(np.int64, fill=-1)
    "stable id of the fish that the player is, -1 at the helm of the submarine, (1,)"
    since: Int64s = column(np.int64, fill=-1)
    "tick at which that began, or at which the player came back to the helm, (1,)"
    lost_at: Int64s = column(np.int64, fill=-1)
    "tick at which the fish that the player was left the world, -1 for never, (1,)"
    refused_at: Int64s = column(np.int64, fill=-1)
    "tick at which the player last asked to become a fish and none stood before the bow, -1 for never, (1,)"
    behind: Int8s = column(np.int8)
    "1 where the player looks from behind the fish, 0 through its eyes, (1,)"
    setting: Float64s = column(np.float64)
    "speed asked for, -1 backwards to 1 as fast as it can, (1,)"
    swing: Float64s = column(np.float64)
    "how long and hard the player has been turning, -1 right to 1 left, (1,)"
    climb: Float64s = column(np.float64)
    "sine of the climb asked for, (1,)"
    course: Float64s = column(np.float64, 3)
    "unit direction asked for, world axes, (1, 3)"
    gaze: Float64s = column(np.float64, 3)
    "running mean of where the head points: the beat of the tail does not shake it, (1, 3)"
    last_gaze: Float64s = column(np.float64, 3)
    "the same a tick ago, for interpolation, (1, 3)"

    def __init__(self) -> None:
        super().__init__(count=1, capacity=1)

    @property
    def attached(self) -> bool:
        """Whether the player is a fish now."""
        return bool(self.fish[0] >= 0)
