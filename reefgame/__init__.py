"""The game: content, world, schedule, loop, replay, screens and the command line (DESIGN 1)."""

from importlib.metadata import version
from typing import Final

VERSION: Final = version("reefgame")
"""The installed game's version, as replays and mods name it."""
