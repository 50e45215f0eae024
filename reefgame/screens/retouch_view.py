"""Draws the retouch window: the fish with its handles, the curve of the chosen angle over time, and the buttons."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from pyglet.image import ImageData, Texture

from components.arrays import Float64s
from reefgame.screens import theme
from reefgame.screens.canvas import Canvas, Panel, Text
from reefgame.screens.retouch_stage import RetouchStage
from reefgame.screens.strokes import Strokes
from reefgame.screens.theme import Colour, faded

BUTTONS: Final = ("play", "undo", "redo", "save")
_TIMELINE: Final = 0.34
"""Of the window's height."""
_GRAB: Final = 16.0
"""[units] from a handle at which it is meant."""
_PICTURE: Final = 900
"""[px] of the longer side that the fish is painted in, at most; larger windows stretch it."""
_FACES: Final = {"play": "Play", "undo": "Undo", "redo": "Redo", "save": "Save"}


@dataclass(frozen=True)
class Box:
    """A rectangle of the window [px], y up."""

    x: float
    y: float
    width: float
    height: float

    def holds(self, x: float, y: float) -> bool:
        """Return whether a place lies in it."""
        return self.x <= x < self.x + self.width and self.y <= y < self.y + self.height


class RetouchView:
    """One layout of the window, for one size."""

    def __init__(self, stage: RetouchStage, width: int, height: int) -> None:
        self.stage, self.width, self.height = stage, width, height
        self.canvas = Canvas(width, height)
        u = self._unit = self.canvas.unit
        low = round(_TIMELINE * height)
        self.fish = Box(0, low, width, height - low)
        self.curve = Box(16 * u, 56 * u, width - 32 * u, low - 92 * u)
        self._front = Strokes()
        shrink = min(1.0, _PICTURE / max(width, height - low))
        self._size = (max(1, round(width * shrink)), max(1, round((height - low) * shrink)))
        self._texture = Texture.create(*self._size)
        self.canvas.picture(self._texture, (0, low, width, height - low), order=0)
        self.canvas.panel(0, 0, width, low, theme.ABYSS, bottom=(2, 10, 17, 255))
        self.buttons = self._add_buttons()
        self._title = self.canvas.text("", 18 * u, low - 24 * u, theme.BODY, order=2)
        self._when = self.canvas.text(
            "", width - 18 * u, low - 24 * u, theme.SMALL, theme.MIST, "right baseline", order=2
        )
        self._said = self.canvas.text(
            "", width - 18 * u, 26 * u, theme.SMALL, theme.SUNLIT, "right center", order=2
        )

    def _add_buttons(self) -> dict[str, tuple[Box, Panel, Text]]:
        u, found = self._unit, {}
        for at, name in enumerate(BUTTONS):
            box = Box((16 + 94 * at) * u, 12 * u, 86 * u, 30 * u)
            panel = self.canvas.panel(
                box.x,
                box.y,
                box.width,
                box.height,
                theme.DEEP,
                radius=8 * u,
                rim=theme.RIM,
                rim_width=1.0,
                order=1,
            )
            text = self.canvas.text(
                _FACES[name],
                box.x + 0.5 * box.width,
                box.y + 0.5 * box.height,
                theme.SMALL,
                anchor="center center",
                order=2,
            )
            found[name] = (box, panel, text)
        return found

    def button_at(self, x: float, y: float) -> str | None:
        """Return the button at a place of the window."""
        return next((name for name, (box, _, _) in self.buttons.items() if box.holds(x, y)), None)

    def handle_at(self, x: float, y: float) -> int | None:
        """Return the column of the handle nearest to a place of the window, None where none is near."""
        away = {c: float(np.hypot(*(p - (x, y)))) for c, p in self.handles().items()}
        nearest = min(away, key=lambda column: away[column])
        return nearest if away[nearest] <= _GRAB * self._unit else None

    def handles(self) -> dict[int, Float64s]:
        """Return where the handle of each column is in the window [px], (2,) each."""
        scale = self.width / self._size[0]
        wanted = self.stage.handles
        places = self.stage.places(*self._size)
        return {
            c: np.array([places[c][0] * scale, self.height - places[c][1] * scale]) for c in wanted
        }

    def drag(self, x: float, y: float) -> None:
        """Move the grabbed handle to a place of the window."""
        scale = self._size[0] / self.width
        self.stage.drag(np.array([x, self.height - y]) * scale, *self._size)

    def frame_at(self, x: float) -> int:
        """Return the frame at a place of the timeline."""
        share = (x - self.curve.x) / self.curve.width
        return round(share * (self.stage.frames - 1))

    def draw(self, hovered: int | None, said: str) -> None:
        """Paint everything."""
        width, height = self._size
        picture = self.stage.picture(width, height)
        self._texture.blit_into(
            ImageData(width, height, "RGB", picture.tobytes(), -3 * width), 0, 0, 0
        )
        self._write(said)
        self.canvas.draw()
        self._draw_handles(hovered)
        self._draw_curve()
        self._front.draw(self.width, self.height)

    def _write(self, said: str) -> None:
        stage = self.stage
        first, last = stage.window()
        self._title.set(stage.label())
        self._when.set(
            f"frame {stage.frame + 1} of {stage.frames}    reaches {first + 1} to {last + 1}"
        )
        self._said.set(said)
        lit = {
            "play": True,
            "undo": stage.session.edits > 0,
            "redo": stage.session.can_redo,
            "save": stage.session.unsaved,
        }
        for name, (_, panel, text) in self.buttons.items():
            panel.paint(faded(theme.LAGOON, 0.35) if lit[name] else theme.DEEP)
            text.set(self._face(name), theme.FOAM if lit[name] else theme.HAZE)

    def _face(self, name: str) -> str:
        return "Pause" if name == "play" and self.stage.playing else _FACES[name]

    def _draw_handles(self, hovered: int | None) -> None:
        for column, place in self.handles().items():
            chosen = column == self.stage.column
            size = (7.0 if chosen or column == hovered else 4.5) * self._unit
            self._dot(place, size + 1.5 * self._unit, theme.ABYSS)
            self._dot(
                place,
                size,
                theme.SUNLIT if chosen else theme.CORAL if column == hovered else theme.FOAM,
            )

    def _dot(self, place: Float64s, radius: float, colour: Colour) -> None:
        turn = np.linspace(0.0, 2.0 * np.pi, 17)
        rim = place + radius * np.stack((np.cos(turn), np.sin(turn)), axis=1)
        middle = np.broadcast_to(place, (16, 2))
        self._front.fill(np.stack((middle, rim[:-1], rim[1:]), axis=1), colour)

    def _draw_curve(self) -> None:
        stage, box = self.stage, self.curve
        now, before = stage.course(), stage.original()
        half = max(float(np.abs(np.concatenate((now, before))).max()), 0.02) * 1.1
        x = box.x + np.arange(stage.frames) / max(stage.frames - 1, 1) * box.width

        def line(values: Float64s) -> Float64s:
            return np.stack((x, box.y + (0.5 + 0.5 * values / half) * box.height), axis=1)

        first, last = stage.window()
        self._area(x[first], x[last], faded(theme.LAGOON, 0.16))
        self._front.path(line(np.zeros(stage.frames)), faded(theme.HAZE, 0.5), 1.0)
        self._front.path(line(before), faded(theme.MIST, 0.55), 1.5 * self._unit)
        self._front.path(line(now), theme.LAGOON, 2.5 * self._unit)
        at = np.array([[x[stage.frame], box.y], [x[stage.frame], box.y + box.height]])
        self._front.path(at, theme.SUNLIT, 1.5 * self._unit)
        self._dot(line(now)[stage.frame], 5.0 * self._unit, theme.SUNLIT)

    def _area(self, left: float, right: float, colour: Colour) -> None:
        low, high = self.curve.y, self.curve.y + self.curve.height
        corners = np.array([(left, low), (right + 1.0, low), (right + 1.0, high), (left, high)])
        self._front.fill(corners[np.array([[0, 1, 2], [0, 2, 3]])], colour)

    def delete(self) -> None:
        """Free what lies on the graphics card."""
        self._front.delete()
        self._texture.delete()
        self.canvas.delete()
