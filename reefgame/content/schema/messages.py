"""pydantic's findings in plain English: what is wrong, what is allowed, which known name is nearest."""

import re
import types
from collections.abc import Callable, Mapping, Sequence
from typing import Annotated, Any, Final, TypeAlias, Union, get_args, get_origin

from pydantic import BaseModel

from reefgame.content.errors import did_you_mean, listed, quoted
from reefgame.content.schema.strict import ALLOWED

Details: TypeAlias = Mapping[str, Any]
Location: TypeAlias = tuple[int | str, ...]

UNITS: Final = {
    "m": "metres",
    "cm": "centimetres",
    "s": "seconds",
    "min": "minutes",
    "g": "grams",
    "c": "degrees Celsius",
    "deg": "degrees",
    "hz": "beats a second",
    "percent": "percent",
    "bl": "body lengths",
}
_OTHER_UNITS: Final = (
    *UNITS,
    "mm",
    "km",
    "h",
    "ms",
    "rad",
    "ft",
    "in",
    "inch",
    "kg",
    "mg",
    "f",
    "metres",
)


def message(error: Details, model: type[BaseModel]) -> str:
    """Return what one of `ValidationError.errors()` says, for a file checked against `model`."""
    kind, value = str(error["type"]), error.get("input")
    context: Details = error.get("ctx") or {}
    if kind == "extra_forbidden":
        return _unknown_key(str(error["loc"][-1]), model_at(model, error["loc"][:-1]))
    if kind in _LIMITS:
        return f"{quoted(value)} is out of range: must be {_LIMITS[kind](context)}"
    if kind in _PLAIN:
        return _PLAIN[kind]
    if kind in _WRITTEN:
        return _WRITTEN[kind](value, context)
    return str(error["msg"])


def missing_key(name: str) -> str:
    """Return the message for a key that must be there."""
    return f"key '{name}' is missing"


def wrong_length(length: int, allowed: int) -> str:
    """Return the message for a list that must have another length."""
    return f"the list has {length} values: must have {allowed}"


_LIMITS: Final[dict[str, Callable[[Details], str]]] = {
    "greater_than": lambda c: f"more than {c['gt']:g}",
    "greater_than_equal": lambda c: f"at least {c['ge']:g}",
    "less_than": lambda c: f"less than {c['lt']:g}",
    "less_than_equal": lambda c: f"at most {c['le']:g}",
}

_PLAIN: Final = {
    "finite_number": "must be a finite number",
    "int_from_float": "must be a whole number",
}


def _number(value: object, whole: bool) -> str:
    allowed = "must be a whole number, such as 3" if whole else "must be a number, such as 1.5"
    if isinstance(value, str) and re.match(r"\s*[-+.]?[0-9][0-9.]*\s*[a-zA-Z%]+\s*\Z", value):
        return f"{quoted(value)} has a unit: write the number alone, the key says the unit"
    if isinstance(value, str) and re.match(r"\s*[-+]?[0-9]+,[0-9]+\s*\Z", value):
        return f"{quoted(value)} has a comma: write a decimal point"
    if isinstance(value, str) and re.match(r"\s*[-+.]?[0-9][0-9.]*\s*\Z", value):
        return f"{quoted(value)} is text: write the number without quotes"
    return f"{allowed}, is {describe(value)}"


def describe(value: object) -> str:
    """Return what a value is, in words."""
    if value is None:
        return "empty"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return f"the number {quoted(value)[1:-1]}"
    if isinstance(value, str):
        return f"the text {quoted(value)}"
    return "a list" if isinstance(value, tuple) else "keys and values"


def _text(value: object, _: Details) -> str:
    if isinstance(value, (bool, int, float)):
        return f"must be text, is {describe(value)}: put it in quotes"
    if value is None:
        return "must be text, is empty (a bare # begins a comment: put colours in quotes)"
    return f"must be text, is {describe(value)}"


def _pattern(value: object, context: Details) -> str:
    return f"{quoted(value)} is not allowed: {ALLOWED[str(context['pattern'])]}"


