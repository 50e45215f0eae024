"""Spawn: fishes come and go at any tick, ids are never used again, nobody starts in a wall."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from components.terrain import clearance
from reefgame.content import load
from reefgame.world import World

CONTENT = load("first_dive")


def free(world: World) -> float:
    """Return the smallest distance [m] of a fish from ground, rock, surface and rim."""
    position = world.population.fish.live("position")
    return min((clearance(world.terrain, *map(float, p))[0] for p in position), default=1.0)


@settings(max_examples=10)
@given(
    st.lists(
        st.one_of(
            st.tuples(st.just("add"), st.integers(0, 30)),
            st.tuples(st.just("remove"), st.integers(0, 200)),
            st.tuples(st.just("tick"), st.integers(1, 40)),
        ),
        max_size=12,
    )
)
def test_ids_stay_with_their_fishes_whatever_comes_and_goes(steps: list[tuple[str, int]]) -> None:
    world = World.build(CONTENT, 1)
    lengths = dict(zip(*ids_and_lengths(world), strict=True))
    for what, number in steps:
        if what == "add":
            new = world.spawn.add(0, number, np.array([0.0, 0.0, -5.0]), 3.0)
            assert not set(new) & set(lengths)
            lengths.update(zip(*ids_and_lengths(world), strict=True))
        elif what == "remove" and world.population.count:
            identity = int(world.population.fish.id[number % world.population.count])
            world.spawn.remove(identity)
            del lengths[identity]
        elif what == "tick":
            for _ in range(number):
                world.tick()
    assert dict(zip(*ids_and_lengths(world), strict=True)) == lengths
    assert len(world.entities) == len(lengths)


def ids_and_lengths(world: World) -> tuple[list[int], list[float]]:
    fish = world.population.fish
    return fish.live("id").tolist(), fish.live("length").tolist()


def test_everybody_starts_in_free_water() -> None:
    for seed in range(5):
        assert free(World.build(CONTENT, seed)) > 0.0


def test_nobody_leaves_the_water_in_a_minute() -> None:
    world = World.build(CONTENT, 2)
    for tick in range(3600):
        world.tick()
        if tick % 60 == 0:
            assert free(world) > 0.0
            rotation = world.population.fish.rotation[: world.population.count]
            identity = np.einsum("nij,nik->njk", rotation, rotation)
            assert np.abs(identity - np.eye(3)).max() < 1e-6


def test_another_seed_is_another_dive() -> None:
    one, other = World.build(CONTENT, 1), World.build(CONTENT, 2)
    assert one.checksums()["fish"] != other.checksums()["fish"]
    assert one.checksums()["fish"] == World.build(CONTENT, 1).checksums()["fish"]
