"""What living fishes do (FINDINGS 3 and the literature it names), and how a figure stands to it."""

from dataclasses import dataclass
from typing import Final

from components.segment import Pattern
from components.trigonometry import DEGREE
from tools.capture.bend import JOINT_LIMIT
from tools.capture.measure import CLOSURE_LIMIT

SMALL_LENGTH: Final = 0.5
"""[m] up to which a fish counts as a small reef fish."""

SHARK_LENGTH: Final = 1.3
"""[m] from which a fish is held against the reef shark's cruise."""


@dataclass(frozen=True)
class Range:
    """From and to, and whose they are; an end that is None is open."""

    low: float | None
    high: float | None
    source: str

    def holds(self, value: float) -> bool:
        """Return whether a value lies within."""
        above = self.low is None or value >= self.low
        return above and (self.high is None or value <= self.high)

    def text(self) -> str:
        """Return the range in words."""
        if self.low is None:
            return "any" if self.high is None else f"at most {short(self.high)}"
        if self.high is None:
            return f"at least {short(self.low)}"
        return f"{short(self.low)} to {short(self.high)}"


def short(value: float) -> str:
    """Return a number without a zero in front of the point."""
    text = f"{value:g}" if abs(value) >= 1e-4 or value == 0.0 else f"{value:.0e}"
    return text.removeprefix("0") if text.startswith("0.") else text


STROUHAL: Final = Range(0.2, 0.4, "living fishes; carangiform about .25")
SWEEP: Final = Range(0.12, 0.24, "about .2 at most speeds (Bainbridge 1958)")
HEAD: Final = Range(None, 0.5, "below half of the tail's")
STRIDE: Final = Range(0.55, 0.8, ".55 at 5 Hz (Bainbridge 1958) to .8 in saithe and mackerel")
WAVELENGTH: Final = Range(0.57, 0.95, "trout .76, a quarter either way")
SUSTAINED: Final = Range(None, 4.0, "kept up for 20 s; 10 for 1 s")
JOINT: Final = Range(None, JOINT_LIMIT / DEGREE, "beyond, a fish folds its fin inside out")
CLOSURE: Final = Range(None, CLOSURE_LIMIT, "our own limit")
DRIFT: Final = Range(None, 0.1, "our own limit")
STAGE_ONE_TIME: Final = Range(15.0, 40.0, "stage 1 of a fish of 10 cm")
STAGE_ONE_ANGLE: Final = Range(50.0, 120.0, "stage 1 of a C-start")
START_NET: Final = Range(80.0, None, "net, 1 s from rest")
SHARP_TIME: Final = Range(None, 1.2, "our own limit")

_SMALL_CRUISE: Final = Range(1.0, 3.0, "small reef fishes at cruise")
_SHARK_CRUISE: Final = Range(0.5, 0.8, "reef sharks at cruise, m/s")


def cruise(length: float) -> tuple[Range, float] | None:
    """Return the cruising speeds of fishes so long [m] and how many of their unit go into 1 BL/s; None: unknown."""
    if length <= SMALL_LENGTH:
        return _SMALL_CRUISE, 1.0
    return (_SHARK_CRUISE, length) if length >= SHARK_LENGTH else None


def turn(pattern: Pattern, length: float) -> Range:
    """Return the degrees that a turn of a fish so long [m] should make."""
    if pattern == Pattern.TURN_LEFT:
        return Range(10.0, 40.0, "gradual")
    least = 40.0 if length >= SHARK_LENGTH else 60.0
    return Range(least, None, "sharp, out of cruise")


def envelope(along: float) -> float:
    """Return half of what a carangiform swimmer's body sweeps [BL] at `along`, 0 nose to 1 tail (FINDINGS 3)."""
    return 0.02 - 0.0825 * along + 0.1625 * along * along
