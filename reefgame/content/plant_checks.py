"""What a level's plants can get wrong although every value is allowed: no room, dry land, too many of them."""

from collections.abc import Iterable, Mapping
from math import hypot
from typing import Final

from components.flora import Flora
from components.ground import Terrain
from reefgame.content import nodes
from reefgame.content.errors import Problem, quoted
from reefgame.content.level_checks import terrain_of
from reefgame.content.planting import SHALLOWEST, planting, surface
from reefgame.content.schema.level import Level
from reefgame.content.schema.validate import node_at
from tools.grow.plants import nodes as nodes_of

MOST_PLANTS: Final = 3000
MOST_NODES: Final = 250_000
"""Of all fibres of a level."""


def plant_problems(level: Level, tree: nodes.Mapping, floras: Mapping[str, Flora]) -> list[Problem]:
    """Return what is wrong with a level's plants beyond their values; `tree` has the marks."""
    if not level.plants:
        return []
    many = [*_numbers(level, tree, floras)]
    if many:
        return many
    terrain = terrain_of(level)
    return [*_places(level, tree, terrain)] or [*_room(level, tree, floras, terrain)]


def _numbers(level: Level, tree: nodes.Mapping, floras: Mapping[str, Flora]) -> Iterable[Problem]:
    mark = node_at(tree, ("plants",)).mark
    plants = sum(place.count for place in level.plants)
    if plants > MOST_PLANTS:
        yield mark.problem(f"there are too many plants: {plants}, at most {MOST_PLANTS}")
    each = {name: nodes_of(flora) for name, flora in floras.items()}
    total = sum(place.count * each[place.flora] for place in level.plants)
    if total > MOST_NODES:
        worst = max(level.plants, key=lambda place: place.count * each[place.flora])
        yield mark.problem(
            f"the plants have too many nodes: {total}, at most {MOST_NODES}; "
            f"{worst.count} of {quoted(worst.flora)} alone have {worst.count * each[worst.flora]}"
        )


def _places(level: Level, tree: nodes.Mapping, terrain: Terrain) -> Iterable[Problem]:
    for index, place in enumerate(level.plants):
        at = place.at_m or place.around_m or (0.0, 0.0)
        key = "at_m" if place.at_m else "around_m"
        mark = node_at(tree, ("plants", index, key)).mark
        out = hypot(*at)
        if out > terrain.radius:
            yield mark.problem(
                f"this lies outside of the world: {out:.1f} m from the middle, "
                f"at most {terrain.radius:g} m"
            )
        elif place.at_m and surface(terrain, *at).point[2] > SHALLOWEST:
            yield mark.problem("this rock rises out of the water: no plant can stand on it")


def _room(
    level: Level, tree: nodes.Mapping, floras: Mapping[str, Flora], terrain: Terrain
) -> Iterable[Problem]:
    planted = planting(level, floras, terrain)
    for index, other in planted.crowded:
        line = node_at(tree, ("plants", other)).mark.line
        yield node_at(tree, ("plants", index, "at_m")).mark.problem(
            f"this stands in plants[{other}] in line {line}: set them further apart"
        )
    for index, (place, found) in enumerate(zip(level.plants, planted.found, strict=True)):
        if found < place.count:
            on = place.stands or floras[place.flora].stands
            where = "" if on == "any" else f" on {on}"
            yield node_at(tree, ("plants", index)).mark.problem(
                f"only {found} of {place.count} find room{where} here: "
                "a larger within_m, fewer or smaller ones"
            )
