"""A school closes ranks, splits round a predator that comes through, and is one again soon after."""

from types import ModuleType
from typing import Any

import numpy as np
import pytest

from components.arrays import Float64s
from systems.mind.behave.school import heed, part, school, split
from systems.mind.perceive import in_view

BARRACUDA = np.array([0.5, 1.05, 1.5])
SARDINE = np.array([1.13, 2.22, 3.38])
NUMBER = 26
SIGHT = 6.0


class Shoal:
    """Sardines that travel along x, and a barracuda, the last, that swims its course."""

    def __init__(self, tank: ModuleType, seed: int, gear: int) -> None:
        rng = np.random.default_rng(seed)
        place = rng.uniform(-0.6, 0.6, (NUMBER + 1, 3)) + np.array([0, 0, -5.0])
        way = np.array([1.0, 0, 0]) + rng.normal(0, 0.1, (NUMBER + 1, 3))
        place[-1], way[-1] = (90.0, 0, -5), (-1.0, 0, 0)
        length = np.append(rng.uniform(0.18, 0.22, NUMBER), 1.1)
        self.scene = tank.Tank(place, way, length, np.array([*[SARDINE] * NUMBER, BARRACUDA]), seed)
        self.gear, self.danger, self.shoal = gear, np.zeros(7), np.zeros(6)
        self.brains = dict.fromkeys(range(NUMBER), self._sardine)
        self.brains[NUMBER] = self._barracuda

    def _barracuda(self, t: object, me: int) -> tuple[int, float, float]:
        self.scene.out[:] = self.scene.way[me]
        return self.gear, 0.3, 1.0

    def _sardine(self, t: object, me: int) -> tuple[int, float, float]:
        scene, all_of_them = self.scene, np.arange(NUMBER)
        near, distance = scene.nearest(me, all_of_them)
        seen = [
            k for k in range(8)
            if distance[k] < 0.36 and in_view(*(scene.place[near[k]] - scene.place[me]), *scene.way[me])
        ]  # fmt: skip
        near[: len(seen)], distance[: len(seen)] = near[seen], distance[seen]
        others = all_of_them[all_of_them != me]
        self.shoal[:3] = (scene.place[others] - scene.place[me]).mean(axis=0)
        self.shoal[3:] = scene.way[others].mean(axis=0)
        away = scene.place[-1] - scene.place[me]
        far, alarm = float(np.linalg.norm(away)), 0.0
        self.danger[6] = 0.0
        if far < SIGHT and in_view(*away, *scene.way[me]):
            x, y, z = away
            u, v, w = scene.way[-1] * scene.speed[-1]
            heed(x, y, z, u, v, w, 1.1, self.danger)
            alarm = min(1.5 / far, 1.0)
        x, _y, _z = scene.place[me]
        found: tuple[int, float, float] = school(
            scene.crowd, me, near, distance, len(seen), self.shoal, NUMBER - 1.0,
            1.15 * scene.length[me], x + 20.0, 0.0, -5.0, int(scene.gear[me]), alarm, self.danger,
            np.zeros(3), 0.0, scene.out,
        )  # fmt: skip
        scene.out[2] *= 0.7
        return found

    def send(self, ahead: float) -> None:
        """Let the barracuda come from `ahead` [m] straight through the school."""
        scene = self.scene
        scene.place[-1] = scene.place[:-1].mean(axis=0) + np.array([ahead, 0.1, 0])
        scene.way[-1] = (-1.0, 0.0, 0.0)

    def apart(self) -> Float64s:
        place = self.scene.place[:-1]
        apart: Float64s = np.linalg.norm(place[:, None] - place[None], axis=2)
        return apart + 9.0 * np.eye(NUMBER)

    def largest_group(self) -> int:
        """Return how many hang together by gaps of at most a metre."""
        touching = (self.apart() < 1.0) | np.eye(NUMBER, dtype=bool)
        for _ in range(6):
            touching = touching.astype(int) @ touching.astype(int) > 0
        return int(touching.sum(axis=1).max())

    def polarisation(self) -> float:
        return float(np.linalg.norm(self.scene.way[:-1].mean(axis=0)))

    def to_the_barracuda(self) -> float:
        scene = self.scene
        return float(np.linalg.norm(scene.place[:-1] - scene.place[-1], axis=1).min())


