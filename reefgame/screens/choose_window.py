"""The window of `reefgame video --choose`: a click chooses the fish that is followed (papers/003, section 3.1)."""

from typing import Any, Final

from pyglet import gl
from pyglet.image import ImageData

from reefgame.screens import theme
from reefgame.screens.canvas import Canvas, Text
from reefgame.screens.choose_stage import BAR, ChooseStage
from reefgame.screens.game_window import key_name
from reefgame.screens.screen import trace
from reefgame.screens.strokes import Strokes

_FRAMES_A_SECOND: Final = 30
_LEFT_BUTTON: Final = 1
_TOLD: Final = "click the fish to follow; Esc takes the largest"
_MISSED: Final = "no fish moves there: click inside an outline"


class ChooseWindow:
    """Joins a pyglet window and, once the clip has been looked at, a stage."""

    def __init__(self, window: Any) -> None:
        self.window = window
        self._stage: ChooseStage | None = None
        self._said = "looking at the clip ..."
        self._canvas: Canvas | None = None
        self._line: Text | None = None
        self._front = Strokes()
        window.push_handlers(self)
        self.on_draw()
        window.flip()

    def run(self, stage: ChooseStage) -> tuple[float, float] | None:
        """Show the stage until the user chooses; return the place in the clip [px], None for the largest fish."""
        import pyglet

        self._stage, self._said = stage, _TOLD
        self._forget()
        self._trace_fishes(stage)
        pyglet.app.run(1.0 / _FRAMES_A_SECOND)
        return stage.chosen

    def close(self) -> None:
        """Close the window."""
        self._forget()
        self._front.delete()
        self.window.close()

    def _trace_fishes(self, stage: ChooseStage) -> None:
        """Say where the fishes are: tests with a real mouse follow it. y is down."""
        width, height = self._size
        for number in range(stage.count):
            x, y = stage.outline(number, width, height).mean(axis=0)
            trace(f"fish {number} {x:.0f} {height - y:.0f}")
        trace("screen choose")

    @property
    def _size(self) -> tuple[int, int]:
        width, height = self.window.get_framebuffer_size()
        return int(width), int(height)

    def _laid_out(self) -> Canvas:
        """Return the canvas for the size that the window has now."""
        size = self._size
        if self._canvas is None or (self._canvas.width, self._canvas.height) != size:
            from pyglet.math import Mat4

            self._forget()
            self.window.projection = Mat4.orthogonal_projection(0, size[0], 0, size[1], -255, 255)
            canvas = Canvas(*size)
            if self._stage is not None:
                picture = self._stage.picture
                rows, columns = picture.shape[:2]
                image = ImageData(columns, rows, "RGB", picture.tobytes(), -3 * columns)
                canvas.picture(image.get_texture(), self._stage.box(*size), order=0)
            bar = BAR * size[1]
            canvas.panel(0, 0, size[0], bar, theme.ABYSS, order=1)
            self._line = canvas.text(
                "", 0.5 * size[0], 0.5 * bar, theme.BODY, anchor="center center", order=2
            )
            self._canvas = canvas
        return self._canvas

    def _forget(self) -> None:
        if self._canvas is not None:
            self._canvas.delete()
        self._canvas = None

    def on_draw(self) -> None:
        """Draw the picture, the outlines and the line below."""
        self.window.switch_to()
        canvas, size = self._laid_out(), self._size
        gl.glViewport(0, 0, *size)
        self.window.clear()
        if self._line is not None:
            self._line.set(self._said)
        canvas.draw()
        for number in range(0 if self._stage is None else self._stage.count):
            self._draw_outline(number)
        self._front.draw(*size)

    def _draw_outline(self, number: int) -> None:
        if self._stage is None or self._canvas is None:
            return
        lit = number == self._stage.hovered
        colour = theme.SUNLIT if lit else theme.LAGOON
        wide = (3.5 if lit else 2.0) * self._canvas.unit
        self._front.path(self._stage.outline(number, *self._size), colour, wide)

    def _place(self, x: float, y: float) -> tuple[float, float]:
        """Return window coordinates as pixels of the framebuffer."""
        width, height = self.window.get_size()
        size = self._size
        return x * size[0] / max(width, 1), y * size[1] / max(height, 1)

    def on_mouse_motion(self, x: float, y: float, _dx: float, _dy: float) -> bool:
        """Light up the fish under the pointer."""
        if self._stage is not None:
            self._stage.point(*self._place(x, y), *self._size)
        return True

    def on_mouse_press(self, x: float, y: float, button: int, _: int) -> bool:
        """Choose the fish under the pointer."""
        if self._stage is not None and button == _LEFT_BUTTON:
            if self._stage.click(*self._place(x, y), *self._size):
                trace("chosen")
                self.on_close()
            else:
                self._said = _MISSED
                trace("missed")
        return True

    def on_key_press(self, symbol: int, _: int) -> bool:
        """Leave it at the largest fish."""
        if key_name(symbol) == "escape":
            self.on_close()
        return True

    def on_close(self) -> bool:
        """End the choice; the window stays until the caller closes it."""
        import pyglet

        pyglet.app.exit()
        return True
