"""The sense of territory: inward at each boundary, pressing, but never so that a fast start answers."""

import numpy as np
import pytest

from components.arrays import Float64s
from components.ground import Terrain, clearance
from components.terrain import build_terrain, rock_on_ground
from systems.motor.bound import Bounded, bound_some
from systems.motor.choose import MORTAL

LENGTH = 0.25


@pytest.fixture(scope="module")
def terrain() -> Terrain:
    bare = build_terrain(20.0, 12.0, 0.5, 14.0, 3)
    return bare.with_rocks([rock_on_ground(bare, (5.0, 0.0), (1.0, 1.0, 1.5), 0.0, 0.3)])


def bound(terrain: Terrain, place: Float64s, way: Float64s) -> tuple[Float64s, float]:
    """Return heading and urgency of a fish at `place` that swims along `way` after bounding."""
    rotation = np.zeros((1, 3, 3))
    rotation[0, :, 0] = way
    last = place - way * 0.4 / 60.0
    fish = Bounded(
        np.zeros(1, np.int32), np.array([LENGTH]), place[None], last[None], rotation,
        way[None].copy(), np.zeros(1),
    )  # fmt: skip
    bound_some(terrain, np.array([0.19]), 0, 1, fish)
    return fish.heading[0], float(fish.urgency[0])


@pytest.mark.parametrize(
    ("place", "way"),
    [
        ((0.0, 0.0, -0.15), (0.6, 0.0, 0.8)),
        ((0.0, 19.8, -5.0), (0.0, 1.0, 0.0)),
        ((3.85, 0.0, -11.0), (1.0, 0.0, 0.0)),
        ((-3.0, 2.0, None), (0.6, 0.0, -0.8)),
    ],
    ids=["surface", "cylinder", "rock", "seabed"],
)
def test_who_swims_into_a_boundary_is_turned_inward(
    terrain: Terrain, place: tuple[float, float, float | None], way: tuple[float, float, float]
) -> None:
    x, y, z = place
    if z is None:
        z = next(z for z in np.arange(-14.0, 0.0, 0.02) if clearance(terrain, x, y, z)[0] > 0.15)
    ahead = np.array(way)
    _, *out = clearance(terrain, x, y, z)
    heading, urgency = bound(terrain, np.array([x, y, z]), ahead)
    assert heading @ np.array(out) > ahead @ np.array(out) + 0.5
    assert 0.5 < urgency < MORTAL


def test_in_open_water_nothing_is_changed(terrain: Terrain) -> None:
    way = np.array([1.0, 0.0, 0.0])
    heading, urgency = bound(terrain, np.array([-6.0, 0.0, -5.0]), way)
    assert heading.tolist() == way.tolist()
    assert urgency == 0.0
