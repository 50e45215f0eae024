"""Who is eaten is followed by another of its group, out of the submarine's sight; and everybody is born with a past."""

from typing import TYPE_CHECKING

import numpy as np
import pytest

from components.cohort import NEVER
from systems.play.spawn import in_sight

if TYPE_CHECKING:
    from tests.play.conftest import Sea, Table

VIEW = np.array([1.0, 0.0, 0.0])


def test_another_comes_for_the_eaten_after_the_levels_time(table: "Table") -> None:
    spawn, population = table.world.spawn, table.world.population
    eaten = table.of("sardine")[2]
    group = population.fish.cohort[table.row(eaten)]
    spawn.lose(eaten)
    table.tick(120)
    assert population.count == 7
    table.tick()
    assert population.count == 8
    assert table.world.restocks.count == 0
    fresh = max(table.of("sardine"))
    assert population.fish.cohort[table.row(fresh)] == group
    assert fresh == table.world.roster.next_id[0] - 1


def test_none_comes_where_the_level_says_never_or_the_group_has_left(table: "Table") -> None:
    world = table.world
    world.cohorts.restock[1] = NEVER
    world.spawn.lose(table.of("barracuda")[0])
    assert world.restocks.count == 0
    world.spawn.lose(table.of("sardine")[0])
    assert world.restocks.count == 1
    world.cohorts.leaves[0] = world.clock.now
    table.tick(400)
    assert world.restocks.count == 0
    assert table.of("sardine") == []


def test_nobody_appears_before_the_submarines_windows(sea: "Sea") -> None:
    spots = []
    for seed in range(6):
        world = sea(seed=seed)
        world.submarine.position[0] = [0.0, 0.0, -5.0]
        world.spawn.lose(int(world.population.fish.id[0]))
        world.clock.tick[0] = 120
        world.spawn()
        assert world.restocks.count == 0
        newest = world.population.row(int(world.roster.next_id[0]) - 1)
        spots.append(world.population.fish.position[newest].copy())
    eye = np.array([0.0, 0.0, -5.0])
    assert not any(in_sight(world.terrain, eye, VIEW, 22.0, spot) for spot in spots)
    assert in_sight(world.terrain, eye, VIEW, 22.0, np.array([4.0, 0.0, -5.0]))
    assert in_sight(world.terrain, eye, VIEW, 22.0, np.array([-1.0, 0.0, -5.0]))
    assert not in_sight(world.terrain, eye, VIEW, 3.0, np.array([4.0, 0.0, -5.0]))


def test_who_is_watched_all_the_time_comes_after_half_a_minute_all_the_same(sea: "Sea") -> None:
    world = sea(fishes="{species: sardine, count: 3, around_m: [4, 0, -5], within_m: 0.1}")
    world.submarine.position[0] = [2.5, 0.0, -5.0]
    world.spawn.lose(0)
    due = int(world.restocks.due[0])
    for now in (due, due + 1, due + 60, due + 1740):
        world.clock.tick[0] = now
        world.spawn()
        assert world.population.count == 2
    world.clock.tick[0] = due + 1800
    world.spawn()
    assert world.population.count == 3


def test_the_newborn_are_hungry_and_ready_in_every_degree(sea: "Sea") -> None:
    world = sea(fishes="{species: sardine, count: 200, around_m: [4, 0, -5], within_m: 3}")
    mind, senses = world.population.mind, world.senses
    eaten = mind.eaten[:200] / senses.appetite[0]
    since = -mind.ate_at[:200] / senses.digestion[0]
    mated = -mind.mated_at[:200] / senses.breeding[0]
    for share, least, most in ((eaten, 0.6, 1.6), (since, 0.0, 0.35), (mated, 0.0, 0.14)):
        assert share.min() >= least
        assert share.max() <= most + 1e-9
        assert np.histogram(share, 4, (least, most))[0].min() > 25
    hungry = eaten * (1.0 - since) < 0.75
    assert 0.2 < hungry.mean() < 0.5
    assert abs(np.corrcoef([eaten, since, mated])[0, 1:]).max() < 0.25
    again = sea(fishes="{species: sardine, count: 200, around_m: [4, 0, -5], within_m: 3}")
    assert np.array_equal(again.population.mind.live("eaten"), mind.live("eaten"))


@pytest.mark.parametrize("count", [0, 1])
def test_a_sea_with_nobody_or_one_lives_on(sea: "Sea", count: int) -> None:
    world = sea(fishes="{species: sardine, count: 1, around_m: [4, 0, -5], within_m: 1}")
    if count == 0:
        world.spawn.remove(0)
    for _ in range(300):
        world.tick()
    assert world.population.count == count
    assert np.isfinite(world.population.fish.live("position")).all()


def test_a_group_comes_as_hungry_as_its_level_says(sea: "Sea") -> None:
    school = "{{species: sardine, count: 5, around_m: [4, 0, -5], within_m: 3, hunger: {}}}"
    for hunger in (1.0, 0.25, -1.0):
        world = sea(fishes=school.format(hunger))
        mind, appetite = world.population.mind, world.senses.appetite[0]
        np.testing.assert_allclose(mind.eaten[:5], (1.0 - hunger) * appetite)
        assert mind.ate_at[:5].tolist() == [0] * 5
