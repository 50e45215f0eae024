"""The world's ground, rocks and bounds: what fishes, submarine and view take on trust."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.terrain import (
    Rock,
    Terrain,
    build_terrain,
    clearance,
    confine,
    ground_height,
    ground_normal,
    rock_distance,
    rock_on_ground,
    sees,
)

RADIUS, DEPTH = 40.0, 14.0
WORLD = build_terrain(RADIUS, DEPTH, 1.5, 14.0, 3)
ROCKS = [
    rock_on_ground(WORLD, (5.0, 5.0), (3.0, 2.0, 1.5), 30.0, 0.3),
    rock_on_ground(WORLD, (7.5, 6.0), (2.0, 2.0, 3.0), 0.0, 0.1),
    rock_on_ground(WORLD, (-12.0, 3.0), (4.0, 1.0, 2.0), 115.0, 0.0),
    Rock((0.0, -15.0, -7.0), (3.0, 3.0, 2.0)),
    Rock((20.0, 0.0, -6.0), (2.0, 2.0, 9.0)),
]
REEF = WORLD.with_rocks(ROCKS)

across = st.floats(-1.4 * RADIUS, 1.4 * RADIUS)
metres = st.floats(0.2, 5.0)


def height(terrain: Terrain, x: float, y: float) -> float:
    return ground_height(terrain.height, terrain.extent, terrain.cell, x, y)


@given(across, across, st.floats(-1e-4, 1e-4), st.floats(-1e-4, 1e-4))
def test_ground_has_no_steps(x: float, y: float, dx: float, dy: float) -> None:
    steepest = 4.0
    climb = abs(height(WORLD, x + dx, y + dy) - height(WORLD, x, y))
    assert climb <= steepest * (abs(dx) + abs(dy)) + 1e-9


def test_ground_passes_through_its_grid_points() -> None:
    for i, j in ((0, 0), (7, 100), (120, 13), (240, 240)):
        x, y = -WORLD.extent + i * WORLD.cell, -WORLD.extent + j * WORLD.cell
        assert height(WORLD, x, y) == pytest.approx(WORLD.height[i, j], abs=1e-6)


@given(
    st.floats(5, 300),
    st.floats(3, 60),
    st.floats(0, 20),
    st.floats(2, 50),
    st.integers(0, 1_000_000),
)
@settings(max_examples=15)
def test_ground_lies_between_its_depth_and_two_metres(
    radius: float, depth: float, relief: float, feature: float, seed: int
) -> None:
    world = build_terrain(radius, depth, relief, feature, seed)
    assert world.height.min() >= -depth
    assert world.height.max() <= -2.0
    assert max(world.height.shape) <= 257


def test_ground_rises_towards_the_rim() -> None:
    turns = np.linspace(0.0, 6.2, 40)
    rim = [height(WORLD, RADIUS * np.cos(a), RADIUS * np.sin(a)) for a in turns]
    inner = [height(WORLD, 10.0 * np.cos(a), 10.0 * np.sin(a)) for a in turns]
    assert min(rim) > max(inner) + 2.0


def test_a_seed_names_one_ground() -> None:
    again = build_terrain(RADIUS, DEPTH, 1.5, 14.0, 3)
    other = build_terrain(RADIUS, DEPTH, 1.5, 14.0, 4)
    assert np.array_equal(again.height, WORLD.height)
    assert np.abs(other.height - WORLD.height).max() > 0.3


@given(across, across)
def test_normal_is_a_unit_vector_that_points_up(x: float, y: float) -> None:
    n = ground_normal(WORLD.height, WORLD.extent, WORLD.cell, x, y)
    assert n[0] ** 2 + n[1] ** 2 + n[2] ** 2 == pytest.approx(1.0)
    assert n[2] > 0.3


@given(
    st.tuples(metres, metres, metres),
    st.floats(-360, 360),
    st.tuples(*[st.floats(-8, 8)] * 3),
)
def test_rock_distance_is_negative_inside_alone(
    radii: tuple[float, float, float], yaw: float, at: tuple[float, float, float]
) -> None:
    world = WORLD.with_rocks([Rock((1.0, 2.0, -5.0), radii, yaw)])
    a = np.deg2rad(yaw)
    dx, dy, dz = at
    u, v = np.cos(a) * dx + np.sin(a) * dy, np.cos(a) * dy - np.sin(a) * dx
    implicit = (u / radii[0]) ** 2 + (v / radii[1]) ** 2 + (dz / radii[2]) ** 2 - 1.0
    if abs(implicit) > 1e-6:
        d = rock_distance(world, 0, 1.0 + dx, 2.0 + dy, -5.0 + dz)
        assert (d > 0.0) == (implicit > 0.0)


def test_rock_distance_to_a_sphere_is_exact() -> None:
    world = WORLD.with_rocks([Rock((0.0, 0.0, -6.0), (2.0, 2.0, 2.0), 40.0)])
    assert rock_distance(world, 0, 3.0, 4.0, -6.0) == pytest.approx(3.0)
    assert rock_distance(world, 0, 0.0, 0.0, -6.0) == pytest.approx(-2.0)


@given(st.floats(-3.1, 3.1), st.floats(-1.5, 1.5), st.floats(1.05, 1.5))
def test_clearance_grows_along_its_way_out_of_a_rock(turn: float, rise: float, out: float) -> None:
    at = out * np.array(
        (3.0 * np.cos(turn) * np.cos(rise), 2.0 * np.sin(turn) * np.cos(rise), np.sin(rise))
    )
    world = build_terrain(RADIUS, DEPTH, 0.0, 14.0, 1).with_rocks(
        [Rock((0.0, 0.0, -6.0), (3.0, 2.0, 1.0))]
    )
    d, nx, ny, nz = clearance(world, at[0], at[1], at[2] - 6.0)
    further = clearance(world, at[0] + 1e-3 * nx, at[1] + 1e-3 * ny, at[2] - 6.0 + 1e-3 * nz)[0]
    assert nx * nx + ny * ny + nz * nz == pytest.approx(1.0)
    assert further - d > 0.3e-3


def test_clearance_finds_each_kind_of_boundary() -> None:
    assert clearance(REEF, 0.0, 0.0, -0.25)[0] == pytest.approx(0.25)
    assert clearance(REEF, RADIUS - 0.5, 0.0, -3.0)[:2] == pytest.approx((0.5, -1.0))
    assert clearance(REEF, 0.0, -15.0, -4.5)[0] == pytest.approx(0.5, abs=0.1)
    floor = height(REEF, -3.0, 0.0)
    assert clearance(REEF, -3.0, 0.0, floor + 0.3)[0] == pytest.approx(0.3, abs=0.03)


def test_lists_hold_every_rock_in_reach() -> None:
    rng = np.random.default_rng(5)
    for x, y, z in rng.uniform((-25, -25, -13), (25, 25, -1), (2000, 3)):
        listed = clearance(REEF, x, y, z, 3.0)[0]
        for k, rock in enumerate(ROCKS):
            offset = np.array((x, y, z)) - rock.centre
            over = np.hypot(offset[0], offset[1]) < max(rock.radii[:2])
            if over and np.sqrt(offset @ offset) < max(rock.radii) + 3.0:
                assert listed <= rock_distance(REEF, k, x, y, z)


places = st.tuples(
    st.floats(-60, 60) | st.floats(allow_nan=True, allow_infinity=True),
    st.floats(-60, 60),
    st.floats(-20, 5),
)


def assert_free(world: Terrain, at: np.ndarray, margin: float) -> None:
    x, y, z = at
    assert np.hypot(x, y) <= world.radius - margin + 1e-9
    assert height(world, x, y) + margin - 1e-9 <= z <= -margin + 1e-9
    for rock in range(len(world.rock_centre)):
        assert rock_distance(world, rock, x, y, z) > 0.0


@given(places, st.floats(0.01, 0.9))
@settings(max_examples=400)
def test_confine_puts_everything_into_free_water_once(
    place: tuple[float, float, float], margin: float
) -> None:
    at = np.array([(9.0, 9.0, 9.0), place])
    confine(REEF, at, 1, margin)
    assert_free(REEF, at[1], margin)
    assert np.array_equal(at[0], (9.0, 9.0, 9.0))
    after = at.copy()
    assert not confine(REEF, at, 1, margin)
    assert np.array_equal(at, after)


@given(
    st.lists(
        st.builds(
            Rock,
            st.tuples(st.floats(-6, 6), st.floats(-6, 6), st.floats(-14, -6)),
            st.tuples(metres, metres, metres),
            st.floats(0, 180),
        ),
        max_size=6,
    ),
    st.tuples(st.floats(-9, 9), st.floats(-9, 9), st.floats(-14, -3)),
)
@settings(max_examples=300)
def test_confine_finds_free_water_among_rocks_that_overlap(
    rocks: list[Rock], place: tuple[float, float, float]
) -> None:
    world = WORLD.with_rocks(rocks)
    at = np.array([place])
    confine(world, at, 0, 0.1)
    assert_free(world, at[0], 0.1)


def test_confine_leaves_free_swimmers_alone() -> None:
    at = np.array([(0.0, 0.0, -3.0)])
    assert not confine(REEF, at, 0, 0.1)
    assert np.array_equal(at, [(0.0, 0.0, -3.0)])


def test_confine_moves_a_swimmer_little_further_than_it_went_in() -> None:
    rng = np.random.default_rng(2)
    at = rng.uniform((-15, -20, -13), (23, 12, -3), (3000, 3))
    for k in range(len(at)):
        confine(REEF, at, k, 0.1)
    jumps = []
    for _ in range(20):
        before = at.copy()
        stepped = at + rng.normal(size=at.shape) * 0.01
        at = stepped.copy()
        for k in range(len(at)):
            confine(REEF, at, k, 0.1)
        jumps.append(np.sqrt(((at - before) ** 2).sum(axis=1)).max())
    assert max(jumps) < 0.3


def test_a_rock_hides_what_is_behind_it() -> None:
    eye, hidden = np.array((0.0, -20.0, -7.0)), np.array((0.0, -10.0, -7.0))
    beside = np.array((8.0, -10.0, -7.0))
    assert not sees(REEF, eye, hidden)
    assert not sees(REEF, hidden, eye)
    assert sees(REEF, eye, beside)
    assert sees(WORLD, eye, hidden)
    assert sees(REEF, eye, np.array((0.0, -18.5, -7.0)))


def test_a_dune_hides_what_is_behind_it() -> None:
    low = np.array((0.0, 0.0, height(WORLD, 0.0, 0.0) + 0.1))
    behind = np.array((RADIUS, 0.0, height(WORLD, RADIUS, 0.0) - 1.0))
    assert not sees(WORLD, low, behind)
    assert sees(WORLD, low, np.array((5.0, 0.0, -2.5)))


def test_a_rock_on_the_ground_is_buried_as_far_as_asked() -> None:
    rock = rock_on_ground(WORLD, (4.0, -3.0), (2.0, 2.0, 2.0), buried=0.25)
    assert rock.centre[2] - 2.0 == pytest.approx(height(WORLD, 4.0, -3.0) - 0.25 * 4.0)


def test_homes_without_a_depth_stand_on_the_ground() -> None:
    world = WORLD.with_homes([((3.0, 4.0), 1), ((1.0, 2.0, -5.0), 0)])
    assert world.home[0, 2] == height(WORLD, 3.0, 4.0)
    assert world.home[1, 2] == -5.0
    assert world.home_species.tolist() == [1, 0]


@pytest.mark.parametrize(
    ("radius", "depth", "relief", "feature"),
    [(0, 14, 1, 10), (40, 2, 1, 10), (40, 14, -1, 10), (40, 14, 1, 0), (float("nan"), 14, 1, 9)],
)
def test_a_world_that_cannot_be_is_refused(
    radius: float, depth: float, relief: float, feature: float
) -> None:
    with pytest.raises(ValueError, match="a world needs"):
        build_terrain(radius, depth, relief, feature, 1)


def test_a_rock_without_size_is_refused() -> None:
    with pytest.raises(ValueError, match="radii > 0"):
        WORLD.with_rocks([Rock((0.0, 0.0, -5.0), (1.0, 0.0, 1.0))])
