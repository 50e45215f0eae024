"""A long dive among hunters: numbers stay numbers, memory stays, and every run is the same to the bit."""

import tracemalloc
from typing import TYPE_CHECKING

import numpy as np
import pytest

from components.terrain import clearance
from reefgame.content import load
from reefgame.soak import soak
from reefgame.world import World

if TYPE_CHECKING:
    from tests.play.conftest import Sea

HOUR = 216_000
HUNTERS_ALONE = (
    "{species: barracuda, count: 3, around_m: [0, 0, -5], within_m: 3}, "
    "{species: sardine, count: 1, around_m: [9, 9, -5], within_m: 1, leaves_s: 0.1}"
)
RING = """like: reef_shark
title: Shark
size_cm: {size}
mind: {{diet: [{diet}], digests_min: 0.1}}
"""


def room(world: World) -> int:
    """Return the bytes of all tables and of the index, which it builds anew."""
    world.population.reindex()
    columns = [getattr(table, name) for table in world.tables.values() for name in table.columns]
    places = world.population.index.places
    return int(sum(column.nbytes for column in [*columns, *places]))


def assert_sane(world: World) -> None:
    """Say that all state is finite and that everybody swims in free water."""
    for table in world.tables.values():
        for name in table.columns:
            assert np.isfinite(table.live(name).astype(np.float64)).all(), name
    for place in world.population.fish.live("position"):
        assert clearance(world.terrain, *map(float, place))[0] > 0.0
    mind = world.population.mind
    for name in ("hunger", "libido", "fear", "gape"):
        assert mind.live(name).min(initial=0.0) >= 0.0
        assert mind.live(name).max(initial=0.0) <= 1.0
    assert mind.live("eaten").min(initial=0.0) >= 0.0
    assert len(world.entities) == world.population.count


@pytest.mark.parametrize("ticks", [900, pytest.param(HOUR, marks=pytest.mark.prove)])
def test_a_reef_with_hunters_lives_on_the_same_way_every_time(ticks: int) -> None:
    worlds = [World.build(load("nine_species"), 5) for _ in range(2)]
    start, sums = worlds[0].population.count, []
    for world in worlds:
        soak(world, ticks // 3)
        before = room(world)
        tracemalloc.start()
        soak(world, ticks - ticks // 3)
        grown = tracemalloc.get_traced_memory()[0]
        tracemalloc.stop()
        assert_sane(world)
        assert room(world) <= 1.1 * before
        assert grown < 2_000_000
        sums.append(world.checksums())
    assert sums[0] == sums[1]
    world = worlds[0]
    eaten = int(world.roster.next_id[0]) - world.population.count
    assert eaten + world.restocks.count > 0 or ticks < HOUR
    assert start - world.restocks.count == world.population.count


def test_hunters_that_eat_each_other_in_a_circle_leave_a_sane_sea(
    sea: "Sea", tmp_path_factory: pytest.TempPathFactory
) -> None:
    mod = tmp_path_factory.mktemp("ring")
    (mod / "mod.yaml").write_text('id: ring\ntitle: Ring\nversion: "1.0"\n', encoding="utf-8")
    (mod / "species").mkdir()
    for name, size, diet in (
        ("one", 200, "two, one"),
        ("two", 60, "three, two"),
        ("three", 150, "one"),
    ):
        text = RING.format(size=size, diet=diet)
        (mod / "species" / f"{name}.yaml").write_text(text, encoding="utf-8")
    fishes = ", ".join(
        f"{{species: 'ring:{name}', count: 4, around_m: [0, 0, -5], within_m: 3, restock_s: 1}}"
        for name in ("one", "two", "three")
    )
    world = sea(
        fishes=f"{fishes}, {{species: sardine, count: 1, around_m: [5, 5, -5], within_m: 1}}",
        mods=[mod],
    )
    soak(world, 1200)
    assert_sane(world)
    assert world.population.count + world.restocks.count == 13


@pytest.mark.parametrize(
    "fishes",
    [
        HUNTERS_ALONE,
        "{species: sardine, count: 1000, around_m: [0, 0, -5], within_m: 0.2}",
    ],
    ids=["nobody to eat", "a thousand in one cell"],
)
def test_a_strange_sea_is_sane(sea: "Sea", fishes: str) -> None:
    world = sea(fishes=fishes)
    soak(world, 120)
    assert_sane(world)
    assert world.population.count in (3, 1000)
