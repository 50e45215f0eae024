"""The content hash: what a dive's course depends on, so that a replay knows the content it was recorded with.

Names, numbers and motion count. Comments, line ends, the order of keys and where files lie do not, nor do words and
colours: a repainted fish swims the same dive.
"""

import hashlib
import json
from collections.abc import Mapping
from typing import Any, Final

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
    level: Level, species: Mapping[str, SpeciesFile], repertoires: Mapping[str, Repertoire]
) -> str:
    """Return 32 hex digits that change with whatever a dive in `level` can depend on."""
    digest = hashlib.blake2b(digest_size=16)
    _add(digest, level.model_dump(mode="json", exclude=set(_LEVEL_WORDS)))
    for name in sorted(species):
        _add(digest, {name: species[name].model_dump(mode="json", exclude=_SPECIES_LOOKS)})
        for segment in repertoires[name].segments:
            _add(digest, [int(segment.pattern), bool(segment.loops), len(segment.translation)])
            digest.update(segment.rotation.astype("<f8").tobytes())
            digest.update(segment.translation.astype("<f8").tobytes())
            digest.update(segment.shape.astype("<f4").tobytes())
    return digest.hexdigest()


def _add(digest: "hashlib.blake2b", value: Any) -> None:
    digest.update(json.dumps(value, sort_keys=True, separators=(",", ":")).encode() + b"\n")
