"""What the player orders in one tick, quantised at input so that a replay holds it exactly (DESIGN 7)."""

from struct import pack_into
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
    become: int = 0
    "become the fish before the bow, or let go of the one that the player is; counts as it turns to 1"
    eat: int = 0
    "as a fish: go for what is before the mouth, and open it"
    hide: int = 0
    "as a fish: swim for the nearest shelter"
    view: int = 0
    "as a fish: look through its eyes, or from behind it; counts as it turns to 1"


BUTTONS: Final = ("stop", "photograph", "become", "eat", "hide", "view")
"""The orders that are 0 or 1; the others are axes."""


_INTEGERS: Final = f"={len(Command._fields)}i"
"""How a row of the table lies in memory."""


class CommandTable(Table):
    """One row: the orders of this tick and the one before, as integers in `Command`'s order."""

    now: Int32s = column(np.int32, len(Command._fields))
    "this tick's orders, (capacity, 10)"
    before: Int32s = column(np.int32, len(Command._fields))
    "the orders of the tick before, (capacity, 10)"

    def __init__(self) -> None:
        super().__init__(count=1)

    def give(self, command: Command) -> None:
        """Take the orders of the tick that begins."""
        self.before[:] = self.now
        pack_into(_INTEGERS, self.now.data, 0, *command)

    def order(self, name: str) -> int:
        """Return what is ordered this tick under a name of `Command`."""
        return int(self.now[0, Command._fields.index(name)])

    def pressed(self, name: str) -> bool:
        """Return whether the button `name` went down this tick."""
        at = Command._fields.index(name)
        return bool(self.now[0, at] and not self.before[0, at])
