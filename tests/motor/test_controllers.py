"""The nine motor controllers on the muscle model, and the water's published law (papers/000, 3.2; FINDINGS 1)."""

import numpy as np
import pytest

from components.arrays import Float64s
from components.body import Body, Swim
from systems.motor import controllers
from systems.motor.contract import Stroke
from systems.motor.muscle_model import LAWS, BodyModel, body_model
from systems.motor.pectorals import FOLDED, press
from tools.capture.bend import largest_joint
from tools.capture.record import Recording, State, at_rest, record

BODIES = {
    "sardine": (
        Body(
            station=(0.11, 0.28, 0.47, 0.66, 0.82),
            half_width=(0.036, 0.050, 0.047, 0.032, 0.013),
            half_height=(0.060, 0.088, 0.085, 0.058, 0.026),
            tail_span=0.105,
        ),
        Swim(0.341, 0.554, 152.8, 4.0),
    ),
    "blue_tang": (
        Body(
            station=(0.11, 0.27, 0.46, 0.65, 0.80),
            half_width=(0.040, 0.058, 0.054, 0.036, 0.016),
            half_height=(0.120, 0.180, 0.185, 0.125, 0.042),
            tail_span=0.140,
        ),
        Swim(0.286, 0.423, 142.7, 3.0),
    ),
}


@pytest.fixture(params=sorted(BODIES))
def body(request: pytest.FixtureRequest) -> Body:
    return BODIES[request.param][0]


@pytest.fixture
def swim(body: Body) -> Swim:
    return next(swim for shape, swim in BODIES.values() if shape == body)


@pytest.fixture
def model(body: Body, swim: Swim) -> BodyModel:
    return body_model(body, swim)