def _choice(value: object, context: Details) -> str:
    allowed = re.findall(r"'([^']*)'", str(context.get("expected") or context["expected_tags"]))
    got = context.get("tag", value)
    near = did_you_mean(str(got), allowed) if isinstance(got, str) else ""
    return f"{quoted(got)} is not known: must be {listed(allowed)}{near}"


_WRITTEN: Final[dict[str, Callable[[object, Details], str]]] = {
    "float_type": lambda v, _: _number(v, whole=False),
    "int_type": lambda v, _: _number(v, whole=True),
    "bool_type": lambda v, _: f"must be true or false, is {describe(v)}",
    "string_type": _text,
    "tuple_type": lambda v, _: f"must be a list, such as [1, 2], is {describe(v)}",
    "model_type": lambda v, _: f"must hold keys and values, is {describe(v)}",
    "model_attributes_type": lambda v, _: f"must hold keys and values, is {describe(v)}",
    "string_pattern_mismatch": _pattern,
    "string_too_long": lambda _, c: f"the text is too long: at most {c['max_length']} characters",
    "string_too_short": lambda _, c: (
        f"the text is too short: at least {c['min_length']} characters"
    ),
    "too_long": lambda _, c: (
        f"the list is too long: {c['actual_length']} values, at most {c['max_length']}"
    ),
    "too_short": lambda _, c: (
        f"the list is too short: {c['actual_length']} values, at least {c['min_length']}"
    ),
    "literal_error": _choice,
    "union_tag_invalid": _choice,
    "union_tag_not_found": lambda _, c: (
        f"key {c['discriminator']} is missing: it says which kind this is"
    ),
}


def _unknown_key(name: str, model: type[BaseModel] | None) -> str:
    known = list(model.model_fields) if model else []
    stem, _, unit = name.rpartition("_")
    bare = stem if stem and unit in _OTHER_UNITS else name
    for field in known:
        field_stem, _, field_unit = field.rpartition("_")
        if field_unit in UNITS and field_stem == bare:
            return f"unknown key {quoted(name)}: give it in {UNITS[field_unit]} as '{field}'"
    return f"unknown key {quoted(name)}{did_you_mean(name, known)}; allowed are {listed(known)}"


def model_at(model: type[BaseModel], location: Sequence[int | str]) -> type[BaseModel] | None:
    """Return the model that a location of `ValidationError.errors()` leads to, or None."""
    here: Any = model
    for step in location:
        here = _step(here, step)
    models = _models(here)
    return models[0] if len(models) == 1 else None


def tuple_length(model: type[BaseModel], location: Sequence[int | str]) -> int:
    """Return how many values the list at `location` must have; 0 where it may have any number."""
    here: Any = model
    for step in location:
        here = _step(here, step)
    tuples = [get_args(part) for part in _parts(here) if get_origin(part) is tuple]
    return len(tuples[0]) if tuples and tuples[0][-1] is not Ellipsis else 0


_TAGS: Final = ("paint", "kind")
"""Keys that say which of several models a mapping is."""


def _step(annotation: Any, step: int | str) -> Any:
    models = _models(annotation)
    if isinstance(step, int):
        return _item(annotation, step)
    for choice in models if len(models) > 1 else []:
        tags = [choice.model_fields[tag].annotation for tag in _TAGS if tag in choice.model_fields]
        if any(step in get_args(tag) for tag in tags):
            return choice
    fields = [m.model_fields[step] for m in models if step in m.model_fields]
    return fields[0].annotation if fields else None


def _item(annotation: Any, index: int) -> Any:
    for part in _parts(annotation):
        if get_origin(part) is tuple:
            arguments = get_args(part)
            return arguments[0] if arguments[-1] is Ellipsis else arguments[index % len(arguments)]
    return None


def _models(annotation: Any) -> list[type[BaseModel]]:
    return [p for p in _parts(annotation) if isinstance(p, type) and issubclass(p, BaseModel)]


def _parts(annotation: Any) -> list[Any]:
    origin = get_origin(annotation)
    if origin is Annotated:
        return _parts(get_args(annotation)[0])
    if origin in (Union, types.UnionType):
        return [part for argument in get_args(annotation) for part in _parts(argument)]
    return [annotation]
