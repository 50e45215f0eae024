"""Feeding: open mouths suck in what they are about, for a fifth of a second, then it is gone (papers/004)."""

from typing import TYPE_CHECKING

import numpy as np
import pytest

from components.food import GONE, in_stomach
from components.mind import FOOD
from components.senses import FISH_GRAMS, SWALLOWED
from systems.play.feed import OPEN, SUCK_TICKS
from systems.sea.drift import Drift, drift_all

if TYPE_CHECKING:
    from tests.play.conftest import Sea, Table

ASIDE = np.array([0.0, 1.0, 0.0])
HERE = np.array([0.0, 0.0, -5.0])
PATCH = np.array([0.0, 4.0, -5.0])


def served(table: "Table", share: float = 0.9) -> tuple[int, int]:
    """Put a sardine at `share` of a barracuda's reach; return their ids, prey first."""
    prey, hunter = table.of("sardine")[0], table.of("barracuda")[0]
    table.put(hunter, HERE)
    table.put(prey, table.nose(hunter) + share * table.reach(hunter) * ASIDE)
    return prey, hunter


def held(table: "Table", identity: int) -> int:
    """Return whose mouth draws the fish in, -1 for none."""
    return int(table.world.population.mind.swallowed_by[table.row(identity)])


def test_an_open_mouth_sucks_its_prey_in_within_a_fifth_of_a_second(table: "Table") -> None:
    prey, hunter = served(table)
    table.gape(hunter, prey)
    table.tick()
    assert held(table, prey) == hunter
    gaps = []
    for _ in range(SUCK_TICKS):
        table.tick()
        if prey not in table.world.population:
            break
        gaps.append(
            np.linalg.norm(
                table.world.population.fish.position[table.row(prey)] - table.nose(hunter)
            )
        )
    assert prey not in table.world.population
    assert len(gaps) >= SUCK_TICKS - 3
    assert np.all(np.diff(gaps) < 0.0)
    assert len(table.world.entities) == table.world.population.count


def test_the_victim_follows_a_mouth_that_moves_on(table: "Table") -> None:
    prey, hunter = served(table)
    table.gape(hunter, prey)
    table.tick()
    fish = table.world.population.fish
    for _ in range(SUCK_TICKS):
        fish.position[table.row(hunter)] += [0.2, 0.0, 0.0]
        table.gape(hunter, -1, 0.0)
        if prey in table.world.population:
            fish.position[table.row(prey)] -= [0.3, 0.0, 0.0]
        table.feed()
        fish.last_position[: fish.count] = fish.position[: fish.count]
    assert prey not in table.world.population


def test_the_bite_fills_the_stomach_over_what_is_digested(table: "Table") -> None:
    prey, hunter = served(table, share=0.01)
    mind, i = table.world.population.mind, table.row(hunter)
    kind = table.world.population.fish.species[i]
    digestion = float(table.world.senses.digestion[kind])
    mind.eaten[i], mind.ate_at[i] = 2.0, -digestion / 2
    length = table.world.population.fish.length[table.row(prey)]
    table.gape(hunter, prey)
    table.tick(2)
    meals = FISH_GRAMS * length**3 / table.world.senses.meal[kind]
    assert mind.eaten[table.row(hunter)] == pytest.approx(1.0 + meals, rel=1e-3)
    assert mind.ate_at[table.row(hunter)] == 1
    assert in_stomach(2.0, 0, int(2 * digestion), digestion) == 0.0


@pytest.mark.parametrize("fault", ["too far", "shut", "not eaten", "too large", "itself", "gone"])
def test_what_cannot_be_eaten_is_not(table: "Table", fault: str) -> None:
    prey, hunter = served(table, share=1.05 if fault == "too far" else 0.9)
    focus = {"not eaten": table.of("barracuda")[1], "itself": hunter, "gone": 4_000}
    fish = table.world.population.fish
    if fault == "too large":
        fish.length[table.row(prey)] = 1.01 * SWALLOWED * fish.length[table.row(hunter)]
    if fault == "not eaten":
        table.put(focus[fault], table.nose(hunter))
    table.gape(hunter, focus.get(fault, prey), OPEN if fault == "shut" else 1.0)
    before = table.world.population.count
    table.tick(SUCK_TICKS + 1)
    assert table.world.population.count == before
    assert set(table.world.population.mind.live("swallowed_by")) == {-1}


def test_the_nearest_of_two_mouths_has_it_then_the_lower_id(table: "Table") -> None:
    prey, near = served(table, share=0.5)
    far = table.of("barracuda")[1]
    fish = table.world.population.fish
    fish.length[table.row(far)] = fish.length[table.row(near)]
    table.put(far, HERE - 0.2 * table.reach(near) * ASIDE)
    for hunter in (near, far):
        table.gape(hunter, prey)
    table.tick()
    assert held(table, prey) == near
    other = table.of("sardine")[1]
    table.put(other, table.nose(near))
    table.put(far, HERE)
    fish.position[table.row(near)] = fish.position[table.row(far)]
    table.world.spawn.remove(prey)
    for hunter in (far, near):
        table.gape(hunter, other)
    table.tick()
    assert held(table, other) == min(near, far)


