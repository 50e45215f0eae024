"""The frame block: what shaders are told of camera, sun and water."""

import numpy as np
import pytest
from pyglet import gl

from components.camera import Camera, camera_towards
from systems.view.frame import FLOATS, FrameBlock, Look, frame_values, view_projection
from systems.view.program import FRAME_BINDING, load_program, shader_source


def test_a_point_ahead_falls_on_the_middle_and_others_beside_it(level_camera: Camera) -> None:
    matrix = view_projection(level_camera, 1.5)
    ahead, right, above = (
        matrix @ (*(level_camera.eye + 4.0 * level_camera.forward + step), 1.0)
        for step in (np.zeros(3), level_camera.right, level_camera.up)
    )
    assert np.allclose(ahead[:2], 0.0)
    assert ahead[3] == pytest.approx(4.0)
    assert right[0] / right[3] == pytest.approx(1.0 / (4.0 * level_camera.slope * 1.5))
    assert above[1] / above[3] == pytest.approx(1.0 / (4.0 * level_camera.slope))


def test_nearer_things_have_the_lesser_depth(level_camera: Camera) -> None:
    matrix = view_projection(level_camera, 1.5)
    points = [level_camera.eye + far * level_camera.forward for far in (0.06, 1.0, 30.0, 240.0)]
    clip = np.array([matrix @ (*point, 1.0) for point in points])
    depth = clip[:, 2] / clip[:, 3]
    assert (np.diff(depth) > 0).all()
    assert depth[[0, -1]] == pytest.approx([-1.0, 1.0])


def test_the_block_holds_what_was_given() -> None:
    camera = camera_towards(np.array([1.0, 2.0, -3.0]), np.array([4.0, 2.0, -3.0]))
    look = Look(visibility=12.0, caustics=0.5, waves=0.7, depth=9.0, sun_strength=0.8)
    values = frame_values(camera, 320, 180, 2.5, look)
    assert values.shape == (FLOATS,)
    assert np.allclose(values[:16].reshape(4, 4).T, view_projection(camera, 320 / 180))
    assert values[16:20].tolist() == [1.0, 2.0, -3.0, 2.5]
    assert values[20:23].tolist() == [1.0, 0.0, 0.0]
    assert values[27] == pytest.approx(camera.slope * 320 / 180)
    assert values[31] == pytest.approx(camera.slope)
    assert values[35] == pytest.approx(0.8)
    assert values[36:40] == pytest.approx([12.0, 0.5, 0.7, 9.0])
    assert values[40:44] == pytest.approx([320, 180, 1 / 320, 1 / 180])


@pytest.mark.parametrize(("elevation", "highest"), [(90.0, 90.0), (20.0, 45.2), (0.0, 41.4)])
def test_water_bends_the_sun_upward(elevation: float, highest: float) -> None:
    x, y, z = Look(sun_elevation=elevation, sun_azimuth=90.0).sun()
    assert x == pytest.approx(0.0, abs=1e-12)
    assert y >= 0.0
    assert np.degrees(np.arctan2(z, y)) == pytest.approx(highest, abs=0.1)


def test_the_buffer_on_the_gpu_holds_the_values(level_camera: Camera) -> None:
    block = FrameBlock()
    values = block.update(level_camera, 64, 36, 1.5, Look())
    bound = gl.GLint()
    gl.glGetIntegeri_v(gl.GL_UNIFORM_BUFFER_BINDING, FRAME_BINDING, bound)
    assert bound.value != 0
    read = np.zeros(FLOATS, np.float32)
    gl.glGetBufferSubData(gl.GL_UNIFORM_BUFFER, 0, read.nbytes, read.ctypes.data)
    block.delete()
    assert (read == values).all()


def test_a_programs_frame_block_is_at_the_agreed_binding() -> None:
    program = load_program("screen.vert.glsl", "water.frag.glsl", ("LOW",))
    binding = gl.GLint()
    index = gl.glGetUniformBlockIndex(program.id, b"Frame")
    gl.glGetActiveUniformBlockiv(program.id, index, gl.GL_UNIFORM_BLOCK_BINDING, binding)
    assert binding.value == FRAME_BINDING == 3


def test_a_file_included_twice_stands_once_behind_the_defines() -> None:
    text = shader_source("water.frag.glsl", ("LOW", "LAYERS 3"))
    assert text.startswith("#version 330 core\n#define LOW\n#define LAYERS 3\n")
    assert text.count("uniform Frame") == 1
    assert "#include" not in text
