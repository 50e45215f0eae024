"""The schemas as JSON Schema, for editors that complete and check YAML while a modder types."""

import copy
from collections.abc import Sequence
from typing import Any, Final

from pydantic import BaseModel

from reefgame.content.schema.flora import FloraFile
from reefgame.content.schema.level import LevelFile
from reefgame.content.schema.mod import ModFile
from reefgame.content.schema.species import SpeciesFile

MODELS: Final[dict[str, type[BaseModel]]] = {
    "species": SpeciesFile,
    "flora": FloraFile,
    "level": LevelFile,
    "mod": ModFile,
}


def json_schema(kind: str) -> dict[str, Any]:
    """Return the JSON Schema of `species`, `flora`, `level` or `mod`. Raise KeyError for another kind."""
    model = MODELS[kind]
    full = model.model_json_schema()
    full["$schema"] = "https://json-schema.org/draft/2020-12/schema"
    full["title"] = f"reefgame {kind}"
    origins: list[str] = [name for name in ("like", "overrides") if name in model.model_fields]
    return _lenient(full, origins) if origins else full


def _lenient(full: dict[str, Any], origins: Sequence[str]) -> dict[str, Any]:
    """Let a file that starts from another leave out whatever it likes."""
    definitions = full.pop("$defs")
    partial = _without_required(copy.deepcopy({k: full[k] for k in ("type", "properties")}))
    parts = {f"Partial{k}": _without_required(v) for k, v in copy.deepcopy(definitions).items()}
    whole = {
        key: full.pop(key) for key in ("type", "properties", "required", "additionalProperties")
    }
    return {
        **full,
        "if": {"anyOf": [{"required": [origin]} for origin in origins]},
        "then": {**partial, "additionalProperties": False},
        "else": whole,
        "$defs": {**definitions, **parts},
    }


def _without_required(schema: Any) -> Any:
    if isinstance(schema, list):
        return [_without_required(item) for item in schema]
    if not isinstance(schema, dict):
        return schema
    result = {k: _without_required(v) for k, v in schema.items() if k != "required"}
    if "$ref" in result:
        result["$ref"] = result["$ref"].replace("#/$defs/", "#/$defs/Partial")
    mapping = result.get("discriminator", {}).get("mapping", {})
    for tag, target in mapping.items():
        mapping[tag] = target.replace("#/$defs/", "#/$defs/Partial")
    return result
