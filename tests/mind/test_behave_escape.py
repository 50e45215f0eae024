"""Flight: away from all predators, in zig-zag, to shelter or the school; a fast start with one upon it."""

from types import ModuleType

import numpy as np
import pytest

from components.arrays import Float64s
from systems.mind.behave.escape import ZIGZAG_TICKS, escape, find_shelter
from systems.motor.choose import MORTAL

BARRACUDA = np.array([0.5, 1.05, 1.5])
SARDINE = np.array([1.13, 2.22, 3.38])


class Scare:
    """A sardine at the middle and predators around."""

    def __init__(self, tank: ModuleType, *offsets: tuple[float, float, float]) -> None:
        number = len(offsets)
        place = np.array([(0.0, 0, 0), *offsets]) - np.array([0, 0, 5.0])
        way = np.array([(1.0, 0, 0), *(-np.array(offset) for offset in offsets)])
        self.scene = tank.Tank(
            place, way, np.array([0.2] + [1.1] * number), np.array([SARDINE] + [BARRACUDA] * number)
        )
        self.scene.crowd.speed[1:] = 0.5
        self.shelter, self.shoal = np.zeros(3), np.zeros(6)
        self.sheltered, self.company = False, 0.0
        self.away, self.scare = np.zeros(3), 0.0

    def flee(self, now: int = 0) -> tuple[Float64s, tuple[int, float, float]]:
        """Return the unit direction, and gear, urgency, throttle."""
        scene, predators = self.scene, np.zeros(8, np.int64)
        number = len(scene.length) - 1
        predators[:number] = np.arange(1, number + 1)
        found = escape(
            scene.crowd, 0, predators, number, self.away, self.scare, self.shelter, self.sheltered,
            self.shoal, self.company, 1, now, scene.out,
        )  # fmt: skip
        return np.array(scene.out) / np.linalg.norm(scene.out), found


def test_it_flees_from_all_and_most_from_the_nearest(tank: ModuleType) -> None:
    one, _ = Scare(tank, (6.0, 0, 0)).flee()
    assert one[0] < -0.95
    both, _ = Scare(tank, (5.0, 0, 0), (0, 9.0, 0)).flee()
    assert both[0] < both[1] < 0.0


def test_it_dodges_to_either_side_the_more_the_nearer(tank: ModuleType) -> None:
    def sideways(distance: float) -> Float64s:
        scare = Scare(tank, (distance, 0, 0))
        return np.array([scare.flee(ZIGZAG_TICKS * k)[0][1] for k in range(30)])

    near, far = sideways(2.2), sideways(7.0)
    assert near.min() < -0.3
    assert near.max() > 0.3
    assert np.abs(far).max() < 0.1


def test_only_one_upon_it_makes_it_start(tank: ModuleType) -> None:
    assert Scare(tank, (1.0, 0, 0)).flee()[1][1] >= MORTAL
    gear, urgency, throttle = Scare(tank, (3.5, 0, 0)).flee()[1]
    assert gear == 2
    assert 0.5 < urgency < MORTAL
    assert throttle >= 1.0


def test_charged_by_a_faster_one_it_doubles_back(tank: ModuleType) -> None:
    scare = Scare(tank, (-1.2, 0.1, 0))
    scare.scene.crowd.speed[:] = (0.6, 2.0)
    way, _ = scare.flee()
    assert way[0] < 0.0
    assert abs(way[1]) > 0.6
    scare.scene.crowd.speed[1] = 0.3
    assert scare.flee()[0][0] > 0.3


def test_near_neighbours_scatter_far_ones_close_ranks(tank: ModuleType) -> None:
    def towards_the_school(distance: float) -> float:
        scare = Scare(tank, (distance, 0, 0))
        alone = scare.flee()[0]
        scare.company, scare.shoal[:3] = 20.0, (0.0, 0.8, 0.0)
        return float(scare.flee()[0][1] - alone[1])

    assert towards_the_school(5.5) > 0.2
    assert towards_the_school(1.0) < -0.03


def test_it_makes_for_shelter_and_stays_in_it(tank: ModuleType) -> None:
    scare = Scare(tank, (5.0, 0, 0))
    scare.sheltered, scare.shelter[:] = True, (0.0, -3.0, 0.0)
    assert scare.flee()[0][1] < -0.4
    scare.shelter[:] = (0.0, -0.3, 0.0)
    gear, _, throttle = scare.flee()[1]
    assert (gear, throttle) == (0, 0.2)


@pytest.mark.parametrize("scare", [0.3, 1.0])
def test_it_flees_from_the_submarine_too(tank: ModuleType, scare: float) -> None:
    alone = Scare(tank)
    alone.away[:], alone.scare = (0.0, 2.0, 0.0), scare
    way, (_, urgency, _) = alone.flee()
    assert way[1] > 0.5
    assert (urgency >= MORTAL) == (scare > 0.9)


def test_shelter_is_home_or_the_far_side_of_a_rock(pond: ModuleType) -> None:
    terrain, out = pond.make_terrain(1), np.zeros(3)
    rock = terrain.rock_centre[4]
    here = rock + np.array([terrain.rock_radii[4].max() + 0.5, 0, 0.5])
    x, y, z = here
    assert find_shelter(terrain, 1, x, y, z, 3.0, 0.0, 8.0, out)
    hidden, predator = here + out, here + np.array([3.0, 0, 0])
    nearest = np.argmin(np.linalg.norm((terrain.rock_centre - hidden)[:, :2], axis=1))
    centre = terrain.rock_centre[nearest]
    assert (hidden - centre)[:2] @ (predator - centre)[:2] < 0.0
    home = here + np.array([0, 1.0, 0.2])
    assert find_shelter(terrain.with_homes([(tuple(home), 1)]), 1, x, y, z, 3.0, 0.0, 8.0, out)
    assert np.allclose(out, home - here)
    assert not find_shelter(terrain, 1, x, y, z, 3.0, 0.0, 0.1, out)
