"""What the player reads as a fish: its kind, what it feels, and how to steer it."""

from typing import Final

from reefgame.screens import theme
from reefgame.screens.canvas import Canvas, Panel, Text
from reefgame.screens.theme import Colour, faded
from reefgame.world import World

FEELINGS: Final[tuple[tuple[str, str, Colour], ...]] = (
    ("hunger", "hunger", theme.SUNLIT),
    ("libido", "libido", (236, 130, 190, 255)),
    ("fear", "fear", theme.CORAL),
)
"""Column of the mind, its name, and the colour in which it is drawn everywhere."""
ORDERS: Final = "B  let go    E  eat    G  hide    V  from behind"
"""The keys of a fish."""
_WIDE, _TALL, _ROW = 300.0, 116.0, 20.0


class FishPanel:
    """A card at the lower left, there only while the player is a fish."""

    def __init__(self, canvas: Canvas, world: World) -> None:
        u = canvas.unit
        self._world, self._unit = world, u
        self._left, self._low = 14 * u, 14 * u if canvas.width > 980 * u else 78 * u
        left, low = self._left, self._low
        self._card: Panel = canvas.panel(
            0, 0, 0, 0, theme.DEEP, bottom=theme.ABYSS, radius=12 * u, rim=theme.RIM,
            rim_width=max(1.0, 1.2 * u),
        )  # fmt: skip
        self._title: Text = canvas.text(
            "", left + 14 * u, low + (_TALL - 24) * u, theme.BODY, order=1
        )
        self._keys: Text = canvas.text(
            "", left + 14 * u, low + 11 * u, theme.TINY, theme.HAZE, order=1
        )
        self._rows: list[tuple[Panel, Panel, Text, str, Colour]] = []
        for at, (column, _, colour) in enumerate(FEELINGS):
            y = low + (_TALL - 46 - _ROW * at) * u
            label = canvas.text("", left + 14 * u, y, theme.SMALL, theme.MIST, order=1)
            rail = canvas.panel(0, 0, 0, 0, (255, 255, 255, 26), radius=4 * u, order=1)
            bar = canvas.panel(0, 0, 0, 0, colour, radius=4 * u, order=2)
            self._rows.append((rail, bar, label, column, colour))
        self._names = [name for _, name, _ in FEELINGS]
        self._hidden = False
        self.show()

    def show(self) -> None:
        """Show the fish that the player is, or nothing."""
        world, u = self._world, self._unit
        if not world.avatar.attached or int(world.avatar.fish[0]) not in world.population:
            self._hide()
            return
        self._hidden = False
        row = world.population.row(int(world.avatar.fish[0]))
        self._card.place(self._left, self._low, _WIDE * u, _TALL * u)
        self._title.set(world.species[world.population.fish.species[row]].title)
        self._keys.set(ORDERS)
        for at, (rail, bar, label, column, colour) in enumerate(self._rows):
            y, x = self._low + (_TALL - 46 - _ROW * at) * u, self._left + 74 * u
            wide = (_WIDE - 90) * u
            value = round(50 * float(getattr(world.population.mind, column)[row])) / 50
            label.set(self._names[at], theme.MIST)
            rail.place(x, y, wide, 8 * u)
            bar.place(x, y, wide * min(value, 1.0), 8 * u)
            bar.paint(colour if value else faded(colour, 0.0))

    def _hide(self) -> None:
        if self._hidden:
            return
        self._hidden = True
        for text in (self._title, self._keys, *(row[2] for row in self._rows)):
            text.set("")
        for panel in (self._card, *(row[0] for row in self._rows), *(row[1] for row in self._rows)):
            panel.hide()
