"""The content hash: what a dive's course depends on, so that a replay knows the content it was recorded with.

Names, numbers and motion count. Comments, line ends, the order of keys and where files lie do not, nor do words and
colours: a repainted fish swims the same dive.
"""

import hashlib
import json
from collections.abc import Mapping
from typing import Any, Final

from components.flora import Anemone, Flora, Form
from components.repertoire import Repertoire
from reefgame.content.schema.level import Level
from reefgame.content.schema.species import SpeciesFile

_LEVEL_WORDS: Final = frozenset({"title", "brief", "prompts", "overrides", "more_fishes"})
"""What a dive does not depend on; `more_fishes` are among the fishes when a level is resolved."""

_SPECIES_LOOKS: Final[dict[str, bool | dict[str, bool | dict[str, bool]]]] = {
    "title": True,
    "like": True,
    "overrides": True,
    "skin": True,
    "stirs": True,
    "body": {"snout": True},
    "fins": {
        "tail": {"upper": True, "lower": True, "slender": True},
        "dorsal": {"profile": True},
        "anal": {"profile": True},
        "pectoral": {"held_out": True},
        "pelvic": True,
    },
}
"""What only the view reads."""


def content_hash(
    level: Level,
    species: Mapping[str, SpeciesFile],
    repertoires: Mapping[str, Repertoire],
    floras: Mapping[str, Flora],
) -> str:
    """Return 32 hex digits that change with whatever a dive in `level` can depend on."""
    digest = hashlib.blake2b(digest_size=16)
    # What came into the format later counts only where a file uses it: older dives stay known.
    unused = {key for key in ("flow", "plants") if not getattr(level, key)}
    looks: dict[str, Any] = {"rocks": {"__all__": {"look"}}}
    left_out = dict.fromkeys(_LEVEL_WORDS | unused, True)
    _add(digest, level.model_dump(mode="json", exclude=left_out | looks))
    for name, flora in floras.items():
        _add(digest, {name: [flora.room, flora.stands, _felt(flora.form)]})
    for name in sorted(species):
        said = species[name].model_dump(mode="json", exclude=_SPECIES_LOOKS)
        if said["mind"]["shelters"] is None:
            del said["mind"]["shelters"]
        _add(digest, {name: said})
        for segment in repertoires[name].segments:
            _add(digest, [int(segment.pattern), bool(segment.loops), len(segment.translation)])
            digest.update(segment.rotation.astype("<f8").tobytes())
            digest.update(segment.translation.astype("<f8").tobytes())
            digest.update(segment.shape.astype("<f4").tobytes())
    return digest.hexdigest()


def _felt(form: Form) -> list[Any]:
    """Return what fishes feel of a plant: the cap of an anemone's tentacles and what it does to them."""
    if not isinstance(form, Anemone):
        return []
    lengths = [*form.foot.length, *form.tentacle.length]
    return [form.radius, *lengths, form.stings, form.holds]


def _add(digest: "hashlib.blake2b", value: Any) -> None:
    digest.update(json.dumps(value, sort_keys=True, separators=(",", ":")).encode() + b"\n")
