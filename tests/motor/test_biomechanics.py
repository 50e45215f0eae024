"""The biomechanical fish: topology, conservation, symmetry, stability, and the dense solver beside the banded one."""

from collections import Counter
from itertools import pairwise

import numpy as np
import pytest

from components.arrays import Float64s
from components.body import Body, Swim
from components.chance import uniform
from systems.motor.biomechanics import Workspace, advance, assemble, substep, workspace
from systems.motor.contract import EXTENSION, Stroke, contract
from systems.motor.muscle_model import (
    FACE,
    FACE_WEIGHT,
    MUSCLES,
    SPRING,
    SPRINGS,
    BodyModel,
    body_model,
)
from tools.peers.dense_dynamics import dense_advance, dense_matrix

REFERENCE = Body(
    station=(0.13, 0.32, 0.50, 0.66, 0.81),
    half_width=(0.042, 0.062, 0.055, 0.038, 0.016),
    half_height=(0.0525 / 0.75, 0.0863 / 0.75, 0.0788 / 0.75, 0.0525 / 0.75, 0.027 / 0.75),
    tail_span=0.115,
)
SWIM = Swim(0.33, 0.55, 120.0, 2.0)
STROKE = Stroke(0.33, 0.55, 2.0943951023931953, 120, 0.0)
UPSIDE_DOWN = [0, *(4 * r + 1 + s for r in range(5) for s in (3, 2, 1, 0)), 22, 21]
LEFT_RIGHT = [0, *(4 * r + 1 + s for r in range(5) for s in (1, 0, 3, 2)), 21, 22]


@pytest.fixture
def model() -> BodyModel:
    return body_model(REFERENCE, SWIM)


def swum(model: BodyModel, stroke: Stroke, frames: int) -> tuple[Float64s, Float64s, Workspace]:
    """Return position, velocity and workspace after `frames` frames from rest."""
    position, velocity, work = model.start.copy(), np.zeros((23, 3)), workspace(model)
    for frame in range(frames):
        advance(model, stroke, frame, position, velocity, work)
    return position, velocity, work


def test_the_body_has_91_springs_12_of_them_muscles() -> None:
    pairs = [tuple(sorted(pair)) for pair in SPRING.tolist()]
    assert len(pairs) == len(set(pairs)) == SPRINGS == 91
    assert [tuple(pair) for pair in SPRING[:MUSCLES].tolist()] == [(i, i + 4) for i in range(1, 13)]
    touched = Counter(node for pair in pairs for node in pair)
    assert sorted(touched) == list(range(23))
    assert touched[0] == 4
    assert touched[21] == touched[22] == 5


def test_the_faces_close_the_body_and_look_outwards(model: BodyModel) -> None:
    assert FACE.shape == (24, 4)
    assert np.allclose(FACE_WEIGHT.sum(axis=1), 1)
    edges: Counter[tuple[int, int]] = Counter()
    for corners in FACE.tolist():
        ring = list(dict.fromkeys(corners))
        for a, b in zip(ring, [*ring[1:], ring[0]], strict=True):
            edges[(a, b)] += 1
    assert all(edges[(b, a)] == count == 1 for (a, b), count in edges.items())
    for corners in FACE.tolist():
        a, b, c, d = model.start[corners]
        normal = np.cross(c - a, d - b)
        middle = (a + b + c + d) / 4
        assert normal @ (middle * (0, 1, 1)) > 0


def test_the_rule_gives_the_reference_fish_its_masses(model: BodyModel) -> None:
    assert model.mass[[1, 5, 9, 13, 17, 21]] == pytest.approx(
        [0.0302, 0.0996, 0.0741, 0.0311, 0.0074, 0.0059], rel=0.01
    )
    assert model.stiffness[4] == pytest.approx(1050, rel=0.1)
    assert np.allclose(model.damping, 0.0095 * model.stiffness)


def test_springs_push_nodes_but_not_the_whole(model: BodyModel) -> None:
    position, velocity, work = swum(model, STROKE, 40)
    assemble(model, position, velocity, work)
    momentum = (model.mass[:, None] * velocity).sum(axis=0)
    assert np.allclose(work.right.reshape(23, 3).sum(axis=0), momentum, atol=1e-12)


