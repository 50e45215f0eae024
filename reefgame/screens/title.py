"""The title: the game's name before a living reef, the levels with the player's best, and what to do."""

from math import cos, pi, sin

import numpy as np

from components.arrays import Float64s
from components.camera import camera_towards
from components.command import Command
from components.confinement import confine
from reefgame.content.errors import ContentError
from reefgame.progress import Record
from reefgame.screens import theme
from reefgame.screens.dive import DiveScreen
from reefgame.screens.game import Game
from reefgame.screens.menu import Item, Menu
from reefgame.screens.options import OptionsScreen
from reefgame.screens.result import clock_text
from reefgame.screens.screen import Screen
from reefgame.screens.theme import faded
from reefgame.shelf import LevelCard
from reefgame.world import World

_COMMANDS = 3
"""Items below the levels."""
_SHOWN = 5
"""Levels listed at a time."""
_ORBIT_SECONDS = 150.0
_ORBIT_RADIUS = 4.6
"""[m] from the school to the eye."""
_ORBIT_RISE = 0.12
"""Height of the eye over the school, in orbit radii."""
_CLEARANCE = 0.7
"""[m] that the eye keeps from ground, rocks and surface."""


def best_text(record: Record) -> str:
    """Return what a level's line says of the player's best."""
    if not record.wins:
        return f"best {record.count}" if record.count else "new"
    time = "" if record.seconds is None else f"  \u00b7  {clock_text(record.seconds)}"
    return f"{record.score:,}{time}"


def _school(world: World) -> Float64s:
    """Return the middle [m] of the fishes that the level is about; the start where there are none."""
    fish = world.population.fish
    wanted = world.goals[0].species if world.goals else 0
    school = fish.position[: fish.count][fish.species[: fish.count] == wanted]
    if not len(school):
        return np.asarray(world.submarine.position[0].copy(), np.float64)
    return np.asarray(np.median(school, axis=0), np.float64)


class TitleScreen(Screen):
    """Levels, Play, Options and Quit."""

    name = "title"
    lives_below = True

    def __init__(self, game: Game) -> None:
        super().__init__(game)
        self._first = 0
        self.menu = self._menu()
        self.menu.focus = len(self.menu.items) - _COMMANDS
        game.backdrop.restart()

    def _menu(self) -> Menu:
        names = [card.name for card in self.game.levels]
        chosen = names.index(self.game.chosen)
        self._first = max(0, min(chosen - _SHOWN // 2, len(names) - _SHOWN))
        rows = [self._row(card) for card in self.game.levels[self._first : self._first + _SHOWN]]
        return Menu(
            [
                *rows,
                Item("Dive", self._play, shift=self._other_level if len(names) > 1 else None),
                Item("Options", lambda: self.game.open(OptionsScreen(self.game))),
                Item("Quit", self.game.quit),
            ]
        )

    def _row(self, card: LevelCard) -> Item:
        def choose() -> None:
            self.game.chosen = card.name
            self._play()

        return Item(
            card.title,
            choose,
            lambda: best_text(self.game.progress.record(card.name)),
            marked=lambda: self.game.chosen == card.name,
        )

    def _after_input(self) -> None:
        """Tell of the level that has the focus, and make it the one that Dive begins."""
        at = self._first + self.menu.focus
        if (
            self.menu.focus >= len(self.menu.items) - _COMMANDS
            or self.game.levels[at] is self.game.card
        ):
            return
        self.game.chosen = self.game.levels[at].name
        self.game.stack.relay(self)

    def _other_level(self, step: int) -> None:
        names = [card.name for card in self.game.levels]
        self.game.chosen = names[(names.index(self.game.chosen) + step) % len(names)]
        self.menu = self._menu()
        self.menu.focus = len(self.menu.items) - _COMMANDS
        self.game.stack.relay(self)

    def _play(self) -> None:
        try:
            self.game.stage  # noqa: B018 (loads the level)
        except ContentError as error:
            self.game.say(str(error))
            return
        self.game.stack.replace(lambda: DiveScreen(self.game))

    def opened(self) -> None:
        """Show scores and settings as they are now."""
        self.menu.refresh()

    def layout(self) -> None:
        """Lay out a column at the left, the reef free at the right."""
        c, u = self.canvas, self.canvas.unit
        column = min(470 * u, c.width - 40 * u)
        left = min(64 * u, 0.5 * (c.width - column))
        self._shade(left + column)
        top = c.height - min(150 * u, 0.21 * c.height)
        c.text("reefgame", left - 4 * u, top, theme.HUGE, theme.FOAM, weight="light", shadow=True)
        c.text("A living reef, and you in it", left, top - 30 * u, theme.BODY, theme.MIST)
        card = self.game.card
        inside = column - 36 * u
        brief = c.text(
            card.brief, left + 18 * u, 0, theme.SMALL, theme.MIST, "left top", inside, order=2
        )
        levels = len(self.menu.items) - _COMMANDS
        rows = Menu.height(len(self.menu.items), u)
        height = rows + brief.height + 62 * u
        low = max(46 * u, 0.5 * (top - 56 * u - height))
        c.card(left, low, column, height)
        head = low + height - 28 * u
        c.text(card.title, left + 18 * u, head - 4 * u, theme.LARGE, theme.FOAM, order=2)
        brief.move(left + 18 * u, head - 14 * u)
        self.menu.layout(c, left + 8 * u, low + rows + 8 * u, column - 16 * u)
        c.panel(
            left + 18 * u, low + 8 * u + 3 * 44 * u, inside, max(1.0, u),
            theme.RIM if levels else theme.CLEAR, order=1,
        )  # fmt: skip
        c.text(
            "arrows and Enter, mouse or gamepad   \u00b7   F11 full screen   \u00b7   F12 picture",
            left, 20 * u, theme.TINY, theme.HAZE,
        )  # fmt: skip

    def _shade(self, right: float) -> None:
        c = self.canvas
        c.panel(
            -2, -2, 1.35 * right, c.height + 4, faded(theme.ABYSS, 0.85), bottom=faded(theme.ABYSS, 0.0),
            sideways=True,
        )  # fmt: skip

    def update(self, seconds: float) -> None:
        """Let the reef live on."""
        self.game.backdrop.advance(seconds, Command)

    def draw_sea(self, width: int, height: int) -> None:
        """Look at the school from a slow circle around it, kept right of the column."""
        stage = self.game.backdrop
        middle = _school(stage.world)
        angle = 2.0 * pi * stage.seconds / _ORBIT_SECONDS
        eye = middle[None] + _ORBIT_RADIUS * np.array([[cos(angle), sin(angle), _ORBIT_RISE]])
        confine(stage.world.terrain, eye, 0, _CLEARANCE)
        ahead = camera_towards(eye[0], middle)
        aside = 0.3 * _ORBIT_RADIUS * min(1.0, width / height - 1.0)
        stage.draw(camera_towards(eye[0], middle - aside * ahead.right), width, height)

    def pressed(self, name: str) -> None:
        """Move through the menu."""
        self.menu.pressed(name)
        self._after_input()

    def stick(self, name: str, deflection: float) -> None:
        """Move through the menu."""
        self.menu.stick(name, deflection)
        self._after_input()

    def pointed(self, x: float, y: float) -> None:
        """Focus what the pointer is over."""
        self.menu.pointed(x, y)
        self._after_input()

    def clicked(self, x: float, y: float) -> None:
        """Choose what was clicked."""
        self.menu.clicked(x, y)
