"""Turns: a quarter thinks in a tick, side by side, and nobody looks at who is not copied for it."""

from types import ModuleType

import numpy as np
import pytest

from reefgame.bench.minds import reef
from reefgame.world import World
from systems.mind.crowd import place_of
from systems.mind.think import Think
from systems.mind.turns import quarter, thinking


def minds_of(world: World) -> Think:
    """Return the system that thinks."""
    return next(system for system in world.systems if isinstance(system, Think))


def murky_reef(number: int, copied_m: float, ticks: int) -> tuple[World, list[float]]:
    """Return a reef where nobody sees farther than 7 m, of whom all within `copied_m` are copied, and shares copied."""
    world = reef(number)
    think, shares = minds_of(world), []
    think.habitat, think.grid.visibility = think.habitat._replace(visibility=7.0), copied_m
    for _ in range(ticks):
        world.tick()
        begin, end = think.grid.crowd.stretch[:2]
        shares.append(float(end - begin) / world.population.count)
    return world, shares


@pytest.mark.parametrize("number", [0, 1, 3, 50, 701])
def test_four_quarters_are_everybody_once(number: int) -> None:
    assert quarter(number, 0) == thinking(number, 0) == (0, number)
    places = [place for now in (4, 5, 6, 7) for place in range(*quarter(number, now))]
    assert places == list(range(number))
    for now in range(1, 9):
        (begin, end), (first, last) = quarter(number, now), thinking(number, now)
        assert 0 <= first <= begin <= end <= last <= number


def test_everybody_thinks_in_every_fourth_tick_but_who_changes_quarters(pond: ModuleType) -> None:
    scene = pond.Pond(600, 100, spread=10.0)
    fish, mind, waits = scene.population.fish, scene.population.mind, []
    before = np.zeros(700, np.int64)
    scene.tick(1)
    for now in range(1, 80):
        scene.tick(1)
        at = np.empty(700, np.int64)
        at[fish.id[:700]] = mind.thought_at[:700]
        thought = at == now
        if now > 8:
            assert 0.15 < thought.mean() < 0.35
            waits.extend(now - before[thought])
        before = np.where(thought, now, before)
    assert min(waits) >= 2
    assert max(waits) <= 5
    assert np.mean(np.array(waits) == 4) > 0.99


def test_nobody_looks_at_who_is_not_copied() -> None:
    near, shares = murky_reef(9000, 7.0, 70)
    far, all_of_them = murky_reef(9000, 1e9, 70)
    assert min(shares[1:]) < 0.7
    assert min(all_of_them) == 1.0
    for here, there in zip(
        (near.population.fish, near.population.mind, near.population.motor),
        (far.population.fish, far.population.mind, far.population.motor),
        strict=True,
    ):
        order, other = near.population.fish.id.argsort(), far.population.fish.id.argsort()
        for name in here.columns:
            assert np.array_equal(getattr(here, name)[order], getattr(there, name)[other]), name


def test_who_is_not_copied_has_no_place() -> None:
    world, shares = murky_reef(9000, 7.0, 6)
    crowd, fish = minds_of(world).grid.crowd, world.population.fish
    begin, end = crowd.stretch[:2]
    count, places = world.population.count, world.population.index.places
    found = np.array([place_of(places, crowd, int(one)) for one in fish.id[:count]])
    assert set(found[found >= 0]) == set(range(begin, end))
    assert (crowd.row[found[found >= 0]] == np.flatnonzero(found >= 0)).all()
    assert (found < 0).mean() == pytest.approx(1.0 - shares[-1])
    assert place_of(places, crowd, -1) == place_of(places, crowd, 10**9) == -1


def test_shoals_are_summed_in_the_strips_beside_who_thinks() -> None:
    world, _ = murky_reef(9000, 7.0, 5)
    think, fish, count = minds_of(world), world.population.fish, world.population.count
    think()
    plan, crowd = think.grid.plan, think.grid.crowd
    assert plan.hunters == (world.senses.hunts[fish.species[:count]] != 0).sum()
    assert crowd.stretch[2] > 0 or crowd.stretch[3] < plan.squares
    width = plan.block * plan.cell
    square = np.floor((fish.position[:count, :2] + plan.extent) / width).astype(int)
    here = square[think.population.mind.thought_at[:count] == world.clock.now, 0]
    summed = range(max(here.min() - 1, 0), min(here.max() + 2, plan.squares))
    assert (crowd.stretch[2], crowd.stretch[3]) == (summed.start, summed.stop)
    for kind in np.flatnonzero(world.senses.schooling):
        mine = square[fish.species[:count] == kind]
        for strip in summed:
            for along in range(plan.squares):
                number = ((mine[:, 0] == strip) & (mine[:, 1] == along)).sum()
                assert crowd.shoal[kind, strip * plan.squares + along, 0] == number
