"""Drifting: the flow carries food and fishes, and nobody out of the world (papers/002, section 2)."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.field import field_of, flow, flow_near
from components.singularity import SingularityTable
from components.sphere_grid import list_spheres, sphere_grid
from components.table import Table
from components.terrain import berth, confine
from reefgame.world import World
from systems.sea.drift import FASTEST, Carried, Drift, carry_all, carry_some
from systems.sea.stir import Stir

Pool = Callable[..., World]
CURRENT = "{kind: current, axis: [1, 0, 0], speed_m_per_s: 1}"
WHIRL = "{kind: whirlwind, at_m: [0, 0, -6], speed_m_per_s: 3, core_m: 3, reach_m: 12}"


def drift(world: World, ticks: int) -> None:
    """Let the flow alone move everybody."""
    fish = world.population.fish
    systems = [system for system in world.systems if isinstance(system, Stir | Drift)]
    for _ in range(ticks):
        fish.last_position[: fish.count] = fish.position[: fish.count]
        for system in systems:
            system()
        world.clock.tick[0] += 1


def column(table: Table, name: str) -> Any:
    """Return the living rows of a column."""
    return table.live(name)


def inside(world: World) -> bool:
    """Return whether every fish and particle is where it may be."""
    fish, food = world.population.fish, world.food
    for position, margins in (
        (column(fish, "position"), [float(berth(length)) for length in column(fish, "length")]),
        (column(food, "position"), [0.03] * food.count),
    ):
        for row, margin in enumerate(margins):
            place = position[row : row + 1].copy()
            confine(world.terrain, place, 0, margin)
            if np.abs(place[0] - position[row]).max() > 1e-6:
                return False
    return True


def test_a_current_carries_plankton_and_fishes_downstream(pool: Pool) -> None:
    world = pool(CURRENT)
    fish, cruise = world.population.fish, world.senses.speed[0, 1]
    before, food = column(fish, "position").copy(), column(world.food, "position").copy()
    drift(world, 30)
    went = column(fish, "position") - before
    np.testing.assert_allclose(went[:, 0], 0.5 * (1.0 - cruise * column(fish, "length")), rtol=1e-9)
    np.testing.assert_allclose(went[:, 1:], 0.0, atol=1e-12)
    steps = column(world.food, "position") - column(world.food, "last_position")
    stayed = np.abs(steps[:, 0]) > 0.0
    np.testing.assert_allclose(steps[stayed], [[1.0 / 60.0, 0.0, 0.0]] * stayed.sum(), atol=1e-12)
    moved = column(world.food, "position")[:, 0] - food[:, 0]
    assert np.median(moved) == pytest.approx(0.5)


def test_a_fish_holds_its_place_against_what_it_swims_with_ease(pool: Pool) -> None:
    world = pool("{kind: current, axis: [0, 1, 0], speed_m_per_s: 0.2}")
    before = column(world.population.fish, "position").copy()
    drift(world, 30)
    assert np.array_equal(column(world.population.fish, "position"), before)


def test_a_whirlwind_turns_fishes_and_plankton_about_its_axis(pool: Pool) -> None:
    world = pool(WHIRL)
    fish, food = world.population.fish, world.food
    for table in (fish, food):
        place = column(table, "position")
        turns = []
        drift(world, 1)
        for _ in range(20):
            x, y = place[:, 0].copy(), place[:, 1].copy()
            drift(world, 1)
            turns.append(x * (place[:, 1] - y) - y * (place[:, 0] - x))
        assert np.median(turns) < 0.0
        assert np.mean(np.array(turns) <= 0.0) > 0.95


def test_a_source_in_a_ball_of_plankton_leaves_it_full_of_plankton(pool: Pool) -> None:
    world = pool("{kind: source, at_m: [0, 0, -6], speed_m_per_s: 1, core_m: 0.5}")
    drift(world, 600)
    out = np.linalg.norm(column(world.food, "position") - [0.0, 0.0, -6.0], axis=1)
    assert out.max() < 1.6
    assert np.ptp(column(world.food, "position"), axis=0).min() > 2.0
    flips = 0
    for _ in range(60):
        drift(world, 1)
        step = column(world.food, "position") - column(world.food, "last_position")
        flips += int((np.abs(step).max(axis=1) == 0.0).sum())
    assert flips < 0.05 * 60 * world.food.count


def test_food_and_fishes_are_carried_before_they_are_seen_between_ticks(pool: Pool) -> None:
    still, flowing = pool(), pool("{kind: current, axis: [0, 0, 1], speed_m_per_s: 2}")
    for world in (still, flowing):
        world.tick()
    a, b = still.population.fish, flowing.population.fish
    assert np.array_equal(column(a, "last_position"), column(b, "last_position"))
    assert (column(b, "position")[:, 2] - column(a, "position")[:, 2] > 0.01).all()


FLOWS = st.sampled_from(
    [
        "{kind: current, axis: [1, -1, -1], speed_m_per_s: 20}",
        "{kind: source, at_m: [0, 0, -6], speed_m_per_s: 20, core_m: 50}",
        "{kind: hole, at_m: [6, 0, -11], speed_m_per_s: 20, core_m: 50}",
        "{kind: whirlwind, at_m: [19, 0, -6], speed_m_per_s: -20, core_m: 30, axis: [1, 0, 1]}",
        "{kind: current, axis: [0, 0, 1], speed_m_per_s: 20, wave: {period_s: 0.2, amplitude: 20}}",
    ]
)


@given(st.lists(FLOWS, min_size=1, max_size=4), st.integers(0, 100))
@settings(max_examples=8)
def test_the_strongest_flow_leaves_everybody_in_the_water(
    pool: Pool, flows: list[str], seed: int
) -> None:
    world = pool(", ".join(flows), seed=seed)
    fish = world.population.fish
    for _ in range(6):
        before = column(fish, "position").copy()
        drift(world, 5)
        assert inside(world)
        assert np.isfinite(column(fish, "position")).all()
        # Being put out of rock may take a little more.
        assert (
            np.linalg.norm(column(fish, "position") - before, axis=1).max() < 5 * FASTEST / 30 + 3.0
        )


@pytest.mark.parametrize("phi", [np.inf, np.nan, 1e300, -1e300])
def test_a_flow_that_is_no_number_carries_nobody(pool: Pool, phi: float) -> None:
    world = pool(CURRENT)
    world.singularities.intensity[0] = phi
    before = column(world.population.fish, "position").copy()
    drift(world, 3)
    assert np.array_equal(column(world.population.fish, "position"), before)
    assert np.isfinite(column(world.food, "position")).all()


def test_all_threads_carry_fishes_to_the_same_bits(pool: Pool) -> None:
    world = pool(
        f"{CURRENT}, {WHIRL}",
        fishes="{species: sardine, count: 300, around_m: [0, 0, -6], within_m: 5}",
    )
    fish = world.population.fish
    system = next(one for one in world.systems if isinstance(one, Drift))
    water, speed = system.water(), world.senses.speed
    places = [fish.position.copy(), fish.position.copy()]
    one, all_ = (Carried(fish.species, fish.length, place) for place in places)
    carry_some(world.terrain, water, speed, one, 0, fish.count)
    carry_all(world.terrain, *water, speed, all_, fish.count)
    assert np.array_equal(places[0], places[1])
    assert not np.array_equal(places[0], fish.position)


@given(st.integers(0, 2**32 - 1), st.integers(0, 300))
@settings(max_examples=30)
def test_the_grid_leaves_no_singularity_out_that_is_felt(seed: int, number: int) -> None:
    chance = np.random.default_rng(seed)
    table = SingularityTable(number)
    table.kind[:number] = chance.integers(0, 4, number)
    table.position[:number] = chance.uniform(-25.0, 25.0, (number, 3))
    table.axis[:number] = (0.6, 0.0, 0.8)
    table.intensity[:number], table.most[:number] = chance.uniform(-1.0, 1.0, number), 2.0
    table.reach[:number] = chance.choice([0.2, 3.0, 30.0, np.inf], number)
    field = field_of(table)
    grid = list_spheres(sphere_grid(20.0), field.position, field.reach)
    for x, y, z in chance.uniform(-30.0, 30.0, (20, 3)):
        assert flow_near(field, grid, 7, x, y, z) == flow(field, 7, x, y, z)


def test_the_wash_blows_plankton_astern(pool: Pool) -> None:
    world = pool(
        food="{around_m: [-17.6, 0, -5], within_m: 1, particles: 60, drift_m_per_s: [0, 0, 0]}"
    )
    ship, food = world.submarine, world.food
    ship.throttle[0] = 1.0
    drift(world, 2)
    steps = column(food, "position") - column(food, "last_position")
    stayed = np.abs(steps).max(axis=1) > 0.0
    assert stayed.sum() > 40
    assert steps[stayed, 0].max() < -0.5 / 60.0
    ship.throttle[0] = 0.0
    drift(world, 1)
    assert not (column(food, "position") - column(food, "last_position")).any()
