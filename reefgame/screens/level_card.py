"""A level as the title lists it."""

from dataclasses import dataclass


@dataclass(frozen=True)
class LevelCard:
    """What a player reads of a level before diving."""

    name: str
    "`mod:name`, or `name` in the base game"
    title: str
    brief: str = ""
