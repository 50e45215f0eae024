"""A catalogue put together: the base game, then the mods in load order, then a loose file where one is asked for.

Each installed mod is tried on a copy: one at fault leaves no trace.
"""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from reefgame.content.catalogue import Catalogue
from reefgame.content.errors import ContentError, Problem, quoted
from reefgame.content.load_order import DisabledMod, discover
from reefgame.content.mods import BASE, Mod, base, name_problem
from reefgame.content.nodes import Scalar
from reefgame.content.yaml_marks import read


def catalogue(given: Sequence[Path] = ()) -> tuple[Catalogue, list[DisabledMod]]:
    """Return what the base game and all mods define, and the installed mods that are left out.

    Raise ContentError where the base game or a mod of `given` is at fault.
    """
    known = Catalogue()
    problems = known.add(base()) or known.problems()
    if problems:
        raise ContentError(problems)
    mods, disabled = discover(given)
    fatal: list[Problem] = []
    waiting = list(mods)
    while waiting:
        mod = waiting.pop(0)
        trial = known.copy()
        problems = [*trial.add(mod), *trial.problems()]
        if not problems:
            known = trial
        elif mod.given:
            fatal += problems
            known = trial
        else:
            disabled.append(DisabledMod(str(mod.root), tuple(problems)))
            waiting = _without_dependants(mod, waiting, disabled)
    if fatal:
        raise ContentError(fatal)
    return known, disabled


def _without_dependants(mod: Mod, waiting: list[Mod], disabled: list[DisabledMod]) -> list[Mod]:
    """Return the mods that still can load without `mod`; a given one that needs it raises ContentError."""
    kept: list[Mod] = []
    gone = [mod.id]
    for other in waiting:
        needed = [index for index, name in enumerate(other.info.requires) if name in gone]
        if not needed:
            kept.append(other)
            continue
        name = other.info.requires[needed[0]]
        problem = other.mark("requires", needed[0]).problem(
            f"the mod {quoted(name)} is required and disabled"
        )
        if other.given:
            raise ContentError([problem, *disabled[-1].problems])
        disabled.append(DisabledMod(str(other.root), (problem,)))
        gone.append(other.id)
    return kept


def in_mods(path: Path, kind: str, known: Catalogue) -> str | None:
    """Return the name of the species, flora or level that the file `path` defines or overrides, or None."""
    real = path.resolve()
    for name, definition in known.of(kind).items():
        if definition.path.name == path.name and definition.path.resolve() == real:
            return name
    for (changed, target), definitions in known.overrides.items():
        if changed == kind and real in [definition.path.resolve() for definition in definitions]:
            return target
    return None


def local(path: Path, kind: str, known: Catalogue) -> tuple[Catalogue, str]:
    """Return a catalogue that also holds the file `path`, which no mod holds, and its name there.

    What it is like may lie beside it. Raise ContentError.
    """
    trial = known.copy()
    beside = path.parent
    home = replace(known.mods[BASE], root=beside.resolve(), repertoires=beside / "repertoires")
    changed = read(path).keys.get("overrides")
    if changed is not None:
        raise changed.error("only a file in a mod overrides: put it into the mod's folder")
    definition = trial.add_file(kind, home, path)
    like = definition.tree.items.get("like")
    while isinstance(like, Scalar) and isinstance(like.value, str):
        parent = beside / f"{like.value}.yaml"
        if like.value in trial.of(kind) or name_problem(like.value) or not parent.is_file():
            break
        like = trial.add_file(kind, home, parent).tree.items.get("like")
    return trial, definition.name
