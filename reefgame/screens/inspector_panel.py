"""The inspector's instruments: what a fish is about and why, its feelings as curves, and the bar of time."""

from collections.abc import Callable
from typing import Final

import numpy as np

from components.clock import TICKS_PER_SECOND
from reefgame.explain import Explanation
from reefgame.screens import theme
from reefgame.screens.canvas import Canvas, Panel, Text
from reefgame.screens.fish_panel import FEELINGS
from reefgame.screens.strokes import Strokes
from reefgame.screens.theme import faded
from reefgame.timeline import Timeline
from systems.mind.intend import AFRAID, WANTING

MINUTE: Final = 60.0
_FACTS: Final = 10
_WIDE: Final = 336.0
_CURVES: Final = 120.0
HINT: Final = "Tab  next fish    Space  hold    \u2190 \u2192  step    drag, wheel  look    I  back"
LEGEND: Final = (
    "gold line: what it attends to",
    "white line: where it wants to go",
    "pale fan: what it sees, a ring every metre",
)

Box = tuple[float, float, float, float]


def _inside(box: Box, x: float, y: float) -> bool:
    return box[0] <= x <= box[0] + box[2] and box[1] <= y <= box[1] + box[3]


class MindCard:
    """A card on the left: name, intention, reason, facts and curves."""

    def __init__(self, canvas: Canvas) -> None:
        u = canvas.unit
        left, wide = 14 * u, min(_WIDE * u, canvas.width - 28 * u)
        low, top = 92 * u, canvas.height - 14 * u
        self.box: Box = (left, low, wide, top - low)
        self._unit, inner = u, left + 16 * u
        canvas.card(*self.box)
        self._title = canvas.text("", inner, top - 32 * u, theme.LARGE, order=1)
        self._does = canvas.text("", inner, top - 60 * u, theme.BODY, theme.SUNLIT, order=1)
        self._reason = canvas.text(
            "", inner, top - 70 * u, theme.SMALL, theme.FOAM, "left top", wide - 32 * u, order=1
        )
        self._facts: list[tuple[Text, Text]] = []
        for at in range(_FACTS):
            y = top - (146 + 22 * at) * u
            self._facts.append(
                (
                    canvas.text("", inner, y, theme.SMALL, theme.HAZE, order=1),
                    canvas.text("", inner + 88 * u, y, theme.SMALL, theme.MIST, order=1),
                )
            )
        self.curves: Box = (inner, low + 34 * u, wide - 32 * u, _CURVES * u)
        canvas.panel(*self.curves, faded(theme.ABYSS, 0.6), radius=6 * u, order=1)
        for at, line in enumerate(LEGEND if canvas.height > 560 * u else ()):
            y = low + (_CURVES + 84 - 16 * at) * u
            canvas.text(line, inner, y, theme.TINY, theme.HAZE, order=1)
        for at, (_, name, colour) in enumerate(FEELINGS):
            canvas.text(name, inner + 72 * at * u, low + 13 * u, theme.SMALL, colour, order=1)
        canvas.text(
            "last minute", inner + wide - 32 * u, low + 13 * u, theme.TINY, theme.HAZE,
            "right baseline", order=1,
        )  # fmt: skip

    def show(self, told: Explanation | None) -> None:
        """Show what there is to say of a fish; None where it is no more."""
        if told is None:
            told = Explanation("No such fish now", "", "it is not in the water at this time", ())
        self._title.set(told.title)
        self._does.set(told.does)
        self._reason.set(told.reason)
        for at, (name, value) in enumerate(self._facts):
            fact = told.facts[at] if at < len(told.facts) else ("", "")
            name.set(fact[0])
            value.set(fact[1])

    def draw_curves(self, strokes: Strokes, timeline: Timeline, identity: int, until: int) -> None:
        """Add the feelings of the last minute before the tick `until`."""
        x, y, wide, tall = self.curves
        for level, colour in ((AFRAID, theme.CORAL), (WANTING, theme.SUNLIT)):
            heights = np.full(25, y + level * tall)
            xs = np.linspace(x, x + wide, 25)
            points = np.stack((xs, heights), axis=1)
            strokes.lines(points[:-1:2], points[1::2], faded(colour, 0.4), self._unit)
        ticks, felt = timeline.feelings(identity, until, MINUTE)
        across = x + wide * (1.0 - (until - ticks) / (MINUTE * TICKS_PER_SECOND))
        for at, (_, _, colour) in enumerate(FEELINGS):
            points = np.stack((across, y + tall * felt[:, at]), axis=1)
            strokes.path(points, colour, 1.8 * self._unit)


