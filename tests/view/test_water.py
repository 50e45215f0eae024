"""What water does to a picture: fog, caustics, shafts, the surface above."""

from collections.abc import Callable, Iterator

import numpy as np
import pytest
from pyglet import gl

from components.arrays import Float64s
from components.camera import Camera, camera_towards
from components.terrain import Terrain
from systems.view.draw_ground import DrawGround
from systems.view.draw_motes import DrawMotes
from systems.view.draw_rocks import DrawRocks
from systems.view.draw_water import DrawWater
from systems.view.frame import FrameBlock, Look
from systems.view.target import Target, UInt8s, start_drawing, stop_drawing
from systems.view.water_maps import relief_map, stone_map, surface_map, water_map


class Sea:
    """The environment's drawers over one seabed."""

    def __init__(self, seabed: Terrain) -> None:
        self.frame, self.water, self.motes = FrameBlock(), DrawWater(), DrawMotes()
        self.ground = DrawGround(seabed, Look().sun())
        self.rocks = DrawRocks(seabed, Look().sun())

    def picture(
        self,
        camera: Camera,
        look: Look | None = None,
        seconds: float = 1.0,
        size: tuple[int, int] = (160, 90),
        solid: bool = True,
    ) -> UInt8s:
        """Return the picture of the sea, with or without ground and rocks."""
        with Target(*size) as target:
            start_drawing(*size)
            self.frame.update(camera, *size, seconds, look or Look())
            if solid:
                self.ground.draw(camera, size[0] / size[1])
                self.rocks.draw(camera, size[0] / size[1], size[1])
            self.water.draw()
            self.motes.draw()
            stop_drawing()
            return target.read()

    def delete(self) -> None:
        for part in (self.frame, self.water, self.motes, self.ground, self.rocks):
            part.delete()


@pytest.fixture(scope="module")
def sea(seabed: Terrain) -> Iterator[Sea]:
    whole = Sea(seabed)
    yield whole
    whole.delete()


def mean(picture: UInt8s) -> Float64s:
    """Return the mean colour of the rows or pixels of a picture, (3,)."""
    return np.asarray(picture.reshape(-1, 3).mean(axis=0))


def brightness(picture: UInt8s) -> float:
    return float(picture.mean())


@pytest.mark.golden
def test_the_sea_looks_as_it_did(
    sea: Sea, level_camera: Camera, same_frame: Callable[[str, UInt8s], bool]
) -> None:
    assert same_frame("sea", sea.picture(level_camera, size=(320, 180)))


def test_the_surface_is_above_and_the_sand_below(sea: Sea, level_camera: Camera) -> None:
    picture = sea.picture(level_camera)
    top, water, bottom = picture[:10], picture[22:28], picture[-10:]
    assert brightness(top) > 1.1 * brightness(water)
    assert mean(bottom)[0] > 2.0 * mean(water)[0]
    assert mean(water)[2] > 2.0 * mean(water)[0]


def test_a_rock_on_the_right_is_drawn_on_the_right(sea: Sea, level_camera: Camera) -> None:
    left, right = np.split(sea.picture(level_camera, Look(caustics=0.0))[55:80], 2, axis=1)
    assert np.percentile(right[..., 0], 5) < np.percentile(left[..., 0], 5) - 10


def test_sand_loses_its_red_with_distance(sea: Sea) -> None:
    camera = camera_towards(np.array([-14.0, 3.0, -4.0]), np.array([0.0, 3.0, -6.5]))
    picture = sea.picture(camera, Look(caustics=0.0), size=(160, 160))
    rows = picture[80:, :, 0].reshape(8, -1).mean(axis=1)
    assert (np.diff(rows) > 0).all()


def test_murky_water_hides_more(sea: Sea, level_camera: Camera) -> None:
    contrast = [
        sea.picture(level_camera, Look(visibility=visibility))[60:, :, 0].std()
        for visibility in (4.0, 10.0, 22.0, 60.0)
    ]
    assert (np.diff(contrast) > 0).all()


def test_caustics_move_over_the_sand_and_can_be_left_out(sea: Sea) -> None:
    down = camera_towards(np.array([-6.0, 5.0, -5.0]), np.array([-5.0, 5.0, -7.0]))
    still = [sea.picture(down, Look(caustics=0.0), seconds) for seconds in (1.0, 4.0)]
    moving = [sea.picture(down, Look(caustics=1.0), seconds) for seconds in (1.0, 4.0)]
    assert moving[0].std() > 1.3 * still[0].std()
    shift = [np.abs(a.astype(float) - b).mean() for a, b in (still, moving)]
    assert shift[1] > 3.0 * shift[0]


def test_the_same_moment_gives_the_same_picture(sea: Sea, level_camera: Camera) -> None:
    first, again, later = (sea.picture(level_camera, seconds=s) for s in (2.0, 2.0, 3.0))
    assert (first == again).all()
    assert (first != later).any()


def test_shafts_of_light_stand_in_open_water(sea: Sea) -> None:
    level = camera_towards(np.array([0.0, 0.0, -6.0]), np.array([10.0, 0.0, -6.0]))
    lit = sea.picture(level, solid=False)[50:80].astype(float).mean(axis=0)
    dark = sea.picture(level, Look(sun_strength=0.0), solid=False)[50:80].astype(float)
    assert lit[:, 1].std() > 4.0 * dark.mean(axis=0)[:, 1].std()


def test_a_window_of_sky_opens_overhead(sea: Sea) -> None:
    up = camera_towards(np.array([0.0, 0.0, -6.0]), np.array([0.5, 0.0, 0.0]))
    down = camera_towards(np.array([0.0, 0.0, -6.0]), np.array([0.5, 0.0, -12.0]))
    assert brightness(sea.picture(up)) > 1.8 * brightness(sea.picture(down, solid=False))


def test_deeper_ground_gets_less_light(sea: Sea) -> None:
    open_water = camera_towards(np.array([0.0, 0.0, -3.0]), np.array([9.0, 0.0, -3.0]))
    deep = camera_towards(np.array([0.0, 0.0, -30.0]), np.array([9.0, 0.0, -30.0]))
    pictures = [sea.picture(camera, solid=False)[50:] for camera in (open_water, deep)]
    assert brightness(pictures[0]) > 1.3 * brightness(pictures[1])


def test_frames_raise_no_opengl_error_and_leave_nothing_behind(
    sea: Sea, level_camera: Camera
) -> None:
    def living() -> list[int]:
        kinds = (gl.glIsBuffer, gl.glIsTexture, gl.glIsFramebuffer, gl.glIsRenderbuffer)
        return [sum(kind(name) for name in range(1, 2000)) for kind in kinds]

    before = living()
    for _ in range(12):
        sea.picture(level_camera, size=(32, 18))
    assert living() == before
    assert before[0] > 0
    assert gl.glGetError() == gl.GL_NO_ERROR


@pytest.mark.parametrize("make", [water_map, surface_map, relief_map, stone_map])
def test_a_map_repeats_without_a_seam(make: Callable[[], Float64s]) -> None:
    values = make()
    assert values.min() >= 0.0
    assert values.max() <= 1.0
    for axis in (0, 1):
        steps = np.abs(np.diff(values, axis=axis)).mean(axis=(0, 1))
        ends = np.take(values, 0, axis) - np.take(values, -1, axis)
        assert (np.abs(ends).mean(axis=0) < 2.0 * steps + 0.02).all()
        assert (values.std(axis=(0, 1)) > 0.02).all()
