"""The options: every change counts and is saved at once."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, TypeVar

from reefgame.screens.game import Game
from reefgame.screens.menu import Item
from reefgame.screens.overlay import OverlayScreen
from reefgame.settings import LIVE_FISHES, QUALITIES, RENDER_SCALES, SENSITIVITY

_Choice = TypeVar("_Choice")


def beside(choices: Sequence[_Choice], now: _Choice, step: int) -> _Choice:
    """Return the choice `step` places from `now`, stopping at the ends."""
    return choices[max(0, min(len(choices) - 1, choices.index(now) + step))]


class OptionsScreen(OverlayScreen):
    """Mouse, quality, live physics and full screen."""

    name = "options"
    headline = "Options"

    def __init__(self, game: Game) -> None:
        items = [
            self._item("Mouse sensitivity", self._sensitivity_text, self._shift_sensitivity),
            self._item("Invert pitch", lambda: self._switch("invert_pitch"), self._invert),
            self._item("Quality", lambda: game.settings.quality, self._shift_quality),
            self._item(
                "Sea resolution", lambda: f"{game.settings.render_scale} %", self._shift_scale
            ),
            self._item("Live physics", self._live_text, self._shift_live),
            self._item("Full screen", lambda: self._switch("fullscreen"), self._full),
            Item("Back", self.back),
        ]
        super().__init__(game, items)

    @staticmethod
    def _item(label: str, value: Any, shift: Any) -> Item:
        return Item(label, lambda: shift(1), value, shift)

    def _switch(self, name: str) -> str:
        return "on" if getattr(self.game.settings, name) else "off"

    def _sensitivity_text(self) -> str:
        return f"{self.game.settings.mouse_sensitivity:.1f}"

    def _shift_sensitivity(self, step: int) -> None:
        wanted = round(self.game.settings.mouse_sensitivity + 0.1 * step, 1)
        self._change(mouse_sensitivity=max(SENSITIVITY[0], min(SENSITIVITY[1], wanted)))

    def _shift_quality(self, step: int) -> None:
        self._change(quality=beside(QUALITIES, self.game.settings.quality, step))

    def _shift_scale(self, step: int) -> None:
        self._change(render_scale=beside(RENDER_SCALES, self.game.settings.render_scale, step))

    def _live_text(self) -> str:
        fishes = self.game.settings.live_physics
        return f"{fishes} fishes" if fishes else "off"

    def _shift_live(self, step: int) -> None:
        self._change(live_physics=beside(LIVE_FISHES, self.game.settings.live_physics, step))

    def _invert(self, _: int) -> None:
        self._change(invert_pitch=not self.game.settings.invert_pitch)

    def _full(self, _: int) -> None:
        self._change(fullscreen=not self.game.settings.fullscreen)

    def _change(self, **changed: Any) -> None:
        self.game.change(replace(self.game.settings, **changed))
