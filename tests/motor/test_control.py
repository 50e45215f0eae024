"""Control: the choice of segments and careful steering (papers/000, 6.1 and 6.2)."""

from collections.abc import Callable

import numpy as np
import pytest

from components.arrays import Float64s
from components.clock import Clock
from components.fish import Population
from components.repertoire import Pattern, RepertoireLibrary
from components.table import Columns
from components.terrain import Terrain
from systems.motor.choose import MOOD_SPREAD, MOOD_TICKS, gaits
from systems.motor.control import (
    STEEPEST,
    YAW_RATE,
    Control,
    Controlled,
    control_parallel,
    control_rows,
    half_tangent_angle,
)
from systems.motor.move import Move

School = Callable[[int, RepertoireLibrary], Population]


def _towards(yaw_deg: float, climb_deg: float = 0.0) -> Float64s:
    a, b = np.radians(yaw_deg), np.radians(climb_deg)
    return np.array([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)])


def _run(
    fish: Population, library: RepertoireLibrary, sea: Terrain, ticks: int
) -> tuple[Float64s, Float64s, Float64s]:
    """Return x axes, patterns played and steering of every tick."""
    clock = Clock(7)
    control, move, n = Control(fish, library, clock), Move(fish, library, sea, clock), fish.count
    x, played, steer = [], [], []
    for _ in range(ticks):
        control()
        steer.append(fish.motor.steer[:n].copy())
        move()
        x.append(fish.fish.rotation[:n, :, 0].copy())
        played.append(library.pattern[fish.motor.segment[:n]].astype(np.float64))
        clock.tick[0] += 1
    return np.array(x), np.array(played), np.array(steer)


def _angle_deg(x: Float64s, g: Float64s) -> Float64s:
    mean = x.mean(axis=0)
    cosine = (mean * g).sum(-1) / np.linalg.norm(mean, axis=-1)
    degrees: Float64s = np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))
    return degrees


@pytest.mark.parametrize("urgency", [0.0, 1.0])
def test_every_fish_turns_to_its_heading(
    school: School, captured: RepertoireLibrary, sea: Terrain, urgency: float
) -> None:
    fish = school(24, captured)
    goals = [_towards(15.0 * k - 175.0, 8.0 * (k % 7) - 24.0) for k in range(24)]
    fish.motor.heading[:24] = goals
    fish.motor.urgency[:24] = urgency
    x, _, _ = _run(fish, captured, sea, 360)
    assert _angle_deg(x[-60:], np.array(goals)).max() < 2.0


@pytest.mark.parametrize(
    ("yaw", "pattern"),
    [
        (58.0, Pattern.TURN_LEFT),
        (-58.0, Pattern.TURN_RIGHT),
        (90.0, Pattern.TURN_SHARP_LEFT),
        (-90.0, Pattern.TURN_SHARP_RIGHT),
        (40.0, None),
        (-40.0, None),
    ],
)
def test_a_turn_segment_serves_a_direction_far_to_the_side(
    school: School, captured: RepertoireLibrary, sea: Terrain, yaw: float, pattern: Pattern | None
) -> None:
    fish = school(1, captured)
    fish.motor.heading[0] = _towards(yaw)
    _, played, _ = _run(fish, captured, sea, 120)
    turns = set(played[played >= Pattern.TURN_LEFT].tolist())
    assert turns == (set() if pattern is None else {float(pattern)})


@pytest.mark.parametrize("yaw", [100.0, -100.0, 150.0])
def test_in_mortal_danger_a_fish_makes_a_fast_start(
    school: School, captured: RepertoireLibrary, sea: Terrain, yaw: float
) -> None:
    fish = school(2, captured)
    fish.fish.species[1] = 1
    fish.motor.segment[1] = fish.motor.wanted[1] = captured.segment[1, Pattern.SWIM_MEDIUM]
    fish.motor.frame[1] = 0
    fish.motor.shape_row[1] = captured.start[fish.motor.segment[1]]
    fish.motor.held[:2] = 60
    fish.motor.gear[:2] = 2
    fish.motor.urgency[:2] = 1.0
    fish.motor.heading[:2] = _towards(yaw)
    x, played, _ = _run(fish, captured, sea, 150)
    side = Pattern.FAST_START_LEFT if yaw > 0 else Pattern.FAST_START_RIGHT
    assert (played[0] == side).all()
    assert (played[-1] == Pattern.SWIM_FAST).all()
    assert _angle_deg(x[45:75], fish.motor.heading[:2]).max() < 70.0
    assert _angle_deg(x[-20:], fish.motor.heading[:2]).max() < 3.0


