"""bench minds: the whole mind at scale, over real time, over bare schooling and over scipy's k-d tree (FINDINGS 5).

The scene: nine species, 70 % of the fishes schooling prey at the density of real schools, so that about twelve are
within a mind's radius, 1 % predators, rocks as many a square metre as in the level that it is made from.
"""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from math import cos, sin, sqrt
from statistics import median
from time import perf_counter
from typing import Final

import numba
import numpy as np

from components.arrays import Float64s
from components.clock import TICK_SECONDS, TICKS_PER_SECOND, Clock
from components.mind import Role
from components.senses import SenseTable
from reefgame.bench.case import Case, in_turn, seconds_in_turn, times_faster
from reefgame.bench.memory import peak_of
from reefgame.content import load
from reefgame.content.schema.level import Bounds, RockPlace
from reefgame.schedule import System
from reefgame.world import World
from systems.mind.bare import BareSchooling
from systems.mind.grid import REACH, Plan
from systems.mind.think import Think
from tools.peers.ckdtree_schooling import schooling_step

CLUMP: Final = 100
"""Fishes of one species that appear together."""

DENSITY: Final = 0.35
"""Schooling fishes in a cube of a body length when they appear; they settle at their own spacing."""

GOLDEN: Final = 2.399963
"""[rad] a turn that spreads clumps and rocks evenly."""

_SHARES: Final = {Role.PREY: 0.7, Role.PREDATOR: 0.01}
_BOUNDS: Final = {10_000: 8.0, 50_000: 1.5, 100_000: 0.8}
_WARM_SECONDS: Final = 3
_LATER_SECONDS: Final = 120
_TREE_ROUNDS: Final = 5
_TURN_SECONDS: Final = 0.05
_LIVED: Final = """
from reefgame.bench.minds import reef
world = reef(FISHES)
for _ in range(130):
    world.tick()
"""


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
        world.spawn.add(species, number, around, max(within, 0.5), cohort=-1 - place)
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
    yield from _against_tree()
    yield from _parts()
    for fishes, least in _BOUNDS.items():
        yield _full(f"part=full fishes={fishes}", _lived(fishes), f"ratio >= {least:g}")
    later = _lived(10_000, _LATER_SECONDS)
    yield _full(f"part=full fishes=10000 after={_LATER_SECONDS}s", later)
    yield _memory()


def _lived(fishes: int, seconds: int = _WARM_SECONDS) -> World:
    """Return the scene when schools have settled; two minutes later all have met the hunters."""
    world = reef(fishes)
    for _ in range(seconds * TICKS_PER_SECOND):
        world.tick()
    return world


def _full(case: str, world: World, bound: str = "") -> Case:
    (second,) = in_turn((partial(_second, world.systems, world.clock),))
    return _over_real(case, second / TICKS_PER_SECOND, bound)


def _second(systems: tuple[System, ...], clock: Clock) -> None:
    """Let a second of play pass."""
    for _ in range(TICKS_PER_SECOND):
        for system in systems:
            system()
        clock.tick[0] += 1


def _over_real(case: str, tick: float, bound: str = "") -> Case:
    return Case(case, tick * 1e3, "ms a tick", TICK_SECONDS * 1e3, TICK_SECONDS / tick, bound)


def _everyone(world: World) -> SenseTable:
    """Return senses with which every species schools."""
    return world.senses._replace(schooling=np.ones_like(world.senses.schooling))


def _against_tree() -> Iterator[Case]:
    """Yield bare schooling, every fish each tick on one thread, against scipy's k-d tree."""
    threads = numba.get_num_threads()
    numba.set_num_threads(1)
    for fishes in (1000, 10_000, 100_000):
        yield from _schooling(_lived(fishes))
    numba.set_num_threads(threads)


