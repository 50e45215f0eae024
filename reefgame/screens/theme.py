"""One look for all screens: colours taken from the sea, letter sizes, and how both scale (DESIGN 5)."""

from typing import Final, TypeAlias

Colour: TypeAlias = tuple[int, int, int, int]
"""Red, green, blue and opacity, 0 to 255."""

FOAM: Final[Colour] = (240, 250, 252, 255)
"""Text that matters."""
MIST: Final[Colour] = (178, 214, 224, 255)
"""Text beside it."""
HAZE: Final[Colour] = (140, 186, 200, 255)
"""Labels and hints."""
DEEP: Final[Colour] = (5, 26, 40, 168)
"""Panels."""
ABYSS: Final[Colour] = (3, 15, 25, 215)
"""Panels above panels, and the lower end of gradients."""
LAGOON: Final[Colour] = (58, 196, 214, 255)
"""What has the focus."""
SUNLIT: Final[Colour] = (255, 214, 120, 255)
"""What is achieved, or can be now."""
CORAL: Final[Colour] = (255, 138, 108, 255)
"""Warnings."""
RIM: Final[Colour] = (160, 226, 240, 46)
"""The thin edge of panels."""
CLEAR: Final[Colour] = (0, 0, 0, 0)

FAMILIES: Final = ("Inter", "SF Pro Text", "Segoe UI", "Ubuntu", "Noto Sans", "DejaVu Sans")

HUGE: Final = 62
TITLE: Final = 34
LARGE: Final = 22
BODY: Final = 17
SMALL: Final = 13
TINY: Final = 11
"""Heights of letters [units]; a unit is a pixel in a window 720 pixels high."""

_LOWEST, _DESIGN_HEIGHT, _DESIGN_WIDTH = 0.5, 720.0, 1060.0


def unit(width: int, height: int) -> float:
    """Return the pixels of one layout unit in a window of width x height [px]."""
    return max(_LOWEST, min(height / _DESIGN_HEIGHT, width / _DESIGN_WIDTH))


def faded(colour: Colour, opacity: float) -> Colour:
    """Return the colour with its opacity scaled by 0 to 1."""
    return (*colour[:3], round(colour[3] * max(0.0, min(1.0, opacity))))