def test_in_danger_short_of_mortal_a_turn_is_sharp_but_no_fast_start(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(2, captured)
    fish.motor.urgency[:2] = 0.7
    fish.motor.held[:2] = 60
    fish.motor.heading[:2] = (_towards(50.0), _towards(130.0))
    _, played, _ = _run(fish, captured, sea, 100)
    assert (played[0] == Pattern.TURN_SHARP_LEFT).all()
    assert played.max() == Pattern.TURN_SHARP_LEFT


def test_a_turn_whose_end_would_lead_past_the_direction_is_broken_off(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, captured)
    fish.motor.heading[0] = _towards(100.0)
    control, move = Control(fish, captured, Clock(7)), Move(fish, captured, sea, Clock(7))
    fish.motor.held[0] = 60
    for _ in range(8):
        control()
        move()
    assert captured.pattern[fish.motor.segment[0]] == Pattern.TURN_SHARP_LEFT
    fish.motor.heading[0] = _towards(-60.0)
    control()
    assert captured.pattern[fish.motor.wanted[0]] < Pattern.TURN_LEFT


def test_danger_turns_a_fish_faster_than_leisure(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(2, library)
    fish.motor.heading[:2] = _towards(30.0)
    fish.motor.urgency[:2] = (0.0, 1.0)
    x, _, steer = _run(fish, library, sea, 30)
    left = _angle_deg(x[-10:], fish.motor.heading[:2])
    assert left[1] < 0.5 * left[0]
    assert np.abs(steer[:, 0, 2]).max() <= YAW_RATE[0] / 60 + 1e-12
    assert np.abs(steer[:, 1, 2]).max() <= YAW_RATE[1] / 60 + 1e-12


def test_steering_has_no_jerks(school: School, library: RepertoireLibrary, sea: Terrain) -> None:
    fish = school(6, library)
    fish.motor.heading[:6] = [_towards(yaw) for yaw in (-170, -90, -40, 40, 90, 170)]
    fish.motor.urgency[:6] = 1.0
    _, _, steer = _run(fish, library, sea, 240)
    assert np.abs(np.diff(steer, axis=0)).max() < 0.01
    assert np.abs(steer).max() > 0.015


@pytest.mark.parametrize("climb", [-90.0, -70.0, 70.0, 90.0])
def test_no_fish_climbs_or_dives_beyond_40_degrees(
    school: School, library: RepertoireLibrary, sea: Terrain, climb: float
) -> None:
    fish = school(1, library)
    fish.motor.heading[0] = _towards(0.0, climb)
    fish.fish.position[0, 2] = -30.0
    x, _, _ = _run(fish, library, sea, 240)
    rise = x[-60:].mean(axis=0)[0, 2]
    assert np.sign(rise) == np.sign(climb)
    assert abs(rise) == pytest.approx(STEEPEST, abs=0.03)


@pytest.mark.parametrize("gear", [0, 1, 2])
def test_in_earnest_a_fish_plays_the_gear_it_is_asked_for(
    school: School, captured: RepertoireLibrary, sea: Terrain, gear: int
) -> None:
    fish = school(30, captured)
    fish.motor.gear[:30] = gear
    fish.motor.urgency[:30] = 0.6
    _, played, _ = _run(fish, captured, sea, 400)
    assert (played[60:] == gear).all()


def test_at_leisure_fishes_change_gear_at_random_and_not_together(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(60, captured)
    _, played, _ = _run(fish, captured, sea, 900)
    slow = (played == Pattern.SWIM_SLOW).mean(axis=1)
    assert 0.05 < slow[300:].mean() < 0.4
    assert slow[300:].max() < 0.5
    changes = (np.diff(played, axis=0) != 0).sum(axis=0)
    assert changes.max() <= 900 / MOOD_TICKS + 1
    assert (changes > 0).mean() > 0.5
    when = np.argmax(np.diff(played[1:], axis=0) != 0, axis=0)
    assert len(set(when[changes > 0].tolist())) > 20
    assert MOOD_SPREAD & (MOOD_SPREAD - 1) == 0


def test_a_fish_whose_aim_lies_behind_keeps_to_one_side(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(15, captured)
    fish.motor.heading[:15] = _towards(180.0)
    x, _, steer = _run(fish, captured, sea, 60)
    for k in range(15):
        signs = np.sign(steer[5:, k, 2])
        assert (signs == signs[0]).all()
    assert (_angle_deg(x[-10:], fish.motor.heading[:15]) < 150.0).all()


def test_a_species_without_turns_or_gears_swims_on(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    bare = np.full((1, len(Pattern)), -1, np.int32)
    bare[0, 1] = library.segment[0, 1]
    poor = type(library)(**{**vars(library), "segment": bare})
    fish = school(3, poor)
    fish.motor.gear[:3] = (0, 1, 2)
    fish.motor.urgency[:3] = 1.0
    fish.motor.heading[:3] = _towards(120.0)
    x, played, _ = _run(fish, poor, sea, 240)
    assert (played == Pattern.SWIM_MEDIUM).all()
    assert _angle_deg(x[-30:], fish.motor.heading[:3]).max() < 4.0


def test_threads_and_rows_change_no_bit(school: School, captured: RepertoireLibrary) -> None:
    rng = np.random.default_rng(4)
    g = rng.normal(size=(200, 3))
    g /= np.linalg.norm(g, axis=1)[:, None]
    gait = gaits(captured)
    results = []
    for threads, order in ((1, np.arange(200)), (2, np.arange(200)), (1, rng.permutation(200))):
        fish = school(200, captured)
        fish.motor.heading[:200] = g
        fish.motor.held[:200] = np.arange(200) % 60
        fish.motor.urgency[:200] = np.linspace(0, 1, 200)
        fish.reorder(order)
        columns = Columns(Controlled, fish.fish, fish.motor)()
        for tick in range(5):
            if threads == 1:
                control_rows(0, 200, columns, gait, 11, tick)
            else:
                control_parallel(200, columns, gait, 11, tick)
        back = np.argsort(fish.fish.id[:200])
        results.append((fish.motor.wanted[back].tobytes(), fish.motor.steer[back].tobytes()))
    assert results[0] == results[1] == results[2]
    assert len(set(np.frombuffer(results[0][0], np.int32).tolist())) > 2


def test_angles_come_from_half_tangents() -> None:
    angles = np.linspace(-np.pi / 2, np.pi / 2, 181)
    found = [half_tangent_angle(float(np.sin(a)), float(np.cos(a))) for a in angles]
    assert np.abs(np.array(found) - angles).max() < 0.011
    behind = np.linspace(np.pi / 2, np.pi, 91)
    found = [half_tangent_angle(float(np.sin(a)), float(np.cos(a))) for a in behind]
    assert np.abs(np.array(found) - behind).max() < 0.011
    assert half_tangent_angle(-0.1, -0.99) == pytest.approx(-np.pi + 0.1, abs=0.02)
