"""What a species' habits can get wrong although every value is allowed: they contradict each other."""

from collections.abc import Iterable
from typing import Final

from reefgame.content.errors import Problem, quoted
from reefgame.content.nodes import Mapping, Mark
from reefgame.content.schema.species import SpeciesFile
from reefgame.content.schema.validate import key_mark, node_at

_SHALLOW: Final = 5.0
_DEEP: Final = 40.0
"""[m] no deeper than, and no shallower than: where darkness by day, and light, are not to be had."""


def mind_problems(file: SpeciesFile, tree: Mapping, home: str) -> list[Problem]:
    """Return the contradictions; each is placed in the species' own file, `home`, where one side of it stands there."""
    return [_mark(tree, home, places).problem(message) for places, message in _contradictions(file)]


def _mark(tree: Mapping, home: str, places: tuple[tuple[str, ...], ...]) -> Mark:
    marks = [key_mark(node_at(tree, place[:-1]), place[-1]) for place in places]
    return next((mark for mark in marks if mark.file == home), marks[0])


def _contradictions(file: SpeciesFile) -> Iterable[tuple[tuple[tuple[str, ...], ...], str]]:
    """Yield the places of the two habits that exclude each other, and what to do."""
    mind, diet, role = file.mind, ("mind", "diet"), ("role",)
    if mind.diet and file.role != "predator":
        message = (
            f"a {file.role} hunts no fishes, but `diet` names {quoted(mind.diet[0])}: "
            "write `role: predator`, or `diet: []`"
        )
        yield (diet, role), message
    if mind.grazes is False and not mind.diet and file.role != "predator":
        message = f"this {file.role} would eat nothing: leave `grazes` out, or write `grazes: true`"
        yield (("mind", "grazes"), role), message
    light, depth = ("mind", "likes", "light"), ("depth_m",)
    if mind.likes.light == "dark" and file.depth_m[1] <= _SHALLOW:
        message = (
            f"it likes the dark but not the deep: `depth_m` ends at {file.depth_m[1]:g}, "
            f"and it is bright down to {_SHALLOW:g}"
        )
        yield (light, depth), message
    if mind.likes.light == "bright" and file.depth_m[0] >= _DEEP:
        message = (
            f"it likes the light but not the shallows: `depth_m` begins at {file.depth_m[0]:g}, "
            f"and it is dark from {_DEEP:g} down"
        )
        yield (light, depth), message
