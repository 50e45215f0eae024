"""All controls on one card, over the dive that waits."""

from typing import Final

from reefgame.screens import theme
from reefgame.screens.game import Game
from reefgame.screens.menu import Item
from reefgame.screens.overlay import OverlayScreen

CONTROLS: Final = (
    ("W  S  \u00b7  wheel", "throttle ahead, astern"),
    ("A  D  \u00b7  mouse", "turn"),
    ("arrows  \u00b7  mouse", "turn, nose up and down"),
    ("Space  R  \u00b7  C  F  Ctrl", "rise  \u00b7  dive"),
    ("X", "full stop"),
    ("Enter  P  \u00b7  left click", "photograph"),
    ("B", "become the fish before the bow, let go"),
    ("E  \u00b7  right click", "as a fish: eat (hold)"),
    ("G  \u00b7  V", "as a fish: hide (hold)  \u00b7  from behind"),
    ("I", "inspect: why each fish does what it does"),
    ("Esc  \u00b7  F11  \u00b7  F12", "pause  \u00b7  full screen  \u00b7  picture"),
    ("gamepad", "sticks, triggers, A photo, B stop, Y become"),
)


class HelpScreen(OverlayScreen):
    """What every key does."""

    name = "help"
    headline = "Controls"
    card_width = 560.0
    body_height = 28.0 * len(CONTROLS) + 12.0

    def __init__(self, game: Game) -> None:
        super().__init__(game, [Item("Back to the dive", self.back)])

    def layout_body(self, left: float, top: float, width: float) -> None:
        """List the controls."""
        u = self.canvas.unit
        for at, (keys, deed) in enumerate(CONTROLS):
            y = top - (28 * at + 14) * u
            self.canvas.text(keys, left, y, theme.SMALL, theme.SUNLIT, order=1)
            self.canvas.text(deed, left + 0.42 * width, y, theme.SMALL, theme.FOAM, order=1)

    def pressed(self, name: str) -> None:
        """Go back, also by the key that opened it."""
        if name == "h":
            self.back()
        else:
            super().pressed(name)
