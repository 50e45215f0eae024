"""A card with a menu over the sea: pause, options and result are made of it."""

from collections.abc import Sequence

from reefgame.screens import theme
from reefgame.screens.game import Game
from reefgame.screens.menu import BACK, Item, Menu
from reefgame.screens.screen import Screen


class OverlayScreen(Screen):
    """A dimmed sea, a headline, room for more, and a menu below."""

    overlay = True
    headline = ""
    card_width = 440.0
    "units"
    body_height = 0.0
    "units between the headline and the menu"

    def __init__(self, game: Game, items: Sequence[Item]) -> None:
        super().__init__(game)
        self.menu = Menu(items)

    def layout(self) -> None:
        """Centre the card."""
        c, u = self.canvas, self.canvas.unit
        c.panel(0, 0, c.width, c.height, (2, 14, 24, 120), bottom=(2, 10, 18, 170))
        width = min(self.card_width * u, c.width - 24 * u)
        rows = Menu.height(len(self.menu.items), u)
        height = rows + (self.body_height + 92) * u
        left, low = 0.5 * (c.width - width), 0.5 * (c.height - height)
        c.card(left, low, width, height)
        c.text(self.headline, 0.5 * c.width, low + height - 52 * u, theme.TITLE,
               anchor="center baseline", weight="light", order=1)  # fmt: skip
        self.menu.layout(c, left + 12 * u, low + rows + 12 * u, width - 24 * u)
        self.layout_body(left + 30 * u, low + height - 74 * u, width - 60 * u)

    def layout_body(self, left: float, top: float, width: float) -> None:
        """Fill the room below the headline, from (left, top) downwards [px]."""

    def back(self) -> None:
        """What Escape does."""
        self.game.stack.pop()

    def pressed(self, name: str) -> None:
        """Go back, or move through the menu."""
        if name in BACK:
            self.back()
        else:
            self.menu.pressed(name)

    def stick(self, name: str, deflection: float) -> None:
        """Move through the menu."""
        self.menu.stick(name, deflection)

    def pointed(self, x: float, y: float) -> None:
        """Focus what the pointer is over."""
        self.menu.pointed(x, y)

    def clicked(self, x: float, y: float) -> None:
        """Choose what was clicked."""
        self.menu.clicked(x, y)
