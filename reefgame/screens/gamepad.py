"""Gamepads, where there are any: their sticks and buttons by the names that controls.py knows.

Importing `pyglet.input` fails where there is no display or no /dev/input (FINDINGS 8): then there
are no gamepads, and the game goes on.
"""

from collections.abc import Callable
from typing import Any

_DPAD = (("pad_dpleft", "pad_dpright"), ("pad_dpdown", "pad_dpup"))


class Gamepads:
    """Opens every gamepad, now and as they come, and passes on what it does."""

    def __init__(
        self,
        pressed: Callable[[str], None],
        released: Callable[[str], None],
        stick: Callable[[str, float], None],
    ) -> None:
        self._pressed, self._released, self._stick = pressed, released, stick
        self._dpad: set[str] = set()
        self._manager: Any = None
        try:
            from pyglet import input as devices

            self._manager = devices.ControllerManager()
        except (AttributeError, ImportError, OSError):
            return
        self._manager.push_handlers(on_connect=self._open)
        for controller in self._manager.get_controllers():
            self._open(controller)

    def _open(self, controller: Any) -> None:
        try:
            controller.open()
        except OSError:
            return
        controller.push_handlers(
            on_button_press=lambda _, name: self._pressed(f"pad_{name}"),
            on_button_release=lambda _, name: self._released(f"pad_{name}"),
            on_stick_motion=self.on_stick_motion,
            on_dpad_motion=self.on_dpad_motion,
            on_trigger_motion=lambda _, name, value: self._stick(name, value),
        )

    def on_stick_motion(self, _: Any, stick: str, vector: Any) -> None:
        """Pass a stick ("leftstick") on as two axes ("leftx", "lefty")."""
        side = stick.removesuffix("stick")
        self._stick(f"{side}x", vector[0])
        self._stick(f"{side}y", vector[1])

    def on_dpad_motion(self, _: Any, vector: Any) -> None:
        """Pass the directional pad on as four buttons."""
        held = {
            names[int(amount > 0)]
            for names, amount in zip(_DPAD, vector, strict=False)
            if abs(amount) > 0.5
        }
        for name in self._dpad - held:
            self._released(name)
        for name in held - self._dpad:
            self._pressed(name)
        self._dpad = held
