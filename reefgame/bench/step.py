"""bench step: how much faster than real time the whole simulation of first_dive runs, headless."""

from collections.abc import Iterator
from time import perf_counter

import numpy as np

from components.clock import TICK_SECONDS, TICKS_PER_SECOND
from reefgame.autopilot import tour
from reefgame.bench.case import Case
from reefgame.content import load
from reefgame.world import World

_SIZES = {60: 50.0, 10_000: 6.0}
_WARM_SECONDS = 4
_ROUNDS = 7


def crowded(fishes: int, seed: int = 1) -> World:
    """Return first_dive with `fishes` fishes, the added ones in its own proportion of species."""
    world = World.build(load("first_dive"), seed)
    for identity in sorted(world.population.fish.live("id").tolist())[fishes:]:
        world.spawn.remove(identity)
    missing = fishes - world.population.count
    shares = np.bincount(world.population.fish.live("species"), minlength=len(world.species))
    reach, deep = 0.8 * world.terrain.radius, 0.5 * world.terrain.depth
    clumps = max(1, missing // 100)
    for clump in range(clumps):
        angle = 2.399963 * clump
        out = reach * np.sqrt((clump + 0.5) / clumps)
        around = np.array([out * np.cos(angle), out * np.sin(angle), -deep])
        number = missing * (clump + 1) // clumps - missing * clump // clumps
        share = np.round(np.cumsum(shares) / shares.sum() * number).astype(int)
        for species, count in enumerate(np.diff(share, prepend=0)):
            world.spawn.add(species, int(count), around, 0.3 * deep + 2.0, cohort=-1 - clump)
    return world


def measure() -> Iterator[Case]:
    """Yield simulated : real time for each number of fishes: the median of seven seconds of play."""
    for fishes, least in _SIZES.items():
        world = crowded(fishes)
        for _ in range(_WARM_SECONDS * TICKS_PER_SECOND):
            world.tick(tour(world))
        times = []
        for _ in range(_ROUNDS):
            start = perf_counter()
            for _ in range(TICKS_PER_SECOND):
                world.tick()
            times.append((perf_counter() - start) / TICKS_PER_SECOND)
        tick = float(np.median(times))
        yield Case(
            f"fishes={fishes}",
            tick * 1e3,
            "ms a tick",
            TICK_SECONDS * 1e3,
            TICK_SECONDS / tick,
            f"ratio >= {least:g}",
        )
