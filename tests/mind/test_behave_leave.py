"""Who finds the water too dark goes up, too bright down; at the end of the water along the slope of the ground."""

from types import ModuleType
from typing import Any

import numpy as np
import pytest

from components.ground import Terrain, ground_height
from systems.mind.behave.leave import leave

TANG = np.array([0.85, 1.64, 2.44])


def at(tank: ModuleType, place: tuple[float, float, float]) -> Any:
    return tank.Tank(np.array([place]), np.array([[0.8, 0.6, 0]]), np.array([0.25]), TANG[None])


@pytest.fixture(scope="module")
def terrain(pond: ModuleType) -> Terrain:
    made: Terrain = pond.make_terrain(3, rocks=0)
    return made


@pytest.mark.parametrize("rise", [1.0, -1.0, 0.3, -0.3])
def test_it_goes_up_or_down_as_it_wants(tank: ModuleType, terrain: Terrain, rise: float) -> None:
    scene = at(tank, (2.0, 3.0, -6.0))
    gear, urgency, throttle = leave(terrain, scene.crowd, 0, rise, -10.0, -1.0, scene.out)
    assert scene.out[2] * rise > 0.0
    assert scene.out[:2] @ scene.way[0, :2] > 0.9
    assert (gear, throttle) == (1, 1.0)
    assert 0.1 < urgency < 0.5


@pytest.mark.parametrize("rise", [1.0, -1.0])
def test_at_the_end_of_the_water_it_follows_the_ground(
    tank: ModuleType, terrain: Terrain, rise: float
) -> None:
    scene = at(tank, (12.0, -9.0, -6.0))
    leave(terrain, scene.crowd, 0, rise, -6.0, -6.0, scene.out)
    assert scene.out[2] == 0.0
    lean = scene.out[:2] - scene.way[0, :2]

    def ground(x: float, y: float) -> float:
        return float(ground_height(terrain.height, terrain.extent, terrain.cell, x, y))

    slope = np.array([ground(14.0, -9.0), ground(12.0, -7.0)]) - ground(12.0, -9.0)
    assert lean @ slope * rise > 0.0
