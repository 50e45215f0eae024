"""The tree of a content file: nodes that know their file, line and column, and how trees merge."""

from dataclasses import dataclass, field
from typing import Any, TypeAlias

from reefgame.content.errors import ContentError, Problem
from reefgame.content.scalars import Plain


@dataclass(frozen=True)
class Mark:
    """A place in a file; line and column count from 1."""

    file: str
    line: int = 1
    column: int = 1

    def problem(self, message: str) -> Problem:
        """Return the problem `message` at this place."""
        return Problem(self.file, self.line, self.column, message)

    def error(self, message: str) -> ContentError:
        """Return an error that holds one problem at this place."""
        return ContentError([self.problem(message)])


@dataclass(frozen=True)
class Scalar:
    """A word, a number, true, false or nothing."""

    mark: Mark
    value: Plain


@dataclass(frozen=True)
class Listing:
    """A list of nodes."""

    mark: Mark
    items: list["Node"] = field(default_factory=list)


@dataclass(frozen=True)
class Mapping:
    """Keys with the places of the keys, and nodes."""

    mark: Mark
    items: dict[str, "Node"] = field(default_factory=dict)
    keys: dict[str, Mark] = field(default_factory=dict)


Node: TypeAlias = Scalar | Listing | Mapping


def plain(node: Node) -> Any:
    """Return the tree as Python values: dictionaries, tuples, str, int, float, bool and None."""
    if isinstance(node, Scalar):
        return node.value
    if isinstance(node, Listing):
        return tuple(plain(item) for item in node.items)
    return {name: plain(item) for name, item in node.items.items()}


def merged(below: Mapping, above: Mapping) -> Mapping:
    """Return `below` with the values of `above` over it: mappings merge, all else is replaced."""
    result = Mapping(above.mark, dict(below.items), dict(below.keys))
    for name, node in above.items.items():
        old = below.items.get(name)
        both = isinstance(old, Mapping) and isinstance(node, Mapping)
        result.items[name] = merged(old, node) if both else node  # type: ignore[arg-type]
        result.keys[name] = above.keys[name]
    return result


def without(node: Mapping, *names: str) -> Mapping:
    """Return the mapping without the keys `names`."""
    kept = {name: item for name, item in node.items.items() if name not in names}
    return Mapping(node.mark, kept, {name: node.keys[name] for name in kept})
