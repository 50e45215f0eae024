"""The levels that a player may choose from, as the title lists them."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from reefgame.console import complain, progress_bar
from reefgame.content import Content, load
from reefgame.content.catalogue import LEVEL
from reefgame.content.errors import ContentError
from reefgame.content.loading import find

_FIRST_LEVEL: Final = "first_dive"


@dataclass(frozen=True)
class LevelCard:
    """What a player reads of a level before diving."""

    name: str
    "`mod:name`, or `name` in the base game"
    title: str
    brief: str = ""


@dataclass(frozen=True)
class Shelf:
    """The levels there are, and which of them to begin with."""

    cards: tuple[LevelCard, ...]
    start: str
    "the full name of the level chosen"
    asked: str
    "what the player called it: a name or a file"
    mods: tuple[Path, ...]

    def load(self, name: str) -> Content:
        """Return the content of the level `name`. Raise ContentError where it is at fault."""
        with progress_bar("loading") as report:
            wanted = self.asked if name == self.start else name
            return load(wanted, mods=self.mods, progress=report)


def find_levels(level: str | None, mods: Sequence[Path] = ()) -> Shelf:
    """Return the levels to list, `level` chosen. Raise ContentError where it or a mod is at fault.

    Another level that is at fault, and an installed mod that is, are left out and complained of.
    """
    asked = level or _FIRST_LEVEL
    known, disabled, start = find(LEVEL, asked, mods)
    for mod in disabled:
        complain(str(mod))
    cards = []
    for name in sorted(known.levels, key=lambda name: (name != _FIRST_LEVEL, name)):
        try:
            found = known.level(name)
        except ContentError as error:
            if name == start:
                raise
            complain(str(error))
            continue
        cards.append(LevelCard(name, found.title, found.brief))
    return Shelf(tuple(cards), start, asked, tuple(mods))
