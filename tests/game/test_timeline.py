"""Looking back: every moment of a dive comes back to the bit, and the present is unchanged by it."""

import numpy as np
import pytest

from components.command import Command
from reefgame.content import load
from reefgame.timeline import Timeline, size_of
from reefgame.world import World

CONTENT = load("visitors")


def orders(tick: int) -> Command:
    """Return orders that change now and then."""
    return Command(throttle=20 * (tick // 50 % 5), turn=-30 if tick % 170 > 90 else 0)


def dived(ticks: int, **bounds: int) -> tuple[World, Timeline, list[dict[str, int]]]:
    """Return a world after a dive, its timeline, and the checksums before each tick, and at the end."""
    world = World.build(CONTENT, 5)
    timeline, sums = Timeline(world, **bounds), []
    for tick in range(ticks):
        sums.append(world.checksums())
        world.tick(orders(tick))
        timeline.tick(orders(tick))
    return world, timeline, [*sums, world.checksums()]


@pytest.fixture(scope="module")
def dive() -> tuple[World, Timeline, list[dict[str, int]]]:
    return dived(400)


def test_every_moment_comes_back_to_the_bit(
    dive: tuple[World, Timeline, list[dict[str, int]]],
) -> None:
    world, timeline, sums = dive
    for tick in (0, 399, 61, 62, 250, 119, 120, 400):
        timeline.seek(tick)
        assert world.clock.now == tick
        assert world.checksums() == sums[tick]
        assert timeline.at_present == (tick == 400)


def test_the_present_comes_back_and_goes_on_as_if_nobody_had_looked(
    dive: tuple[World, Timeline, list[dict[str, int]]],
) -> None:
    world, timeline, sums = dive
    timeline.seek(133)
    for _ in range(40):
        world.tick(timeline.command(world.clock.now))
        timeline.catch_up()
    assert world.checksums() == sums[173]
    assert not timeline.at_present
    timeline.to_present()
    assert world.checksums() == sums[400]
    assert timeline.at_present


def test_the_past_plays_on_into_the_present(
    dive: tuple[World, Timeline, list[dict[str, int]]],
) -> None:
    world, timeline, sums = dive
    timeline.seek(390)
    for _ in range(10):
        assert not timeline.at_present
        world.tick(timeline.command(world.clock.now))
        timeline.catch_up()
    assert timeline.at_present
    assert world.checksums() == sums[400]


def test_moments_out_of_the_dive_are_its_ends(
    dive: tuple[World, Timeline, list[dict[str, int]]],
) -> None:
    world, timeline, sums = dive
    timeline.seek(-7)
    assert world.checksums() == sums[0]
    timeline.seek(10_000)
    assert world.checksums() == sums[400]


@pytest.mark.parametrize("bound", ["most", "budget"])
def test_memory_is_bounded_and_every_moment_still_comes_back(bound: str) -> None:
    one = size_of(World.build(CONTENT, 5).snapshot())
    world, timeline, sums = dived(700, **{bound: 4 if bound == "most" else 5 * one})
    assert len(timeline._shots) <= 4 or timeline._bytes <= 5 * one
    assert len(timeline._shots) >= 2
    for tick in (3, 301, 640):
        timeline.seek(tick)
        assert world.checksums() == sums[tick]


def test_feelings_of_the_last_minute_are_those_of_the_minds(
    dive: tuple[World, Timeline, list[dict[str, int]]],
) -> None:
    world, timeline, _ = dive
    timeline.to_present()
    identity = int(world.population.fish.id[0])
    ticks, felt = timeline.feelings(identity, 390, 60.0)
    assert list(ticks) == list(range(15, 391, 15))
    assert felt.shape == (len(ticks), 3)
    timeline.seek(240)
    mind, row = world.population.mind, world.population.row(identity)
    expected = [mind.hunger[row], mind.libido[row], mind.fear[row]]
    assert felt[list(ticks).index(240)] == pytest.approx(expected, abs=0.003)
    assert len(timeline.feelings(identity, 240, 1.0)[0]) == 5
    assert np.isfinite(felt).all()
    assert timeline.feelings(10**9, 390, 60.0)[1].shape == (0, 3)
