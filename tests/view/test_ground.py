"""The seabed's tiles, their levels of detail, and rocks that stand where they are felt."""

from itertools import product

import numpy as np
import pytest

from components.arrays import Float64s
from components.camera import Camera, camera_towards
from components.terrain import Terrain
from systems.view.draw_ground import (
    LEVELS,
    TILE,
    apron,
    boxes_seen,
    coarser_sides,
    grid_points,
    padded,
    tile_bounds,
    tile_indices,
    tile_levels,
)
from systems.view.draw_rocks import rock_mesh
from systems.view.shade import ground_light, ground_under, in_rock_axes
from systems.view.stone import LUMPS, split_octahedron

SIDE = TILE + 1


def corners(level: int, coarser: int) -> Float64s:
    """Return the tile's triangles as grid coordinates, (n, 3, 2)."""
    numbers = tile_indices(SIDE, level, coarser).reshape(-1, 3)
    return np.stack((numbers // SIDE, numbers % SIDE), axis=-1).astype(np.float64)


def on_edge(triangles: Float64s, axis: int, at: int) -> set[tuple[float, ...]]:
    """Return the sides of triangles that lie along an edge of the tile."""
    sides = np.concatenate([triangles[:, pair] for pair in ((0, 1), (1, 2), (2, 0))])
    along = sides[(sides[:, :, axis] == at).all(axis=1)][:, :, 1 - axis]
    return {tuple(sorted(side)) for side in along.tolist()}


@pytest.mark.parametrize(("level", "coarser"), list(product(range(LEVELS), range(16))))
def test_a_tile_is_covered_once_and_faces_up(level: int, coarser: int) -> None:
    a, b, c = corners(level, coarser).swapaxes(0, 1)
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    area = 0.5 * (ux * vy - uy * vx)
    assert (area > 0).all()
    assert area.sum() == TILE**2


@pytest.mark.parametrize("level", range(LEVELS - 1))
def test_no_crack_opens_between_two_levels(level: int) -> None:
    for bit, (axis, at) in enumerate(((0, 0), (0, TILE), (1, 0), (1, TILE))):
        fine = on_edge(corners(level, 1 << bit), axis, at)
        coarse = on_edge(corners(level + 1, 0), axis, TILE - at)
        assert fine == coarse
        assert on_edge(corners(level, 0), axis, at) != coarse


def test_neighbouring_tiles_differ_by_one_level_at_most(seabed: Terrain) -> None:
    low, high, _ = tile_bounds(grid_points(seabed, padded(seabed)))
    for eye in np.random.default_rng(1).uniform((-16, -16, -8), (16, 16, 0), (20, 3)):
        level = tile_levels(low, high, eye)
        assert level.min() == 0
        assert max(np.abs(np.diff(level, axis=axis)).max() for axis in (0, 1)) <= 1


def test_a_far_tile_is_coarse_and_its_finer_neighbour_knows() -> None:
    x = np.arange(0.0, 320.0, 8.0)
    low = np.stack((*np.meshgrid(x, x[:2], indexing="ij"), np.zeros((40, 2))), axis=-1)
    level = tile_levels(low, low + 8.0, np.array([0.0, 8.0, 2.0]))
    assert (np.diff(level[:, 0]) >= 0).all()
    assert level[-1, 0] == LEVELS - 1
    steps = np.flatnonzero(np.diff(level[:, 0]))
    assert (np.flatnonzero(coarser_sides(level)[:, 0] == 0b10) == steps).all()


def test_the_mesh_goes_through_the_heights_that_fishes_feel(seabed: Terrain) -> None:
    height = padded(seabed)
    points = grid_points(seabed, height)
    assert (len(height) - 1) % TILE == 0
    side = len(seabed.height)
    assert (points[:side, :side, 2] == seabed.height).all()
    inside = points[:side, :side].reshape(-1, 3)
    assert np.allclose(ground_under(seabed, inside), inside[:, 2])


def test_the_apron_joins_the_border_all_round(seabed: Terrain) -> None:
    points = grid_points(seabed, padded(seabed))
    outer, triangles = apron(points)
    assert len(outer) == 4 * (len(points) - 1)
    assert len(triangles) == 6 * len(outer)
    assert np.linalg.norm(outer[:, :2], axis=1).min() > 150
    everywhere = np.concatenate((points.reshape(-1, 3), outer))
    a, b, c = everywhere[triangles.reshape(-1, 3)].swapaxes(0, 1)
    assert (np.cross(b - a, c - a)[:, 2] > 0).all()


def test_boxes_before_the_eye_are_seen_and_those_behind_are_not(level_camera: Camera) -> None:
    low = np.array([[5, -1, -6], [-7, -1, -6], [5, 20, -6], [-1, -1, -6.0]])
    seen = boxes_seen(low, low + 2.0, level_camera, 1.5)
    assert seen.tolist() == [True, False, False, True]


def test_turning_round_shows_what_was_behind() -> None:
    low = np.array([[-7.0, -1.0, -6.0]])
    back = camera_towards(np.array([0.0, 0.0, -5.5]), np.array([-9.0, 0.0, -5.5]))
    assert boxes_seen(low, low + 2.0, back, 1.5).all()


@pytest.mark.parametrize("times", [0, 2, 4])
def test_the_sphere_is_closed_and_faces_outward(times: int) -> None:
    points, sides = split_octahedron(times)
    assert np.allclose(np.linalg.norm(points, axis=1), 1.0)
    assert len(sides) == 8 * 4**times
    assert len(points) - len(sides) * 3 // 2 + len(sides) == 2
    a, b, c = points[sides].swapaxes(0, 1)
    assert (np.sum(np.cross(b - a, c - a) * (a + b + c), axis=1) > 0).all()


def test_a_rock_is_drawn_where_it_is_felt(seabed: Terrain) -> None:
    drawn = rock_mesh(seabed, 0, split_octahedron(4), np.array([0.0, 0.0, 1.0]))
    away = np.linalg.norm(in_rock_axes(drawn[:, :3], seabed, 0), axis=1)
    assert np.abs(away - 1.0).max() <= LUMPS
    assert away.std() > 0.1 * LUMPS
    outward = np.sum(drawn[:, 3:6] * (drawn[:, :3] - seabed.rock_centre[0]), axis=1)
    assert (outward > 0).all()


def test_sand_is_dark_at_a_rocks_foot_and_in_its_shadow(seabed: Terrain) -> None:
    x, y, _ = seabed.rock_centre[0]
    z = float(seabed.rock_centre[0, 2]) - 0.3
    points = np.array([(x, y, z), (x + 1.3, y, z), (x - 1.3, y, z), (x, y + 9.0, z)])
    sky, lit = ground_light(points, seabed, np.array([0.6, 0.0, 0.8])).T
    assert sky[0] < sky[1] < sky[3] == 1.0
    assert lit[2] < 0.5 < lit[1]
    assert lit[3] == 1.0
