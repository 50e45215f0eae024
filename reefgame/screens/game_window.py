"""The window that joins pyglet and the screens: it hears keys, mouse and gamepads and draws the topmost (DESIGN 5).

pyglet is imported when the window works, not before: it decides what kind of window it makes at its first import.
"""

from dataclasses import replace
from time import perf_counter
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from reefgame.settings import Settings
from systems.view.target import UInt8s, write_png

if TYPE_CHECKING:
    from reefgame.screens.game import Game
    from reefgame.screens.screen import Screen

CAPTION: Final = "reefgame"
_FRAMES_A_SECOND: Final = 120
"""Most frames drawn where the display does not set the pace."""
_SAME_KEY: Final = {"return": "enter", "num_enter": "enter"}
_LONGEST_FRAME: Final = 0.25
"""[s] of a frame; more is dropped: the window was dragged, the machine slept."""
_LEFT_BUTTON: Final = 1
_RIGHT_BUTTON: Final = 4


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
        if self.game.stack.open:
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
        if self.game.stack.open:
            self._pressed(key_name(symbol))
        return True

    def on_key_release(self, symbol: int, _: int) -> bool:
        """Hear that a key came up."""
        if self.game.stack.open:
            self._released(key_name(symbol))
        return True

    def on_mouse_motion(self, x: float, y: float, dx: float, dy: float) -> bool:
        """Steer or point."""
        if not self.game.stack.open:
            return True
        if self._captured:
            self.top.moved(dx, dy)
        else:
            self.top.pointed(*self._place(x, y))
        return True

    def on_mouse_drag(
        self, x: float, y: float, dx: float, dy: float, _buttons: int, _modifiers: int
    ) -> bool:
        """Steer, drag or point, with a button held."""
        if self.game.stack.open and not self._captured:
            wide, high = self._place(dx, dy)
            self.top.dragged(*self._place(x, y), wide, high)
        return self.on_mouse_motion(x, y, dx, dy)

    def on_mouse_press(self, x: float, y: float, button: int, _: int) -> bool:
        """Choose or photograph; the right button is a key like others."""
        if button == _LEFT_BUTTON and self.game.stack.open:
            self.top.clicked(*self._place(x, y))
            self._settle()
        elif button == _RIGHT_BUTTON and self.game.stack.open:
            self._pressed("mouse_right")
        return True

    def on_mouse_release(self, _x: float, _y: float, button: int, _: int) -> bool:
        """Hear that the right button came up."""
        if button == _RIGHT_BUTTON and self.game.stack.open:
            self._released("mouse_right")
        return True

    def on_mouse_scroll(self, _x: float, _y: float, _across: float, up: float) -> bool:
        """Set the throttle."""
        if self.game.stack.open:
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
        """Leave, closing the recording; at once where the first picture is still being made."""
        if not self.game.stack.open:
            raise SystemExit(0)
        self.quit()
        return True


def key_name(symbol: int) -> str:
    """Return the neutral name of a pyglet key, as controls.py and the menus know it."""
    from pyglet.window import key

    name = key.symbol_string(symbol).lower()
    return _SAME_KEY.get(name, name)
