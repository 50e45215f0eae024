"""The window opens: for playing, or for watching a recorded dive (DESIGN 5, 8).

pyglet is imported when a window is wanted, not before: the command line may ask for this module on
a machine that has neither a display nor its libraries.
"""

import os
import secrets
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from reefgame.console import InputError, complain
from reefgame.content import Content
from reefgame.screens.game_window import CAPTION, GameWindow
from reefgame.shelf import LevelCard, Shelf, find_levels
from reefgame.warmup import warm_up
from systems.sea.choose import Backend
from systems.view.context import PACKAGES, choose_options, config

if TYPE_CHECKING:
    from reefgame.replay import Replay
    from reefgame.screens.game import Game

SIZE: Final = (1280, 720)
SMALLEST: Final = (480, 300)
_INSTEAD: Final = "the game needs one to open a window; --headless plays without"
_SEEDS: Final = 2**31


def play(
    level: str | None,
    mods: Sequence[Path] = (),
    seed: int | None = None,
    record: Path | None = None,
    size: tuple[int, int] | None = None,
    live: int | None = None,
    fibres: Backend = "auto",
) -> int:
    """Open the title with `level` chosen and play until the player leaves; return the exit status.

    The `live` fishes nearest the submarine are simulated, not replayed; without it as many as the settings say.
    `fibres` bends the plants.

    Raise ContentError where level or mods are at fault, InputError where there is no display or no
    OpenGL, or where `record` cannot be written.
    """
    shelf = find_levels(level, mods)
    _check_writable(record)
    window = open_window(size or SIZE)
    game = new_game(
        shelf, secrets.randbelow(_SEEDS) if seed is None else seed, record, live, fibres
    )
    view = GameWindow(window, game)
    _fill(view, game.live > 0)
    game.to_title()
    view.run()
    return 0


def _fill(view: GameWindow, live: bool) -> None:
    """Say what is going on before the first picture: at the first launch kernels compile."""
    warm_up(lambda done, what: view.announce(f"{what} {done:.0%}"), live)
    view.announce("filling the sea ...")


def _check_writable(record: Path | None) -> None:
    """Refuse, before a window opens, a recording that could not be written later."""
    if record is None:
        return
    there = next(folder for folder in (record, *record.absolute().parents) if folder.exists())
    if record.is_dir() or not os.access(there, os.W_OK) or not (there == record or there.is_dir()):
        raise InputError(f"{record}: cannot be written")


def new_game(
    shelf: Shelf,
    seed: int = 0,
    record: Path | None = None,
    live: int | None = None,
    fibres: Backend = "auto",
) -> "Game":
    """Return a game with the shelf's level chosen and its title not yet open."""
    from reefgame.screens.game import Game
    from reefgame.screens.title import TitleScreen

    game = Game(shelf.cards, shelf.load, shelf.start, seed, record, live, fibres)
    game.to_title = lambda: game.stack.replace(lambda: TitleScreen(game))
    for message in game.messages:
        complain(message)
    return game


def watch(replay: "Replay", content: Content) -> int:
    """Show a recorded dive as its pilot saw it; return the exit status.

    Raise InputError where there is no display or no OpenGL.
    """
    window = open_window(SIZE)
    from reefgame.screens.game import Game
    from reefgame.screens.watch import WatchScreen

    level = content.level
    card = LevelCard(level.name, level.title, level.brief)
    game = Game([card], lambda _: content, level.name, replay.seed, live=replay.live)
    view = GameWindow(window, game)
    _fill(view, game.live > 0)
    game.stack.replace(lambda: WatchScreen(game, replay))
    view.run()
    return 0


def open_window(size: tuple[int, int], headless: bool = False, instead: str = _INSTEAD) -> Any:
    """Return a new pyglet window with OpenGL 3.3, invisible where `headless`.

    Raise InputError, one line, where there is no display, which says what to do `instead`, or no OpenGL.
    """
    choose_options(headless=headless)
    try:
        import pyglet.window as windows
        from pyglet.display import get_display
        from pyglet.gl import ContextException
    except ImportError as error:
        raise InputError(_no_opengl(error)) from None
    try:
        get_display()
    except _display_error() as error:
        raise InputError(_no_display(error, instead)) from None
    try:
        window = windows.Window(
            *size, caption=CAPTION, resizable=True, vsync=True, visible=False, config=config()
        )
    except (windows.WindowException, ContextException, ImportError, OSError) as error:
        raise InputError(_no_opengl(error)) from None
    window.set_minimum_size(min(size[0], SMALLEST[0]), min(size[1], SMALLEST[1]))
    window.set_visible(True)
    return window


def _display_error() -> type[Exception]:
    """Return what pyglet raises where no X server answers: it keeps the class in the X11 module."""
    error = getattr(sys.modules.get("pyglet.display.xlib"), "NoSuchDisplayException", OSError)
    return error if isinstance(error, type) and issubclass(error, Exception) else OSError


def _no_display(error: Exception, instead: str) -> str:
    asked = os.environ.get("DISPLAY", "")
    where = f"no display answers at '{asked}'" if asked else f"no display ({error})"
    return f"{where}: {instead}"


def _no_opengl(error: Exception) -> str:
    reason = " ".join(str(error).split()) or type(error).__name__
    return f"no OpenGL 3.3: {reason}; on Debian: apt-get install {PACKAGES}"
