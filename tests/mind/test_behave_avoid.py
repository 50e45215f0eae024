"""Avoiding: round walls and out of corners, braking head-on; past fishes and the submarine; never by a fast start."""

from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from components.arrays import Float64s
from systems.mind.behave.avoid_fish import avoid_fish, avoid_submarine, jostle
from systems.mind.behave.avoid_static_obstacle import avoid_static_obstacle, choose_side
from systems.motor.choose import MORTAL

TANG = np.array([0.85, 1.64, 2.44])
LENGTH = 0.25
ALARM = 0.8 * LENGTH + 0.2


def swim(tank: ModuleType, walls: Float64s, way: tuple[float, float], seconds: int) -> Float64s:
    """Return places, headings and throttles of a fish among walls: rows of a unit way out and its offset [m]."""
    scene = tank.Tank(
        np.array([[0.0, 0, -5]]), np.array([[*way, 0.0]]), np.array([LENGTH]), TANG[None]
    )
    side, seen = [0], []

    def wanderer(t: object, me: int) -> tuple[int, float, float]:
        here, ahead = scene.place[0], scene.way[0]
        antenna = here + ahead * (LENGTH + 0.8 * abs(scene.speed[0]))
        rooms = [min(w[:3] @ p + w[3] for p in (antenna, 0.5 * (here + antenna))) for w in walls]
        nearest = int(np.argmin(rooms))
        near = 1.0 - rooms[nearest] / ALARM
        if near < (-0.4 if side[0] else 0.0):
            side[0] = 0
            scene.out[:] = ahead
            return 1, 0.1, 1.0
        normal = np.ascontiguousarray(walls[nearest, :3])
        side[0] = choose_side(ahead[0], ahead[1], normal, side[0], 0)
        found: tuple[int, float, float] = avoid_static_obstacle(
            ahead[0], ahead[1], ahead[2], normal, min(max(near, 0.0), 1.0), side[0], scene.out
        )
        return found

    for _ in range(60 * seconds):
        scene.tick({0: wanderer})
        seen.append(np.r_[scene.place[0], scene.way[0], scene.throttle[0]])
    return np.array(seen)


WALL = np.array([[-1.0, 0.0, 0.0, 3.0]])
CORNER = np.array([[-1.0, 0.0, 0.0, 3.0], [0.0, -1.0, 0.0, 3.0]])
POCKET = np.array([[-1.0, 0.0, 0.0, 3.0], [0.0, -1.0, 0.0, 0.6], [0.0, 1.0, 0.0, 0.6]])


@pytest.mark.parametrize(
    ("walls", "way"),
    [
        (WALL, (1.0, 0.0)),
        (WALL, (0.9, 0.4)),
        (CORNER, (0.7, 0.7)),
        (CORNER, (0.7, 0.71)),
        (POCKET, (1.0, 0.0)),
    ],
)
def test_a_wanderer_turns_before_walls_and_out_of_corners(
    tank: ModuleType, walls: Float64s, way: tuple[float, float]
) -> None:
    path = swim(tank, walls, way, 25)
    rooms = path[:, :3] @ walls[:, :3].T + walls[:, 3]
    assert rooms.min() > 0.4 * LENGTH
    assert path[-1, 0] < 2.9
    steps = np.linalg.norm(np.diff(path[:, :3], axis=0), axis=1)
    assert np.convolve(steps, np.ones(180), "valid").min() > 0.2


def test_head_on_it_brakes_and_backs_up_when_too_near() -> None:
    out, normal = np.zeros(3), np.array([-1.0, 0.0, 0.0])

    def throttle(near: float, hx: float, hy: float) -> float:
        return float(avoid_static_obstacle(hx, hy, 0.0, normal, near, 1, out)[2])

    assert throttle(0.1, 1.0, 0.0) == 1.0
    assert 0.0 < throttle(0.5, 1.0, 0.0) < 0.8
    assert throttle(0.9, 1.0, 0.0) == pytest.approx(-0.2)
    assert throttle(0.9, 0.0, 1.0) == 1.0
    assert throttle(0.9, -1.0, 0.0) == 1.0


def test_a_side_once_chosen_is_kept() -> None:
    normal = np.array([-1.0, 0.0, 0.0])
    assert choose_side(0.9, 0.4, normal, 0, 1) == -choose_side(0.9, -0.4, normal, 0, 1)
    assert choose_side(1.0, 0.0, normal, 0, 0) == -choose_side(1.0, 0.0, normal, 0, 1)
    assert choose_side(0.9, 0.4, normal, 1, 0) == 1
    assert choose_side(0.9, 0.4, normal, -1, 0) == -1


