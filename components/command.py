"""What the player orders in one tick, quantised at input so that a replay holds it exactly (DESIGN 7)."""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Int32s
from components.table import Table, column

FULL: Final = 100
"""The largest magnitude of an axis."""


class Command(NamedTuple):
    """The pilot's orders: axes from -100 to 100, buttons 0 or 1."""

    throttle: int = 0
    "accelerate (+) or decelerate and reverse (-)"
    turn: int = 0
    "left (+), right (-)"
    pitch: int = 0
    "nose up (+), down (-)"
    rise: int = 0
    "rise (+), dive (-)"
    stop: int = 0
    "full stop"
    photograph: int = 0
    "release the shutter; counts on the tick at which it turns from 0 to 1"


class CommandTable(Table):
    """One row: the orders of this tick and the one before, as integers in `Command`'s order."""

    now: Int32s = column(np.int32, len(Command._fields))
    "this tick's orders, (capacity, 6)"
    before: Int32s = column(np.int32, len(Command._fields))
    "the orders of the tick before, (capacity, 6)"

    def __init__(self) -> None:
        super().__init__(count=1)

    def give(self, command: Command) -> None:
        """Take the orders of the tick that begins."""
        self.before[0] = self.now[0]
        self.now[0] = command
