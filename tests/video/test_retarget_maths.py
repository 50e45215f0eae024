"""Rigid moving least squares, the skeleton and rigid fins (papers/003, section 5)."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from tools.video.retarget.fin import Fin, RigidFin, smoothstep
from tools.video.retarget.moving_least_squares import RigidDeformation
from tools.video.retarget.skeleton import (
    BONES,
    HEAD,
    angle_of,
    bones,
    nearest_turn,
    posed,
    sampled_axis,
    skeleton_of,
)

REACH = st.floats(-3.0, 3.0)
TURN = st.floats(-3.1, 3.1)
AXIS = np.stack((np.zeros(41), np.linspace(0.5, -0.5, 41)), axis=1)
VERTICES = np.random.default_rng(3).uniform(-0.7, 0.7, (60, 2))
CONTROLS = sampled_axis(AXIS, 0.4)


def turned(points: np.ndarray, angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return np.asarray(points @ np.array([[c, s], [-s, c]]))


@given(TURN, REACH, REACH)
def test_a_rigid_motion_of_the_controls_moves_everything_rigidly(
    a: float, x: float, y: float
) -> None:
    deform, shift = RigidDeformation(VERTICES, CONTROLS), np.array([x, y])
    moved = deform(turned(CONTROLS, a) + shift)
    assert np.allclose(moved, turned(VERTICES, a) + shift, atol=1e-9)


def test_vertices_on_controls_follow_them() -> None:
    bent = CONTROLS + 0.05 * np.stack((np.sin(6.0 * CONTROLS[:, 1]), np.zeros(21)), axis=1)
    moved = RigidDeformation(CONTROLS, CONTROLS)(bent)
    assert np.abs(moved - bent).max() < 1e-3


def test_it_is_the_deformation_that_its_authors_print() -> None:
    bent = CONTROLS + np.stack((0.3 * CONTROLS[:, 1] ** 2, np.zeros(21)), axis=1)
    moved = RigidDeformation(VERTICES, CONTROLS)(bent)
    for vertex, found in zip(VERTICES[:8], moved[:8], strict=True):
        w = ((CONTROLS - vertex) ** 2).sum(axis=1) ** -1.5
        p, q = (w @ CONTROLS) / w.sum(), (w @ bent) / w.sum()
        f = np.zeros(2)
        for weight, here, there in zip(w, CONTROLS - p, bent - q, strict=True):
            left = weight * np.array([here, [here[1], -here[0]]])
            arm = vertex - p
            f += there @ (left @ np.array([arm, [arm[1], -arm[0]]]).T)
        expected = np.hypot(*(vertex - p)) * f / np.hypot(*f) + q
        assert np.allclose(found, expected, atol=1e-9)


@given(arrays(np.float64, BONES, elements=st.floats(0.01, 6.27)))
def test_posing_and_reading_a_skeleton_are_inverse(angles: np.ndarray) -> None:
    skeleton = skeleton_of(CONTROLS)
    controls = posed(skeleton, angles)
    assert np.allclose(nearest_turn(angle_of(bones(controls)) - angles), 0.0, atol=1e-9)
    assert np.allclose(skeleton_of(controls).lengths, skeleton.lengths)


def test_a_straight_fish_points_up_ahead_of_its_centre_and_down_behind() -> None:
    angles = angle_of(bones(CONTROLS))
    assert np.allclose(angles[:HEAD], 0.5 * np.pi)
    assert np.allclose(angles[HEAD:], 1.5 * np.pi)
    assert abs(skeleton_of(CONTROLS).body_length - 1.0) < 1e-9


@given(st.floats(-2.0, 2.0), TURN)
def test_a_fin_beyond_its_root_keeps_every_distance(turn: float, roll: float) -> None:
    places = np.array([[0.1 + 0.02 * k, 0.1 - 0.03 * k] for k in range(12)])
    distance = np.sqrt(((places - places[0]) ** 2).sum(axis=1))
    fin = Fin(places[-1], np.array([0.1, 0.13]), np.array([0.1, 0.07]), np.arange(12), distance)
    rigid = RigidFin(fin, places, 1.0)
    body = turned(places, roll)
    moved = rigid(body, turned(fin.top, roll), turned(fin.bottom, roll), turn + roll)
    stiff = np.flatnonzero(distance > rigid.band)
    assert len(stiff) > 3
    before = np.sqrt(((places[stiff, None] - places[stiff]) ** 2).sum(axis=2))
    after = np.sqrt(((moved[stiff, None] - moved[stiff]) ** 2).sum(axis=2))
    assert np.allclose(after, before, atol=1e-9)
    assert np.allclose(moved[0], body[0])


@given(st.floats(-1.0, 2.0))
def test_smoothstep_rises_from_nought_to_one(t: float) -> None:
    value = float(smoothstep(np.array(t)))
    assert 0.0 <= value <= 1.0
    assert value == (0.0 if t <= 0.0 else 1.0 if t >= 1.0 else value)
    assert np.isclose(value + float(smoothstep(np.array(1.0 - t))), 1.0)
