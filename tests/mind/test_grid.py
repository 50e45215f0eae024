"""The grid against looking at everybody: same neighbours, whatever the crowding."""

from types import ModuleType

import numpy as np
import pytest

from systems.mind.attention import NEIGHBOURS, make_attention
from systems.mind.gather import gather
from systems.mind.nearest import nearest_of_kind
from systems.mind.perceive import LATERAL_LINE, see_around


def nearest_by_brute_force(pond, me: int, reach: float) -> list[int]:  # type: ignore[no-untyped-def]
    fish, count = pond.population.fish, pond.population.count
    offset = fish.position[:count] - fish.position[me]
    square = (offset[:, 0] ** 2 + offset[:, 1] ** 2) + offset[:, 2] ** 2
    axis = fish.rotation[me, :, 0]
    along = offset @ axis
    felt = LATERAL_LINE * fish.length[me]
    seen = (along >= 0) | (along**2 < 0.75 * square) | (square < felt * felt)
    seen &= (square <= reach * reach) & (fish.species[:count] == fish.species[me])
    seen[me] = False
    rows = np.flatnonzero(seen)
    return list(rows[np.lexsort((fish.id[rows], square[rows]))][:NEIGHBOURS])


@pytest.mark.parametrize(
    ("sardines", "tangs", "spread"),
    [(40, 10, 2.0), (700, 100, 2.0), (1000, 0, 0.02), (900, 300, 5.0)],
)
def test_neighbours_are_those_of_brute_force(
    pond: ModuleType, sardines: int, tangs: int, spread: float
) -> None:
    scene = pond.Pond(sardines, tangs, spread=spread)
    grid, attention = scene.think.grid, make_attention()
    scene.think()
    plan, crowd = grid.plan, grid.crowd
    several = 0
    for place in range(0, sardines + tangs, 7):
        around = gather(plan, crowd, crowd.column[place], crowd.layer[place], attention, 0)
        many, _ = see_around(crowd, place, plan.cell, True, True, around, attention, 0)
        near, square = attention.sought[0], attention.sought_distance[0]
        found = nearest_of_kind(many, attention, 0, near, square)
        rows = [int(crowd.row[k]) for k in near[:found]]
        assert rows == nearest_by_brute_force(scene, int(crowd.row[place]), plan.cell)
        several += found > 1
    assert several > 0


def test_every_fish_stands_in_its_column_once(pond: ModuleType) -> None:
    scene = pond.Pond(300, 50, spread=5.0)
    grid = scene.think.grid
    scene.think()
    crowd, side = grid.crowd, grid.plan.columns
    assert sorted(crowd.row[:350].tolist()) == list(range(350))
    assert crowd.first[0] == 0
    assert crowd.first[side * side] == 350
    assert np.all(np.diff(crowd.first[: side * side + 1]) >= 0)
    for k in range(350):
        column = crowd.column[k]
        assert crowd.first[column] <= k < crowd.first[column + 1]
        if k > crowd.first[column]:
            assert (crowd.layer[k - 1], crowd.id[k - 1]) < (crowd.layer[k], crowd.id[k])


def test_shoals_count_the_schooling_alone(pond: ModuleType) -> None:
    scene = pond.Pond(120, 30, spread=4.0)
    scene.think()
    squares = scene.think.grid.plan.squares**2
    numbers = scene.think.grid.crowd.shoal[:, :squares, 0].sum(axis=1)
    assert numbers.tolist() == [120, 0]


def test_each_sees_the_shoal_of_its_own_kind_around_its_own_square(pond: ModuleType) -> None:
    scene = pond.Pond(40, 24, spread=14.0)
    scene.senses.schooling[:] = 1
    scene.think()
    plan, crowd, thoughts = scene.think.grid.plan, scene.think.grid.crowd, scene.think._thoughts
    column, kind = crowd.column[:64], crowd.species[:64]
    x, y = column // plan.columns // plan.block, column % plan.columns // plan.block
    place = np.stack([crowd.x, crowd.y, crowd.z], axis=1)[:64]
    shoals = set()
    for me in range(64):
        assert thoughts.me[me] == me
        near = (abs(x - x[me]) <= 1) & (abs(y - y[me]) <= 1) & (kind == kind[me])
        near[me] = False
        seen, number = int(thoughts.number[me]), int(near.sum())
        offset = place[near].mean(axis=0) - place[me] if number else np.full(3, np.inf)
        sight = 2.0 * scene.senses.sight[kind[me]]
        assert seen == (number if np.linalg.norm(offset) <= sight else 0)
        if seen:
            np.testing.assert_allclose(thoughts.shoal[me, :3], offset, atol=1e-4)
            shoals.add((kind[me], x[me], y[me]))
    assert len(shoals) > 4