def test_water_slows_a_fish_that_glides_and_speeds_none(model: BodyModel) -> None:
    position, velocity, work = model.start.copy(), np.zeros((23, 3)), workspace(model)
    velocity[:, 0] = 1.0
    speeds = [1.0]
    for _ in range(120):
        substep(model, position, velocity, work)
        speeds.append(float(model.mass @ velocity[:, 0] / model.mass.sum()))
    assert all(later < earlier for earlier, later in pairwise(speeds))
    assert 0.3 < speeds[-1] < 0.95


def test_a_relaxed_fish_at_rest_stays(model: BodyModel) -> None:
    position, velocity, work = model.start.copy(), np.zeros((23, 3)), workspace(model)
    for _ in range(100):
        substep(model, position, velocity, work)
    assert np.abs(position - model.start).max() < 1e-12


def test_the_matrix_is_symmetric_positive_definite_within_the_band(model: BodyModel) -> None:
    position, velocity, work = swum(model, STROKE, 40)
    assemble(model, position, velocity, work)
    matrix = dense_matrix(work.band)
    assert np.linalg.eigvalsh(matrix).min() > 0
    rows, columns = np.nonzero(matrix)
    assert np.abs(rows - columns).max() == 23


def test_dense_elimination_swims_the_same(model: BodyModel) -> None:
    position, velocity, work = swum(model, STROKE, 60)
    other, speed, scratch = position.copy(), velocity.copy(), workspace(model)
    for frame in range(60, 90):
        advance(model, STROKE, frame, position, velocity, work)
        dense_advance(model, STROKE, frame, other, speed, scratch)
    assert np.abs(position - other).max() < 1e-10
    assert np.abs(velocity - speed).max() < 1e-8


def test_a_symmetric_swim_stays_level_and_upright(model: BodyModel) -> None:
    position, velocity, _ = swum(model, STROKE, 480)
    assert np.abs(position[UPSIDE_DOWN] * (1, 1, -1) - position).max() < 1e-9
    assert np.abs(velocity[UPSIDE_DOWN] * (1, 1, -1) - velocity).max() < 1e-8
    assert position[0, 0] > 5


def test_the_mirror_image_of_a_stroke_swims_the_mirror_image(model: BodyModel) -> None:
    half = 3.141592653589793
    one, _, _ = swum(model, STROKE._replace(turn=0.3, turn_at=60), 90)
    other, _, _ = swum(model, STROKE._replace(offset=half, turn=-0.3, turn_at=60), 90)
    assert np.abs(other[LEFT_RIGHT] * (1, -1, 1) - one).max() < 1e-9
    assert one[0, 1] > one[21, 1] + 0.1


def test_the_fish_survives_any_muscle_commands(model: BodyModel) -> None:
    position, velocity, work = model.start.copy(), np.zeros((23, 3)), workspace(model)
    for step in range(4 * 180):
        for muscle in range(MUSCLES):
            pull = 0.6 * uniform(7, muscle, step // 16, 0)
            work.rest[muscle] = model.length[muscle] * (1 - pull)
        substep(model, position, velocity, work)
    lengths = np.linalg.norm(position[SPRING[:, 1]] - position[SPRING[:, 0]], axis=1)
    assert np.isfinite(position).all()
    assert np.abs(velocity).max() < 20
    assert (lengths / model.length).max() < 2.5


def test_swim_contracts_sides_in_turn_and_ramps_in(model: BodyModel) -> None:
    rest = model.length.copy()
    contract(STROKE, model.length, 0, 1 / 240, rest)
    assert np.array_equal(rest, model.length)
    contract(STROKE, model.length, 120 * 10 + 30, 1 / 240, rest)
    share = 1 - rest[:MUSCLES] / model.length[:MUSCLES]
    assert np.allclose(share[:4], 0)
    assert np.allclose(share[4:8], [0.33, 0, 0, 0.33])
    assert np.all(share[8:] >= 0)
    assert np.allclose(share[8] + share[9], 0.55)


def test_turning_contracts_the_left_and_extends_the_right(model: BodyModel) -> None:
    rest = model.length.copy()
    still = Stroke(0.0, 0.0, 0.0, 120, 0.0, 1.0, 0)
    contract(still, model.length, 84, 1 / 240, rest)
    share = 1 - rest[:MUSCLES] / model.length[:MUSCLES]
    left = np.tile([True, False, False, True], 3)
    assert np.all(share[left] > 0)
    assert np.allclose(share[~left], -EXTENSION * share[left])
    contract(still, model.length, 300, 1 / 240, rest)
    assert np.allclose(rest, model.length)