def test_obstacles_and_fishes_are_no_matter_of_life_and_death(tank: ModuleType) -> None:
    out, normal = np.zeros(3), np.array([-1.0, 0.0, 0.0])
    assert avoid_static_obstacle(1.0, 0.0, 0.0, normal, 1.0, 1, out)[1] < MORTAL
    scene = pair(tank, (0.5, 0.0, 0.0), (-1.0, 0.0, 0.0))
    assert avoid_fish(scene.crowd, 0, 1, 0.0, scene.out)[1] < MORTAL
    assert avoid_submarine(scene.crowd, 0, normal, 0.0, out)[1] < MORTAL


def pair(
    tank: ModuleType, offset: tuple[float, float, float], way: tuple[float, float, float]
) -> Any:
    return tank.Tank(
        np.array([(0.0, 0, -5), np.add(offset, (0, 0, -5))]), np.array([(1.0, 0, 0), way]),
        np.array([0.25, 0.25]), np.array([TANG, TANG]),
    )  # fmt: skip


def test_two_that_meet_swerve_apart(tank: ModuleType) -> None:
    scene = pair(tank, (0.8, 0.05, 0.0), (-1.0, 0.0, 0.0))
    avoid_fish(scene.crowd, 0, 1, 0.8, scene.out)
    mine = np.array(scene.out)
    avoid_fish(scene.crowd, 1, 0, 0.8, scene.out)
    assert mine[1] < 0.0 < scene.out[1]


def test_one_that_comes_up_behind_slows_down(tank: ModuleType) -> None:
    scene = pair(tank, (0.5, 0.0, 0.0), (1.0, 0.1, 0.0))
    scene.crowd.speed[:] = (0.4, 0.2)
    assert avoid_fish(scene.crowd, 0, 1, 0.8, scene.out)[2] == pytest.approx(0.5)
    assert avoid_fish(scene.crowd, 1, 0, 0.8, scene.out)[2] == 1.0


def test_a_fish_turns_from_the_submarine(tank: ModuleType) -> None:
    scene = pair(tank, (9.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    avoid_submarine(scene.crowd, 0, np.array([-2.0, 0.5, 0.0]), 0.2, scene.out)
    assert scene.out[0] < 0.0 < scene.out[1]


def jostled(tank: ModuleType, others: Float64s, wanted: Float64s) -> Float64s:
    """Return what a fish at (0, 0, -5) wants that wanted a direction and has neighbours at some offsets [m]."""
    number = len(others) + 1
    place = np.vstack([np.zeros(3), others]) + np.array([0.0, 0, -5])
    scene = tank.Tank(
        place,
        np.tile([1.0, 0, 0], (number, 1)),
        np.full(number, LENGTH),
        np.tile(TANG, (number, 1)),
    )
    near, square = scene.nearest(0, np.arange(number))
    out = wanted.copy()
    jostle(scene.crowd, 0, near, square, min(number - 1, 8), out)
    return out


@given(
    place=arrays(float, 3, elements=st.floats(-0.09, 0.09)),
    wanted=arrays(float, 3, elements=st.floats(-3.0, 3.0)),
)
def test_who_is_pressed_leans_away_and_the_harder_it_wants_the_harder(
    tank: ModuleType, place: Float64s, wanted: Float64s
) -> None:
    assume(np.linalg.norm(place) > 1e-3)
    away = -place / np.linalg.norm(place)
    push = jostled(tank, place[None], wanted) - wanted
    size = float(np.linalg.norm(push))
    np.testing.assert_allclose(push, size * away, atol=1e-9)
    share = 2.0 * (1.0 - float(np.linalg.norm(place)) / (0.6 * LENGTH))
    assert size == pytest.approx(max(share, 0.0) * float(np.linalg.norm(wanted)), abs=1e-6)


def test_who_has_room_is_not_jostled_and_who_is_shut_in_evenly_goes_on(tank: ModuleType) -> None:
    wanted, side = np.array([1.0, 0.2, 0.0]), np.array([[0.0, 0.1, 0.0], [0.0, -0.1, 0.0]])
    assert jostled(tank, 1.6 * side, wanted).tolist() == wanted.tolist()
    assert jostled(tank, np.zeros((0, 3)), wanted).tolist() == wanted.tolist()
    np.testing.assert_allclose(jostled(tank, side, wanted), wanted, atol=1e-9)
    assert jostled(tank, side[:1], wanted)[1] < -0.2
