"""A chaser leads its target, comes alongside and stays there."""

from types import ModuleType

import numpy as np
import pytest

from components.arrays import Float64s
from systems.mind.behave.chase_target import chase_target, turn_finely
from systems.motor.choose import TURN_FROM

BARRACUDA = np.array([0.5, 1.05, 1.5])
TANG = np.array([0.85, 1.64, 2.44])


def chase(tank: ModuleType, way: tuple[float, float, float], eagerness: float) -> Float64s:
    """Return the distances [m] of twenty seconds, ten a second."""
    place = np.array([[0.0, 0.0, -5.0], [6.0, 3.0, -4.0]])
    scene = tank.Tank(
        place, np.array([[-1.0, 0, 0], way]), np.array([1.1, 0.25]), np.array([BARRACUDA, TANG])
    )

    def chaser(t: object, me: int) -> tuple[int, float, float]:
        x, y, z = scene.place[1] - scene.place[0]
        u, v, w = scene.way[1] * scene.speed[1]
        found: tuple[int, float, float] = chase_target(
            scene.crowd, me, scene.speeds[me], x, y, z, u, v, w, eagerness, scene.out
        )
        return found

    apart = []
    for _ in range(200):
        scene.tick({0: chaser}, 6)
        apart.append(float(np.linalg.norm(scene.place[1] - scene.place[0])))
    return np.array(apart)


@pytest.mark.parametrize("way", [(0.0, 1.0, 0.0), (-1.0, 0.2, 0.0), (1.0, 0.0, 0.1)])
@pytest.mark.parametrize("eagerness", [0.2, 0.9])
def test_a_slow_target_is_caught_and_never_overrun(
    tank: ModuleType, way: tuple[float, float, float], eagerness: float
) -> None:
    apart = chase(tank, way, eagerness)
    assert apart[-1] < 0.8
    assert apart.min() > 0.05
    assert (apart[np.argmax(apart < 1.0) :] < 1.2).all()


def test_the_eager_come_sooner(tank: ModuleType) -> None:
    slow, quick = (np.argmax(chase(tank, (0.0, 1.0, 0.0), e) < 1.0) for e in (0.2, 0.9))
    assert quick < 0.85 * slow


def test_it_steers_to_where_the_target_will_be(tank: ModuleType) -> None:
    scene = tank.Tank(
        np.array([[0.0, 0, -5]]), np.array([[1.0, 0, 0]]), np.array([0.25]), TANG[None]
    )
    chase_target(scene.crowd, 0, TANG, 2.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.5, scene.out)
    assert scene.out[0] > 0.0
    assert scene.out[1] > 0.1


@pytest.mark.parametrize("bearing", [5, 30, 60, 120, 175, 180, -90])
def test_a_fine_turn_keeps_within_what_needs_no_turn_segment(
    tank: ModuleType, bearing: int
) -> None:
    scene = tank.Tank(
        np.array([[0.0, 0, -5]]), np.array([[1.0, 0, 0]]), np.array([0.25]), TANG[None]
    )
    turn = np.radians(bearing)
    scene.out[:] = 2.0 * np.cos(turn), 2.0 * np.sin(turn), 0.0
    turn_finely(scene.crowd, 0, scene.out)
    asked = np.arctan2(scene.out[1], scene.out[0])
    assert abs(asked) < TURN_FROM
    assert abs(asked) == pytest.approx(min(abs(turn), np.radians(40)), abs=0.01)
    assert bearing == 180 or asked * turn > 0.0