class TimeBar:
    """Buttons and a bar along the lower edge: where in the dive the picture stands."""

    def __init__(self, canvas: Canvas, deeds: dict[str, Callable[[], None]]) -> None:
        u = canvas.unit
        self._unit, self._deeds = u, list(deeds.values())
        left, low, wide = 14 * u, 14 * u, canvas.width - 28 * u
        canvas.card(left, low, wide, 66 * u)
        self.bar: Box = (left + 16 * u, low + 44 * u, wide - 32 * u, 12 * u)
        canvas.panel(*self.bar, (255, 255, 255, 26), radius=6 * u, order=1)
        self._played: Panel = canvas.panel(0, 0, 0, 0, theme.LAGOON, radius=6 * u, order=2)
        self._knob: Panel = canvas.panel(0, 0, 0, 0, theme.FOAM, radius=8 * u, order=3)
        self._buttons: list[tuple[Box, Text]] = []
        x = left + 16 * u
        for name in deeds:
            text = canvas.text(name, 0, 0, theme.SMALL, theme.FOAM, "center center", order=3)
            wide_enough = max(text.width + 18 * u, 44 * u)
            box = (x, low + 9 * u, wide_enough, 26 * u)
            text.move(x + 0.5 * wide_enough, low + 22 * u)
            canvas.panel(*box, faded(theme.LAGOON, 0.22), radius=7 * u, order=2)
            self._buttons.append((box, text))
            x += wide_enough + 6 * u
        self._time = canvas.text(
            "", x + 10 * u, low + 22 * u, theme.SMALL, theme.MIST, "left center", order=2
        )
        self._hint = canvas.text(
            "",
            left + wide - 16 * u,
            low + 22 * u,
            theme.TINY,
            theme.HAZE,
            "right center",
            order=2,
        )
        self._wide = canvas.width >= 1000 * u

    def show(self, timeline: Timeline, now: int, rate: float, held: bool) -> None:
        """Show the tick, how fast time goes, and whether it is held."""
        x, y, wide, tall = self.bar
        part = (now - timeline.oldest) / max(timeline.newest - timeline.oldest, 1)
        u = self._unit
        self._played.place(x, y, round(wide * part), tall)
        self._knob.place(x + round(wide * part) - 8 * u, y - 2 * u, 16 * u, 16 * u)
        self._buttons[2][1].set("play" if held else "hold")
        where = "" if timeline.at_present else "   the past: closing returns to now"
        self._hint.set(HINT if self._wide and timeline.at_present else "")
        speed = f"\u00d7{rate:g}" if rate >= 1.0 else f"1/{round(1.0 / rate)}"
        self._time.set(f"{moment(now)} of {moment(timeline.newest)}   tick {now}   {speed}{where}")

    def tick_at(self, x: float, timeline: Timeline) -> int:
        """Return the tick that a place on the bar stands for."""
        part = min(max((x - self.bar[0]) / max(self.bar[2], 1.0), 0.0), 1.0)
        return timeline.oldest + round(part * (timeline.newest - timeline.oldest))

    def on_bar(self, x: float, y: float) -> bool:
        """Say whether (x, y) is on the bar."""
        left, low, wide, tall = self.bar
        u = self._unit
        return _inside((left - 4 * u, low - 4 * u, wide + 8 * u, tall + 10 * u), x, y)

    def click(self, x: float, y: float) -> bool:
        """Press the button at (x, y); return whether there is one."""
        for (box, _), deed in zip(self._buttons, self._deeds, strict=True):
            if _inside(box, x, y):
                deed()
                return True
        return False


def moment(tick: int) -> str:
    """Return minutes and seconds of a tick."""
    seconds = tick / TICKS_PER_SECOND
    return f"{int(seconds) // 60}:{seconds % 60:04.1f}"
