"""The simulation's clock: ticks of 1/60 s and the seed from which all chance follows."""

from typing import Final

import numpy as np

from components.arrays import Int64s
from components.table import Table, column

TICKS_PER_SECOND: Final = 60
TICK_SECONDS: Final = 1.0 / TICKS_PER_SECOND


class Clock(Table):
    """One row: the tick being computed and the dive's seed."""

    tick: Int64s = column(np.int64)
    "number of ticks begun before this one, (capacity,)"
    seed: Int64s = column(np.int64)
    "what every random stream starts from, (capacity,)"

    def __init__(self, seed: int = 0) -> None:
        super().__init__(count=1)
        self.seed[0] = seed

    @property
    def now(self) -> int:
        """The tick being computed."""
        return int(self.tick[0])