@pytest.mark.parametrize(("seed", "gear"), [(1, 1), (3, 2)])
def test_a_school_splits_round_a_predator_and_rejoins(
    tank: ModuleType, seed: int, gear: int
) -> None:
    shoal = Shoal(tank, seed, gear)
    shoal.scene.tick(shoal.brains, 480)
    settled = np.median(shoal.apart().min(axis=1) / shoal.scene.length[:-1])
    assert shoal.polarisation() > 0.8
    assert 0.5 < settled < 1.5
    shoal.send(6.0)
    groups, sides, nearest = [], [], []
    for _ in range(40):
        shoal.scene.tick(shoal.brains, 15)
        groups.append(shoal.largest_group())
        nearest.append(shoal.to_the_barracuda())
        offset = shoal.scene.place[:-1] - shoal.scene.place[-1]
        beside = offset[np.abs(offset[:, 0]) < 1.0, 1]
        sides.append((int((beside > 0.1).sum()), int((beside < -0.1).sum())))
    assert max(min(left, right) for left, right in sides) >= 3
    assert min(nearest) > 0.25
    shoal.scene.tick(shoal.brains, 30 * 60 - 600)
    assert shoal.largest_group() == NUMBER
    assert shoal.polarisation() > 0.8
    assert 0.5 < np.median(shoal.apart().min(axis=1) / shoal.scene.length[:-1]) < 1.5


def one(tank: ModuleType) -> Any:
    return tank.Tank(
        np.array([[0.0, 0, -5]]), np.array([[1.0, 0, 0]]), np.array([0.2]), SARDINE[None]
    )


def test_who_is_afraid_closes_ranks(tank: ModuleType) -> None:
    def drawn(alarm: float) -> float:
        scene = tank.Tank(
            np.array([[0.0, 0, -5], [0.0, 0.24, -5]]), np.tile([1.0, 0, 0], (2, 1)),
            np.array([0.2, 0.2]), np.array([SARDINE, SARDINE]),
        )  # fmt: skip
        near, square = scene.nearest(0, np.arange(2))
        school(
            scene.crowd, 0, near, square, 1, np.zeros(6), 0.0, 0.23, 20.0, 0.0, -5.0, 1, alarm,
            np.zeros(7), np.zeros(3), 0.0, scene.out,
        )  # fmt: skip
        return float(scene.out[1] / scene.out[0])

    assert drawn(1.0) > drawn(0.0) + 0.02


def test_a_small_shoal_draws_its_members_and_a_large_one_lets_cohorts_travel(
    tank: ModuleType,
) -> None:
    def northward(number: float) -> float:
        scene, shoal = one(tank), np.array([0.0, 5.0, 0.0, 0.0, 1.0, 0.0])
        school(
            scene.crowd, 0, np.zeros(8, np.int64), np.zeros(8), 0, shoal, number, 0.23, 0.0, -20.0,
            -5.0, 1, 0.0, np.zeros(7), np.zeros(3), 0.0, scene.out,
        )  # fmt: skip
        return float(scene.out[1])

    assert northward(24.0) == northward(100.0) > 0.3
    assert northward(1000.0) < -0.1
    assert northward(4000.0) < northward(1000.0)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_each_gives_way_to_its_own_side_then_goes_back_along_the_path(
    tank: ModuleType, side: float
) -> None:
    scene, danger = one(tank), np.zeros(7)

    def wanted(x: float, y: float) -> Float64s:
        heed(x, y, 0.0, -1.2, 0.0, 0.0, 1.1, danger)
        scene.out[:] = (1.0, 0.0, 0.0)
        assert split(scene.crowd, 0, danger, scene.out) > 0.0
        return np.array(scene.out)

    before, beside = wanted(1.0, -0.3 * side), wanted(0.0, -0.6 * side)
    assert before[1] * side > 0.8
    assert beside[0] > 1.5
    heed(9.0, 0.0, 0.0, -1.2, 0.0, 0.0, 1.1, danger)
    scene.out[:] = (1.0, 0.0, 0.0)
    assert split(scene.crowd, 0, danger, scene.out) == 0.0
    assert scene.out.tolist() == [1.0, 0.0, 0.0]


def test_a_school_parts_along_what_stands_in_its_way(tank: ModuleType) -> None:
    out = np.array([1.0, 0.2, 0.0])
    part(1.0, 0.0, 0.0, np.array([-1.0, 0.0, 0.0]), 1.0, out)
    assert out[0] <= 0.0
    assert out[1] == 0.2
