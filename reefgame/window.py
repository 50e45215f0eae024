"""The window: it opens, hears keys, mouse and gamepads, and draws the topmost screens (DESIGN 5, 8).

pyglet is imported when a window is wanted, not before: the command line may ask for this module on
a machine that has neither a display nor its libraries.
"""

import os
import secrets
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from reefgame.console import InputError, complain
from reefgame.content import Content
from reefgame.settings import Settings
from reefgame.shelf import LevelCard, Shelf, find_levels
from systems.view.context import PACKAGES, choose_options, config
from systems.view.target import UInt8s, write_png

if TYPE_CHECKING:
    from reefgame.replay import Replay
    from reefgame.screens.game import Game
    from reefgame.screens.screen import Screen

SIZE: Final = (1280, 720)
SMALLEST: Final = (480, 300)
CAPTION: Final = "reefgame"
_FRAMES_A_SECOND: Final = 120
"""Most frames drawn where the display does not set the pace."""
_SAME_KEY: Final = {"return": "enter", "num_enter": "enter"}
_SEEDS: Final = 2**31
_LONGEST_FRAME: Final = 0.25
"""[s] of a frame; more is dropped: the window was dragged, the machine slept."""
_LEFT_BUTTON: Final = 1


def play(
    level: str | None,
    mods: Sequence[Path] = (),
    seed: int | None = None,
    record: Path | None = None,
    size: tuple[int, int] | None = None,
) -> int:
    """Open the title with `level` chosen and play until the player leaves; return the exit status.

    Raise ContentError where level or mods are at fault, InputError where there is no display or no
    OpenGL, or where `record` cannot be written.
    """
    shelf = find_levels(level, mods)
    _check_writable(record)
    window = open_window(size or SIZE)
    game = new_game(shelf, secrets.randbelow(_SEEDS) if seed is None else seed, record)
    view = GameWindow(window, game)
    view.announce("filling the sea ...")
    game.to_title()
    view.run()
    return 0


def _check_writable(record: Path | None) -> None:
    """Refuse, before a window opens, a recording that could not be written later."""
    if record is None:
        return
    there = next(folder for folder in (record, *record.absolute().parents) if folder.exists())
    if record.is_dir() or not os.access(there, os.W_OK) or not (there == record or there.is_dir()):
        raise InputError(f"{record}: cannot be written")


def new_game(shelf: Shelf, seed: int = 0, record: Path | None = None) -> "Game":
    """Return a game with the shelf's level chosen and its title not yet open."""
    from reefgame.screens.game import Game
    from reefgame.screens.title import TitleScreen

    game = Game(shelf.cards, shelf.load, shelf.start, seed, record)
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
    game = Game([card], lambda _: content, level.name, replay.seed)
    view = GameWindow(window, game)
    view.announce("filling the sea ...")
    game.stack.replace(lambda: WatchScreen(game, replay))
    view.run()
    return 0


