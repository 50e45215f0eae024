"""Courtship passes through its four phases in order, together; who is left alone gives up."""

from types import ModuleType

import numpy as np
import pytest

from components.arrays import Float64s
from components.mind import Courtship
from systems.mind.behave.mate import JILTED, MATED, mate

LOOPING, CIRCLING, ASCENT, NUZZLING = (int(phase) for phase in list(Courtship)[1:])
TANG = np.array([0.85, 1.64, 2.44])


class Couple:
    """A male, 0, and a female, 1, some way apart."""

    def __init__(self, tank: ModuleType, leaves_at: int = 1 << 30, size: float = 0.25) -> None:
        self.scene = tank.Tank(
            size * np.array([[0.0, 0, -32], [16.0, 4, -34]]),
            np.array([[-1.0, 0, 0], [0, 1.0, 0]]),
            size * np.array([1.0, 1.1]),
            np.array([TANG, TANG]),
        )
        self.size, self.leaves_at = size, leaves_at
        self.phase, self.since = [0, 0], [0, 0]
        self.history: list[list[int]] = [[], []]
        self.path: list[Float64s] = []

    def _brain(self, t: object, me: int) -> tuple[int, float, float]:
        scene, other = self.scene, 1 - me
        if self.phase[me] >= MATED:
            scene.out[:] = scene.way[me]
            return 0, 0.0, 1.0
        gear, urgency, throttle, phase = mate(
            scene.crowd, me, other, me == 0, self.phase[me], self.since[me],
            int(scene.crowd.phase[other]), TANG, scene.now, -6.0 * self.size, scene.out,
        )  # fmt: skip
        if phase != self.phase[me]:
            self.history[me].append(phase)
            self.since[me], self.phase[me] = scene.now, phase
        return gear, urgency, throttle

    def live(self, ticks: int) -> None:
        for _ in range(ticks):
            brains = {0: self._brain}
            if self.scene.now < self.leaves_at:
                brains[1] = self._brain
            else:
                self.phase[1] = 0
            self.scene.crowd.phase[:] = [p if p < MATED else 0 for p in self.phase]
            self.scene.tick(brains)
            self.path.append(np.r_[self.phase[0], self.scene.place.ravel(), self.scene.speed])


@pytest.fixture(scope="module", params=[0.09, 0.25, 0.4])
def couple(tank: ModuleType, request: pytest.FixtureRequest) -> Couple:
    pair = Couple(tank, size=request.param)
    pair.live(2400)
    return pair


def during(couple: Couple, phase: int) -> Float64s:
    path: Float64s = np.array(couple.path)
    chosen: Float64s = path[path[:, 0] == phase]
    return chosen


def test_a_pair_mates_in_the_four_phases(couple: Couple) -> None:
    assert couple.history == [[LOOPING, CIRCLING, ASCENT, NUZZLING, MATED]] * 2


def test_the_male_loops_about_the_female_and_she_waits(couple: Couple) -> None:
    path = during(couple, LOOPING)[120:]
    apart = (path[:, 1:4] - path[:, 4:7]) / couple.size
    far = np.linalg.norm(apart, axis=1)
    assert (far < 2.5).all()
    assert path[:, 8].mean() < 0.3 * path[:, 7].mean()
    bearings = np.unwrap(np.arctan2(apart[:, 1], apart[:, 0]))
    assert abs(bearings[-1] - bearings[0]) > 2.0
    assert np.ptp(apart[:, 2]) > 0.4


def test_they_circle_head_to_tail(couple: Couple) -> None:
    path = during(couple, CIRCLING)[150:]
    apart = path[:, 1:4] - path[:, 4:7]
    bearings = np.unwrap(np.arctan2(apart[:, 1], apart[:, 0]))
    assert abs(bearings[-1] - bearings[0]) > 3.0
    assert (np.linalg.norm(apart, axis=1) < 3.0 * couple.size).all()
    assert np.linalg.norm(path[-1, 1:4] + path[-1, 4:7] - path[0, 1:4] - path[0, 4:7]) < couple.size


def test_they_rise_together(couple: Couple) -> None:
    path = during(couple, ASCENT)
    assert path[-1, 3] - path[0, 3] > 2.0 * couple.size
    assert path[-1, 6] - path[0, 6] > 2.0 * couple.size
    assert np.linalg.norm(path[-1, 1:4] - path[-1, 4:7]) < 4.0 * couple.size


def test_the_male_nudges_her_belly_from_below(couple: Couple) -> None:
    path = during(couple, NUZZLING)[-120:]
    assert (np.linalg.norm(path[:, 1:4] - path[:, 4:7], axis=1) < 1.6 * couple.size).all()
    assert (path[:, 3] < path[:, 6]).all()


@pytest.mark.parametrize(("leaves_at", "before"), [(0, []), (600, [LOOPING])])
def test_one_left_alone_gives_up(tank: ModuleType, leaves_at: int, before: list[int]) -> None:
    pair = Couple(tank, leaves_at)
    pair.live(2400)
    assert pair.history[0] == [*before, JILTED]
