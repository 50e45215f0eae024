"""From keys, mouse and gamepad to one `Command` a tick (DESIGN 3, 7). Knows nothing of windows.

Devices report neutral lower-case names ("w", "left", "mouse_left", "pad_a"), mouse motion in pixels
and stick deflection from -1 to 1. Everything is quantised here, so a replay holds exactly what the
pilot ordered.
"""

from math import copysign
from typing import Final

from components.command import FULL, Command

BINDINGS: Final[dict[str, tuple[str, int]]] = {
    "w": ("throttle", FULL),
    "s": ("throttle", -FULL),
    "a": ("turn", FULL),
    "d": ("turn", -FULL),
    "left": ("turn", FULL),
    "right": ("turn", -FULL),
    "up": ("pitch", FULL),
    "down": ("pitch", -FULL),
    "r": ("rise", FULL),
    "space": ("rise", FULL),
    "f": ("rise", -FULL),
    "c": ("rise", -FULL),
    "lctrl": ("rise", -FULL),
    "rctrl": ("rise", -FULL),
    "pad_dpup": ("throttle", FULL),
    "pad_dpdown": ("throttle", -FULL),
}
"""The axis and the demand that a held key or button stands for."""

STOP_KEYS: Final = frozenset({"x", "pad_b"})
SHUTTER_KEYS: Final = frozenset({"enter", "p", "mouse_left", "pad_a"})
ONCE: Final[dict[str, str]] = {"b": "become", "pad_y": "become", "v": "view", "pad_x": "view"}
"""The order that a key gives for the one tick after it goes down."""
HELD: Final[dict[str, str]] = {
    "e": "eat",
    "mouse_right": "eat",
    "pad_rightshoulder": "eat",
    "g": "hide",
    "pad_leftshoulder": "hide",
}
"""The order that a key gives for as long as it is down."""

STICKS: Final[dict[str, tuple[str, float]]] = {
    "leftx": ("turn", -1.0),
    "lefty": ("throttle", 1.0),
    "rightx": ("turn", -1.0),
    "righty": ("pitch", 1.0),
    "lefttrigger": ("rise", -1.0),
    "righttrigger": ("rise", 1.0),
}
"""The axis that a stick or trigger moves, and which way."""

AXES: Final = ("throttle", "turn", "pitch", "rise")
DEAD_ZONE: Final = 0.15
"""Deflection below which a stick counts as centred."""

_DEMAND_PER_PIXEL: Final = 14.0
"""Command units times ticks that one pixel of mouse motion is worth at sensitivity 1."""
_DEMAND_PER_NOTCH: Final = 900.0
"""Command units times ticks of throttle that one notch of the wheel is worth."""
_SHARE_A_TICK: Final = 0.25
"""Part of the pending mouse demand spent each tick: smooths uneven mouse reports."""
_LONGEST_BACKLOG: Final = 30.0 * FULL
"""Pending demand beyond which more is dropped: a wild fling must not steer for seconds."""
_MOST_SHOTS: Final = 2
"""Shutter presses that may wait for their tick."""


def clamp(value: float) -> int:
    """Return `value` as a whole number of command units, from -FULL to FULL."""
    return max(-FULL, min(FULL, round(value)))


