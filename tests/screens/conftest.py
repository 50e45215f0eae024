"""A window without a display, and a game in it: title, dive and the rest, driven by events."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from reefgame.screens.game_window import GameWindow
from reefgame.shelf import find_levels
from reefgame.window import new_game, open_window

EASY = Path(__file__).with_name("easy.yaml")


class Player:
    """Presses, points and waits, as pyglet would report it, and draws every frame."""

    def __init__(self, view: GameWindow) -> None:
        self.view, self.game = view, view.game

    @property
    def screen(self) -> Any:
        """The topmost screen."""
        return self.view.top

    def dispatch(self, event: str, *values: object) -> None:
        """Let the window report an event."""
        self.view.window.dispatch_event(event, *values)
        self.view.window.dispatch_events()

    def hold(self, key: str) -> None:
        """Press a key, by pyglet's name."""
        from pyglet.window import key as keys

        self.dispatch("on_key_press", getattr(keys, key), 0)

    def release(self, key: str) -> None:
        """Let go of a key."""
        from pyglet.window import key as keys

        self.dispatch("on_key_release", getattr(keys, key), 0)

    def press(self, *names: str) -> None:
        """Press and let go of keys, one after the other."""
        for name in names:
            self.hold(name)
            self.release(name)

    def wait(self, ticks: int) -> None:
        """Let as many ticks go by; only the last is drawn."""
        for _ in range(ticks - 1):
            self.screen.update(1.0 / 60.0 + 1e-9)
        self.view.frame(1.0 / 60.0 + 1e-9)


@pytest.fixture(scope="session")
def window() -> Iterator[Any]:
    """A pyglet window of 480x320 without a display."""
    window = open_window((480, 320), headless=True)
    yield window
    window.close()


@pytest.fixture
def player(window: Any, user_folders: Path) -> Iterator[Player]:
    """A game whose title is open; the level is easy to win."""
    game = new_game(find_levels(str(EASY)), seed=1)
    view = GameWindow(window, game)
    game.to_title()
    yield Player(view)
    game.stack.close()
    game.backdrop.delete()
    window.pop_handlers()


@pytest.fixture
def bare_view(window: Any) -> Iterator[GameWindow]:
    """A window whose first screen is not open yet, as at launch."""
    yield GameWindow(window, new_game(find_levels(str(EASY)), seed=1))
    window.pop_handlers()
