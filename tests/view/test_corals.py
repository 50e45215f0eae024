"""Coral heads: lobed shapes that stay near the ellipsoid that fishes meet, drawn for the rocks that a level names."""

import numpy as np
import pytest

from components.camera import Camera
from components.terrain import Terrain
from systems.view.draw_corals import HEADS, DrawCorals, Head, head_mesh, lobes
from systems.view.draw_rocks import DrawRocks
from systems.view.frame import FrameBlock, Look
from systems.view.stone import LUMPS, split_octahedron
from systems.view.target import Target, UInt8s, start_drawing, stop_drawing

SPHERE = split_octahedron(4)
SUN = np.array([0.0, 0.0, 1.0])


@pytest.mark.parametrize("number", [5, 34])
def test_lobes_swell_and_crease_but_stay_near_the_ellipsoid(number: int) -> None:
    shape = lobes(np.random.default_rng(1), SPHERE.points, number)
    assert np.abs(shape).max() <= LUMPS
    assert shape.std() > 0.2 * LUMPS
    assert (shape < -0.3 * LUMPS).any()
    assert (shape > 0.3 * LUMPS).any()


@pytest.mark.parametrize("look", HEADS)
def test_heads_say_what_they_look_like_and_each_is_another(seabed: Terrain, look: Head) -> None:
    mesh = head_mesh(seabed, 0, look, SPHERE, SUN)
    assert mesh.shape == (len(SPHERE.points), 12)
    assert (mesh[:, 10] == HEADS.index(look)).all()
    assert 0.0 <= mesh[0, 11] < 1.0
    assert np.linalg.norm(mesh[:, 3:6], axis=1) == pytest.approx(1.0)


def drawn(part: DrawRocks | DrawCorals, camera: Camera) -> UInt8s:
    """Return what `part` alone draws, and free it."""
    frame = FrameBlock()
    with Target(160, 90) as target:
        start_drawing(160, 90)
        frame.update(camera, 160, 90, 0.0, Look(depth=8.0))
        part.draw(camera, 16 / 9, 90)
        stop_drawing()
        picture = target.read()
    frame.delete()
    part.delete()
    return picture


def test_a_head_covers_what_the_rock_would(seabed: Terrain, level_camera: Camera) -> None:
    sun = Look().sun()
    rock = drawn(DrawRocks(seabed, sun), level_camera)
    heads = [drawn(DrawCorals(seabed, sun, {0: look}), level_camera) for look in HEADS]
    covered = (rock > 0).any(axis=2)
    assert covered.sum() > 100
    for head in heads:
        assert ((head > 0).any(axis=2) != covered).sum() < 0.15 * covered.sum()
        assert np.abs(head.astype(np.int16) - rock)[covered].mean() > 8
    assert (heads[0] != heads[1]).any()


def test_rocks_that_are_heads_are_not_drawn_as_rocks(seabed: Terrain, level_camera: Camera) -> None:
    assert not drawn(DrawRocks(seabed, Look().sun(), (), ()), level_camera).any()
    assert not drawn(DrawCorals(seabed, Look().sun(), {}), level_camera).any()