def test_a_full_mouth_takes_no_second_bite(table: "Table") -> None:
    prey, hunter = served(table)
    table.gape(hunter, prey)
    table.tick()
    second = table.of("sardine")[1]
    table.put(second, table.nose(hunter))
    table.gape(hunter, second)
    table.tick()
    assert held(table, prey) == hunter
    assert held(table, second) == -1


def test_prey_is_free_again_when_its_eater_leaves_or_is_eaten(table: "Table") -> None:
    prey, hunter = served(table)
    table.gape(hunter, prey)
    table.tick()
    other = table.of("sardine")[1]
    mind = table.world.population.mind
    table.put(other, HERE + 3.0)
    mind.swallowed_by[table.row(hunter)] = other
    table.tick()
    assert held(table, prey) == -1
    table.tick(SUCK_TICKS)
    assert prey in table.world.population
    table.gape(table.of("barracuda")[1], prey)
    mind.swallowed_by[table.row(prey)] = table.of("barracuda")[1]
    table.world.spawn.remove(table.of("barracuda")[1])
    table.tick()
    assert held(table, prey) == -1


def test_a_particle_is_eaten_and_comes_back(table: "Table") -> None:
    food, grazer = table.world.food, table.of("sardine")[0]
    table.put(grazer, PATCH)
    food.position[7] = table.nose(grazer)
    table.gape(grazer, FOOD - 7)
    table.tick()
    assert food.eaten_by[7] == grazer
    meals = table.world.population.mind.eaten[table.row(grazer)]
    table.tick()
    assert food.eaten_by[7] == -1
    assert table.world.population.mind.eaten[table.row(grazer)] != meals
    away = int(food.returns[7]) - table.world.clock.now
    assert away == 60
    table.tick(away)
    assert food.position[7] == pytest.approx(table.nose(grazer))
    table.tick()
    assert np.linalg.norm(food.position[7] - table.nose(grazer)) > 0.05
    assert food.returns[7] < table.world.clock.now
    assert np.linalg.norm(food.position[7] - table.world.patches.around[0]) <= 1.0


def test_hunters_do_not_graze_and_what_is_eaten_up_stays_away(table: "Table") -> None:
    food, hunter, grazer = table.world.food, table.of("barracuda")[0], table.of("sardine")[0]
    table.world.patches.returns_after[0] = GONE
    table.put(hunter, PATCH - 0.5 * ASIDE)
    table.put(grazer, PATCH)
    food.position[7] = table.nose(grazer)
    food.position[8] = table.nose(hunter)
    table.gape(hunter, FOOD - 8)
    table.gape(grazer, FOOD - 7)
    table.tick(3)
    assert food.returns[8] < 0
    assert food.returns[7] >= GONE


def test_food_drifts_inside_its_ball_at_its_patchs_pace(sea: "Sea") -> None:
    world = sea()
    food, number = world.food, world.food.count
    before = food.position[:number].copy()
    for _ in range(600):
        world.tick()
        steps = food.position[:number] - food.last_position[:number]
        assert np.allclose(steps, [0.3 / 60, 0.0, 0.1 / 60]) or np.any(np.all(steps == 0.0, axis=1))
    place = food.position[:number]
    assert np.linalg.norm(place - world.patches.around[0], axis=1).max() < 1.02
    assert np.linalg.norm(place - before, axis=1).min() > 0.0


def test_food_drifts_alike_on_one_thread_and_on_all(sea: "Sea", table: "Table") -> None:
    world, other = table.world, sea()
    threads = next(system for system in other.systems if isinstance(system, Drift))
    for now in range(200):
        table.tick()
        water = threads.water()._replace(tick=now)
        drift_all(other.terrain, *water, 3, threads.plankton(), other.food.count)
    for name in world.food.columns:
        assert np.array_equal(world.food.live(name), other.food.live(name))


def test_a_world_saved_in_mid_swallow_goes_on_with_the_same_bits(
    sea: "Sea", table: "Table"
) -> None:
    prey, hunter = served(table)
    food, grazer = table.world.food, table.of("sardine")[1]
    table.put(grazer, PATCH)
    food.position[7] = table.nose(grazer) + 0.9 * table.reach(grazer) * ASIDE
    table.gape(hunter, prey)
    table.gape(grazer, FOOD - 7)
    table.tick(3)
    assert held(table, prey) == hunter
    assert food.eaten_by[7] == grazer
    saved = table.world.snapshot()
    other = sea(seed=9)
    other.restore(saved)
    for world in (table.world, other):
        for _ in range(200):
            world.tick()
    assert prey not in other.population
    assert other.checksums() == table.world.checksums()
