"""The window of `reefgame retouch`: mouse and keys in, frames out (papers/003, section 6)."""

from collections.abc import Callable
from time import perf_counter
from typing import Any, Final

import numpy as np

from components.arrays import Float64s
from components.fault import FaultError
from reefgame.screens.game_window import key_name
from reefgame.screens.retouch_stage import RetouchStage
from reefgame.screens.retouch_view import RetouchView
from reefgame.screens.screen import trace
from tools.video.retarget.skeleton import NAMES

_FRAMES_A_SECOND: Final = 60
_LONGEST_FRAME: Final = 0.25
_LEFT_BUTTON: Final = 1
_CONTROL: Final = 2
_COMMAND: Final = 64
_SHIFT: Final = 1
_LEAVE: Final = "not saved yet: Esc again leaves it so"
Save = Callable[[Float64s, int], str]
"""Writes angles (T, 22) with so many edits; returns a line that says where. May raise FaultError."""


class RetouchWindow:
    """Joins a pyglet window and a stage."""

    def __init__(self, window: Any, stage: RetouchStage, save: Save) -> None:
        self.window, self.stage, self._save = window, stage, save
        self._view: RetouchView | None = None
        self._hovered: int | None = None
        self._scrubbing = self._dragging = False
        self._said = "drag a point: its neighbours in time follow"
        self._last = perf_counter()
        self._deeds: dict[str, Callable[[], None]] = {
            "play": self._play,
            "undo": self._undo,
            "redo": self._redo,
            "save": self._store,
        }
        window.push_handlers(self)

    @property
    def view(self) -> RetouchView:
        """The layout for the size that the window has now."""
        size = self.window.get_framebuffer_size()
        if self._view is None or (self._view.width, self._view.height) != size:
            from pyglet.math import Mat4

            if self._view is not None:
                self._view.delete()
            self.window.switch_to()
            self.window.projection = Mat4.orthogonal_projection(0, size[0], 0, size[1], -255, 255)
            self._view = RetouchView(self.stage, *size)
        return self._view

    def run(self) -> None:
        """Work until the user leaves."""
        import pyglet

        trace("screen retouch")
        self._trace_handles()
        self._last = perf_counter()
        try:
            pyglet.app.run(1.0 / _FRAMES_A_SECOND)
        finally:
            self.window.close()

    def _trace_handles(self) -> None:
        """Say where handles, buttons and timeline are: tests with a real mouse follow it. y is down."""
        view = self.view
        for column, (x, y) in view.handles().items():
            trace(f"handle {NAMES[column]} {x:.0f} {view.height - y:.0f}")
        for name, (box, _, _) in view.buttons.items():
            trace(
                f"button {name} {box.x + 0.5 * box.width:.0f} {view.height - box.y - 0.5 * box.height:.0f}"
            )
        box = view.curve
        trace(
            f"timeline {box.x:.0f} {box.x + box.width:.0f} {view.height - box.y - 0.5 * box.height:.0f}"
        )

    def on_draw(self) -> None:
        """Advance by the time since the last frame, and draw."""
        from pyglet import gl

        now = perf_counter()
        seconds, self._last = min(now - self._last, _LONGEST_FRAME), now
        self.stage.advance(seconds)
        view = self.view
        gl.glViewport(0, 0, view.width, view.height)
        view.draw(self._hovered, self._said)

    def _place(self, x: float, y: float) -> tuple[float, float]:
        """Return window coordinates as pixels of the framebuffer."""
        width, height = self.window.get_size()
        return x * self.view.width / max(width, 1), y * self.view.height / max(height, 1)

    def on_mouse_motion(self, x: float, y: float, _dx: float, _dy: float) -> bool:
        """Light up the handle under the pointer."""
        self._hovered = self.view.handle_at(*self._place(x, y))
        return True

    def on_mouse_press(self, x: float, y: float, button: int, _: int) -> bool:
        """Take hold of a handle or the timeline, or press a button."""
        if button != _LEFT_BUTTON:
            return True
        at = self._place(x, y)
        name, column = self.view.button_at(*at), self.view.handle_at(*at)
        if name is not None:
            self._deeds[name]()
        elif column is not None:
            self._dragging = True
            self.stage.grab(column)
        elif self.view.curve.holds(*at):
            self._scrubbing = True
            self.stage.show(self.view.frame_at(at[0]))
        return True

    def on_mouse_drag(
        self, x: float, y: float, _dx: float, _dy: float, _buttons: int, _modifiers: int
    ) -> bool:
        """Drag what is held."""
        at = self._place(x, y)
        if self._dragging:
            self.view.drag(*at)
        elif self._scrubbing:
            self.stage.show(self.view.frame_at(at[0]))
        return True

    def on_mouse_release(self, _x: float, _y: float, button: int, _: int) -> bool:
        """Let go: a drag becomes an edit."""
        if button != _LEFT_BUTTON:
            return True
        if self._dragging:
            reached = self.stage.release()
            if reached is not None:
                self._tell(f"frames {reached.first + 1} to {reached.last + 1} follow")
                trace(
                    f"edited {NAMES[self.stage.column]} {self.stage.frame} {reached.first} {reached.last}"
                )
        if self._scrubbing:
            trace(f"frame {self.stage.frame}")
        self._dragging = self._scrubbing = False
        return True

    def on_key_press(self, symbol: int, modifiers: int) -> bool:
        """Play, step, choose, undo, redo, save or leave."""
        name, held = key_name(symbol), bool(modifiers & (_CONTROL | _COMMAND))
        stage = self.stage
        if held:
            again = name == "y" or (name == "z" and modifiers & _SHIFT)
            deed = "redo" if again else {"z": "undo", "s": "save"}.get(name)
            if deed:
                self._deeds[deed]()
        elif name == "space":
            self._play()
        elif name in ("left", "right"):
            stage.show(stage.frame + (1 if name == "right" else -1))
            trace(f"frame {stage.frame}")
        elif name == "tab":
            columns = stage.handles
            stage.column = columns[(columns.index(stage.column) + 1) % len(columns)]
        elif name == "escape":
            self.on_close()
        return True

    def on_close(self) -> bool:
        """Leave; edits that are not saved are asked about once."""
        import pyglet

        if self.stage.session.unsaved and self._said != _LEAVE:
            self._tell(_LEAVE)
            trace("unsaved")
        else:
            pyglet.app.exit()
        return True

    def _tell(self, line: str) -> None:
        self._said = line

    def _play(self) -> None:
        self.stage.playing = not self.stage.playing
        trace("playing" if self.stage.playing else f"paused {self.stage.frame}")

    def _undo(self) -> None:
        self._tell("taken back" if self.stage.session.undo() else "there is nothing to take back")
        trace(f"undone, {self.stage.session.edits} left")

    def _redo(self) -> None:
        self._tell("done again" if self.stage.session.redo() else "there is nothing to do again")
        trace(f"redone, {self.stage.session.edits} left")

    def _store(self) -> None:
        session = self.stage.session
        try:
            self._tell(self._save(np.array(session.angles), session.edits))
        except FaultError as error:
            self._tell(str(error))
            trace("not saved")
            return
        session.mark_saved()
        trace("saved")
