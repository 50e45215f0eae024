"""What `mod.yaml` may say: who the mod is, which game it needs and after which mods it loads."""

from typing import Annotated

from pydantic import Field, StringConstraints

from reefgame.content.schema.strict import (
    GAME_PATTERN,
    VERSION_PATTERN,
    Identifier,
    Strict,
    Title,
    Words,
)


class ModFile(Strict):
    """The head of a mod: lies in its folder as mod.yaml."""

    id: Identifier
    """The mod's name in `mod:species`: small letters, digits and _."""
    title: Title
    """What players read."""
    version: Annotated[str, StringConstraints(pattern=VERSION_PATTERN)]
    """The mod's own version, in quotes: "1.0"."""
    game: Annotated[str, StringConstraints(pattern=GAME_PATTERN)] = ">=0.1"
    """Which versions of the game it is for: ">=0.1" or ">=0.1, <2"."""
    about: Words = ""
    """A few sentences on the mod."""
    requires: tuple[Identifier, ...] = Field(default=(), max_length=100)
    """Mods that must be there; this one loads after them."""
    after: tuple[Identifier, ...] = Field(default=(), max_length=100)
    """Mods that this one loads after, where they are there."""
