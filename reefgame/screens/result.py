"""The result: the winning photograph, the score, and what it was made of."""

from typing import TYPE_CHECKING

from reefgame.progress import Record, Result
from reefgame.screens import theme
from reefgame.screens.menu import Item
from reefgame.screens.overlay import OverlayScreen

if TYPE_CHECKING:
    from reefgame.screens.dive import DiveScreen


def clock_text(seconds: float) -> str:
    """Return minutes and seconds as m:ss."""
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


class ResultScreen(OverlayScreen):
    """Score, photograph, and again or back."""

    name = "result"
    headline = "Well dived!"
    body_height = 300.0

    def __init__(self, dive: "DiveScreen", result: Result, before: Record) -> None:
        self.dive, self.result, self.before = dive, result, before
        super().__init__(
            dive.game,
            [Item("Dive again", dive.restart), Item("Back to the title", self.back)],
        )

    def back(self) -> None:
        """Go to the title."""
        self.dive.leave()

    def layout_body(self, left: float, top: float, width: float) -> None:
        """Show the photograph, the score and the figures."""
        c, u, result = self.canvas, self.canvas.unit, self.result
        tall = 150 * u
        wide = 1.5 * tall
        x = left + 0.5 * (width - wide)
        edge = 6 * u
        if self.dive.photograph is not None:
            c.panel(
                x - edge, top - tall - 2 * edge, wide + 2 * edge, tall + 2 * edge,
                (244, 248, 246, 255), radius=3 * u, order=1,
            )  # fmt: skip
            c.picture(self.dive.photograph, (x, top - tall - edge, wide, tall), order=1)
        middle, low = left + 0.5 * width, top - tall - 72 * u
        c.text(f"{result.score:,}", middle, low, 44, theme.SUNLIT, "center baseline", order=1)
        c.text(self._compared(), middle, low - 22 * u, theme.SMALL, theme.MIST, "center baseline",
               order=1)  # fmt: skip
        shots = int(self.dive.world.objective.shots[0])
        figures = (
            ("IN FRAME", f"{result.count}"),
            ("TIME", clock_text(result.seconds)),
            ("PHOTOS", f"{shots}"),
        )
        for at, (name, figure) in enumerate(figures):
            across = left + width * (1 + 2 * at) / 6
            c.text(figure, across, low - 58 * u, theme.LARGE, anchor="center baseline", order=1)
            c.text(name, across, low - 74 * u, theme.TINY, theme.HAZE, "center baseline", order=1)
        path = self.dive.recording.path
        if path is not None:
            c.text(f"recorded: {path}", 0.5 * c.width, 16 * u, theme.TINY, theme.MIST,
                   "center baseline", shadow=True)  # fmt: skip

    def _compared(self) -> str:
        if not self.before.wins:
            return "your first success here"
        if self.result.score > self.before.score:
            return f"a new best, {self.result.score - self.before.score:,} more"
        return f"your best is {self.before.score:,}"