def _schooling(world: World) -> Iterator[Case]:
    fishes, fish = world.population.count, world.population.fish
    bare = BareSchooling(world.population, _everyone(world), world.terrain, world.clock, every=1)

    def step() -> None:
        bare()
        # The rows are put in order once a second, not in every step.
        world.clock.tick[0] += 1

    step()
    place = fish.position[:fishes].copy()
    course = fish.rotation[:fishes, :, 0].copy()
    kind = fish.species[:fishes].copy()
    spacing = world.senses.spacing[kind] * fish.length[:fishes]
    radius = REACH * world.senses.length

    def tree() -> None:
        schooling_step(place, course, kind, radius, spacing, np.ones(len(radius), np.bool_))

    ours, theirs = seconds_in_turn((step, tree), _TREE_ROUNDS, _TURN_SECONDS)
    mine = median(ours)
    case, share = f"fishes={fishes} threads=1", 1e9 / fishes
    yield Case(
        f"part=schooling against=ckdtree {case}",
        *(mine * share, "ns a mind", median(theirs) * share, times_faster(ours, theirs)),
        bound="ratio >= 8",
    )
    pairs = tested_pairs(bare.grid.plan, place)
    yield Case(f"part=pairs {case}", mine * 1e9 / pairs, "ns a tested pair")


def tested_pairs(plan: Plan, position: Float64s) -> int:
    """Return how many distances a look around every fish's cell tests: who is in the 27 cells around it."""
    corner = np.array((plan.extent, plan.extent, 0.0))
    cells = np.floor((position + corner) / np.array((plan.cell, plan.cell, -plan.cell)))
    most = (plan.columns - 1, plan.columns - 1, plan.layers - 1)
    cells = np.clip(cells.astype(np.int64), 0, most)
    flat = (cells[:, 0] * plan.columns + cells[:, 1]) * plan.layers + cells[:, 2]
    known, many = np.unique(flat, return_counts=True)
    total = 0
    for dx, dy, dz in np.ndindex(3, 3, 3):
        other = cells + np.array((dx - 1, dy - 1, dz - 1))
        inside = ((other >= 0) & (other <= most)).all(axis=1)
        key = (other[:, 0] * plan.columns + other[:, 1]) * plan.layers + other[:, 2]
        at = np.minimum(np.searchsorted(known, key), len(known) - 1)
        total += int(many[at][inside & (known[at] == key)].sum())
    return total


def _parts() -> Iterator[Case]:
    """Yield whole minds against bare schooling, both with motion, one thread against two, and where the time goes."""
    threads = numba.get_num_threads()
    full, bare = _lived(10_000), _lived(10_000)
    schooling = BareSchooling(
        bare.population,
        _everyone(bare),
        bare.terrain,
        bare.clock,
        visibility=bare.habitat.visibility,
    )
    simple = tuple(schooling if isinstance(s, Think) else s for s in bare.systems)

    def whole(threads: int) -> None:
        numba.set_num_threads(threads)
        _second(full.systems, full.clock)

    def plain() -> None:
        numba.set_num_threads(1)
        _second(simple, bare.clock)

    one, school, both = seconds_in_turn((lambda: whole(1), plain, lambda: whole(threads)))
    tick = median(one) * 1e3 / TICKS_PER_SECOND
    scene = "fishes=10000"
    yield Case(
        f"part=full against=schooling {scene} threads=1",
        *(tick, "ms a tick", median(school) * 1e3 / TICKS_PER_SECOND),
        ratio=times_faster(school, one),
        bound="ratio <= 1.8",
    )
    yield Case(
        f"part=full {scene} threads={threads} against=1 thread",
        *(median(both) * 1e3 / TICKS_PER_SECOND, "ms a tick", tick, times_faster(both, one)),
        bound="ratio >= 1.6",
    )
    numba.set_num_threads(1)
    for system, seconds in _each(full).items():
        yield Case(f"part={system} {scene} threads=1", seconds * 1e9 / 10_000, "ns a fish and tick")
    numba.set_num_threads(threads)


def _each(world: World) -> dict[str, float]:
    """Return the mean seconds that each system takes of a tick, over a second of play."""
    taken: dict[str, float] = {}
    for _ in range(TICKS_PER_SECOND):
        for system in world.systems:
            start = perf_counter()
            system()
            name = type(system).__name__.lower()
            taken[name] = taken.get(name, 0.0) + perf_counter() - start
        world.clock.tick[0] += 1
    return {name: seconds / TICKS_PER_SECOND for name, seconds in taken.items()}


def _memory() -> Case:
    """Return what 100,000 fishes take over an empty world, whole processes measured."""
    # The first may have kernels to compile, which takes more than all its fishes.
    empty, full = (
        min(peak_of(_LIVED.replace("FISHES", str(fishes))) for _ in range(2))
        for fishes in (9, 100_000)
    )
    a_fish = (full - empty) * 2**20 / 100_000
    return Case("memory fishes=100000", a_fish, "B a fish", bound="<= 1500")
