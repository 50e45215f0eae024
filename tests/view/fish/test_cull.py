"""Culling: nothing that is seen is lost, what is behind or drowned in haze is dropped, records say what is drawn."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from components.arrays import Float64s
from components.camera import Camera, camera_at
from components.fish import Population
from systems.view.cull import CARD, GAPES, Culling, level_at, view_of

AFTER = np.array([1, 2, 3, 4, 0, 6, 7, 5], np.int32)
"""Rows that follow each other in two loops, 0 to 4 and 5 to 7."""


def placed(positions: Float64s, length: float = 0.2) -> Population:
    """Return fishes at rest at the places given, facing along x."""
    population = Population()
    rows = population.append(np.arange(len(positions), dtype=np.int64))
    fish = population.fish
    fish.position[rows] = fish.last_position[rows] = positions
    fish.rotation[rows] = fish.last_rotation[rows] = np.eye(3)
    fish.length[rows] = length
    return population


def drawn_ids(culling: Culling, population: Population) -> list[int]:
    """Return the rows drawn, recognised by their places."""
    seen = np.concatenate([culling.records(level)[:, :3] for level in range(3)])
    at = population.fish.position[: population.count].astype(np.float32)
    return sorted(int(np.abs(at - place).sum(axis=1).argmin()) for place in seen)


def inside(camera: Camera, points: Float64s, aspect: float) -> NDArray[np.bool_]:
    """Return which points lie in the frustum itself: the reference."""
    away = points - camera.eye
    ahead, right, up = (away @ axis for axis in (camera.forward, camera.right, camera.up))
    wide, tall = ahead * camera.slope * aspect, ahead * camera.slope
    result: NDArray[np.bool_] = (ahead > 0) & (np.abs(right) <= wide) & (np.abs(up) <= tall)
    return result


@settings(max_examples=40, deadline=None)
@given(
    st.integers(0, 2**32 - 1),
    st.floats(-3.1, 3.1),
    st.floats(-1.4, 1.4),
    st.floats(0.2, 1.5),
    st.floats(0.5, 3.0),
)
def test_every_fish_in_the_frustum_is_kept_and_every_one_behind_dropped(
    seed: int, yaw: float, pitch: float, slope: float, aspect: float
) -> None:
    points = np.random.default_rng(seed).uniform(-8.0, 8.0, (60, 3))
    camera = camera_at(np.array([0.5, -1.0, -2.0]), yaw, pitch, slope)
    population = placed(points)
    culling = Culling(np.zeros(1), AFTER)
    culling(population, view_of(camera, 720, aspect, 30.0), 1.0, 0.0)
    kept = drawn_ids(culling, population)
    assert set(np.flatnonzero(inside(camera, points, aspect)).tolist()) <= set(kept)
    behind = (points - camera.eye) @ camera.forward < -0.2
    assert not set(np.flatnonzero(behind).tolist()) & set(kept)
    assert len(kept) == culling.counts.sum()


@pytest.fixture
def ahead() -> Camera:
    """An eye at 5 m depth that looks along x."""
    return camera_at(np.array([0.0, 0.0, -5.0]), 0.0, 0.0)


@pytest.mark.parametrize("side", [(0.0, 1.0, 0.0), (0.0, 0.0, 1.0)])
def test_a_fish_just_outside_the_frustum_is_kept_and_one_well_outside_dropped(
    ahead: Camera, side: tuple[float, float, float]
) -> None:
    reach = 4.0 * ahead.slope
    view = view_of(ahead, 720, 1.0, 30.0)
    near = np.array([4.0, 0.0, -5.0]) + (reach + 0.1) * np.array(side)
    far = np.array([4.0, 0.0, -5.0]) + (reach + 0.5) * np.array(side)
    assert level_at(view, near[0], near[1], near[2], 0.2) >= 0
    assert level_at(view, far[0], far[1], far[2], 0.2) == -1


def test_water_hides_what_is_far_beyond_its_visibility(ahead: Camera) -> None:
    murky, clear = (view_of(ahead, 720, 1.5, visibility) for visibility in (5.0, 40.0))
    assert level_at(murky, 30.0, 0.0, -5.0, 1.0) == -1
    assert level_at(clear, 30.0, 0.0, -5.0, 1.0) >= 0


def test_detail_falls_with_distance_and_rises_with_the_picture(ahead: Camera) -> None:
    view = view_of(ahead, 720, 1.5, 30.0)
    levels = [level_at(view, x, 0.0, -5.0, 0.25) for x in np.linspace(0.3, 40.0, 80)]
    assert levels[0] == 0
    assert CARD in levels
    seen = [level for level in levels if level >= 0]
    assert seen == sorted(seen)
    small = view_of(ahead, 180, 1.5, 30.0)
    assert level_at(small, 1.2, 0.0, -5.0, 0.25) > level_at(view, 1.2, 0.0, -5.0, 0.25)


def test_records_blend_place_and_warp_between_ticks(ahead: Camera) -> None:
    population = placed(np.array([[1.0, 0.1, -5.0]]))
    fish, motor = population.fish, population.motor
    fish.last_position[0] = (0.8, 0.1, -5.0)
    motor.shape_row[0], motor.last_shape_row[0] = 7, 6
    motor.warp_from[0], motor.warp_to[0] = 3, 5
    motor.warp_weight[0], motor.last_warp_weight[0] = 0.4, 0.8
    fish.species[0] = 1
    culling = Culling(np.array([0.1, 0.9]), AFTER)
    culling(population, view_of(ahead, 720, 1.5, 30.0), 0.25, 3.0)
    record = culling.records(0)[0]
    assert record[:4] == pytest.approx([0.85, 0.1, -5.0, 0.2])
    assert record[4:8] == pytest.approx([0.0, 0.0, 0.0, 1.0])
    assert record[8:15] == pytest.approx([6.0, 7.0, 0.25, 0.7, 3.0, 5.0, 1.0])
    assert record[19] == pytest.approx(0.9)


def test_a_record_says_how_wide_the_mouth_is_open_beside_the_shine(ahead: Camera) -> None:
    population = placed(np.array([[1.0, 0.1, -5.0]]))
    population.mind.gape[0] = 0.25
    culling = Culling(np.array([0.9]), AFTER)
    culling(population, view_of(ahead, 720, 1.5, 30.0), 1.0, 0.0)
    packed = float(culling.records(0)[0, 19])
    assert packed // 2 == GAPES / 4
    assert packed % 2 == pytest.approx(0.9, abs=1e-5)


def test_records_of_a_fish_between_entries_hold_neighbouring_rows(ahead: Camera) -> None:
    population = placed(np.array([[1.0, 0.1, -5.0]]))
    motor = population.motor
    motor.last_shape_row[0], motor.last_part[0] = 3, 0.75
    motor.shape_row[0], motor.part[0] = 0, 0.25
    motor.warp_from[0], motor.warp_part[0], motor.warp_to[0] = 7, 0.5, 2
    population.fish.species[0] = 1
    culling = Culling(np.zeros(2), AFTER)
    for alpha, rows in ((0.0, (3, 4, 0.75)), (0.5, (4, 0, 0.5)), (1.0, (0, 1, 0.25))):
        culling(population, view_of(ahead, 720, 1.5, 30.0), alpha, 3.0)
        record = culling.records(0)[0]
        assert record[8:11] == pytest.approx(rows)
        assert record[12:15] == pytest.approx([7.0, 2.0, 1.5])
    motor.warp_part[0] = np.nextafter(1.0, 0.0)
    culling(population, view_of(ahead, 720, 1.5, 30.0), 1.0, 3.0)
    assert int(culling.records(0)[0][14]) == 1


def test_quaternions_turn_as_the_rotations_do(ahead: Camera) -> None:
    rng = np.random.default_rng(5)
    population = placed(np.tile([1.0, 0.0, -5.0], (40, 1)))
    turns = np.linalg.qr(rng.normal(size=(40, 3, 3)))[0]
    turns *= np.sign(np.linalg.det(turns))[:, None, None]
    population.fish.rotation[:40] = population.fish.last_rotation[:40] = turns
    population.fish.length[:40] = 0.2 + 0.001 * np.arange(40)
    culling = Culling(np.zeros(1), AFTER)
    culling(population, view_of(ahead, 720, 1.5, 30.0), 0.5, 0.0)
    for record in culling.records(0):
        i = round((float(record[3]) - 0.2) / 0.001)
        axis, w = record[4:7].astype(float), float(record[7])
        v = np.array([0.3, -0.5, 0.8])
        turned = v + 2 * np.cross(axis, np.cross(axis, v) + w * v)
        assert turned == pytest.approx(turns[i] @ v, abs=1e-5)


def test_fishes_with_fins_come_from_the_farthest_to_the_nearest(ahead: Camera) -> None:
    points = np.column_stack((np.array([0.8, 0.5, 0.95, 0.65]), np.zeros(4), np.full(4, -5.0)))
    culling = Culling(np.zeros(1), AFTER)
    culling(placed(points), view_of(ahead, 720, 1.5, 30.0), 1.0, 0.0)
    assert culling.records(0)[:, 0] == pytest.approx([0.95, 0.8, 0.65, 0.5])


def test_room_grows_with_the_population(ahead: Camera) -> None:
    rng = np.random.default_rng(0)
    culling = Culling(np.zeros(1), AFTER)
    for count in (3, 500, 40):
        places = rng.uniform(-1, 1, (count, 3)) + np.array([4.0, 0.0, -5.0])
        culling(placed(places), view_of(ahead, 720, 1.5, 30.0), 1.0, 0.0)
        assert culling.counts.sum() == count
