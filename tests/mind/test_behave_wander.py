"""The curious come, stand and look, go round; after a while they lose interest. Homebodies stay near home."""

import itertools
from types import ModuleType

import numpy as np
import pytest

from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND
from systems.mind.behave.wander import (
    INTEREST_TICKS,
    LOOK_TICKS,
    choose_place,
    is_curious,
    visit,
    wander,
)

ANGELFISH = np.array([0.59, 1.22, 1.9])
RING = 3.5


def approach(tank: ModuleType, start: tuple[float, float, float], seconds: int) -> Float64s:
    """Return offsets [m] from the submarine, headings and speeds [m/s], one row a tick."""
    scene = tank.Tank(
        np.array([start]) + np.array([0, 0, -6.0]),
        np.array([[0.0, 1, 0]]),
        np.array([0.35]),
        ANGELFISH[None],
    )
    ship, seen = np.array([0.0, 0, -6]), []

    def curious(t: object, me: int) -> tuple[int, float, float]:
        found: tuple[int, float, float] = visit(
            scene.crowd, 0, ANGELFISH, scene.place[0] - ship, RING, scene.now, scene.out
        )
        return found

    for _ in range(seconds * TICKS_PER_SECOND):
        scene.tick({0: curious})
        seen.append(np.r_[scene.place[0] - ship, scene.way[0], scene.speed[0]])
    return np.array(seen)


@pytest.mark.parametrize("start", [(9.0, 2.0, 1.0), (-6.0, 0.0, -1.0), (1.0, 0.5, 0.0)])
def test_the_curious_come_to_a_ring_and_keep_to_it(
    tank: ModuleType, start: tuple[float, float, float]
) -> None:
    path = approach(tank, start, 60)
    far = np.linalg.norm(path[-1800:, :3], axis=1)
    assert (np.abs(far - RING) < 1.3).all()


def test_they_stand_and_look_and_go_round_in_turn(tank: ModuleType) -> None:
    path = approach(tank, (9.0, 2.0, 1.0), 60)[-1800:]
    offset = path[:, :3] / np.linalg.norm(path[:, :3], axis=1, keepdims=True)
    faces = -(offset * path[:, 3:6]).sum(axis=1)
    stands = np.abs(path[:, 6]) < 0.05
    assert ((faces > 0.9) & stands).sum() > LOOK_TICKS
    assert ((np.abs(faces) < 0.6) & ~stands).sum() > LOOK_TICKS // 2


def test_interest_comes_and_goes_by_chance() -> None:
    kept = [is_curious(3, now, 5, 0.5) for now in range(0, 40 * INTEREST_TICKS, 60)]
    turns = sum(a != b for a, b in itertools.pairwise(kept))
    assert 5 < turns < 36
    assert 0.25 < np.mean(kept) < 0.75
    assert not any(is_curious(3, now, 5, 0.0) for now in range(0, 9000, 60))
    assert all(is_curious(3, now, 5, 1.0) for now in range(0, 9000, 60))


def test_one_with_a_home_never_goes_far(pond: ModuleType) -> None:
    home = (3.0, -2.0, -8.0)
    terrain = pond.make_terrain(1).with_homes(
        [((-20.0, 9.0, -8.0), 1), (home, 1), ((3.5, -2.5, -8.0), 0)]
    )
    places = np.array([choose_place(terrain, 1, 3.5, -2.5, 7, now, 2) for now in range(200)])
    apart = np.linalg.norm(places - home[:2], axis=1)
    assert apart.max() < 2.5
    assert apart.max() > 0.5


def test_some_legs_are_brisk_and_some_nearly_a_stop() -> None:
    way, out = np.array([0.6, 0.8, 0.0]), np.zeros(3)
    legs = [wander(way, drawn, out) for drawn in np.linspace(0, 0.999, 50)]
    assert {gear for gear, _, _ in legs} == {0, 1}
    assert min(throttle for _, _, throttle in legs) < 0.5
    assert out.tolist() == way.tolist()
