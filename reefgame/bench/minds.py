"""bench minds: the whole mind at scale, over real time, over bare schooling and over scipy's k-d tree (FINDINGS 5).

The scene: nine species, 70 % of the fishes schooling prey at the density of real schools, so that about twelve are
within a mind's radius, 1 % predators, rocks as many a square metre as in the level that it is made from.
"""

from collections.abc import Iterator
from dataclasses import replace
from math import cos, sin, sqrt
from time import perf_counter
from typing import Final

import numpy as np

from components.clock import TICK_SECONDS, TICKS_PER_SECOND
from components.mind import Role
from reefgame.bench.case import Case
from reefgame.content import load
from reefgame.content.schema.level import Bounds, RockPlace
from reefgame.world import World

CLUMP: Final = 100
"""Fishes of one species that appear together."""

DENSITY: Final = 0.35
"""Schooling fishes in a cube of a body length when they appear; they settle at their own spacing."""

GOLDEN: Final = 2.399963
"""[rad] a turn that spreads clumps and rocks evenly."""

_SHARES: Final = {Role.PREY: 0.7, Role.PREDATOR: 0.01}
_BOUNDS: Final = {10_000: 8.0, 50_000: 1.5, 100_000: 0.8}
_WARM_TICKS: Final = 3 * TICKS_PER_SECOND
_ROUNDS: Final = 5


def reef(fishes: int, seed: int = 1) -> World:
    """Return a world of `fishes` fishes of nine species, as wide as they need."""
    content = load("nine_species")
    radius = max(35.0, 0.32 * sqrt(fishes))
    level = content.level.model_copy(
        update={
            "world": Bounds(radius_m=radius, depth_m=14.0),
            "rocks": tuple(_rocks(content.level.rocks, radius)),
            "fishes": (),
        }
    )
    world = World.build(replace(content, level=level), seed)
    shares = _shares(world)
    clumps = _clumps(np.round(shares * fishes).astype(int))
    for place, (species, number) in enumerate(clumps):
        out = 0.85 * radius * sqrt((place + 0.5) / len(clumps))
        angle, deep = GOLDEN * place, 4.0 + 6.0 * (place * 0.618034 % 1.0)
        around = np.array([out * cos(angle), out * sin(angle), -deep])
        length = world.species[species].length
        within = length * (number / (DENSITY * 4.18879)) ** (1 / 3)
        world.spawn.add(species, number, around, max(within, 0.5))
    return world


def _rocks(rocks: tuple[RockPlace, ...], radius: float) -> Iterator[RockPlace]:
    """Yield the rocks of a level of radius 35 m strewn over a wider one, as many a square metre."""
    number = min(400, round(len(rocks) * (radius / 35.0) ** 2))
    for k in range(number):
        out = 0.9 * radius * sqrt((k + 0.5) / number)
        at = (out * cos(GOLDEN * k + 1.0), out * sin(GOLDEN * k + 1.0))
        yield rocks[k % len(rocks)].model_copy(update={"at_m": at})


def _shares(world: World) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return the share of each species: schooling prey, predators, and what is left for the others."""
    groups = [
        Role.PREY if kind.schooling else Role.PREDATOR if kind.role is Role.PREDATOR else None
        for kind in world.species
    ]
    rest = 1.0 - sum(_SHARES.values())
    share = [rest if group is None else _SHARES[group] for group in groups]
    return np.array([part / groups.count(group) for part, group in zip(share, groups, strict=True)])


def _clumps(numbers: np.ndarray[tuple[int], np.dtype[np.int64]]) -> list[tuple[int, int]]:
    """Return (species, number) of clumps, the species interleaved."""
    clumps = []
    for species, number in enumerate(numbers.tolist()):
        while number > 0:
            clumps.append((species, min(number, CLUMP)))
            number -= CLUMP
    return sorted(clumps, key=lambda clump: (clump[0] * 7 + len(clumps)) % 9)


def measure() -> Iterator[Case]:
    """Yield the bench's cases."""
    for fishes, least in _BOUNDS.items():
        world = reef(fishes)
        for _ in range(_WARM_TICKS):
            world.tick()
        tick = _tick_seconds(world)
        yield Case(
            f"part=full fishes={fishes}",
            tick * 1e3,
            "ms a tick",
            TICK_SECONDS * 1e3,
            TICK_SECONDS / tick,
            f"ratio >= {least:g}",
        )


def _tick_seconds(world: World) -> float:
    """Return the median over seconds of play of the mean seconds of a tick."""
    times = []
    for _ in range(_ROUNDS):
        start = perf_counter()
        for _ in range(TICKS_PER_SECOND):
            world.tick()
        times.append((perf_counter() - start) / TICKS_PER_SECOND)
    return float(np.median(times))
