"""A list of things to choose, by keyboard, mouse or gamepad."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

from reefgame.screens import theme
from reefgame.screens.canvas import Canvas, Panel, Text
from reefgame.screens.theme import faded

ACCEPT: Final = frozenset({"enter", "num_enter", "space", "pad_a"})
BACK: Final = frozenset({"escape", "pad_b", "pad_start"})
_STEPS: Final = {
    "up": -1,
    "w": -1,
    "down": 1,
    "s": 1,
    "tab": 1,
    "pad_dpup": -1,
    "pad_dpdown": 1,
}
_SHIFTS: Final = {"left": -1, "a": -1, "right": 1, "d": 1, "pad_dpleft": -1, "pad_dpright": 1}
_STICK_ON, _STICK_OFF = 0.6, 0.3


@dataclass(frozen=True)
class Item:
    """One line of a menu."""

    label: str
    choose: Callable[[], None]
    value: Callable[[], str] | None = None
    "what stands at the right, for settings and scores"
    shift: Callable[[int], None] | None = None
    "what left (-1) and right (+1) do"
    marked: Callable[[], bool] = lambda: False
    "whether it is the one in force, among several"


class Menu:
    """Items stacked downwards in a box; one of them has the focus."""

    def __init__(self, items: Sequence[Item], focus: int = 0) -> None:
        self.items = tuple(items)
        self.focus = focus
        self._rows: list[tuple[Panel, Panel, Text, Text | None]] = []
        self._box = (0.0, 0.0, 0.0, 0.0)
        self._step = 1.0
        self._stick_rests = True

    @staticmethod
    def height(count: int, unit: float) -> float:
        """Return the pixels that `count` items take."""
        return count * 44 * unit

    def layout(self, canvas: Canvas, left: float, top: float, width: float) -> None:
        """Add the items to `canvas`, downwards from (left, top), `width` wide [px]."""
        u = canvas.unit
        self._step, self._rows = self.height(1, u), []
        self._box = (left, top, width, self._step * len(self.items))
        for at, item in enumerate(self.items):
            low = top - (at + 1) * self._step
            panel = canvas.panel(
                left, low + 3 * u, width, self._step - 6 * u, theme.CLEAR, radius=9 * u, order=1
            )
            bar = canvas.panel(
                left, low + 10 * u, 4 * u, self._step - 20 * u, theme.CLEAR, radius=2 * u, order=2
            )
            base = low + 0.5 * self._step
            label = canvas.text(item.label, left + 20 * u, base, anchor="left center", order=2)
            value = None
            if item.value:
                value = canvas.text(
                    item.value(), left + width - 18 * u, base, theme.BODY, theme.MIST,
                    anchor="right center", order=2,
                )  # fmt: skip
            self._rows.append((panel, bar, label, value))
        self.refresh()

    def refresh(self) -> None:
        """Show the focus and the values as they are now."""
        for at, (panel, bar, label, value) in enumerate(self._rows):
            focused, item = at == self.focus, self.items[at]
            panel.paint(
                faded(theme.LAGOON, 0.30) if focused else theme.CLEAR,
                faded(theme.LAGOON, 0.14) if focused else theme.CLEAR,
            )
            bar.paint(theme.LAGOON if focused else theme.SUNLIT if item.marked() else theme.CLEAR)
            label.set(item.label, theme.FOAM if focused else theme.MIST)
            if value and item.value:
                shown = item.value()
                arrows = focused and item.shift
                value.set(
                    f"\u2039  {shown}  \u203a" if arrows else shown,
                    theme.FOAM if focused else theme.HAZE,
                )

    def pressed(self, name: str) -> bool:
        """Hear a key or button; return whether it meant anything."""
        item = self.items[self.focus]
        if name in _STEPS:
            self.focus = (self.focus + _STEPS[name]) % len(self.items)
        elif name in _SHIFTS and item.shift:
            item.shift(_SHIFTS[name])
        elif name in ACCEPT:
            item.choose()
        else:
            return False
        self.refresh()
        return True

    def stick(self, name: str, deflection: float) -> None:
        """Move the focus by a gamepad's left stick, one step a push."""
        if name != "lefty":
            return
        if self._stick_rests and abs(deflection) > _STICK_ON:
            self._stick_rests = False
            self.pressed("up" if deflection > 0 else "down")
        elif abs(deflection) < _STICK_OFF:
            self._stick_rests = True

    def pointed(self, x: float, y: float) -> None:
        """Give the focus to the item under the pointer."""
        at = self._at(x, y)
        if at is not None and at != self.focus:
            self.focus = at
            self.refresh()

    def clicked(self, x: float, y: float) -> None:
        """Choose the item at (x, y); on a setting's left half step back, on its right half forward."""
        at = self._at(x, y)
        if at is None:
            return
        self.focus = at
        item = self.items[at]
        if item.shift:
            item.shift(1 if x > self._box[0] + 0.5 * self._box[2] else -1)
        else:
            item.choose()
        self.refresh()

    def _at(self, x: float, y: float) -> int | None:
        left, top, width, height = self._box
        if not (left <= x <= left + width and top - height < y <= top):
            return None
        return min(int((top - y) / self._step), len(self.items) - 1)
