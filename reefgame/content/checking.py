"""What `reefgame check` and `reefgame list` say: every fault of files and folders, and what there is."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from reefgame.content.assembly import catalogue
from reefgame.content.catalogue import FLORA, KINDS, LEVEL, SPECIES, Catalogue
from reefgame.content.errors import ContentError, Problem
from reefgame.content.level_checks import level_problems
from reefgame.content.load_order import DisabledMod, check_new, ordered
from reefgame.content.loading import check_tuned, enclosing_mod, floras_in, locate, species_in
from reefgame.content.mods import BASE, FOLDERS, Mod, read_mod
from reefgame.content.nodes import Mapping, Mark, Scalar
from reefgame.content.plant_checks import plant_problems
from reefgame.content.schema.flora import FORMS
from reefgame.content.schema.mod import ModFile
from reefgame.content.schema.validate import validate
from reefgame.content.yaml_marks import read, shown


def check(paths: Sequence[Path]) -> list[Problem]:
    """Return every problem of the given files, folders of files and mods, in order of place."""
    problems: list[Problem] = []
    mods: list[Path] = []
    known: dict[Path | None, Catalogue] = {}
    for path in paths:
        found, faults = _content_in(Path(path))
        problems += faults
        for one in found:
            if one.is_dir():
                mods.append(one)
            else:
                problems += _problems(_check_file, one, known)
    if mods:
        problems += _problems(_check_mods, mods)
    return sorted(set(problems))


def _problems(work: Callable[..., Iterable[Problem]], *arguments: object) -> list[Problem]:
    try:
        return list(work(*arguments))
    except ContentError as error:
        return list(error.problems)


def _is_mod(folder: Path) -> bool:
    """Return whether a folder is a mod other than the base game."""
    if not (folder / "mod.yaml").exists():
        return False
    try:
        identity = read(folder / "mod.yaml").items.get("id")
    except ContentError:
        return True
    return not (isinstance(identity, Scalar) and identity.value == BASE)


def _content_in(path: Path) -> tuple[list[Path], list[Problem]]:
    """Return the mods (folders) and files of content at or below a path, and what is wrong with it."""
    if not path.is_dir():
        return ([path.parent] if path.name == "mod.yaml" and _is_mod(path.parent) else [path]), []
    if _is_mod(path):
        return [path], []
    try:
        entries = sorted(path.iterdir())
    except OSError as error:
        return [], [Mark(shown(path)).problem(f"the folder cannot be read: {error.strerror}")]
    found = [entry for entry in entries if entry.suffix == ".yaml"]
    for folder in entries:
        if folder.is_dir() and not folder.is_symlink() and not folder.name.startswith((".", "_")):
            found += _content_in(folder)[0]
    nothing = Mark(shown(path)).problem("there is no YAML file in this folder")
    return found, [] if found else [nothing]


def kind_of(tree: Mapping, path: Path) -> str:
    """Return `species`, `flora`, `level` or `mod`: by the folder that a file lies in, else by its keys."""
    if path.name == "mod.yaml":
        return "mod"
    folder = path.absolute().parent.name
    if folder in FOLDERS.values():
        return next(kind for kind, name in FOLDERS.items() if name == folder)
    if {"world", "submarine", "objective", "fishes"} & set(tree.items):
        return LEVEL
    return FLORA if {"room_cm", *FORMS} & set(tree.items) else SPECIES


def _check_file(path: Path, known: dict[Path | None, Catalogue]) -> list[Problem]:
    tree = read(path)
    kind = kind_of(tree, path)
    if kind == "mod":
        validate(tree, ModFile)
        return []
    home = enclosing_mod(path)
    if home not in known:
        known[home] = catalogue([home] if home else [])[0]
    found, name = locate(kind, path, known[home])
    return _check_one(found, kind, name)


def _check_one(known: Catalogue, kind: str, name: str) -> list[Problem]:
    if kind == SPECIES:
        check_tuned(known, name, known.species_file(name))
        return []
    if kind == FLORA:
        known.flora_file(name)
        return []
    level = known.level(name)
    tree, floras = known.level_tree(name), floras_in(known, level)
    problems = [*level_problems(level, tree), *plant_problems(level, tree, floras)]
    for species in species_in(level):
        problems += _problems(_check_one, known, SPECIES, species)
    return problems


def _check_mods(folders: Sequence[Path]) -> list[Problem]:
    known, _ = catalogue(())
    mods, problems = _heads(folders)
    try:
        mods = ordered(mods, [])
    except ContentError as error:
        problems += error.problems
    for mod in mods:
        known = _without(known, mod.id)
        problems += known.add(mod)
        problems += known.problems()
        for kind in KINDS:
            for name, definition in known.of(kind).items():
                if definition.mod == mod.id:
                    problems += _problems(_check_one, known, kind, name)
    return problems


def _heads(folders: Sequence[Path]) -> tuple[list[Mod], list[Problem]]:
    mods: dict[str, Mod] = {}
    problems: list[Problem] = []
    for folder in dict.fromkeys(folder.absolute() for folder in folders):
        try:
            mod = read_mod(folder, given=True)
            check_new(mod, mods)
            mods[mod.id] = mod
        except ContentError as error:
            problems += error.problems
    return list(mods.values()), problems


def _without(known: Catalogue, mod: str) -> Catalogue:
    """Return the catalogue less an installed copy of a mod that is being checked."""
    left = known.copy()
    left.mods.pop(mod, None)
    for kind in KINDS:
        for name in [n for n, d in left.of(kind).items() if d.mod == mod]:
            del left.of(kind)[name]
    left.overrides = {
        key: tuple(d for d in definitions if d.mod != mod)
        for key, definitions in left.overrides.items()
    }
    return left


_GROUND = {"sand": "sand", "rock": "rock", "any": "sand and rock"}


@dataclass(frozen=True)
class Listed:
    """One line of `reefgame list`."""

    name: str
    title: str
    note: str = ""

    def __str__(self) -> str:
        """Return name, title and note in columns."""
        return f"{self.name:<24} {self.title:<28} {self.note}".rstrip()


def list_levels(mods: Sequence[Path] = ()) -> list[Listed]:
    """Return the levels that can be dived in. Raise ContentError where one of `mods` is at fault."""
    known, _ = catalogue([Path(mod) for mod in mods])
    found = [known.level(name) for name in known.levels]
    return [
        Listed(level.name, level.title, f"{sum(group.count for group in level.fishes)} fishes")
        for level in found
    ]


def list_species(mods: Sequence[Path] = ()) -> list[Listed]:
    """Return the species that levels can name. Raise ContentError where one of `mods` is at fault."""
    known, _ = catalogue([Path(mod) for mod in mods])
    found = {name: known.species_file(name) for name in known.species}
    return [
        Listed(name, file.title, f"{file.role}, {file.size_cm:g} cm")
        for name, file in found.items()
    ]


def list_flora(mods: Sequence[Path] = ()) -> list[Listed]:
    """Return the plants that levels can name. Raise ContentError where one of `mods` is at fault."""
    known, _ = catalogue([Path(mod) for mod in mods])
    found = {name: known.flora_file(name) for name in known.flora}
    return [
        Listed(name, file.title, f"{file.form.replace('_', ' ')}, on {_GROUND[file.stands]}")
        for name, file in found.items()
    ]


def list_disabled(mods: Sequence[Path] = ()) -> list[DisabledMod]:
    """Return the installed mods that are at fault and left out."""
    return catalogue([Path(mod) for mod in mods])[1]


def list_mods(mods: Sequence[Path] = ()) -> list[Listed]:
    """Return the base game and the mods in load order, then the disabled ones with their faults."""
    known, disabled = catalogue([Path(mod) for mod in mods])
    found = [
        Listed(mod.id, mod.info.title, f"version {mod.info.version}") for mod in known.mods.values()
    ]
    for left_out in disabled:
        faults = "; ".join(str(problem) for problem in left_out.problems)
        found.append(Listed(Path(left_out.folder).name, "disabled", faults))
    return found
