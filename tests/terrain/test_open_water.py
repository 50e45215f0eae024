"""The glance that spares most fishes a closer look: who passes it would not have been moved."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from components import confinement
from components.terrain import Rock, build_terrain, clearance, is_clear

SPOT = st.floats(-29.0, 29.0)
ROCKS = st.lists(
    st.builds(
        Rock,
        centre=st.tuples(SPOT, SPOT, st.floats(-12.0, -4.0)),
        radii=st.tuples(*[st.floats(0.2, 5.0)] * 3),
        yaw_deg=st.floats(0.0, 360.0),
    ),
    max_size=6,
)


@settings(max_examples=60)
@given(rocks=ROCKS, seed=st.integers(0, 50), margin=st.floats(0.02, 0.9), chance=st.integers(0, 99))
def test_who_swims_in_open_water_would_not_have_been_moved(
    rocks: list[Rock], seed: int, margin: float, chance: int
) -> None:
    terrain = build_terrain(30.0, 12.0, 2.0, 10.0, seed, rocks)
    points = np.random.default_rng(chance).uniform((-31, -31, -13), (31, 31, 0.5), (200, 3))
    seen = 0
    for point in points:
        x, y, z = map(float, point)
        if confinement._in_open_water(terrain, x, y, z, margin):
            seen += 1
            before = point.copy()
            assert not confinement._into_cylinder(terrain, point, margin)
            assert not confinement._into_water(terrain, point, margin)
            assert not confinement._out_of_rocks(terrain, point, margin, False)
            assert (point == before).all()
    assert seen > 0


def test_what_is_no_number_gets_the_closer_look() -> None:
    terrain = build_terrain(30.0, 12.0, 2.0, 10.0, 1)
    for bad in (float("nan"), float("inf"), -float("inf")):
        assert not confinement._in_open_water(terrain, bad, 0.0, -3.0, 0.1)
        assert not confinement._in_open_water(terrain, 0.0, 0.0, bad, 0.1)
    assert confinement._in_open_water(terrain, 0.0, 0.0, -3.0, 0.1)


@settings(max_examples=30)
@given(rocks=ROCKS, seed=st.integers(0, 50), within=st.floats(0.1, 2.5), chance=st.integers(0, 99))
def test_what_is_called_clear_is_farther_than_asked(
    rocks: list[Rock], seed: int, within: float, chance: int
) -> None:
    terrain = build_terrain(30.0, 12.0, 2.0, 10.0, seed, rocks)
    points = np.random.default_rng(chance).uniform((-31, -31, -13), (31, 31, 0.5), (200, 3))
    seen = 0
    for x, y, z in points.tolist():
        if is_clear(terrain, x, y, z, within):
            seen += 1
            assert clearance(terrain, x, y, z, within)[0] > within
    assert seen > 0
    assert not is_clear(terrain, float("nan"), 0.0, -3.0, within)
    assert not is_clear(terrain, 0.0, 0.0, float("nan"), within)
