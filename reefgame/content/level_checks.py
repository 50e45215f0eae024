"""What a level's file can get wrong although every value is allowed: places in rock, goals that cannot be met."""

from collections.abc import Iterable, Sequence
from math import hypot
from typing import Final

from components.ground import Terrain, ground_height, rock_distance
from components.landscape import build_terrain, rock_on_ground
from components.submarine import HULL_RADIUS
from reefgame.content.errors import Problem, quoted
from reefgame.content.flow_checks import flow_problems
from reefgame.content.nodes import Mapping, Mark
from reefgame.content.schema.level import Group, Level
from reefgame.content.schema.validate import node_at

MOST_FISHES: Final = 200_000
MOST_PARTICLES: Final = 50_000
_SHALLOWEST: Final = 3.0
"""[m] that the dunes must leave between the deepest ground and the surface."""


def terrain_of(level: Level) -> Terrain:
    """Return the level's ground and rocks, without home points."""
    world, seabed = level.world, level.seabed
    ground = build_terrain(
        world.radius_m, world.depth_m, seabed.relief_m, seabed.feature_m, seabed.seed
    )
    return ground.with_rocks(
        [rock_on_ground(ground, r.at_m, r.radii_m, r.yaw_deg, r.buried) for r in level.rocks]
    )


def level_problems(level: Level, tree: Mapping) -> list[Problem]:
    """Return what is wrong with a level beyond its values; `tree` has the marks."""
    seabed = [*_seabed(level, tree)]
    # Above a wrong seabed every place would be wrong too.
    places = [] if seabed else [*_places(level, tree)]
    return [*seabed, *places, *_numbers(level, tree), *flow_problems(level, tree)]


def _mark(tree: Mapping, *location: int | str) -> Mark:
    return node_at(tree, location).mark


def _seabed(level: Level, tree: Mapping) -> Iterable[Problem]:
    most = level.world.depth_m - _SHALLOWEST
    if level.seabed.relief_m > most:
        message = (
            f"the seabed rises too high: at most {most:g} m in water {level.world.depth_m:g} m deep"
        )
        yield _mark(tree, "seabed", "relief_m").problem(message)


def _places(level: Level, tree: Mapping) -> Iterable[Problem]:
    terrain = terrain_of(level)
    for index, rock in enumerate(level.rocks):
        out, most = hypot(*rock.at_m), terrain.extent
        if out > most:
            message = f"the rock lies {out:.1f} m from the middle: at most {most:g} m is allowed"
            yield _mark(tree, "rocks", index, "at_m").problem(message)
    for index, home in enumerate(level.homes):
        message_or_none = _outside(terrain, home.at_m, 0.0)
        if message_or_none:
            yield _mark(tree, "homes", index, "at_m").problem(message_or_none)
    places = [(("submarine", "at_m"), level.submarine.at_m, HULL_RADIUS)]
    places += [(("fishes", i, "around_m"), g.around_m, 0.0) for i, g in enumerate(level.fishes)]  # type: ignore[misc]
    places += [(("food", i, "around_m"), f.around_m, 0.0) for i, f in enumerate(level.food)]  # type: ignore[misc]
    for location, at, margin in places:
        message_or_none = _fault(terrain, tree, at, margin)
        if message_or_none:
            yield _mark(tree, *location).problem(message_or_none)


def _outside(terrain: Terrain, at: Sequence[float], margin: float) -> str | None:
    out, most = hypot(at[0], at[1]), terrain.radius - margin
    if out > most:
        return f"this lies outside of the world: {out:.1f} m from the middle, at most {most:g} m"
    return None


def _fault(
    terrain: Terrain, tree: Mapping, at: tuple[float, float, float], margin: float
) -> str | None:
    """Return why nothing of radius `margin` [m] can be at a place, or None."""
    x, y, z = at
    outside = _outside(terrain, at, margin)
    if outside:
        return outside
    if z > -margin:
        return f"this lies out of the water: z is {z:g}, must be below {0.0 - margin:g}"
    ground = ground_height(terrain.height, terrain.extent, terrain.cell, x, y)
    if z < ground + margin:
        return f"this lies in the ground: z is {z:g}, must be above {ground + margin:.2f} here"
    for rock in range(len(terrain.rock_centre)):
        if rock_distance(terrain, rock, x, y, z) < margin:
            place = node_at(tree, ("rocks", rock)).mark
            return f"this lies inside rock: rocks[{rock}] in line {place.line}"
    return None


def _numbers(level: Level, tree: Mapping) -> Iterable[Problem]:
    goal = level.objective.photograph
    there = most_at_once([g for g in level.fishes if g.species == goal.species])
    if there < goal.count:
        message = (
            f"this level cannot be won: {goal.count} of {quoted(goal.species)} are wanted, "
            f"at most {there} are there at once"
        )
        yield _mark(tree, "objective", "photograph", "count").problem(message)
    most = most_at_once(level.fishes)
    if most > MOST_FISHES:
        message = f"there are too many fishes: {most} at once, at most {MOST_FISHES}"
        yield _mark(tree, "fishes").problem(message)
    particles = sum(patch.particles for patch in level.food)
    if particles > MOST_PARTICLES:
        message = f"there is too much food: {particles} particles, at most {MOST_PARTICLES}"
        yield _mark(tree, "food").problem(message)


def most_at_once(groups: Sequence[Group]) -> int:
    """Return the largest number of fishes of these groups that are there at the same time."""
    counts = [
        sum(
            other.count
            for other in groups
            if other.arrives_s <= group.arrives_s
            and (other.leaves_s is None or other.leaves_s > group.arrives_s)
        )
        for group in groups
    ]
    return max(counts, default=0)
