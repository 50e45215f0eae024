"""An eater slows down, opens its mouth and reaches its meal from wherever it starts; a hunter gets some of its prey."""

from types import ModuleType

import numpy as np
import pytest

from systems.mind.behave.eat import eat
from systems.mind.behave.escape import escape

BARRACUDA = np.array([0.5, 1.05, 1.5])
SARDINE = np.array([1.13, 2.22, 3.38])
TANG = np.array([0.85, 1.64, 2.44])
NOSE = 0.28
NEAR = 2.5
CALM = 5.0


@pytest.mark.parametrize("bearing", [0, 90, 135, 180])
@pytest.mark.parametrize("distance", [0.15, 0.4, 2.0])
def test_a_fish_reaches_what_drifts_and_is_slow_when_it_does(
    tank: ModuleType, bearing: int, distance: float
) -> None:
    turn = np.radians(bearing)
    meal = np.array([distance * np.cos(turn), distance * np.sin(turn), -5.0 + 0.2 * distance])
    scene = tank.Tank(
        np.array([[0.0, 0, -5]]), np.array([[1.0, 0, 0]]), np.array([0.25]), TANG[None]
    )
    reached = []

    def eater(t: object, me: int) -> tuple[int, float, float]:
        away = meal - scene.place[0]
        x, y, z = away
        gear, urgency, throttle, gape = eat(
            scene.crowd,
            0,
            TANG,
            x,
            y,
            z,
            0.0,
            0.0,
            0.0,
            NOSE,
            0.35,
            0.8,
            False,
            scene.now,
            scene.out,
        )
        gap = np.linalg.norm(away - NOSE * 0.25 * scene.way[0])
        if gape > 0.5 and gap < 0.35 * 0.25:
            reached.append(float(scene.speed[0]))
        return gear, urgency, throttle

    while not reached and scene.now < 600:
        scene.tick({0: eater})
    assert reached
    assert reached[0] < 0.4


def hunt(tank: ModuleType, seed: int, flees: bool) -> tuple[bool, float]:
    """Return whether a barracuda got a lone sardine in 25 s, and how far they are then."""
    scene = tank.Tank(
        np.array([[0.0, 0, -5], [4.0, 0, -5.2]]),
        np.array([[1.0, 0, 0], [np.cos(seed), np.sin(seed), 0]]),
        np.array([1.1, 0.2]),
        np.array([BARRACUDA, SARDINE]),
        seed,
    )
    afraid, caught = [False], [False]
    nowhere, nobody = np.zeros(3), np.zeros(6)

    def prey(t: object, me: int) -> tuple[int, float, float]:
        apart = np.linalg.norm(scene.place[0] - scene.place[1])
        afraid[0] = bool(flees and apart < (CALM if afraid[0] else NEAR))
        if not afraid[0]:
            scene.out[:] = scene.way[1] * (1, 1, 0)
            return 1, 0.1, 1.0
        found: tuple[int, float, float] = escape(
            scene.crowd, 1, np.zeros(8, np.int64), 1, nowhere, 0.0, nowhere, False, nobody, 0.0,
            seed, scene.now, scene.out,
        )  # fmt: skip
        return found

    def hunter(t: object, me: int) -> tuple[int, float, float]:
        away = scene.place[1] - scene.place[0]
        x, y, z = away
        u, v, w = scene.way[1] * scene.speed[1]
        gear, urgency, throttle, gape = eat(
            scene.crowd, 0, BARRACUDA, x, y, z, u, v, w, NOSE, 0.2, 0.9, True, scene.now, scene.out
        )
        gap = np.linalg.norm(away - NOSE * 1.1 * scene.way[0])
        caught[0] |= bool(gape > 0.5 and gap < 0.2 * 1.1)
        return gear, urgency, throttle

    while not caught[0] and scene.now < 1500:
        scene.tick({0: hunter, 1: prey})
    return caught[0], float(np.linalg.norm(scene.place[0] - scene.place[1]))


def test_prey_that_does_not_flee_is_caught(tank: ModuleType) -> None:
    assert all(hunt(tank, seed, False)[0] for seed in range(6))


def test_most_prey_that_flees_gets_away_and_some_does_not(tank: ModuleType) -> None:
    caught = [hunt(tank, seed, True)[0] for seed in range(16)]
    assert 1 <= sum(caught) <= 10


def test_a_mouth_opens_only_before_its_meal(tank: ModuleType) -> None:
    scene = tank.Tank(
        np.array([[0.0, 0, -5]]), np.array([[1.0, 0, 0]]), np.array([0.25]), TANG[None]
    )

    def gape(x: float, y: float) -> float:
        found: float = eat(
            scene.crowd, 0, TANG, x, y, 0.0, 0.0, 0.0, 0.0, NOSE, 0.35, 0.8, False, 0, scene.out
        )[3]
        return found

    assert gape(0.1, 0.0) == 1.0
    assert gape(2.0, 0.0) == 0.0
    assert gape(-0.05, 0.0) == 0.0
    assert gape(0.0, 0.1) == 0.0