class Controls:
    """What is held, deflected and pending; asked for one `Command` a tick."""

    def __init__(self, sensitivity: float = 1.0, invert_pitch: bool = False) -> None:
        self.sensitivity = sensitivity
        self.invert_pitch = invert_pitch
        self._held: set[str] = set()
        self._tapped: set[str] = set()
        self._stick: dict[str, float] = {}
        self._pending = {"throttle": 0.0, "turn": 0.0, "pitch": 0.0}
        self._shots = 0
        self._shutter_open = False
        self._waiting: list[str] = []
        self._given: str | None = None

    def press(self, name: str) -> bool:
        """Note that `name` went down; return whether it means anything to the pilot."""
        if name in SHUTTER_KEYS:
            self._shots = min(self._shots + 1, _MOST_SHOTS)
            return True
        if name in ONCE:
            if len(self._waiting) < _MOST_SHOTS:
                self._waiting.append(ONCE[name])
            return True
        if name not in BINDINGS and name not in STOP_KEYS and name not in HELD:
            return False
        self._held.add(name)
        self._tapped.add(name)
        return True

    def release(self, name: str) -> None:
        """Note that `name` came up. One that went down since the last tick still counts for it."""
        self._held.discard(name)

    def release_all(self) -> None:
        """Let go of everything: the pilot looked away."""
        self._held.clear()
        self._tapped.clear()
        self._stick.clear()
        self._shots = 0
        self._waiting.clear()
        self._pending = dict.fromkeys(self._pending, 0.0)

    def mouse_moved(self, dx: float, dy: float) -> None:
        """Steer by mouse motion [pixels], right and up positive."""
        gain = _DEMAND_PER_PIXEL * self.sensitivity
        self._push("turn", -dx * gain)
        self._push("pitch", -dy * gain if self.invert_pitch else dy * gain)

    def wheel_turned(self, notches: float) -> None:
        """Move the throttle by the mouse wheel, away from the pilot positive."""
        self._push("throttle", notches * _DEMAND_PER_NOTCH)

    def stick_moved(self, stick: str, deflection: float) -> None:
        """Note a stick's or trigger's deflection, from -1 to 1. Unknown ones are ignored."""
        if stick in STICKS:
            self._stick[stick] = deflection

    def command(self) -> Command:
        """Return the orders of the tick that begins, and forget what was pending for it."""
        demand = dict.fromkeys(AXES, 0.0)
        for name in self._held | self._tapped:
            if name in BINDINGS:
                axis, amount = BINDINGS[name]
                demand[axis] += amount
        self._add_sticks(demand)
        if self.invert_pitch:
            demand["pitch"] = -demand["pitch"]
        for axis in self._pending:
            demand[axis] += self._spend(axis)
        down = self._held | self._tapped
        self._tapped.clear()
        buttons = {HELD[name]: 1 for name in down if name in HELD}
        buttons |= dict.fromkeys(self._once(), 1)
        return Command(
            **{axis: clamp(demand[axis]) for axis in AXES},
            stop=int(bool(down & STOP_KEYS)),
            photograph=self._shutter(),
            **buttons,
        )

    def _push(self, axis: str, demand: float) -> None:
        total = self._pending[axis] + demand
        self._pending[axis] = max(-_LONGEST_BACKLOG, min(_LONGEST_BACKLOG, total))

    def _spend(self, axis: str) -> float:
        """Take this tick's share of the pending demand, in whole units; the rest waits."""
        pending = self._pending[axis]
        share = copysign(max(1.0, abs(pending) * _SHARE_A_TICK), pending)
        spent = clamp(share) if abs(pending) >= 1.0 else 0
        self._pending[axis] = pending - spent
        return spent

    def _add_sticks(self, demand: dict[str, float]) -> None:
        for stick, deflection in self._stick.items():
            axis, way = STICKS[stick]
            beyond = max(0.0, min(1.0, abs(deflection)) - DEAD_ZONE) / (1.0 - DEAD_ZONE)
            demand[axis] += way * copysign(beyond * beyond, deflection) * FULL

    def _once(self) -> list[str]:
        """Give the order that has waited longest, for one tick; the same one twice needs a tick between."""
        if not self._waiting or self._waiting[0] == self._given:
            self._given = None
            return []
        self._given = self._waiting.pop(0)
        return [self._given]

    def _shutter(self) -> int:
        """Open the shutter for one tick a press; two presses need a closed tick between."""
        self._shutter_open = self._shots > 0 and not self._shutter_open
        if self._shutter_open:
            self._shots -= 1
        return int(self._shutter_open)
