"""What a level's `flow` can get wrong although every value is allowed: places out of the sea, carriers not there."""

from collections.abc import Iterable
from math import hypot

from reefgame.content.errors import Problem, quoted
from reefgame.content.nodes import Mapping, Mark
from reefgame.content.schema.flow import Carrier
from reefgame.content.schema.level import Level
from reefgame.content.schema.strict import Place
from reefgame.content.schema.validate import node_at


def flow_problems(level: Level, tree: Mapping) -> Iterable[Problem]:
    """Yield what is wrong with the flow; `tree` has the marks."""
    for index, flow in enumerate(level.flow):
        place = ("flow", index)
        if flow.at_m is not None:
            yield from _placed(level, flow.at_m, _mark(tree, *place, "at_m"))
        for number, frame in enumerate(flow.track.frames if flow.track is not None else ()):
            if frame.at_m is not None:
                mark = _mark(tree, *place, "track", "frames", number, "at_m")
                yield from _placed(level, frame.at_m, mark)
        if flow.attached is not None:
            yield from _carried(level, flow.attached, tree, index)


def _mark(tree: Mapping, *location: int | str) -> Mark:
    return node_at(tree, location).mark


def _placed(level: Level, at: Place, mark: Mark) -> Iterable[Problem]:
    """Yield why nothing stirs the water there: it may lie in the ground, as a vent does, no farther."""
    out, most = hypot(at[0], at[1]), level.world.radius_m
    if out > most:
        text = f"this lies outside of the world: {out:.1f} m from the middle, at most {most:g} m"
        yield mark.problem(text)
    elif not -level.world.depth_m <= at[2] <= 0.0:
        lowest = -level.world.depth_m
        yield mark.problem(
            f"this lies out of the water: z is {at[2]:g}, must be from {lowest:g} to 0"
        )


def _carried(level: Level, carrier: Carrier, tree: Mapping, index: int) -> Iterable[Problem]:
    if carrier.rock is not None and carrier.rock >= len(level.rocks):
        count = len(level.rocks)
        there = f"the last is {count - 1}" if count else "there is none at all"
        mark = _mark(tree, "flow", index, "attached", "rock")
        yield mark.problem(f"there is no rock {carrier.rock}: {there}, counted from 0")
    if carrier.species is not None and carrier.species not in [g.species for g in level.fishes]:
        mark = _mark(tree, "flow", index, "attached", "species")
        yield mark.problem(f"no group of `fishes` is of the species {quoted(carrier.species)}")
