"""Where `reefgame shot` takes its picture from when nobody says."""

import numpy as np
import pytest

from components.camera import Camera
from components.terrain import clearance, ground, sees
from reefgame.content import load
from reefgame.filming import COCKPIT_SLOPE, cockpit
from reefgame.viewpoint import viewpoint
from reefgame.world import World


@pytest.fixture(scope="module", params=["first_dive", "visitors"])
def world(request: pytest.FixtureRequest) -> World:
    dive = World.build(load(request.param), 1)
    for _ in range(60):
        dive.tick()
    return dive


@pytest.fixture(scope="module")
def camera(world: World) -> Camera:
    return viewpoint(world)


def test_the_eye_is_in_free_water(world: World, camera: Camera) -> None:
    terrain, (x, y, z) = world.terrain, camera.eye
    assert clearance(terrain, x, y, z)[0] > 0.4
    assert ground(terrain.height, terrain.extent, terrain.cell, x, y)[0] + 0.6 < z < -0.5
    assert sees(terrain, camera.eye, camera.eye + 2.0 * camera.forward)


def test_most_of_the_school_is_in_the_upper_half_of_the_picture(
    world: World, camera: Camera
) -> None:
    fish = world.population.fish
    species = fish.species[: fish.count]
    school = fish.position[: fish.count][species == np.bincount(species).argmax()]
    away = school - camera.eye
    ahead = away @ camera.forward
    across = away @ camera.right / (ahead * COCKPIT_SLOPE * 16 / 9)
    height = away @ camera.up / (ahead * COCKPIT_SLOPE)
    inside = (ahead > 0) & (np.abs(across) < 1) & (np.abs(height) < 1)
    assert inside.mean() > 0.7
    assert np.median(height) > 0.1
    assert np.median(ahead) < 8.0


def test_without_fishes_the_submarine_looks() -> None:
    dive = World.build(load("first_dive"), 1)
    for identity in dive.population.fish.live("id").tolist():
        dive.population.remove(int(identity))
    assert (viewpoint(dive).eye == cockpit(dive).eye).all()