def pitch_deg(run: Recording, stroke: Stroke, end: int) -> float:
    """Return the mean pitch over the beat that ends before frame `end`."""
    beat = run.rotation[end - stroke.period // 4 : end, 2, 0]
    return float(np.degrees(np.arcsin(beat)).mean())


def roll_deg(run: Recording) -> Float64s:
    turned: Float64s = np.degrees(np.arctan2(-run.rotation[:, 2, 2], run.rotation[:, 2, 1]))
    return turned


def speed(run: Recording, frame: int) -> float:
    """Return the speed along the body's axis [BL/s]."""
    way = run.origin[frame] - run.origin[frame - 1]
    return float(60 * way @ run.rotation[frame, :, 0])


def cruising(model: BodyModel, stroke: Stroke) -> State:
    state = at_rest(model)
    record(model, stroke, 300, state)
    return state


def rolled(model: BodyModel, degrees: float) -> State:
    a = np.radians(degrees)
    about = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    return State(np.ascontiguousarray(model.start @ about.T), np.zeros((23, 3)))


@pytest.mark.parametrize("way", [1, -1])
def test_ascending_and_descending_pitch_the_body_within_two_seconds(
    model: BodyModel, swim: Swim, way: int
) -> None:
    climb = controllers.ascend if way > 0 else controllers.descend
    stroke = climb(controllers.swim(swim))
    run = record(model, stroke, 300)
    assert 17 < way * pitch_deg(run, stroke, 120) < 27
    assert way * pitch_deg(run, stroke, 300) == pytest.approx(25, abs=2)
    assert way * run.origin[-1, 2] > 1.5
    assert abs(roll_deg(run)[-stroke.period // 4 :].mean()) < 1


@pytest.mark.parametrize("degrees", [40.0, -40.0])
def test_balance_rights_a_rolled_body(model: BodyModel, swim: Swim, degrees: float) -> None:
    still = roll_deg(
        record(model, controllers.balance(controllers.glide()), 60, rolled(model, degrees))
    )
    assert abs(still[29]) < 12
    assert abs(still[-1]) < 3
    moving = controllers.balance(controllers.swim(swim))
    period = moving.period // 4
    roll = roll_deg(record(model, moving, 180, rolled(model, degrees)))
    assert abs(roll[-period:].mean()) < 1
    left = roll_deg(record(model, controllers.swim(swim), 180, rolled(model, degrees)))
    assert abs(left[-period:].mean()) > 20


def test_braking_stops_a_fish_that_would_glide_on(model: BodyModel, body: Body, swim: Swim) -> None:
    state = cruising(model, controllers.swim(swim))
    gliding = record(model, controllers.glide(), 90, state.copy())
    braking = record(model, controllers.brake(body), 90, state.copy())
    assert speed(gliding, 60) > 0.9
    assert speed(braking, 60) < 0.3 * speed(gliding, 60)
    assert abs(speed(braking, 89)) < 0.1


def test_a_fish_rows_backwards_straight_and_level(model: BodyModel, body: Body) -> None:
    run = record(model, controllers.backward(body), 300)
    way = run.origin[-1] - run.origin[0]
    assert -2.0 < way[0] < -0.4
    assert np.abs(way[1:]).max() < 1e-6
    assert run.rotation[-1, 0, 0] > 1 - 1e-9


def test_left_and_right_turns_are_mirror_images(model: BodyModel, swim: Swim) -> None:
    stroke = controllers.swim(swim)
    period = stroke.period // 4
    half = 3.141592653589793
    left = record(model, controllers.turn_left(stroke, 0.3, 180), 330)
    other = stroke._replace(offset=half)
    right = record(model, controllers.turn_right(other, 0.3, 180), 330)
    assert np.abs(left.origin[:, :2] * (1, -1) - right.origin[:, :2]).max() < 1e-7
    ahead = left.rotation[-period:, :, 0].mean(axis=0)
    assert np.degrees(np.arctan2(ahead[1], ahead[0])) > 25


def test_gliding_is_doing_nothing(model: BodyModel) -> None:
    run = record(model, controllers.glide(), 60)
    assert np.abs(run.nodes - model.start).max() < 1e-9


def test_the_swim_of_a_gear_beats_in_whole_frames(swim: Swim) -> None:
    cruise, fast = controllers.swim(swim), controllers.swim(swim, 0.5, 1.6)
    assert cruise.period == 4 * round(60 / swim.frequency_hz)
    assert fast.period == 4 * round(60 / (1.6 * swim.frequency_hz))
    assert fast.rear == 0.5 * swim.contraction_rear


def test_folded_fins_change_nothing_and_couples_push_nobody(
    model: BodyModel, swim: Swim, body: Body
) -> None:
    state = cruising(model, controllers.swim(swim))
    right = np.zeros(69)
    press(FOLDED, 400.0, model.mass, state.position, state.velocity, 5, 1 / 240, right)
    assert not right.any()
    fins = controllers.ascend(controllers.glide()).fins
    press(fins, 400.0, model.mass, state.position, state.velocity, 5, 1 / 240, right)
    pushes = right.reshape(23, 3)
    assert np.abs(pushes).max() > 1e-4
    assert np.abs(pushes.sum(axis=0)).max() < 1e-12
    assert not pushes[13:].any()


def test_the_published_law_swims_at_twice_the_strouhal_number(body: Body, swim: Swim) -> None:
    stroke = controllers.swim(swim)
    period = stroke.period // 4
    found = {}
    for law in ("streamlined", "published"):
        run = record(body_model(body, swim, law=law), stroke, 480)
        way = (run.origin[-1] - run.origin[-1 - period])[:2]
        course = way / np.linalg.norm(way)
        tail = run.nodes[-period:, 21:, :2].mean(axis=1)
        sweep = np.ptp(tail @ (-course[1], course[0]))
        found[law] = sweep / np.linalg.norm(way)
        assert run.rotation[-period:, :2, 0].mean(axis=0) @ course > 0.95
    assert 0.2 < found["streamlined"] < 0.35
    assert found["published"] > 0.5
    assert LAWS["published"].tolist()[1:] == [0.0, 1.0]
    with pytest.raises(KeyError):
        body_model(body, swim, law="none")


def test_the_largest_joint_is_the_sharpest_bend_of_the_centre_line(model: BodyModel) -> None:
    nodes = np.tile(model.start, (3, 1, 1))
    assert largest_joint(nodes) == pytest.approx(0.0, abs=1e-12)
    hinge = nodes[1, 17:21].mean(axis=0)
    a = np.radians(50.0)
    about = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    nodes[1, 21:] = (nodes[1, 21:] - hinge) @ about.T + hinge
    assert np.degrees(largest_joint(nodes)) == pytest.approx(50.0, abs=1e-6)
