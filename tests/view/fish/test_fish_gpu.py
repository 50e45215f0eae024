"""The GPU's fishes against the CPU's: the same nodes, the same weights, within 1e-4 body lengths (DESIGN 5)."""

from collections.abc import Sequence
from ctypes import (
    POINTER,
    byref,
    c_char,
    c_char_p,
    c_int,
    c_uint,
    c_void_p,
    cast,
    create_string_buffer,
)
from typing import Any

import numpy as np
import pytest
from pyglet import gl

from components.arrays import Float32s, Float64s, Int32s, Int64s
from components.camera import camera_at, camera_towards
from components.fish import Population
from components.motor import MotorTable
from systems.motor.pose import pose
from systems.view.cull import RECORD
from systems.view.draw_fish import DrawFish, wrapped
from systems.view.fish_levels import COUNT_STEP, levels_of
from systems.view.fish_surface import PECTORAL
from systems.view.frame import FrameBlock, Look
from systems.view.program import shader_source
from systems.view.target import Target, start_drawing

SIDE = 4096
"""Widest texture that the drawer makes, where OpenGL allows it."""


def capturing_program(side: int) -> int:
    """Link fish.vert.glsl alone, with `world` captured by transform feedback."""
    defines = (f"SHAPES_A_ROW {side // 23}", f"VERTICES_A_ROW {side // 12}")
    program = gl.glCreateProgram()
    shader = gl.glCreateShader(gl.GL_VERTEX_SHADER)
    text = create_string_buffer(shader_source("fish.vert.glsl", defines).encode())
    pointer = cast(byref(text), POINTER(c_char))
    gl.glShaderSource(shader, 1, byref(pointer), byref(c_int(len(text.value))))
    gl.glCompileShader(shader)
    gl.glAttachShader(program, shader)
    names = (POINTER(c_char) * 2)(
        *(cast(c_char_p(name), POINTER(c_char)) for name in (b"world", b"normal"))
    )
    gl.glTransformFeedbackVaryings(program, 2, names, gl.GL_INTERLEAVED_ATTRIBS)
    gl.glLinkProgram(program)
    linked = c_int()
    gl.glGetProgramiv(program, gl.GL_LINK_STATUS, byref(linked))
    assert linked.value
    return int(program)


