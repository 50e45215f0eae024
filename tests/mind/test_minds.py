"""What minds promise: order does not matter, schools form, nobody leaves the world."""

import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numba
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.arrays import Float64s
from components.fish import Population
from components.kernels import loop, row
from components.mind import SUBMARINE, Intention
from components.terrain import clearance
from systems.motor.bound import Bounded

WANDER, OBSTACLE, AVOID, SCHOOL = (int(kind) for kind in list(Intention)[:4])


def polarisation(axes: Float64s) -> float:
    return float(np.sqrt((axes.mean(axis=0) ** 2).sum()))


def nearest(places: Float64s) -> Float64s:
    offset = places[:, None, :] - places[None, :, :]
    square = (offset**2).sum(axis=2)
    np.fill_diagonal(square, np.inf)
    apart: Float64s = np.sqrt(square.min(axis=1))
    return apart


@pytest.mark.parametrize("count", [90, 600])
def test_rows_in_another_order_change_no_bit(pond: ModuleType, count: int) -> None:
    one, other = pond.Pond(count, count // 5), pond.Pond(count, count // 5)
    rng = np.random.default_rng(9)
    for _ in range(4):
        other.population.reorder(rng.permutation(other.population.count))
        one.tick(8)
        other.tick(8)
    assert one.by_id() == other.by_id()


def test_threads_and_processor_change_no_bit(pond_script: Path) -> None:
    settings_tried = (
        {"NUMBA_NUM_THREADS": "1"},
        {"NUMBA_NUM_THREADS": "2"},
        {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""},
    )
    hashes = [
        subprocess.run(
            [sys.executable, str(pond_script), "520", "40", "90"],
            env={**os.environ, **chosen},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for chosen in settings_tried
    ]
    assert len(hashes[0]) == 32
    assert len(set(hashes)) == 1


def test_a_school_forms_and_holds_its_distance(pond: ModuleType) -> None:
    scene = pond.Pond(60)
    scene.tick(1200)
    fish = scene.population.fish
    apart = nearest(fish.position[:60]) / 0.2
    assert polarisation(fish.rotation[:60, :, 0]) > 0.8
    assert 0.5 < np.median(apart) < 1.5
    assert np.quantile(apart, 0.05) > 0.35
    assert (scene.population.mind.intention[:60] == SCHOOL).mean() > 0.9


def test_a_school_travels(pond: ModuleType) -> None:
    scene = pond.Pond(40)
    scene.tick(600)
    start = scene.population.fish.position[:40].mean(axis=0)
    scene.tick(1200)
    end = scene.population.fish.position[:40].mean(axis=0)
    assert np.sqrt(((end - start) ** 2).sum()) > 3.0


def test_wanderers_part_ways_and_keep_their_depth(pond: ModuleType) -> None:
    scene = pond.Pond(0, 12)
    scene.tick(1800)
    fish, mind = scene.population.fish, scene.population.mind
    assert polarisation(fish.rotation[:12, :, 0]) < 0.8
    assert set(mind.intention[:12].tolist()) <= {WANDER, OBSTACLE, AVOID}
    assert (fish.position[:12, 2] < -2.0).all()


@given(
    st.integers(0, 1000),
    st.floats(10, 60),
    st.floats(4, 25),
    st.integers(0, 30),
    st.integers(1, 40),
)
@settings(max_examples=12, deadline=None)
def test_nobody_leaves_the_world(
    pond: ModuleType, seed: int, radius: float, depth: float, rocks: int, count: int
) -> None:
    terrain = pond.make_terrain(seed, radius, depth, rocks)
    scene = pond.Pond(count, count // 2, seed, min(2.0, 0.2 * depth), terrain)
    for _ in range(20):
        scene.tick(60)
        fish, number = scene.population.fish, scene.population.count
        for x, y, z in fish.position[:number]:
            assert clearance(terrain, x, y, z)[0] > 0.02


def test_the_sense_of_territory_turns_fishes_before_they_are_held(pond: ModuleType) -> None:
    scene = pond.Pond(60, 12)
    scene.tick(60)
    scene.confined = 0
    scene.tick(1800)
    assert scene.confined < 72 * 1800 * 0.001


@pytest.mark.parametrize("count", [0, 1])
def test_an_empty_and_a_lonely_world_tick(pond: ModuleType, count: int) -> None:
    scene = pond.Pond(count)
    scene.tick(100)
    assert scene.population.count == count
    assert (scene.population.mind.intention[:count] == WANDER).all()


def test_a_thousand_in_one_place_part(pond: ModuleType) -> None:
    scene = pond.Pond(1000, spread=1e-9)
    before = scene.population.fish.position[:1000].std(axis=0).sum()
    scene.tick(120)
    heading = scene.population.motor.heading[:1000]
    assert scene.population.fish.position[:1000].std(axis=0).sum() > before + 0.1
    assert np.allclose((heading**2).sum(axis=1), 1.0)


def test_fishes_keep_clear_of_the_submarine(pond: ModuleType) -> None:
    scene = pond.Pond(60, submarines=1)
    scene.submarine.position[0] = (6.0, 1.0, -5.0)
    scene.tick(240)
    focused = scene.population.mind.focus[:60] == SUBMARINE
    scene.tick(360)
    offset = scene.population.fish.position[:60] - scene.submarine.position[0]
    assert focused.any() or (np.sqrt((offset**2).sum(axis=1)) > 2.5).all()
    assert np.quantile(np.sqrt((offset**2).sum(axis=1)), 0.1) > 2.0


def test_the_parallel_loop_drops_no_store(pond: ModuleType) -> None:
    scene = pond.Pond(600)
    scene.population.motor.heading[:600] = 0.0
    scene.population.motor.gear[:600] = 9
    scene.think()
    heading = scene.population.motor.heading[:600]
    assert (scene.population.mind.thought_at[:600] == 0).all()
    assert np.allclose((heading**2).sum(axis=1), 1.0)
    assert (scene.population.motor.gear[:600] < 3).all()


@row
def _raise_urgency(swimmers: Bounded, i: int) -> None:
    swimmers.urgency[i] = 1.0


@loop
def _raise_all(swimmers: Bounded, number: int) -> None:
    for i in numba.prange(number):
        _raise_urgency(swimmers, i)


def test_a_row_function_called_in_prange_stores_into_a_tuple_of_columns() -> None:
    population = Population()
    population.append(np.arange(100))
    fish, motor = population.fish, population.motor
    swimmers = Bounded(
        fish.species, fish.length, fish.position, fish.last_position, fish.rotation,
        motor.heading, motor.urgency,
    )  # fmt: skip
    _raise_all(swimmers, 100)
    assert (motor.urgency[:100] == 1.0).all()


def test_ids_find_their_rows_after_growth_removal_and_sorting() -> None:
    population = Population()
    population.append(np.arange(5, 40))
    population.remove(7)
    population.append(np.array([1000]))
    population.reorder(np.random.default_rng(1).permutation(population.count))
    for identity in population.fish.id[: population.count].tolist():
        assert population.fish.id[population.row(identity)] == identity
    assert 7 not in population
    assert -1 not in population
    with pytest.raises(KeyError):
        population.row(7)
    with pytest.raises(KeyError):
        population.remove(4000)
