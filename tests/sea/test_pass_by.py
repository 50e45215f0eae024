"""Passing by: which fishes stir plants, and how (papers/002, section 1)."""

from collections.abc import Callable

import numpy as np

from components.singularity import SingularityKind
from reefgame.world import World
from systems.sea.pass_by import MOST, PassBy, stirrers_of

Pool = Callable[..., World]
GUESTS = (
    "{species: clownfish, count: 2, around_m: [0, 0, -6], within_m: 0.2},"
    "{species: barracuda, count: 1, around_m: [12, 0, -6], within_m: 0.2},"
    "{species: sardine, count: 3, around_m: [1, 0, -6], within_m: 0.2}"
)
PLANT = np.array([[0.0, 0.0, -6.0, 0.5]])


def test_clownfish_push_tentacles_away_and_others_draw_them(pool: Pool) -> None:
    world = pool(fishes=GUESTS)
    stirrers = stirrers_of(world.species)
    kinds = dict(zip([one.name for one in world.species], stirrers.kind.tolist(), strict=True))
    assert kinds == {
        "barracuda": SingularityKind.HOLE,
        "clownfish": SingularityKind.SOURCE,
        "sardine": SingularityKind.HOLE,
    }
    packed = PassBy(world.population, world.species, PLANT, 20.0)()
    fish = world.population.fish
    near = fish.species[: fish.count] != 0
    assert len(packed) == near.sum() == 5
    signs = {1: 1.0, 2: -1.0}
    for row in np.flatnonzero(near):
        gap = np.abs(packed[:, :3] - fish.position[row]).max(axis=1)
        assert gap.min() < 1e-5
        assert np.sign(packed[gap.argmin(), 8]) == signs[int(fish.species[row])]


def test_fishes_stand_between_two_ticks_and_in_any_order_of_rows(pool: Pool) -> None:
    world = pool(fishes=GUESTS)
    fish = world.population.fish
    fish.position[: fish.count] += (0.2, 0.0, 0.0)
    passers = PassBy(world.population, world.species, PLANT, 20.0)
    half = passers(0.5)
    assert np.abs(half[:, 0] - passers(1.0)[:, 0] + 0.1).max() < 1e-5
    world.population.reorder(np.arange(fish.count)[::-1].copy())
    assert np.array_equal(passers(0.5), half)


def test_of_many_the_nearest_stir(pool: Pool) -> None:
    many = "{species: sardine, count: 600, around_m: [0, 0, -6], within_m: 1.5}"
    world = pool(fishes=many)
    packed = PassBy(world.population, world.species, PLANT, 20.0)()
    fish = world.population.fish
    gaps = np.sort(np.linalg.norm(fish.position[: fish.count] - PLANT[0, :3], axis=1))
    assert len(packed) == MOST
    taken = np.linalg.norm(packed[:, :3] - PLANT[0, :3].astype(np.float32), axis=1)
    assert taken.max() <= gaps[MOST - 1] + 1e-4


def test_who_stirs_nothing_and_no_plants_make_nothing(pool: Pool) -> None:
    world = pool(fishes=GUESTS)
    passers = PassBy(world.population, world.species, np.zeros((0, 4)), 20.0)
    assert passers().shape == (0, 16)
    quiet = PassBy(world.population, world.species, PLANT, 20.0)
    quiet.stirrers.reach[:] = 0.0
    assert len(quiet()) == 0
