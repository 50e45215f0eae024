"""`load`: a level by name or file, with the species and flora that it needs, all checked (DESIGN 6)."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from components.flora import Flora
from components.repertoire import Repertoire
from components.species import Species
from reefgame.content.anatomy import UNTUNED, body_of, species_of, swim_of
from reefgame.content.assembly import catalogue, in_mods, local
from reefgame.content.botany import flora_of
from reefgame.content.catalogue import FLORA, LEVEL, SPECIES, Catalogue
from reefgame.content.digest import content_hash
from reefgame.content.errors import ContentError, Problem
from reefgame.content.level_checks import level_problems
from reefgame.content.load_order import DisabledMod
from reefgame.content.mods import BASE, FOLDERS, check_inside
from reefgame.content.nodes import Mark, Scalar
from reefgame.content.plant_checks import plant_problems
from reefgame.content.repertoires import Progress, repertoire_of
from reefgame.content.schema.level import Level
from reefgame.content.schema.species import SpeciesFile
from reefgame.content.schema.validate import node_at
from reefgame.content.yaml_marks import read, read_bytes


@dataclass(frozen=True)
class Content:
    """A level, checked, with all that a dive in it needs."""

    level: Level
    species: tuple[Species, ...]
    "those that the level names, sorted by name"
    hash: str
    "32 hex digits: what a replay compares"
    disabled: tuple[DisabledMod, ...]
    "installed mods that are at fault and left out"
    floras: Mapping[str, Flora] = field(default_factory=dict)
    "by name, those that the level's plants are of"


def load(
    level: str | os.PathLike[str], mods: Sequence[Path] = (), progress: Progress | None = None
) -> Content:
    """Return the level `level` (`name`, `mod:name` or a YAML file) with its species and their motion.

    `mods` are folders of mods beside those installed; `progress` is told how far captures are.
    Raise ContentError, with every problem found, where the level or one of `mods` is at fault.
    """
    known, disabled, name = find(LEVEL, level, mods)
    dive = known.level(name)
    tree, floras = known.level_tree(name), floras_in(known, dive)
    problems = [*level_problems(dive, tree), *plant_problems(dive, tree, floras)]
    if problems:
        raise ContentError(problems)
    files = {one: known.species_file(one) for one in species_in(dive)}
    motion = repertoires(known, files, progress)
    return Content(
        level=dive,
        species=tuple(species_of(one, file, motion[one]) for one, file in files.items()),
        hash=content_hash(dive, files, motion, floras),
        disabled=tuple(disabled),
        floras=floras,
    )


def load_species(
    name: str | os.PathLike[str], mods: Sequence[Path] = (), progress: Progress | None = None
) -> Species:
    """Return one species by name or YAML file, with its motion. Raise ContentError."""
    known, _, found = find(SPECIES, name, mods)
    file = known.species_file(found)
    return species_of(found, file, repertoires(known, {found: file}, progress)[found])


def read_species(
    name: str | os.PathLike[str], mods: Sequence[Path] = ()
) -> tuple[str, SpeciesFile]:
    """Return one species' full name and checked file, by name or YAML file, without its motion."""
    known, _, found = find(SPECIES, name, mods)
    return found, known.species_file(found)


def read_flora(name: str | os.PathLike[str], mods: Sequence[Path] = ()) -> Flora:
    """Return one species of plant, by name or YAML file. Raise ContentError."""
    known, _, found = find(FLORA, name, mods)
    return flora_of(found, known.flora_file(found))


def species_in(level: Level) -> list[str]:
    """Return the full names of the species that a level names, sorted."""
    named = {group.species for group in level.fishes} | {home.species for home in level.homes}
    return sorted(named | {level.objective.photograph.species})


def floras_in(known: Catalogue, level: Level) -> dict[str, Flora]:
    """Return the flora that a level's plants are of, by name, sorted. Raise ContentError."""
    names = sorted({place.flora for place in level.plants})
    return {name: flora_of(name, known.flora_file(name)) for name in names}


def find(
    kind: str, wanted: str | os.PathLike[str], mods: Sequence[Path]
) -> tuple[Catalogue, list[DisabledMod], str]:
    """Return the catalogue that holds a species, flora or level, the mods left out, and its full name."""
    text = os.fspath(wanted)
    is_file = isinstance(wanted, Path) or "/" in text or os.sep in text
    if not is_file and not text.endswith((".yaml", ".yml")):
        known, disabled = catalogue([Path(mod) for mod in mods])
        return known, disabled, _by_name(kind, text, known, disabled)
    path = Path(text)
    read_bytes(path)
    home = enclosing_mod(path)
    known, disabled = catalogue([Path(mod) for mod in (*mods, *([home] if home else []))])
    found, name = locate(kind, path, known)
    return found, disabled, name


def locate(kind: str, path: Path, known: Catalogue) -> tuple[Catalogue, str]:
    """Return the catalogue that holds what the file `path` defines, and its name there."""
    name = in_mods(path, kind, known)
    return local(path, kind, known) if name is None else (known, name)


def _by_name(kind: str, text: str, known: Catalogue, disabled: Sequence[DisabledMod]) -> str:
    try:
        return known.find(kind, text, Mark(text))
    except ContentError as error:
        problems = [Problem(text, 0, 0, p.message) for p in error.problems]
    # It may be missing because its mod is disabled: that is said as well.
    raise ContentError([*problems, *(fault for mod in disabled for fault in mod.problems)])


def enclosing_mod(path: Path) -> Path | None:
    """Return the folder of the mod in whose species/, flora/ or levels/ a file lies, or None."""
    folder = path.absolute().parent.parent
    if path.absolute().parent.name not in FOLDERS.values():
        return None
    if not (folder / "mod.yaml").is_file():
        return None
    try:
        identity = node_at(read(folder / "mod.yaml"), ("id",))
    except ContentError:
        return folder
    own = isinstance(identity, Scalar) and identity.value == BASE
    return None if own else folder


def check_tuned(known: Catalogue, name: str, file: SpeciesFile) -> None:
    """Raise ContentError where the species `name` has no `swim`."""
    if file.swim is None:
        mark = known.species[name].tree.mark
        raise Mark(mark.file).error(f"this species {UNTUNED} {mark.file}")


def repertoires(
    known: Catalogue, files: Mapping[str, SpeciesFile], progress: Progress | None
) -> dict[str, Repertoire]:
    """Return the motion of each species; progress counts over all of them. Raise ContentError."""
    found: dict[str, Repertoire] = {}
    for index, (name, file) in enumerate(files.items()):
        check_tuned(known, name, file)
        origins = known.origins(name)
        for origin in origins:
            check_inside(origin.repertoire, origin.root)
        found[name] = repertoire_of(
            body_of(file),
            swim_of(file),
            [origin.repertoire for origin in origins],
            node_at(known.species_tree(name), ("swim",)).mark,
            _part(progress, index, len(files), file.title),
        )
    return found


def _part(progress: Progress | None, index: int, count: int, title: str) -> Progress | None:
    if progress is None:
        return None
    tell = progress
    return lambda fraction, what: tell((index + fraction) / count, f"{title}: {what}")
