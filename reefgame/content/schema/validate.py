"""A tree with marks checked against a schema: pydantic's paths joined to the places of nodes (FINDINGS 7)."""

from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from reefgame.content.errors import ContentError, Problem
from reefgame.content.nodes import Listing, Mapping, Mark, Node, plain
from reefgame.content.schema.messages import (
    Location,
    message,
    missing_key,
    tuple_length,
    wrong_length,
)

Model = TypeVar("Model", bound=BaseModel)


def validate(tree: Mapping, model: type[Model], **extra: Any) -> Model:
    """Return the tree as a `model`, with `extra` fields beside it. Raise ContentError with every problem."""
    try:
        return model.model_validate({**plain(tree), **extra})
    except ValidationError as error:
        found = error.errors(include_url=False)
        raise ContentError(_problem(tree, model, one) for one in found) from None


def _problem(tree: Mapping, model: type[BaseModel], error: Any) -> Problem:
    location: Location = error["loc"]
    node = node_at(tree, location)
    listing = location[:-1] if error["type"] == "missing" else location
    if isinstance(node, Listing) and error["type"] in ("missing", "too_long"):
        allowed = tuple_length(model, listing)
        if allowed:
            return node.mark.problem(wrong_length(len(node.items), allowed))
    if error["type"] == "missing":
        return node.mark.problem(missing_key(str(location[-1])))
    mark = node.mark
    if error["type"] == "extra_forbidden":
        mark = key_mark(node_at(tree, location[:-1]), str(location[-1]))
    return mark.problem(message(error, model))


def node_at(tree: Node, location: Location) -> Node:
    """Return the deepest node on the way to `location`.

    Steps that name the branch of a union have no node and are passed over.
    """
    node = tree
    for step in location:
        below: Node | None = None
        if isinstance(node, Mapping) and isinstance(step, str):
            below = node.items.get(step)
        elif isinstance(node, Listing) and isinstance(step, int) and step < len(node.items):
            below = node.items[step]
        node = below or node
    return node


def key_mark(node: Node, key: str) -> Mark:
    """Return where the key `key` of a mapping stands; the node's own place where it has none."""
    return node.keys.get(key, node.mark) if isinstance(node, Mapping) else node.mark
