"""Where mods are found, and the order in which they load; installed ones that cannot load are left out.

Faults of a mod that the player names (--mod) are fatal; those of one that lies in a folder of mods are not.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from platformdirs import user_data_path

import reefgame
from reefgame.content.errors import ContentError, Problem, did_you_mean, quoted
from reefgame.content.mods import BASE, Mod, read_mod


@dataclass(frozen=True)
class DisabledMod:
    """An installed mod that is left out, and why."""

    folder: str
    problems: tuple[Problem, ...]

    def __str__(self) -> str:
        """Return a line that names the mod, and one for each fault."""
        faults = "\n".join(f"  {problem}" for problem in self.problems)
        return f"warning: the installed mod {self.folder} is disabled:\n{faults}"


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
