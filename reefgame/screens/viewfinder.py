"""The viewfinder: the 3:2 frame in which photographs are judged, and how many animals it holds (DESIGN 7)."""

from components.camera import VIEWFINDER_ASPECT, VIEWFINDER_SLOPE
from reefgame.screens import theme
from reefgame.screens.canvas import Canvas
from reefgame.screens.theme import faded

WIDE_SLOPE = 0.5773502691896257
"""Tangent of half the vertical field of view of the pilot's window, 60 degrees."""
_ROOM = 1.06
"""Least width of the window over the viewfinder's."""


def slope_for(width: int, height: int) -> float:
    """Return the pilot's camera slope for a window of width x height [px]: the frame always fits."""
    return max(WIDE_SLOPE, _ROOM * VIEWFINDER_SLOPE * VIEWFINDER_ASPECT * height / width)


def frame_box(width: int, height: int) -> tuple[float, float, float, float]:
    """Return the frame as (left, low, width, height) [px] in a window of width x height."""
    tall = height * VIEWFINDER_SLOPE / slope_for(width, height)
    wide = tall * VIEWFINDER_ASPECT
    return 0.5 * (width - wide), 0.5 * (height - tall), wide, tall


class Viewfinder:
    """Corner brackets, a small cross and a count that lights up when there is enough in the frame."""

    def __init__(self, canvas: Canvas, wanted: int, name: str) -> None:
        u = canvas.unit
        self._wanted, self._name, self._unit = wanted, name, u
        left, low, wide, tall = frame_box(canvas.width, canvas.height)
        thick, arm = max(1.5, 2.2 * u), 30 * u
        self._brackets = [
            canvas.panel(x, y, w, h, theme.FOAM, radius=0.5 * thick)
            for side in (0, 1)
            for end in (0, 1)
            for x, y, w, h in (
                (left + side * (wide - arm), low + end * (tall - thick), arm, thick),
                (left + side * (wide - thick), low + end * (tall - arm), thick, arm),
            )
        ]
        x, y = 0.5 * canvas.width, 0.5 * canvas.height
        r = 11 * u
        self._ring = canvas.panel(
            x - r, y - r, 2 * r, 2 * r, theme.CLEAR, radius=r, rim=faded(theme.FOAM, 0.35),
            rim_width=max(1.0, 1.3 * u),
        )  # fmt: skip
        self._dot = canvas.panel(x - 1.5 * u, y - 1.5 * u, 3 * u, 3 * u, theme.FOAM, radius=1.5 * u)
        self._centre, self._low = x, low - 4 * u
        self._pill = canvas.panel(x, low, 1, 1, theme.DEEP, radius=13 * u)
        self._count = canvas.text(
            "", x, self._low + 13 * u, theme.BODY, anchor="center center", order=1
        )
        self._shown: tuple[int, bool] | None = None
        self.show(0)

    def show(self, framed: int, done: bool = False) -> None:
        """Show that a photograph taken now would hold `framed` animals; nothing where it is negative."""
        if (framed, done) == self._shown:
            return
        self._shown = (framed, done)
        if framed < 0:
            self._paint(theme.CLEAR, theme.CLEAR)
            self._count.set("")
            self._pill.hide()
            return
        enough = framed >= self._wanted > 0 and not done
        line = theme.SUNLIT if enough else faded(theme.FOAM, 0.60 if framed else 0.38)
        self._paint(line, faded(line, 0.9 if enough else 0.6))
        if not self._wanted or done:
            self._count.set("")
            self._pill.hide()
            return
        text = f"{framed} / {self._wanted} {self._name}"
        self._count.set(
            f"{text}   \u00b7   Enter" if enough else text,
            theme.SUNLIT if enough else theme.FOAM if framed else theme.HAZE,
        )
        wide = self._count.width + 30 * self._unit
        self._pill.place(self._centre - 0.5 * wide, self._low, wide, 26 * self._unit)

    def _paint(self, line: theme.Colour, ring: theme.Colour) -> None:
        for bracket in self._brackets:
            bracket.paint(line)
        self._ring.paint(theme.CLEAR, rim=ring)
        self._dot.paint(faded(line, 0.8))
