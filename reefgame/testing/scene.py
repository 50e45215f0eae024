"""`read_scene`: a scene's file with the species that it needs, all checked before anything swims."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from components.species import Species
from reefgame.content.anatomy import species_of
from reefgame.content.assembly import catalogue
from reefgame.content.catalogue import FLORA, SPECIES, Catalogue
from reefgame.content.errors import ContentError, Problem, did_you_mean, listed, quoted
from reefgame.content.level_checks import level_problems
from reefgame.content.loading import Content, floras_in, repertoires
from reefgame.content.nodes import Mapping, merged, without
from reefgame.content.plant_checks import plant_problems
from reefgame.content.schema.flow import carried_by
from reefgame.content.schema.level import Group, Level, Objective, PhotographGoal, Start
from reefgame.content.schema.species import SpeciesFile
from reefgame.content.schema.validate import node_at, validate
from reefgame.content.yaml_marks import read, shown
from reefgame.testing.fibre_measures import FIBRE_MEASURES
from reefgame.testing.measures import MEASURES
from reefgame.testing.scene_file import SceneFile


@dataclass(frozen=True)
class Scene:
    """A scene, checked, with all that it needs to be played."""

    name: str
    "the file's, without .yaml"
    file: SceneFile
    contents: tuple[Content, ...]
    "one for each value that the scene varies, else one"
    control: "Scene | None"
    "the same without what causes the behaviour, where the file says how"

    @property
    def groups(self) -> tuple[str, ...]:
        """What expectations call the groups of fishes, in the order of the file."""
        return names_of(self.file)


def names_of(file: SceneFile) -> tuple[str, ...]:
    """Return the names of the groups of fishes, in the order of the file."""
    return tuple(group.name or group.species.rpartition(":")[2] for group in file.fishes)


def read_scene(path: Path, mods: Sequence[Path] = ()) -> Scene:
    """Return the scene of a YAML file. Raise ContentError with every problem found."""
    tree = read(path)
    known, _ = catalogue(mods)
    plain = without(tree, "control")
    control = tree.items.get("control")
    other = merged(plain, control) if isinstance(control, Mapping) else None
    validate(tree, SceneFile)
    return _scene(path, plain, known, None if other is None else _scene(path, other, known, None))


def _scene(path: Path, tree: Mapping, known: Catalogue, control: Scene | None) -> Scene:
    file = validate(tree, SceneFile)
    problems = [*_unknown_names(file, tree)]
    full: dict[str, str] = {}
    for name, location in _species_in(file):
        try:
            full[name] = known.find(SPECIES, name, node_at(tree, location).mark)
        except ContentError as error:
            problems += error.problems
    grown: dict[str, str] = {}
    for index, place in enumerate(file.plants):
        try:
            mark = node_at(tree, ("plants", index, "flora")).mark
            grown[place.flora] = known.find(FLORA, place.flora, mark)
        except ContentError as error:
            problems += error.problems
    if problems:
        raise ContentError(problems)
    level = _level(file, full, grown, shown(path))
    floras = floras_in(known, level)
    problems += [*level_problems(level, tree), *plant_problems(level, tree, floras)]
    if problems:
        raise ContentError(problems)
    files = {full[name]: _species_file(tree, name, full[name], known) for name in full}
    contents = tuple(
        replace(content, floras=floras) for content in _contents(file, full, level, files, known)
    )
    return Scene(path.stem, file, contents, control)


def _species_file(tree: Mapping, name: str, full: str, known: Catalogue) -> SpeciesFile:
    """Return a species as its own file says, with what the scene says instead."""
    changes = tree.items.get("species")
    change = changes.items.get(name) if isinstance(changes, Mapping) else None
    if not isinstance(change, Mapping):
        return known.species_file(full)
    changed = validate(merged(known.species_tree(full), change), SpeciesFile)
    return changed.model_copy(
        update={
            "mind": changed.mind.model_copy(update={"diet": known.species_file(full).mind.diet})
        }
    )


def _species_in(file: SceneFile) -> Iterable[tuple[str, tuple[int | str, ...]]]:
    for index, group in enumerate(file.fishes):
        yield group.species, ("fishes", index, "species")
    for index, home in enumerate(file.homes):
        yield home.species, ("homes", index, "species")
    for index, flow in enumerate(file.flow):
        if flow.attached is not None and flow.attached.species is not None:
            yield flow.attached.species, ("flow", index, "attached", "species")
    for name in file.species:
        yield name, ("species", name)
    if file.vary is not None:
        yield file.vary.species, ("vary", "species")


def _unknown_names(file: SceneFile, tree: Mapping) -> Iterable[Problem]:
    """Yield what is named and is not there: groups and measures; and groups of one name."""
    groups = names_of(file)
    for index, name in enumerate(groups):
        if name in groups[:index]:
            mark = node_at(tree, ("fishes", index)).mark
            yield mark.problem(f"two groups are called {quoted(name)}: give one a `name`")
        led_at = file.fishes[index].led_at
        if led_at is not None and led_at not in groups:
            yield _no_such("group", led_at, groups, tree, "fishes", index, "led_at")
    for index, one in enumerate(file.expect):
        for key, value in (("of", one.of), ("to", one.to)):
            if value is not None and value not in groups:
                yield _no_such("group", value, groups, tree, "expect", index, key)
        if one.measure not in MEASURES:
            yield _no_such("measure", one.measure, MEASURES, tree, "expect", index, "measure")
    grown = list(dict.fromkeys(plant.flora for plant in file.plants))
    for index, fibre in enumerate(file.fibres):
        at = ("fibres", index)
        if fibre.of not in grown:
            yield _no_such("flora among the plants", fibre.of, grown, tree, *at, "of")
        if fibre.to is not None and fibre.to not in groups:
            yield _no_such("group", fibre.to, groups, tree, *at, "to")
        if fibre.measure not in FIBRE_MEASURES:
            yield _no_such("measure", fibre.measure, FIBRE_MEASURES, tree, *at, "measure")


def _no_such(
    kind: str, name: str, known: Iterable[str], tree: Mapping, *location: int | str
) -> Problem:
    names = list(known)
    near = did_you_mean(name, names) or f"; there are {listed(names)}"
    return node_at(tree, location).mark.problem(f"there is no {kind} {quoted(name)}{near}")


def _level(file: SceneFile, full: dict[str, str], grown: dict[str, str], where: str) -> Level:
    """Return the level that the scene is set in; its goal and its submarine may be nobody's."""
    groups = [
        Group(
            species=full[group.species],
            count=group.count,
            around_m=group.around_m,
            within_m=group.within_m,
            arrives_s=group.arrives_s,
            restock_s=None,
        )
        for group in file.fishes
    ]
    goal = PhotographGoal(species=groups[0].species, count=1, within_m=1.0)
    return Level(
        name=where,
        title=file.title,
        world=file.world,
        seabed=file.seabed,
        water=file.water,
        day=file.day,
        rocks=file.rocks,
        plants=tuple(p.model_copy(update={"flora": grown[p.flora]}) for p in file.plants),
        flow=tuple(
            carried_by(one, full[one.attached.species])
            if one.attached is not None and one.attached.species is not None
            else one
            for one in file.flow
        ),
        homes=tuple(h.model_copy(update={"species": full[h.species]}) for h in file.homes),
        submarine=file.submarine or Start(at_m=(0.0, 0.0, -0.5 * file.world.depth_m)),
        fishes=tuple(groups),
        food=file.food,
        objective=Objective(photograph=goal),
    )


def _contents(
    file: SceneFile,
    full: dict[str, str],
    level: Level,
    files: dict[str, SpeciesFile],
    known: Catalogue,
) -> Iterable[Content]:
    motion = repertoires(known, files, None)
    for value in (None,) if file.vary is None else file.vary.values:
        species: list[Species] = []
        for name, one in sorted(files.items()):
            varied = file.vary is not None and full[file.vary.species] == name
            changed = _with_mind(one, file, value) if varied else one
            species.append(species_of(name, changed, motion[name]))
        yield Content(level, tuple(species), "", ())


def _with_mind(species: SpeciesFile, file: SceneFile, value: float | None) -> SpeciesFile:
    assert file.vary is not None
    mind = species.mind.model_copy(update={file.vary.mind: value})
    return species.model_copy(update={"mind": mind})
