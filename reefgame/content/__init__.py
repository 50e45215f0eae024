"""How species, flora, levels and mods come in: YAML with marks, strict checks (DESIGN 6)."""

from reefgame.content.checking import (
    check,
    list_disabled,
    list_flora,
    list_levels,
    list_mods,
    list_species,
)
from reefgame.content.errors import ContentError, Problem
from reefgame.content.loading import Content, load, load_species, read_flora, read_species
from reefgame.content.new import new
from reefgame.content.schema.published import json_schema

__all__ = [
    "Content",
    "ContentError",
    "Problem",
    "check",
    "json_schema",
    "list_disabled",
    "list_flora",
    "list_levels",
    "list_mods",
    "list_species",
    "load",
    "load_species",
    "new",
    "read_flora",
    "read_species",
]
