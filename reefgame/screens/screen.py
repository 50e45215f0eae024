"""What a screen is, and the stack of them: the topmost one hears the player (DESIGN 5)."""

import os
from collections.abc import Callable
from typing import TYPE_CHECKING, ClassVar

from reefgame.screens.canvas import Canvas

if TYPE_CHECKING:
    from reefgame.screens.game import Game


def trace(event: str) -> None:
    """Print what just happened where REEFGAME_TRACE=1: tests with a real window follow it."""
    if os.environ.get("REEFGAME_TRACE") == "1":
        print(event, flush=True)


class Screen:
    """One screen. Keys and buttons come as lower-case names, places in pixels, y up."""

    name: ClassVar[str] = "screen"
    overlay: ClassVar[bool] = False
    "whether the screen below shows through"
    lives_below: ClassVar[bool] = False
    "whether it goes on while an overlay covers it"
    captures_mouse: ClassVar[bool] = False
    "whether mouse motion steers instead of moving a pointer"

    def __init__(self, game: "Game") -> None:
        self.game = game
        self.canvas = Canvas(1, 1)

    def layout(self) -> None:
        """Fill the fresh `self.canvas`; called when the screen opens and when its size changes."""

    def opened(self) -> None:
        """The screen has become the topmost, for the first time or again."""

    def closed(self) -> None:
        """The screen has left the stack."""

    def update(self, seconds: float) -> None:
        """Advance by a frame."""

    def draw_sea(self, width: int, height: int) -> None:
        """Draw the world into the bound framebuffer of width x height [px]."""

    def draw(self) -> None:
        """Paint the canvas."""
        self.canvas.draw()

    def pressed(self, name: str) -> None:
        """A key or a gamepad's button went down."""

    def released(self, name: str) -> None:
        """A key or button came up."""

    def pointed(self, x: float, y: float) -> None:
        """The pointer moved to (x, y)."""

    def moved(self, dx: float, dy: float) -> None:
        """The captured mouse moved by (dx, dy)."""

    def dragged(self, x: float, y: float, dx: float, dy: float) -> None:
        """The pointer moved by (dx, dy) to (x, y) with a button down."""

    def clicked(self, _x: float, _y: float) -> None:
        """The left mouse button went down at (x, y)."""

    def wheel(self, notches: float) -> None:
        """The mouse wheel turned, away from the player positive."""

    def stick(self, name: str, deflection: float) -> None:
        """A gamepad's stick or trigger moved, -1 to 1."""

    def focus_lost(self) -> None:
        """The window lost the keyboard."""


class ScreenStack:
    """The open screens, the topmost last."""

    def __init__(self) -> None:
        self._screens: list[Screen] = []
        self._size = (1, 1)

    @property
    def top(self) -> Screen:
        """The screen that hears the player. Raise IndexError where there is none."""
        return self._screens[-1]

    @property
    def open(self) -> bool:
        """Whether any screen is open."""
        return bool(self._screens)

    @property
    def visible(self) -> list[Screen]:
        """The screens that show, from the one that hides all below it upwards."""
        first = max(
            (at for at, screen in enumerate(self._screens) if not screen.overlay), default=0
        )
        return self._screens[first:]

    def resize(self, width: int, height: int) -> None:
        """Lay every screen out for a window of width x height [px]."""
        self._size = (width, height)
        for screen in self._screens:
            self._lay_out(screen)

    def push(self, screen: Screen) -> None:
        """Open `screen` above the others."""
        self._screens.append(screen)
        self._lay_out(screen)
        self._announce()

    def pop(self) -> None:
        """Close the topmost screen."""
        self._screens.pop().closed()
        if self._screens:
            self._announce()

    def replace(self, make: Callable[[], Screen]) -> None:
        """Close every screen, then make one and open it: it finds what the others left behind."""
        self.close()
        self.push(make())

    def close(self) -> None:
        """Close every screen: the game ends."""
        while self._screens:
            self._screens.pop().closed()

    def relay(self, screen: Screen) -> None:
        """Lay `screen` out anew: what it shows has changed shape."""
        self._lay_out(screen)

    def _lay_out(self, screen: Screen) -> None:
        screen.canvas = Canvas(*self._size)
        screen.layout()

    def _announce(self) -> None:
        trace(f"screen {self.top.name}")
        self.top.opened()
