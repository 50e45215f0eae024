"""All species, flora and levels of the base game and its mods, by name: `like:`, overrides and references resolved.

Definitions stay trees with marks until they are asked for, so that a fault shows where the modder wrote it, whichever
file inherits it.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from reefgame.content.errors import ContentError, Problem, did_you_mean, listed, quoted
from reefgame.content.mind_checks import mind_problems
from reefgame.content.mods import (
    BASE,
    Mod,
    names_listed,
    yaml_files,
)
from reefgame.content.nodes import Listing, Mapping, Mark, Node, Scalar, merged, without
from reefgame.content.schema.flora import FloraFile
from reefgame.content.schema.flow import carried_by
from reefgame.content.schema.level import Level, LevelFile
from reefgame.content.schema.species import SpeciesFile
from reefgame.content.schema.validate import node_at, validate
from reefgame.content.yaml_marks import read

SPECIES: Final = "species"
FLORA: Final = "flora"
LEVEL: Final = "level"
KINDS: Final = (SPECIES, FLORA, LEVEL)
_LONGEST_CHAIN: Final = 32


@dataclass(frozen=True)
class Definition:
    """One file of a mod that defines a species, flora or level."""

    name: str
    "`mod:name`, or `name` in the base game"
    mod: str
    "id of the mod"
    path: Path
    tree: Mapping
    repertoire: Path
    "where the mod would ship its motion"
    root: Path
    "what that may not lead out of"


@dataclass
class Catalogue:
    """What the base game and the mods define, in load order."""

    mods: dict[str, Mod] = field(default_factory=dict)
    species: dict[str, Definition] = field(default_factory=dict)
    flora: dict[str, Definition] = field(default_factory=dict)
    levels: dict[str, Definition] = field(default_factory=dict)
    overrides: dict[tuple[str, str], tuple[Definition, ...]] = field(default_factory=dict)
    "by kind and name of what they change"
    owner: dict[str, str] = field(default_factory=dict)
    "id of the mod that a file belongs to"

    def copy(self) -> "Catalogue":
        """Return a catalogue that can be added to without changing this one."""
        parts = (self.mods, self.species, self.flora, self.levels, self.overrides, self.owner)
        return Catalogue(*(dict(part) for part in parts))  # type: ignore[arg-type]

    def of(self, kind: str) -> dict[str, Definition]:
        """Return the definitions of one of `KINDS`."""
        return {SPECIES: self.species, FLORA: self.flora, LEVEL: self.levels}[kind]

    def add(self, mod: Mod) -> list[Problem]:
        """Take in the files of a mod; return what is wrong with them taken alone."""
        self.mods[mod.id] = mod
        problems: list[Problem] = []
        folders = (mod.species, mod.flora, mod.levels)
        for kind, folder in zip(KINDS, folders, strict=True):
            found, faults = yaml_files(folder, mod.root)
            problems += faults
            for path in found.values():
                try:
                    self.add_file(kind, mod, path)
                except ContentError as error:
                    problems += error.problems
        return problems

    def add_file(self, kind: str, mod: Mod, path: Path) -> Definition:
        """Take in one file of a mod. Raise ContentError where it is no YAML or overrides nothing."""
        tree = read(path)
        name = path.stem if mod.id == BASE else f"{mod.id}:{path.stem}"
        repertoire = mod.repertoires / f"{path.stem}.npz"
        definition = Definition(name, mod.id, path, tree, repertoire, mod.root)
        self.owner[tree.mark.file] = mod.id
        changed = tree.items.get("overrides")
        if changed is None:
            self.of(kind)[name] = definition
        else:
            self._add_override(kind, definition, changed)
        return definition

    def _add_override(self, kind: str, definition: Definition, changed: Node) -> None:
        if "like" in definition.tree.items:
            mark = definition.tree.keys["like"]
            raise mark.error("`like` and `overrides` exclude each other")
        target = self.resolve(kind, changed)
        if self.of(kind)[target].mod == definition.mod:
            raise changed.mark.error("a mod overrides what others define: change the file itself")
        key = (kind, target)
        self.overrides[key] = (*self.overrides.get(key, ()), definition)

    def resolve(self, kind: str, reference: Node, besides: str = "") -> str:
        """Return the full name that a node refers to, seen from the mod whose file it stands in.

        A bare name means the mod's own, else the base game's, else that of the one mod which has
        it. Raise ContentError where there is none or more than one.
        """
        if not isinstance(reference, Scalar) or not isinstance(reference.value, str):
            raise reference.mark.error(f"must be the name of a {kind}")
        return self.find(kind, reference.value, reference.mark, besides)

    def find(self, kind: str, wanted: str, mark: Mark, besides: str = "") -> str:
        """Return the full name of `wanted`, which stands at `mark`. Raise ContentError."""
        known = self.of(kind)
        mod, _, short = wanted.rpartition(":")
        if mod:
            names = [short if mod == BASE else wanted]
        else:
            names = [f"{self.owner.get(mark.file, BASE)}:{short}", short]
        found = [name for name in names if name in known and name != besides]
        if not found and not mod:
            found = [name for name in known if name.endswith(f":{short}") and name != besides]
            if len(found) > 1:
                raise mark.error(f"{quoted(wanted)} is ambiguous: write {listed(sorted(found))}")
        if not found and besides in names:
            return besides
        if not found:
            near = did_you_mean(wanted, [*known, *(name.rpartition(":")[2] for name in known)])
            there = f"there are {names_listed(known)}" if known else "there is none at all"
            raise mark.error(f"there is no {kind} {quoted(wanted)}{near or '; ' + there}")
        return found[0]

    def origins(self, name: str, kind: str = SPECIES) -> list[Definition]:
        """Return what a species or flora is made of: itself, what overrides it, what it is like, and so on."""
        chain = [name]
        result: list[Definition] = []
        while True:
            definition = self.of(kind)[chain[-1]]
            result += [*reversed(self.overrides.get((kind, chain[-1]), ())), definition]
            like = definition.tree.items.get("like")
            if like is None:
                return result
            parent = self.resolve(kind, like, besides=chain[-1])
            if parent in chain:
                raise like.mark.error(f"`like` goes in a circle: {' like '.join([*chain, parent])}")
            if len(chain) == _LONGEST_CHAIN:
                raise like.mark.error(f"`like` goes on too long: at most {_LONGEST_CHAIN} {kind}")
            chain.append(parent)

    def species_tree(self, name: str, kind: str = SPECIES) -> Mapping:
        """Return a species' or flora's tree with `like` and overrides merged. Raise ContentError."""
        origins = self.origins(name, kind)
        tree = without(origins[-1].tree, "like", "overrides")
        for definition in reversed(origins[:-1]):
            tree = merged(tree, without(definition.tree, "like", "overrides"))
        return Mapping(self.of(kind)[name].tree.mark, tree.items, tree.keys)

    def species_file(self, name: str) -> SpeciesFile:
        """Return the species `name` as its file and those it starts from say. Raise ContentError."""
        tree = self.species_tree(name)
        file = validate(tree, SpeciesFile)
        diet, problems = self._diet(tree, file)
        problems += mind_problems(file, tree, self.species[name].tree.mark.file)
        if problems:
            raise ContentError(problems)
        return file.model_copy(update={"mind": file.mind.model_copy(update={"diet": diet})})

    def _diet(self, tree: Mapping, file: SpeciesFile) -> tuple[tuple[str, ...], list[Problem]]:
        """Return the full names of what a species eats, each once, and which species there are not."""
        full: dict[str, None] = {}
        problems: list[Problem] = []
        for index in range(len(file.mind.diet)):
            try:
                full[self.resolve(SPECIES, node_at(tree, ("mind", "diet", index)))] = None
            except ContentError as error:
                problems += error.problems
        return tuple(full), problems

    def flora_file(self, name: str) -> FloraFile:
        """Return the flora `name` as its file and those it starts from say. Raise ContentError."""
        return validate(self.species_tree(name, FLORA), FloraFile)

    def level_tree(self, name: str) -> Mapping:
        """Return a level's tree with overrides merged, all `more_fishes` behind its fishes."""
        tree = self.levels[name].tree
        trees = [tree]
        for definition in self.overrides.get((LEVEL, name), ()):
            trees.append(without(definition.tree, "overrides"))
            tree = merged(tree, trees[-1])
        return _with_more_fishes(tree, trees)

    def level(self, name: str) -> Level:
        """Return the level `name`, its species and flora named in full. Raise ContentError."""
        tree = self.level_tree(name)
        file = validate(tree, LevelFile)
        problems: list[Problem] = []

        def full(*location: int | str, kind: str = SPECIES) -> str:
            try:
                return self.resolve(kind, node_at(tree, (*location, kind)))
            except ContentError as error:
                problems.extend(error.problems)
                return ""

        names = {
            "fishes": tuple(
                group.model_copy(update={"species": full("fishes", i)})
                for i, group in enumerate(file.fishes)
            ),
            "homes": tuple(
                home.model_copy(update={"species": full("homes", i)})
                for i, home in enumerate(file.homes)
            ),
            "plants": tuple(
                place.model_copy(update={"flora": full("plants", i, kind=FLORA)})
                for i, place in enumerate(file.plants)
            ),
            "flow": tuple(
                carried_by(one, full("flow", i, "attached"))
                if one.attached is not None and one.attached.species is not None
                else one
                for i, one in enumerate(file.flow)
            ),
        }
        wanted = {"species": full("objective", "photograph")}
        photograph = file.objective.photograph.model_copy(update=wanted)
        objective = file.objective.model_copy(update={"photograph": photograph})
        if problems:
            raise ContentError(problems)
        fields = {**dict(file), **names, "objective": objective, "name": name}
        return Level.model_validate(fields)

    def problems(self, kinds: Sequence[str] = KINDS) -> list[Problem]:
        """Return everything wrong with all definitions."""
        checks = {SPECIES: self.species_file, FLORA: self.flora_file, LEVEL: self.level}
        found: list[Problem] = []
        for kind in kinds:
            for name in self.of(kind):
                try:
                    checks[kind](name)
                except ContentError as error:
                    found += error.problems
        return found


def _with_more_fishes(tree: Mapping, parts: Sequence[Mapping]) -> Mapping:
    """Return a level's tree with the groups that any of its `parts` adds behind its own; no mod hides another's."""
    added = [part.items["more_fishes"] for part in parts if "more_fishes" in part.items]
    groups = [node for listing in added if isinstance(listing, Listing) for node in listing.items]
    own = tree.items.get("fishes")
    if len(added) != sum(isinstance(one, Listing) for one in added) or not groups:
        return tree
    if own is not None and not isinstance(own, Listing):
        return tree
    whole = Listing(tree.mark if own is None else own.mark, [*(own.items if own else ()), *groups])
    rest = without(tree, "more_fishes")
    keys = {"fishes": rest.keys.get("fishes", rest.mark)}
    return Mapping(rest.mark, {**rest.items, "fishes": whole}, {**rest.keys, **keys})
