"""Mods: folders of data, where they are found, what they say of themselves, and the order in which they load.

A mod is a folder with mod.yaml, species/, levels/, textures/ and repertoires/; the base game is one too. Nothing in a
mod is ever run, and no path or link in it leads out of it.
"""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from importlib import metadata
from importlib.resources import files
from pathlib import Path
from typing import Final

from platformdirs import user_data_path

import assets
import levels
import reefgame
from reefgame.content.errors import ContentError, Problem, did_you_mean, listed, quoted
from reefgame.content.schema.mod import ModFile
from reefgame.content.schema.strict import ALLOWED, NAME_PATTERN
from reefgame.content.schema.validate import node_at, validate
from reefgame.content.yaml_marks import Mapping, Mark, read, shown

BASE: Final = "reefgame"
"""The id of the base game, whose names need no `mod:` before them."""

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


@dataclass(frozen=True)
class DisabledMod:
    """An installed mod that is left out, and why."""

    folder: str
    problems: tuple[Problem, ...]


def base() -> Mod:
    """Return the base game as a mod: assets/mod.yaml, assets/species, levels."""
    root = Path(str(files(assets)))
    tree = read(root / "mod.yaml")
    return Mod(
        info=validate(tree, ModFile),
        tree=tree,
        root=root.parent,
        species=root / "species",
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
        info, tree, root, folder / "species", folder / "levels", folder / "repertoires", given
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
    """Return why `name` cannot be the name of a mod, species or level; None where it can."""
    if not re.fullmatch(NAME_PATTERN[1:-1], name):
        return f"the name {quoted(name)} is not allowed: {ALLOWED[NAME_PATTERN]}"
    if name in _RESERVED:
        return f"the name {quoted(name)} is not allowed: some systems keep it for themselves"
    return None


def yaml_files(folder: Path, root: Path) -> tuple[dict[str, Path], list[Problem]]:
    """Return the YAML files of a mod's folder by their names, and what is wrong with the others."""
    found: dict[str, Path] = {}
    problems: list[Problem] = []
    for path in sorted(folder.iterdir()) if folder.is_dir() else []:
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


def installed_folders() -> list[Path]:
    """Return the folders of mods in the user's data folder and in the checkout's mods/."""
    checkout = Path(str(reefgame.__file__)).parents[1]
    places = [user_data_path("reefgame") / "mods"]
    if (checkout / "pyproject.toml").is_file():
        places.append(checkout / "mods")
    found: list[Path] = []
    for place in places:
        try:
            found += sorted(folder for folder in place.iterdir() if folder.is_dir())
        except OSError:
            continue
    return found


def discover(given: Sequence[Path]) -> tuple[list[Mod], list[DisabledMod]]:
    """Return the mods in load order without the base, and the installed ones that had to be left out.

    Raise ContentError where one of the `given` folders is at fault.
    """
    disabled: list[DisabledMod] = []
    wanted = _given(given)
    known = {mod.id: mod for mod in wanted}
    for folder in installed_folders():
        try:
            mod = read_mod(folder, given=False)
            check_new(mod, known)
        except ContentError as error:
            disabled.append(DisabledMod(str(folder), error.problems))
        else:
            known[mod.id] = mod
    installed = [mod for _, mod in sorted(known.items()) if not mod.given]
    return ordered([*installed, *wanted], disabled), disabled


def _given(folders: Sequence[Path]) -> list[Mod]:
    problems: list[Problem] = []
    known: dict[str, Mod] = {}
    for folder in dict.fromkeys(folders):
        try:
            mod = read_mod(folder, given=True)
            check_new(mod, known)
            known[mod.id] = mod
        except ContentError as error:
            problems.extend(error.problems)
    if problems:
        raise ContentError(problems)
    return list(known.values())


def check_new(mod: Mod, known: dict[str, Mod]) -> None:
    """Raise ContentError where `known` holds another mod of the same id."""
    other = known.get(mod.id)
    if other is not None:
        where = other.mark("id")
        message = f"two mods are called {quoted(mod.id)}: the other is {where.file}:{where.line}"
        raise mod.mark("id").error(message)


def ordered(mods: Sequence[Mod], disabled: list[DisabledMod]) -> list[Mod]:
    """Return the mods in load order; installed ones that cannot load move to `disabled`.

    Raise ContentError where a given mod requires one that is not there, or stands in a circle.
    """
    left = list(mods)
    while True:
        faults = [*_missing(left)] or [*_circles(left)]
        fatal = [problem for mod, problem in faults if mod.given]
        if fatal:
            raise ContentError(fatal)
        if not faults:
            return _sorted(left)[0]
        for mod in {m.id: m for m, _ in faults}.values():
            problems = tuple(problem for m, problem in faults if m is mod)
            disabled.append(DisabledMod(str(mod.root), problems))
            left.remove(mod)


def _missing(mods: Sequence[Mod]) -> Iterable[tuple[Mod, Problem]]:
    known = [mod.id for mod in mods]
    for mod in mods:
        for index, other in enumerate(mod.info.requires):
            if other not in (*known, BASE):
                message = f"the mod {quoted(other)} is required and not there"
                hint = did_you_mean(other, [name for name in known if name != mod.id])
                yield mod, mod.mark("requires", index).problem(message + hint)


def _before(mod: Mod, among: Iterable[str]) -> list[str]:
    known = set(among)
    return [other for other in (*mod.info.requires, *mod.info.after) if other in known]


def _sorted(mods: Sequence[Mod]) -> tuple[list[Mod], list[Mod]]:
    """Return the mods that can be ordered, in order, and those that stand in or behind a circle."""
    done: list[Mod] = []
    left = list(mods)
    while left:
        ready = [m for m in left if not _before(m, (other.id for other in left))]
        if not ready:
            return done, left
        done.append(ready[0])
        left.remove(ready[0])
    return done, left


def _circles(mods: Sequence[Mod]) -> Iterable[tuple[Mod, Problem]]:
    by_id = {mod.id: mod for mod in _sorted(mods)[1]}
    for mod in by_id.values():
        circle = _way_back(mod, by_id)
        if circle:
            key = "requires" if circle[1] in mod.info.requires else "after"
            index = getattr(mod.info, key).index(circle[1])
            message = f"the load order goes round in a circle: {' after '.join(circle)}"
            yield mod, mod.mark(key, index).problem(message)


def _way_back(mod: Mod, by_id: dict[str, Mod]) -> list[str] | None:
    """Return a way from the mod over those it loads after back to itself, or None."""
    ways = [[mod.id]]
    seen: set[str] = set()
    for way in ways:
        for other in _before(by_id[way[-1]], by_id):
            if other == mod.id:
                return [*way, other]
            if other not in seen:
                seen.add(other)
                ways.append([*way, other])
    return None


def names_listed(names: Iterable[str]) -> str:
    """Return the names for a message: at most twelve of them."""
    known = sorted(names)
    return listed(known) if len(known) <= 12 else ", ".join(known[:12]) + " and others"
