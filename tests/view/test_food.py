"""Which particles of food are drawn, where, and how large."""

import numpy as np
import pytest

from components.camera import camera_at
from components.food import FoodTable
from systems.view.draw_food import FARTHEST, seen_food

CAMERA = camera_at(np.array([0.0, 0.0, -5.0]), 0.0, 0.0)


def particles(*ahead: float) -> FoodTable:
    """Return particles so far before the eye [m], moving along y."""
    food = FoodTable(count=len(ahead))
    food.position[: food.count] = food.last_position[: food.count] = (0.0, 0.0, -5.0)
    food.position[: food.count, 0] = food.last_position[: food.count, 0] = ahead
    food.position[: food.count, 1] = 0.2
    return food


def test_what_is_before_the_eye_near_and_in_the_water_is_drawn_from_far_to_near() -> None:
    food = particles(1.0, 3.0, 2.0, -1.0, FARTHEST + 1.0, 4.0)
    food.returns[5] = 101
    assert seen_food(food, CAMERA, 1.0, 100)[:, 0] == pytest.approx([3.0, 2.0, 1.0])
    assert len(seen_food(food, CAMERA, 1.0, 101)) == 4


def test_particles_stand_between_two_ticks_and_larger_meals_are_larger() -> None:
    food = particles(2.0, 1.0)
    food.meal[:2] = 0.4, 0.05
    large, small = seen_food(food, CAMERA, 0.25, 0)
    assert large[1] == pytest.approx(0.05)
    assert large[3] == pytest.approx(2.0 * small[3])


def test_a_sea_without_food_shows_none() -> None:
    assert seen_food(particles(), CAMERA, 1.0, 0).shape == (0, 5)
