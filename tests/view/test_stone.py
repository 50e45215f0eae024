"""Craggy shapes of stone, and the rubble that lies about rocks."""

import numpy as np
import pytest

from components.camera import Camera, camera_towards
from components.terrain import Terrain
from systems.view.draw_contact import AROUND, RINGS, ring_mesh, ring_sides
from systems.view.draw_rocks import normals
from systems.view.draw_rubble import A_PIECE, lay, stone_mesh
from systems.view.shade import ground_under
from systems.view.stone import LUMPS, crags, hollows, split_octahedron

SPHERE = split_octahedron(4)


@pytest.mark.parametrize("seed", range(6))
def test_crags_are_rough_but_stay_near_the_ellipsoid(seed: int) -> None:
    shape = crags(np.random.default_rng(seed), SPHERE.points)
    assert np.abs(shape).max() <= LUMPS
    assert shape.std() > 0.3 * LUMPS
    a, b = SPHERE.sides[:, 0], SPHERE.sides[:, 1]
    assert np.abs(shape[a] - shape[b]).max() > 0.25 * LUMPS


def test_no_two_rocks_are_alike() -> None:
    one, two = (crags(np.random.default_rng(seed), SPHERE.points) for seed in (1, 2))
    assert abs(np.corrcoef(one, two)[0, 1]) < 0.4


def test_a_dent_is_hollow_and_a_knob_is_not() -> None:
    shape = np.zeros(len(SPHERE.points))
    shape[10], shape[400] = -0.05, 0.05
    hollow = hollows(SPHERE, shape)
    assert hollow[10] > 0.2
    assert hollow[400] < -0.2
    assert np.abs(np.median(hollow)) < 1e-9


def test_normals_of_a_sphere_point_away_from_its_middle() -> None:
    two = np.stack((SPHERE.points, 3.0 * SPHERE.points + 1.0))
    assert np.abs(normals(two, SPHERE) - SPHERE.points).max() < 0.05


def test_stones_lie_on_the_sand_mostly_about_rocks(seabed: Terrain) -> None:
    stones = lay(seabed)
    flat = stones.place.reshape(-1, 3)
    assert np.allclose(flat[:, 2], ground_under(seabed, flat))
    assert (np.diff(stones.size, axis=1) <= 0).all()
    away = np.linalg.norm(stones.place[0, :, :2] - seabed.rock_centre[0, :2], axis=1)
    assert np.median(away) < 1.8 * seabed.rock_radii[0].max()
    assert (stones.place[0] == lay(seabed).place[0]).all()


def test_stones_are_drawn_partly_over_the_sand(seabed: Terrain) -> None:
    sphere = split_octahedron(1)
    mesh = stone_mesh(lay(seabed), seabed, sphere, np.array([0.0, 0.0, 1.0]))
    stone = mesh.reshape(-1, len(sphere.points), 10)
    assert len(stone) % A_PIECE == 0
    assert (stone[:, :, 6].max(axis=1) > 0.0).all()
    assert (stone[:, :, 6].min(axis=1) < 0.0).mean() > 0.9
    assert np.allclose(np.linalg.norm(stone[..., 3:6], axis=-1), 1.0)


def test_sand_is_dark_about_a_rock_and_darkest_at_its_foot(seabed: Terrain) -> None:
    ring = ring_mesh(seabed, 0, np.array([0.6, 0.0, 0.8])).reshape(len(RINGS), AROUND, 4)
    flat = ring[..., :2] - seabed.rock_centre[0, :2]
    assert (np.diff(np.linalg.norm(flat, axis=-1), axis=0) > 0).all()
    assert (np.diff(ring[..., 3], axis=0) <= 0).all()
    assert (ring[-1, :, 3] == 0).all()
    assert (ring[0, :, 3] > 0.5).all()
    ground = ground_under(seabed, ring.reshape(-1, 4)).reshape(ring.shape[:2])
    assert (np.abs(ring[..., 2] - ground) < 0.01).all()
    lee, lit = ring[-1, AROUND // 2], ring[-1, 0]
    assert lee[:2] @ [-1, 0] + seabed.rock_centre[0, 0] > lit[0] - seabed.rock_centre[0, 0]


def test_the_rings_lie_face_up(seabed: Terrain) -> None:
    places = ring_mesh(seabed, 0, np.array([0.0, 0.0, 1.0]))[:, :3]
    a, b, c = places[ring_sides().reshape(-1, 3)].swapaxes(0, 1)
    assert (np.cross(b - a, c - a)[:, 2] > 0).all()


def test_stones_show_close_by_and_not_from_afar(seabed: Terrain, level_camera: Camera) -> None:
    from systems.view.draw_rubble import FARTHEST, DrawRubble
    from systems.view.frame import FrameBlock, Look
    from systems.view.target import Target, start_drawing, stop_drawing

    frame, rubble = FrameBlock(), DrawRubble(seabed, (0.0, 0.0, 1.0))
    shares = []
    centre = seabed.rock_centre[0]
    for away in (3.0, 10.0, FARTHEST + 60.0):
        eye = centre + np.array([-away, 0.0, 1.0])
        camera = camera_towards(eye, centre)
        with Target(160, 90) as target:
            start_drawing(160, 90)
            frame.update(camera, 160, 90, 0.0, Look())
            rubble.draw(camera, 16 / 9)
            stop_drawing()
            shares.append(float((target.read().max(axis=2) > 0).mean()))
    frame.delete()
    rubble.delete()
    assert shares[0] > shares[1] > shares[2] == 0.0