def open_window(size: tuple[int, int], headless: bool = False) -> Any:
    """Return a new pyglet window with OpenGL 3.3, invisible where `headless`.

    Raise InputError, one line, where there is no display or no OpenGL.
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
        raise InputError(_no_display(error)) from None
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


def _no_display(error: Exception) -> str:
    asked = os.environ.get("DISPLAY", "")
    where = f"no display answers at '{asked}'" if asked else f"no display ({error})"
    return f"{where}: the game needs one to open a window; --headless plays without"


def _no_opengl(error: Exception) -> str:
    reason = " ".join(str(error).split()) or type(error).__name__
    return f"no OpenGL 3.3: {reason}; on Debian: apt-get install {PACKAGES}"


class GameWindow:
    """Joins a pyglet window and a game: events in, frames out."""

    def __init__(self, window: Any, game: "Game") -> None:
        from reefgame.screens.gamepad import Gamepads
        from reefgame.screens.toast import Toast

        self.window, self.game = window, game
        self.toast = Toast(game.messages)
        self._captured = False
        self._picture_wanted = False
        self._size = (0, 0)
        self._last = perf_counter()
        game.quit, game.apply = self.quit, self.apply
        window.push_handlers(self)
        self._gamepads = Gamepads(self._pressed, self._released, self._stick)
        self.resize()
        if game.settings.fullscreen:
            self.apply(game.settings)

    @property
    def top(self) -> "Screen":
        """The screen that hears the player."""
        return self.game.stack.top

    def run(self) -> None:
        """Play until the player leaves; whatever happens, the dive's recording is closed."""
        import pyglet

        self._last = perf_counter()
        try:
            pyglet.app.run(1.0 / _FRAMES_A_SECOND)
        finally:
            self.game.stack.close()
            self.window.close()

    def quit(self) -> None:
        """Leave the game."""
        import pyglet

        self._capture(False)
        pyglet.app.exit()

    def announce(self, message: str) -> None:
        """Show a line on a bare sea before long work."""
        from reefgame.screens import theme
        from reefgame.screens.canvas import Canvas

        width, height = self._size
        canvas = Canvas(width, height)
        canvas.panel(0, 0, width, height, (12, 86, 112, 255), bottom=(3, 26, 42, 255))
        canvas.text(
            CAPTION, 0.5 * width, 0.5 * height, theme.HUGE, anchor="center baseline", order=1,
            weight="light",
        )  # fmt: skip
        canvas.text(
            message, 0.5 * width, 0.5 * height - 36 * canvas.unit, theme.BODY, theme.MIST,
            "center baseline", order=1,
        )  # fmt: skip
        self.window.switch_to()
        self.window.dispatch_events()
        canvas.draw()
        self.window.flip()

    def apply(self, settings: Settings) -> None:
        """Draw as the settings say from now on."""
        from pyglet.window import WindowException

        if settings.fullscreen != bool(self.window.fullscreen):
            try:
                self.window.set_fullscreen(settings.fullscreen)
            except WindowException as error:
                self.game.say(f"full screen is not to be had here: {error}")
        if self.game.stack.open:
            self.game.backdrop.apply(settings)

    def resize(self) -> None:
        """Lay everything out for the size that the window has now."""
        from pyglet.math import Mat4

        self._size = width, height = self.window.get_framebuffer_size()
        self.window.switch_to()
        self.window.projection = Mat4.orthogonal_projection(0, width, 0, height, -255, 255)
        self.game.stack.resize(width, height)
        self.toast.resize(width, height)

    def on_draw(self) -> None:
        """Advance by the time since the last frame, and draw."""
        now = perf_counter()
        seconds, self._last = min(now - self._last, _LONGEST_FRAME), now
        self.frame(seconds)

    def frame(self, seconds: float) -> None:
        """Advance every screen that lives by `seconds`, and draw what shows."""
        from pyglet import gl

        if self._size != self.window.get_framebuffer_size():
            self.resize()
        for screen in self.game.stack.visible:
            if screen is self.top or screen.lives_below:
                screen.update(seconds)
        self.toast.update(seconds)
        self._follow()
        gl.glViewport(0, 0, *self._size)
        self.game.stack.visible[0].draw_sea(*self._size)
        self.top.draw()
        self.toast.draw()
        if self._picture_wanted:
            self._picture_wanted = False
            self._save_picture()

    def _follow(self) -> None:
        """Capture the mouse where the topmost screen steers by it, free it elsewhere."""
        self._capture(self.top.captures_mouse)

    def _capture(self, wanted: bool) -> None:
        if wanted != self._captured:
            self._captured = wanted
            self.window.set_exclusive_mouse(wanted)

    def picture(self) -> UInt8s:
        """Return what was drawn last, (height, width, 3) uint8, the top row first."""
        from pyglet import gl

        width, height = self._size
        rows = np.empty((height, width, 4), np.uint8)
        gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
        gl.glReadPixels(0, 0, width, height, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, rows.ctypes.data)
        return np.ascontiguousarray(rows[::-1, :, :3])

    def _save_picture(self) -> None:
        try:
            path = self.game.picture_path()
            write_png(path, self.picture())
        except OSError as error:
            self.game.say(f"the picture cannot be saved: {error.strerror or error}")
        else:
            self.game.say(f"picture: {path}")

    def _pressed(self, name: str) -> None:
        if name == "f12":
            self._picture_wanted = True
        elif name == "f11":
            now = self.game.settings
            self.game.change(replace(now, fullscreen=not now.fullscreen))
        else:
            self.top.pressed(name)
            self._settle()

    def _released(self, name: str) -> None:
        self.top.released(name)

    def _stick(self, name: str, deflection: float) -> None:
        self.top.stick(name, deflection)
        self._settle()

    def _settle(self) -> None:
        if self.game.stack.open:
            self._follow()

    def _place(self, x: float, y: float) -> tuple[float, float]:
        """Return window coordinates as pixels of the framebuffer."""
        width, height = self.window.get_size()
        return x * self._size[0] / max(width, 1), y * self._size[1] / max(height, 1)

    def on_key_press(self, symbol: int, _: int) -> bool:
        """Hear a key."""
        self._pressed(key_name(symbol))
        return True

    def on_key_release(self, symbol: int, _: int) -> bool:
        """Hear that a key came up."""
        self._released(key_name(symbol))
        return True

    def on_mouse_motion(self, x: float, y: float, dx: float, dy: float) -> bool:
        """Steer or point."""
        if self._captured:
            self.top.moved(dx, dy)
        else:
            self.top.pointed(*self._place(x, y))
        return True

    def on_mouse_drag(
        self, x: float, y: float, dx: float, dy: float, _buttons: int, _modifiers: int
    ) -> bool:
        """Steer or point, with a button held."""
        return self.on_mouse_motion(x, y, dx, dy)

    def on_mouse_press(self, x: float, y: float, button: int, _: int) -> bool:
        """Choose or photograph."""
        if button == _LEFT_BUTTON:
            self.top.clicked(*self._place(x, y))
            self._settle()
        return True

    def on_mouse_scroll(self, _x: float, _y: float, _across: float, up: float) -> bool:
        """Set the throttle."""
        self.top.wheel(up)
        return True

    def on_resize(self, _width: int, _height: int) -> None:
        """Lay out anew before the next frame."""
        self._size = (0, 0)

    def on_deactivate(self) -> None:
        """Pause and free the mouse: the player is elsewhere."""
        if self.game.stack.open:
            self.top.focus_lost()
            self._settle()

    def on_close(self) -> bool:
        """Leave, closing the recording."""
        self.quit()
        return True


def key_name(symbol: int) -> str:
    """Return the neutral name of a pyglet key, as controls.py and the menus know it."""
    from pyglet.window import key

    name = key.symbol_string(symbol).lower()
    return _SAME_KEY.get(name, name)