def captured(draw: DrawFish, start: int, vertices: int, records: Float32s, side: int) -> Float32s:
    """Return place and normal of every vertex of every record, (fishes, vertices, 6)."""
    program = capturing_program(side)
    gl.glUseProgram(program)
    for name, value in (("shapes", 0), ("weights", 1), ("vertices", draw.vertices)):
        gl.glUniform1i(gl.glGetUniformLocation(program, name.encode()), value)
    draw.bind_textures()
    buffers, array = (c_uint * 3)(), c_uint()
    gl.glGenBuffers(3, buffers)
    gl.glGenVertexArrays(1, byref(array))
    gl.glBindVertexArray(array)
    numbers = np.arange(start, start + vertices, dtype=np.float32)
    for buffer, values in zip(buffers, (numbers, records), strict=False):
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffer)
        gl.glBufferData(gl.GL_ARRAY_BUFFER, values.nbytes, values.ctypes.data, gl.GL_STATIC_DRAW)
        if values is numbers:
            gl.glVertexAttribPointer(0, 1, gl.GL_FLOAT, gl.GL_FALSE, 0, c_void_p(0))
        else:
            for k in range(RECORD // 4):
                place = c_void_p(16 * k)
                gl.glVertexAttribPointer(1 + k, 4, gl.GL_FLOAT, gl.GL_FALSE, 4 * RECORD, place)
                gl.glVertexAttribDivisor(1 + k, 1)
                gl.glEnableVertexAttribArray(1 + k)
        gl.glEnableVertexAttribArray(0)
    out = np.zeros((len(records), vertices, 6), np.float32)
    gl.glBindBuffer(gl.GL_TRANSFORM_FEEDBACK_BUFFER, buffers[2])
    gl.glBufferData(gl.GL_TRANSFORM_FEEDBACK_BUFFER, out.nbytes, None, gl.GL_STATIC_READ)
    gl.glBindBufferBase(gl.GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[2])
    gl.glEnable(gl.GL_RASTERIZER_DISCARD)
    gl.glBeginTransformFeedback(gl.GL_POINTS)
    gl.glDrawArraysInstanced(gl.GL_POINTS, 0, vertices, len(records))
    gl.glEndTransformFeedback()
    gl.glDisable(gl.GL_RASTERIZER_DISCARD)
    gl.glGetBufferSubData(gl.GL_TRANSFORM_FEEDBACK_BUFFER, 0, out.nbytes, out.ctypes.data)
    gl.glBindVertexArray(0)
    gl.glUseProgram(0)
    gl.glDeleteBuffers(3, buffers)
    gl.glDeleteVertexArrays(1, byref(array))
    gl.glDeleteProgram(program)
    return out


def summed(table: Float32s, column: int, nodes: Float64s) -> Float64s:
    """Return the sum of each vertex' nodes with one column of its weights: the reference, (n, 3)."""
    first = table[:, 0, 3].astype(int) % COUNT_STEP
    padded = np.concatenate((nodes, np.zeros((12, 3))))
    window = padded[first[:, None] + np.arange(12)]
    result: Float64s = np.einsum("nk,nkc->nc", table[:, :, column].astype(np.float64), window)
    return result


def _between_entries(motor: MotorTable, rows: Int64s, after: Int32s) -> None:
    """Let the fishes play at rates of their own: half of them pass from a cycle's last entry to its first."""
    rng = np.random.default_rng(12)
    for column in (motor.part, motor.last_part, motor.warp_part):
        column[rows] = rng.uniform(0.1, 0.9, len(rows))
    wrapping = rows[::2]
    motor.last_shape_row[wrapping] += 23 - motor.last_shape_row[wrapping] % 24
    motor.warp_from[wrapping] = motor.last_shape_row[wrapping]
    motor.shape_row[rows] = after[motor.last_shape_row[rows]]


def wild(shoal: Any, count: int = 24) -> Population:
    """Return fishes anywhere, turned anyhow, between two shapes and in the middle of warps."""
    rng = np.random.default_rng(11)
    forward = rng.normal(size=(count, 3)) * [1.0, 1.0, 0.4]
    turns = np.stack([shoal.rotation(f) for f in forward])
    species = np.arange(count) % 4
    population: Population = shoal.population(
        rng.uniform((4, -3, -8), (9, 3, -2), (count, 3)),
        turns,
        rng.uniform(0.1, 1.5, count),
        species,
    )
    fish, motor = population.fish, population.motor
    angle = 0.06
    step = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    fish.last_rotation[:count] = turns @ step
    fish.last_position[:count] = fish.position[:count] - 0.02
    entries = 24 * species[:, None] + rng.integers(0, 24, (count, 4))
    for name, rows in zip(
        ("shape_row", "last_shape_row", "warp_from", "warp_to"), entries.T, strict=True
    ):
        getattr(motor, name)[:count] = rows
    motor.warp_weight[:count] = rng.uniform(0, 1, count) * (np.arange(count) % 3 > 0)
    motor.last_warp_weight[:count] = motor.warp_weight[:count] * 1.1
    _between_entries(motor, np.arange(0, count, 2), shoal.library.after)
    return population


def test_the_gpu_puts_every_vertex_where_the_cpu_does(shoal: Any) -> None:
    population, alpha = wild(shoal), 0.37
    draw = DrawFish(shoal.species, shoal.library)
    FrameBlock().update(camera_at(np.zeros(3), 0.0, 0.0), 320, 180, 0.0, Look())
    nodes = pose(population, shoal.library, alpha=alpha).astype(np.float64)
    camera = camera_towards(np.array([-4.0, 0.0, -5.0]), np.array([6.0, 0.0, -5.0]), 2.0)
    levels = [levels_of(species.body) for species in shoal.species]
    for height, level in ((100_000, 0), (4_000, 1)):
        draw.select(population, camera, alpha, 1.0, height, 60.0, 1.5)
        start = sum(len(other.table) for other in levels[0][:level])
        records = draw.cull.records(level)
        assert len(records) >= 8
        side = min(draw.widest, SIDE)
        vertices = len(levels[0][level].table)
        result = captured(draw, start, vertices, records, side)
        for record, fish in zip(records, result, strict=True):
            i = int(np.abs(population.fish.length[: population.count] - record[3]).argmin())
            table = levels[int(record[14])][level].table
            fixed = table[:, 3, 3] < PECTORAL
            away = fish[:, :3] - summed(table, 0, nodes[i])
            assert np.abs(away[fixed]).max() / record[3] < 1e-4
            turned = np.cross(summed(table, 1, nodes[i]), summed(table, 2, nodes[i]))
            turned /= np.linalg.norm(turned, axis=1)[:, None] + 1e-12
            seen = fish[:, 3:] / (np.linalg.norm(fish[:, 3:], axis=1)[:, None] + 1e-12)
            assert (turned * seen).sum(axis=1)[fixed].min() > 0.999


def test_paired_fins_keep_their_length_as_they_scull(shoal: Any) -> None:
    population = shoal.population(
        np.array([[1.0, 0.0, -5.0]]), np.eye(3)[None], np.array([0.2]), [1]
    )
    draw = DrawFish(shoal.species, shoal.library)
    camera = camera_at(np.array([0.0, 0.0, -5.0]), 0.0, 0.0)
    FrameBlock().update(camera, 320, 180, 0.0, Look())
    level = levels_of(shoal.species[1].body)[0]
    blades = level.table[:, 3, 3] >= PECTORAL
    strokes = []
    for seconds in (0.0, 0.2, 0.4):
        draw.select(population, camera, 1.0, seconds, 720, 30.0, 1.5)
        records = draw.cull.records(0)
        strokes.append(captured(draw, 0, len(level.table), records, min(draw.widest, SIDE))[0])
    assert np.allclose(strokes[0][~blades, :3], strokes[1][~blades, :3], atol=1e-6)
    moved = np.abs(strokes[0][blades, :3] - strokes[1][blades, :3]).max()
    assert moved > 0.002
    blade = [stroke[blades][:20, :3] for stroke in strokes]
    tip = [np.linalg.norm(b[-1] - b[3]) for b in blade]
    assert tip[0] == pytest.approx(tip[1], rel=0.02)


def picture(
    shoal: Any, places: Sequence[tuple[float, float, float]], size: tuple[int, int], pixels: float
) -> np.ndarray:
    """Return what an eye at the origin, 5 m down, sees of tangs on black, drawn as if `pixels` high."""
    turn = shoal.rotation(np.array([0.1, 1.0, 0.0]))
    count = len(places)
    population = shoal.population(
        np.array(places), np.repeat(turn[None], count, axis=0), np.full(count, 0.25), [1] * count
    )
    camera = camera_at(np.array([0.0, 0.0, -5.0]), 0.0, 0.0, 0.2)
    draw = DrawFish(shoal.species, shoal.library)
    with Target(*size) as target:
        start_drawing(*size)
        FrameBlock().update(camera, *size, 0.0, Look())
        draw.draw(population, camera, 1.0, 0.0, pixels, 30.0)
        drawn = target.read()
    draw.delete()
    return drawn


def test_levels_of_detail_have_nearly_the_same_silhouette(shoal: Any) -> None:
    masks = [
        picture(shoal, [(1.4, 0.1, -5.0)], (240, 160), pixels).max(axis=2) > 0
        for pixels in (2000, 240, 30)
    ]
    close, far, card = masks
    assert close.mean() > 0.03
    assert (close & far).sum() / (close | far).sum() > 0.96
    assert (close & card).sum() / (close | card).sum() > 0.85


def test_a_fish_behind_the_eye_leaves_the_picture_black(shoal: Any) -> None:
    assert picture(shoal, [(-2.0, 0.0, -5.0)], (80, 60), 60).max() == 0
    assert picture(shoal, [(2.0, 0.0, -5.0)], (80, 60), 60).max() > 60


def test_the_nearer_fish_hides_the_farther(shoal: Any) -> None:
    near = picture(shoal, [(1.2, 0.1, -5.0)], (120, 80), 80).astype(int)
    both = picture(shoal, [(1.2, 0.1, -5.0), (2.4, 0.2, -5.0)], (120, 80), 80).astype(int)
    solid = near.sum(axis=2) > 0
    assert np.abs(near - both)[solid].mean() < 2.0


@pytest.mark.parametrize(("count", "size", "widest"), [(10, 23, 64), (1000, 12, 1024), (1, 23, 23)])
def test_items_are_wrapped_whole_into_rows(count: int, size: int, widest: int) -> None:
    items = np.arange(count * size * 4, dtype=np.float32).reshape(count, size, 4)
    texture = wrapped(items, widest)
    assert texture.shape[0] <= widest
    assert texture.shape[1] <= widest
    a_row = widest // size
    for i in (0, count // 2, count - 1):
        row, column = i // a_row, size * (i % a_row)
        assert np.array_equal(texture[row, column : column + size], items[i])


def test_more_items_than_a_texture_holds_are_refused() -> None:
    with pytest.raises(ValueError, match="do not fit"):
        wrapped(np.zeros((24, 23, 4), np.float32), 23)
