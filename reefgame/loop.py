"""The fixed step: a world that ticks sixty times a second whatever the frame rate (DESIGN 3).

Time that has passed accumulates; whole ticks are taken out of it; what is left, as a fraction of a
tick, is how far the picture stands between the last two states. At most five ticks a frame: a
machine that cannot keep up sees slow motion, never a spiral of ever more ticks a frame.
"""

from typing import Final

from components.clock import TICK_SECONDS

MOST_TICKS_A_FRAME: Final = 5


class FixedStep:
    """Turns frame times into whole ticks and a fraction."""

    def __init__(self) -> None:
        self._left = 0.0

    @property
    def alpha(self) -> float:
        """How far the picture stands between the last two states, 0 to 1."""
        return self._left / TICK_SECONDS

    def ticks(self, seconds: float) -> int:
        """Return how many ticks to take after a frame of `seconds`, 0 to 5."""
        self._left += max(seconds, 0.0)
        whole = int(self._left / TICK_SECONDS)
        if whole > MOST_TICKS_A_FRAME:
            self._left = 0.0
            return MOST_TICKS_A_FRAME
        self._left -= whole * TICK_SECONDS
        return whole
