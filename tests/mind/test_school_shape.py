"""The school of first_dive, fed and not in the mood: polarised, near, longer than wide where no home binds it."""

from dataclasses import replace

import numpy as np
import pytest

from components.arrays import Float64s
from reefgame.content import load
from reefgame.world import World

SEEDS = [1, 7, pytest.param(2, marks=pytest.mark.prove), pytest.param(3, marks=pytest.mark.prove)]


def sardines(world: World) -> tuple[Float64s, Float64s, Float64s]:
    """Return positions [m], headings and lengths [m] of the school."""
    fish, kind = world.population.fish, [s.name for s in world.species].index("sardine")
    rows = np.flatnonzero(fish.live("species") == kind)
    return fish.position[rows], fish.rotation[rows][:, :, 0], fish.length[rows]


@pytest.mark.parametrize("seed", SEEDS)
def test_a_school_is_polarised_near_and_longer_than_wide_or_high(seed: int) -> None:
    content = load("first_dive")
    roaming = content.level.model_copy(update={"homes": ()})
    world = World.build(replace(content, level=roaming), seed)
    mind = world.population.mind
    mind.eaten[: mind.count], mind.ate_at[: mind.count] = 100.0, 0
    mind.mated_at[: mind.count] = 40 * 60
    for _ in range(40 * 60):
        world.tick()
    position, heading, length = sardines(world)
    course = heading.mean(axis=0)
    assert np.linalg.norm(course) > 0.9
    apart = np.linalg.norm(position[:, None] - position[None], axis=2) + 9.0 * np.eye(len(length))
    assert 0.5 < np.median(apart.min(axis=1) / length) < 1.5
    course[2] = 0.0
    ahead = course / np.linalg.norm(course)
    aside = np.array([-ahead[1], ahead[0], 0.0])
    long, wide, high = (np.std(position @ axis) for axis in (ahead, aside, np.eye(3)[2]))
    assert long > 1.2 * wide
    assert long > 1.5 * high


def test_a_school_that_nobody_hunts_keeps_to_its_home() -> None:
    content = load("first_dive")
    peaceful = tuple(group for group in content.level.fishes if group.species != "barracuda")
    world = World.build(
        replace(content, level=content.level.model_copy(update={"fishes": peaceful})), 1
    )
    kind = [s.name for s in world.species].index("sardine")
    home = world.terrain.home[world.terrain.home_species == kind][0]
    away = []
    for tick in range(120 * 60):
        world.tick()
        if tick % 60 == 59:
            away.append(np.linalg.norm(sardines(world)[0].mean(axis=0)[:2] - home[:2]))
    assert np.median(away) < home[3] + 1.0
    assert max(away) < home[3] + 5.0
