"""Mods: folders of data, what they say of themselves, and what may lie in them.

A mod is a folder with mod.yaml, species/, flora/, levels/, textures/ and repertoires/; the base game is one too.
Nothing in a mod is ever run, and no path or link in it leads out of it.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from importlib import metadata
from importlib.resources import files
from pathlib import Path
from typing import Final

import assets
import levels
from reefgame.content.errors import ContentError, Problem, listed, quoted
from reefgame.content.nodes import Mapping, Mark
from reefgame.content.schema.mod import ModFile
from reefgame.content.schema.strict import ALLOWED, NAME_PATTERN
from reefgame.content.schema.validate import node_at, validate
from reefgame.content.yaml_marks import read, shown

BASE: Final = "reefgame"
"""The id of the base game, whose names need no `mod:` before them."""

FOLDERS: Final = {"species": "species", "flora": "flora", "level": "levels"}
"""Where a mod keeps the files of each kind."""

_RESERVED: Final = frozenset(
    ["con", "prn", "aux", "nul", *(f"{port}{n}" for port in ("com", "lpt") for n in range(10))]
)


@dataclass(frozen=True)
class Mod:
    """A mod that was found: what its mod.yaml says and where its parts lie."""

    info: ModFile
    tree: Mapping
    "mod.yaml with marks"
    root: Path
    "what no path leaves"
    species: Path
    flora: Path
    levels: Path
    repertoires: Path
    given: bool
    "named by the player (--mod): its faults are fatal"

    @property
    def id(self) -> str:
        """The mod's name."""
        return self.info.id

    def mark(self, *location: int | str) -> Mark:
        """Return the place of a value in mod.yaml."""
        return node_at(self.tree, location).mark


def base() -> Mod:
    """Return the base game as a mod: assets/mod.yaml, assets/species, assets/flora, levels."""
    root = Path(str(files(assets)))
    tree = read(root / "mod.yaml")
    return Mod(
        info=validate(tree, ModFile),
        tree=tree,
        root=root.parent,
        species=root / "species",
        flora=root / "flora",
        levels=Path(str(files(levels))),
        repertoires=root / "repertoires",
        given=True,
    )


def read_mod(folder: Path, given: bool) -> Mod:
    """Return the mod in `folder`. Raise ContentError where its mod.yaml is missing or at fault."""
    head = Mark(shown(folder / "mod.yaml"))
    if not folder.is_dir():
        raise Mark(shown(folder)).error("there is no such folder: a mod is a folder with mod.yaml")
    root = folder.resolve()
    if not (folder / "mod.yaml").exists():
        raise head.error("there is no such file: a mod is a folder with mod.yaml")
    check_inside(folder / "mod.yaml", root)
    tree = read(folder / "mod.yaml")
    info = validate(tree, ModFile)
    mod = Mod(
        info=info,
        tree=tree,
        root=root,
        species=folder / "species",
        flora=folder / "flora",
        levels=folder / "levels",
        repertoires=folder / "repertoires",
        given=given,
    )
    problems = [*_own_problems(mod)]
    if problems:
        raise ContentError(problems)
    return mod


def _own_problems(mod: Mod) -> Iterable[Problem]:
    if mod.id == BASE:
        yield mod.mark("id").problem(f"'{BASE}' is the base game's own name: choose another")
    if not serves(mod.info.game):
        version = metadata.version("reefgame")
        message = f"the mod is for versions {mod.info.game} of the game; this is {version}"
        yield mod.mark("game").problem(message)
    for key in ("requires", "after"):
        for index, other in enumerate(getattr(mod.info, key)):
            if other == mod.id:
                yield mod.mark(key, index).problem("a mod cannot load after itself")


def _version(text: str) -> tuple[int, ...]:
    numbers = [int(n) for n in re.findall(r"[0-9]+", text)[:4]]
    return tuple(numbers + [0] * (4 - len(numbers)))


def serves(condition: str) -> bool:
    """Return whether this version of the game meets `condition`, such as ">=0.1, <2"."""
    released = re.match(r"[0-9.]+", metadata.version("reefgame"))
    ours = _version(released.group() if released else "0")
    meets = {
        ">=": lambda theirs: ours >= theirs,
        "<=": lambda theirs: ours <= theirs,
        "==": lambda theirs: ours == theirs,
        "<": lambda theirs: ours < theirs,
        ">": lambda theirs: ours > theirs,
    }
    parts = re.findall(r"(>=|<=|==|<|>) *([0-9.]+)", condition)
    return all(meets[sign](_version(theirs)) for sign, theirs in parts)


def check_inside(path: Path, root: Path) -> None:
    """Raise ContentError where `path` leads out of the folder `root`, by a link or by dots."""
    try:
        inside = path.resolve().is_relative_to(root)
    except (OSError, RuntimeError):
        inside = False
    if not inside:
        raise Mark(shown(path)).error("this leads out of the mod: only files inside it are allowed")


def name_problem(name: str) -> str | None:
    """Return why `name` cannot be the name of a mod, species, flora or level; None where it can."""
    if not re.fullmatch(NAME_PATTERN[1:-1], name):
        return f"the name {quoted(name)} is not allowed: {ALLOWED[NAME_PATTERN]}"
    if name in _RESERVED:
        return f"the name {quoted(name)} is not allowed: some systems keep it for themselves"
    return None


def yaml_files(folder: Path, root: Path) -> tuple[dict[str, Path], list[Problem]]:
    """Return the YAML files of a mod's folder by their names, and what is wrong with the others."""
    found: dict[str, Path] = {}
    problems: list[Problem] = []
    try:
        entries = sorted(folder.iterdir()) if folder.is_dir() else []
    except OSError as error:
        message = f"the folder cannot be read: {error.strerror}"
        return {}, [Mark(shown(folder)).problem(message)]
    for path in entries:
        if path.suffix == ".yml":
            problems.append(Mark(shown(path)).problem("name the file .yaml, not .yml"))
        if path.suffix != ".yaml":
            continue
        try:
            check_inside(path, root)
            fault = name_problem(path.stem)
            if fault:
                raise Mark(shown(path)).error(fault)
            found[path.stem] = path
        except ContentError as error:
            problems.extend(error.problems)
    return found, problems


def names_listed(names: Iterable[str]) -> str:
    """Return the names for a message: at most twelve of them."""
    known = sorted(names)
    return listed(known) if len(known) <= 12 else ", ".join(known[:12]) + " and others"
