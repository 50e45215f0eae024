"""Messages of the game itself, over every screen: a picture was saved, a folder cannot be written."""

from reefgame.screens import theme
from reefgame.screens.canvas import Canvas

_SECONDS = 4.5


class Toast:
    """Shows each of a growing list of messages for a while, the oldest first."""

    def __init__(self, messages: list[str]) -> None:
        self._messages = messages
        self._next = 0
        self._left = 0.0
        self._canvas: Canvas | None = None
        self._size = (1, 1)

    def resize(self, width: int, height: int) -> None:
        """Show what is shown at another size."""
        self._size = (width, height)
        if self._canvas is not None:
            self._lay_out(self._messages[self._next - 1])

    def update(self, seconds: float) -> None:
        """Advance by a frame."""
        self._left -= seconds
        if self._left > 0.0:
            return
        if self._next < len(self._messages):
            self._next, self._left = self._next + 1, _SECONDS
            self._lay_out(self._messages[self._next - 1])
        else:
            self._canvas = None

    def draw(self) -> None:
        """Paint the message, if any."""
        if self._canvas is not None:
            self._canvas.draw()

    def _lay_out(self, message: str) -> None:
        c = self._canvas = Canvas(*self._size)
        u = c.unit
        wide = min(580 * u, c.width - 24 * u)
        top = c.height - 8 * u
        text = c.text(
            message, 0.5 * c.width, top - 9 * u, theme.SMALL, theme.FOAM, "center top",
            wide - 32 * u, order=1,
        )  # fmt: skip
        tall = text.height + 18 * u
        c.panel(
            0.5 * (c.width - wide), top - tall, wide, tall, theme.ABYSS, radius=10 * u,
            rim=theme.faded(theme.SUNLIT, 0.4), rim_width=max(1.0, u),
        )  # fmt: skip
