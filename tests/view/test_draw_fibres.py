"""A garden drawn: plants where they stand, nearer ones finer, the same picture every time; what is bent is seen."""

from collections.abc import Callable, Iterator

import numpy as np
import pytest
from pyglet import gl

from components.camera import Camera, camera_towards
from components.garden import Garden
from components.terrain import Terrain
from reefgame.bed import Bed, clumps_seen, feet_of
from reefgame.testing.small_garden import current, growth
from systems.sea.bend import NumbaBender
from systems.view.cull import View, view_of
from systems.view.draw_contact import DrawContact
from systems.view.draw_fibres import DrawFibres, tufts_of
from systems.view.draw_ground import DrawGround
from systems.view.draw_rocks import DrawRocks
from systems.view.draw_water import DrawWater
from systems.view.frame import FrameBlock, Look
from systems.view.target import Target, UInt8s, start_drawing, stop_drawing

SIZE = (320, 180)
NOTHING = np.zeros((0, 16), np.float32)


@pytest.fixture(scope="module")
def eye(seabed: Terrain) -> Camera:
    """An eye that looks down on the garden."""
    low = float(seabed.height.min())
    return camera_towards(np.array([0.45, 0.0, low + 1.5]), np.array([2.9, 0.0, low + 0.6]), 0.42)


def bed_of(seabed: Terrain, defines: tuple[str, ...] = ()) -> Bed:
    return Bed(growth(seabed), seabed, Look().sun(), NumbaBender(), 60_000, defines)


@pytest.fixture(scope="module")
def bed(seabed: Terrain) -> Iterator[Bed]:
    """A garden that a current has bent."""
    made = bed_of(seabed)
    yield made
    made.delete()


def seen_from(camera: Camera) -> View:
    return view_of(camera, SIZE[1], SIZE[0] / SIZE[1], 22.0)


def drawn(bed: Bed, camera: Camera, seconds: float = 0.0, speed: float = 0.4) -> UInt8s:
    """Return a picture of the garden alone, on black."""
    frame = FrameBlock()
    with Target(*SIZE) as target:
        start_drawing(*SIZE)
        frame.update(camera, *SIZE, 0.0, Look(depth=8.0))
        bed.draw(seen_from(camera), current(speed), seconds)
        stop_drawing()
        picture = target.read()
    frame.delete()
    return picture


def test_a_garden_on_the_sand_looks_as_it_did(
    seabed: Terrain, eye: Camera, same_frame: Callable[[str, UInt8s], bool]
) -> None:
    bed = bed_of(seabed)
    sun, frame = Look().sun(), FrameBlock()
    rocks, ground = DrawRocks(seabed, sun), DrawGround(seabed, sun)
    contact, water = DrawContact(seabed, sun, bed.feet()), DrawWater()
    aspect = SIZE[0] / SIZE[1]
    with Target(*SIZE) as target:
        start_drawing(*SIZE)
        frame.update(eye, *SIZE, 2.0, Look(depth=8.0))
        bed.draw(seen_from(eye), current(), 2.0)
        rocks.draw(eye, aspect, SIZE[1])
        ground.draw(eye, aspect)
        contact.draw(eye, aspect)
        water.draw()
        stop_drawing()
        picture = target.read()
    for part in (bed, frame, rocks, ground, contact, water):
        part.delete()
    assert gl.glGetError() == gl.GL_NO_ERROR
    assert same_frame("garden", picture)


def test_low_quality_shows_the_same_garden(seabed: Terrain, bed: Bed, eye: Camera) -> None:
    low = bed_of(seabed, ("LOW",))
    coarse, fine = drawn(low, eye).astype(np.int16), drawn(bed, eye).astype(np.int16)
    low.delete()
    assert (fine > 0).any(axis=2).mean() > 0.05
    assert np.abs(coarse - fine).mean() < 6


def test_the_same_garden_gives_the_same_picture(seabed: Terrain, eye: Camera) -> None:
    beds = [bed_of(seabed) for _ in range(2)]
    first, second = (drawn(one, eye, 1.0) for one in beds)
    for one in beds:
        one.delete()
    assert (first == second).all()


def test_time_that_stands_still_moves_nothing_and_time_that_passes_does(
    seabed: Terrain, eye: Camera
) -> None:
    bed = bed_of(seabed)
    still = drawn(bed, eye, 1.0, 0.4)
    paused = drawn(bed, eye, 1.0, 2.0)
    bent = drawn(bed, eye, 1.1, 2.0)
    bed.delete()
    assert (paused == still).all()
    assert (bent != still).any()


def test_a_long_wait_between_pictures_bends_no_more_than_a_tenth_of_a_second(
    seabed: Terrain, eye: Camera
) -> None:
    beds = [bed_of(seabed) for _ in range(2)]
    for bed, wait in zip(beds, (0.1, 60.0), strict=True):
        drawn(bed, eye, 0.0, 0.0)
        drawn(bed, eye, wait, 2.0)
    first, second = (bed.garden.position.copy() for bed in beds)
    for bed in beds:
        bed.delete()
    assert (first == second).all()


def test_what_is_not_seen_is_not_bent(bed: Bed, seabed: Terrain, eye: Camera) -> None:
    garden, tufts = bed.garden, tufts_of(bed.garden, growth(seabed).looks)
    away = camera_towards(eye.eye, eye.eye - eye.forward, 0.45)
    assert clumps_seen(garden, tufts, seen_from(eye)).all()
    assert not clumps_seen(garden, tufts, seen_from(away)).any()


def test_behind_the_eye_nothing_is_drawn(bed: Bed, eye: Camera) -> None:
    away = camera_towards(eye.eye, eye.eye - eye.forward, 0.45)
    assert not drawn(bed, away).any()


def test_plants_darken_the_sand_where_they_stand(seabed: Terrain) -> None:
    plants = growth(seabed)
    feet = feet_of(Garden(plants.tufts), plants.looks, seabed)
    assert feet[:, 0] == pytest.approx([2.2, 3.4, 2.6, 3.0], abs=0.2)
    assert ((feet[:, 2] > 0.05) & (feet[:, 2] < 1.0)).all()
    assert ((feet[:, 3] > 0.2) & (feet[:, 3] < 0.8)).all()


def test_a_garden_of_odd_tufts_is_drawn_without_a_fault(seabed: Terrain, eye: Camera) -> None:
    plants = growth(seabed)
    short = [tuft for tuft in plants.tufts if tuft.carriers is None]
    single = short[0].points[:, :1]
    none = short[0].points[:0]
    short += [
        type(short[0])(single, np.full(1, 0.1), look=0),
        type(short[0])(none, np.full(6, 0.1), look=1),
        type(short[0])(short[0].points[:, :2], np.zeros(2), look=3),
    ]
    garden = Garden(short)
    draw = DrawFibres(garden, plants.looks, (), seabed, Look().sun())
    with Target(*SIZE):
        start_drawing(*SIZE)
        choice = draw.draw(seen_from(eye))
    draw.delete()
    assert len(choice.tuft) == len(short) - 2
    assert gl.glGetError() == gl.GL_NO_ERROR


def test_an_empty_garden_is_drawn(seabed: Terrain, eye: Camera) -> None:
    draw = DrawFibres(Garden([]), (), (), seabed, Look().sun())
    with Target(*SIZE) as target:
        start_drawing(*SIZE)
        choice = draw.draw(seen_from(eye))
        black = target.read()
    draw.delete()
    assert len(choice.tuft) == 0
    assert not black.any()
