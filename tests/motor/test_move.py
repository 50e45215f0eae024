"""Move: replay, scale, balance, steering, warping and independence of order, threads and view."""

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
import pytest

from components.arrays import Float32s, Float64s
from components.clock import Clock
from components.fish import Population
from components.motor import PACES
from components.repertoire import Pattern, RepertoireLibrary
from components.terrain import MARGIN, Terrain, ground_height
from systems.motor.columns import bodies, motors
from systems.motor.move import Move, move_parallel, move_rows
from systems.motor.pose import pose
from systems.motor.rate import BRAKING
from systems.motor.track import track
from systems.motor.warp import SHORTEST_WARP, WARP_STEP

School = Callable[[int, RepertoireLibrary], Population]


def _state(population: Population) -> dict[int, tuple[bytes, ...]]:
    """Return every column of every fish as bytes, by id."""
    tables = (population.fish, population.motor)
    return {
        identity: tuple(
            getattr(table, name)[row].tobytes() for table in tables for name in table.columns
        )
        for row, identity in enumerate(population.fish.id[: population.count].tolist())
    }


def _roll_deg(rotation: Float64s) -> Float64s:
    return np.degrees(np.arctan2(-rotation[..., 2, 2], rotation[..., 2, 1]))


def _rolled(population: Population, degrees: float) -> None:
    a = np.radians(degrees)
    about_x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    rows = slice(0, population.count)
    population.fish.rotation[rows] = population.fish.rotation[rows] @ about_x


def test_a_cycle_ends_in_the_recorded_pose_one_stride_ahead(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, library)
    move = Move(fish, library, sea, Clock())
    before, start = pose(fish, library, body=True), fish.fish.position[0].copy()
    for _ in range(15):
        move()
    np.testing.assert_array_equal(pose(fish, library, body=True), before)
    travelled = fish.fish.position[0] - start
    assert travelled[0] == pytest.approx(2.0 * 15 / 60, rel=0.01)
    assert abs(travelled[2]) < 0.01


@pytest.mark.parametrize("segment", [0, 1, 2, 9, 10, 11])
def test_a_swim_goes_straight_and_level_at_the_segment_s_speed(
    school: School, captured: RepertoireLibrary, sea: Terrain, segment: int
) -> None:
    fish = school(1, captured)
    fish.fish.species[0] = segment // len(Pattern)
    fish.motor.segment[0] = fish.motor.wanted[0] = segment
    fish.motor.frame[0] = 0
    fish.motor.shape_row[0] = captured.start[segment]
    move = Move(fish, captured, sea, Clock())
    track_ = [fish.fish.position[0].copy()]
    for _ in range(480):
        move()
        track_.append(fish.fish.position[0].copy())
    path = np.array(track_) - track_[0]
    assert path[-1, 0] / 8.0 == pytest.approx(captured.speed[segment], rel=0.03)
    assert np.abs(path[:, 1]).max() < 0.02 * path[-1, 0] + 0.05
    assert np.abs(path[:, 2]).max() < 0.02 * path[-1, 0] + 0.05


def test_length_scales_the_way_as_it_scales_the_body(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(2, library)
    fish.motor.frame[1] = fish.motor.frame[0]
    fish.motor.shape_row[1] = fish.motor.shape_row[0]
    fish.fish.position[:2] = (0.0, 0.0, -8.0)
    fish.fish.length[:2] = (0.25, 0.5)
    move = Move(fish, library, sea, Clock())
    for _ in range(40):
        move()
    way = fish.fish.position[:2] - (0.0, 0.0, -8.0)
    np.testing.assert_allclose(way[1], 2.0 * way[0], rtol=1e-9, atol=1e-9)
    assert way[0, 0] > 0.3


@pytest.mark.parametrize("degrees", [-150.0, -70.0, 40.0, 90.0, 179.9, 180.0])
def test_balance_rights_a_rolled_fish_within_seconds(
    school: School, library: RepertoireLibrary, sea: Terrain, degrees: float
) -> None:
    fish = school(1, library)
    _rolled(fish, degrees)
    move = Move(fish, library, sea, Clock())
    rolls = []
    for _ in range(60 * 6):
        move()
        rolls.append(float(_roll_deg(fish.fish.rotation[0])))
    assert abs(np.mean(rolls[-15:])) < 2.0
    assert np.abs(np.diff(np.unwrap(rolls, period=360.0))).max() < 5.0


def test_balance_does_not_fight_the_beat(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, library)
    move = Move(fish, library, sea, Clock())
    rolls = []
    for _ in range(300):
        move()
        rolls.append(float(_roll_deg(fish.fish.rotation[0])))
    recorded = np.degrees(0.1)
    assert np.ptp(rolls[-60:]) / 2 == pytest.approx(recorded, rel=0.1)


def test_steering_turns_by_its_rotation_vector(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, library)
    fish.motor.steer[0] = (0.0, 0.0, 0.02)
    move = Move(fish, library, sea, Clock())
    for _ in range(75):
        move()
    x = fish.fish.rotation[0, :, 0]
    turned = np.arctan2(x[1], x[0])
    assert turned == pytest.approx(1.5, abs=0.02)
    r = fish.fish.rotation[0]
    np.testing.assert_allclose(r @ r.T, np.eye(3), atol=1e-9)


def test_a_turn_segment_turns_and_returns_to_the_medium_swim(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, library)
    fish.motor.wanted[0] = library.segment[0, Pattern.TURN_LEFT]
    move = Move(fish, library, sea, Clock())
    for _ in range(45):
        move()
    assert fish.motor.segment[0] == library.segment[0, Pattern.TURN_LEFT]
    for _ in range(30):
        move()
    medium = library.segment[0, Pattern.SWIM_MEDIUM]
    assert fish.motor.segment[0] == fish.motor.wanted[0] == medium
    x = fish.fish.rotation[0, :, 0]
    assert np.arctan2(x[1], x[0]) == pytest.approx(0.9, abs=0.15)


def test_a_change_waits_until_the_warp_has_decayed(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, library)
    move = Move(fish, library, sea, Clock())
    fish.motor.wanted[0] = Pattern.SWIM_FAST
    move()
    assert fish.motor.segment[0] == Pattern.SWIM_FAST
    fish.motor.wanted[0] = Pattern.SWIM_SLOW
    for _ in range(int(fish.motor.warp_length[0]) - 1):
        assert fish.motor.segment[0] == Pattern.SWIM_FAST
        move()
    assert fish.motor.warp_weight[0] == 0.0
    move()
    assert fish.motor.segment[0] == Pattern.SWIM_SLOW
    assert fish.motor.warp_length[0] >= SHORTEST_WARP


def _own_motion(fish: Population, library: RepertoireLibrary, switched: Float64s) -> Float32s:
    """Return how each node moves by its segment alone, whatever was played before, (n, 23, 3)."""
    n, motor = fish.count, fish.motor
    before = np.where(switched, motor.warp_to[:n], motor.last_shape_row[:n])
    own: Float32s = library.shape[motor.shape_row[:n]] - library.shape[before]
    return own


def _changes(
    fish: Population, library: RepertoireLibrary, sea: Terrain, ticks: int
) -> Iterator[tuple[Float64s, Float32s, Float32s]]:
    """Ask for segments at random; yield who switched, the shapes before and the shapes after."""
    rng = np.random.default_rng(5)
    n = fish.count
    move = Move(fish, library, sea, Clock())
    shown = pose(fish, library, body=True)
    for _ in range(ticks):
        ask = rng.random(n) < 0.1
        species = fish.fish.species[:n]
        fish.motor.wanted[:n] = np.where(
            ask, library.segment[species, rng.integers(0, len(Pattern), n)], fish.motor.wanted[:n]
        )
        segment = fish.motor.segment[:n].copy()
        move()
        before, shown = shown, pose(fish, library, body=True)
        yield segment != fish.motor.segment[:n], before, shown


@pytest.mark.parametrize(
    ("ticks", "least"), [(240, 1_000), pytest.param(2_400, 10_000, marks=pytest.mark.prove)]
)
def test_no_change_of_segment_makes_a_node_jump(
    school: School, captured: RepertoireLibrary, sea: Terrain, ticks: int, least: int
) -> None:
    fish = school(120, captured)
    fish.fish.species[60:120] = 1
    fish.motor.segment[60:120] = fish.motor.wanted[60:120] = captured.segment[1, 1]
    fish.motor.frame[60:120] = 0
    fish.motor.shape_row[60:120] = captured.start[captured.segment[1, 1]] + 19
    worst, changes = 0.0, 0
    for switched, before, shown in _changes(fish, captured, sea, ticks):
        jump = shown - before - _own_motion(fish, captured, switched)
        worst = max(worst, float(np.sqrt((jump**2).sum(-1)).max()))
        changes += int(switched.sum())
    assert changes > least
    assert worst < 0.03 + 1e-6


def test_the_last_pose_is_the_pose_of_the_tick_before(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(40, captured)
    for _, before, _ in _changes(fish, captured, sea, 60):
        np.testing.assert_allclose(
            pose(fish, captured, alpha=0.0, body=True), before, atol=2e-6, rtol=0
        )
    assert (fish.motor.warp_weight[:40] > 0).any()


def test_a_change_of_gear_keeps_the_speed_from_jumping(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(15, library)
    move = Move(fish, library, sea, Clock())
    fish.motor.wanted[:15] = Pattern.SWIM_FAST
    steps = []
    for _ in range(12):
        move()
        steps.append(np.linalg.norm(fish.fish.position[:15] - fish.fish.last_position[:15], axis=1))
    gain = (3.2 - 2.0) / 60
    assert np.abs(np.diff(steps, axis=0)).max() < 0.5 * gain
    assert steps[-1].mean() - steps[0].mean() > 0.75 * gain


def test_every_fish_moves_alike_whatever_its_row(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    one, other = school(20, library), school(20, library)
    order = np.random.default_rng(2).permutation(20)
    other.reorder(order)
    for fish in (one, other):
        for row in range(20):
            fish.motor.wanted[row] = int(fish.fish.id[row]) % 5
        move = Move(fish, library, sea, Clock())
        for _ in range(30):
            move()
    assert _state(one) == _state(other)


def test_all_threads_and_one_compute_the_same_bits(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    serial, parallel = school(300, library), school(300, library)
    played = track(library)
    for fish, kernel in ((serial, partial(move_rows, 0)), (parallel, move_parallel)):
        fish.motor.wanted[:300] = np.arange(300) % 5
        fish.motor.steer[:300, 2] = np.linspace(-0.04, 0.04, 300)
        for _ in range(20):
            kernel(300, bodies(fish.fish), motors(fish.motor), played, sea)
    assert _state(serial) == _state(parallel)
    assert len(_state(serial)) == 300


def test_a_fish_unseen_for_ten_seconds_is_where_and_as_one_looked_at(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    seen, unseen = school(4, library), school(4, library)
    for fish, looks in ((seen, True), (unseen, False)):
        fish.motor.wanted[:4] = (0, 2, 3, 4)
        move = Move(fish, library, sea, Clock())
        for k in range(600):
            move()
            if looks:
                pose(fish, library, alpha=k / 600)
    assert _state(seen) == _state(unseen)


def test_no_fish_swims_into_the_ground(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, library)
    height = ground_height(sea.height, sea.extent, sea.cell, 0.0, 0.0)
    fish.fish.position[0] = (0.0, 0.0, height + 1.0)
    fish.fish.rotation[0] = [[0, 1, 0], [0, 0, -1], [-1, 0, 0]]
    move = Move(fish, library, sea, Clock())
    lowest = np.inf
    for _ in range(90):
        move()
        x, y, z = fish.fish.position[0]
        lowest = min(lowest, z - ground_height(sea.height, sea.extent, sea.cell, x, y))
    assert lowest == pytest.approx(MARGIN, abs=1e-6)


@pytest.mark.parametrize(("throttle", "share"), [(0.5, 0.5), (1.15, 1.15), (9.0, PACES[1])])
def test_a_swim_is_played_at_speeds_between_the_captured_ones(
    school: School, library: RepertoireLibrary, sea: Terrain, throttle: float, share: float
) -> None:
    fish = school(1, library)
    fish.motor.throttle[0] = throttle
    move = Move(fish, library, sea, Clock())
    for _ in range(60):
        move()
    start = fish.fish.position[0].copy()
    for _ in range(150):
        move()
    way = fish.fish.position[0] - start
    assert way[0] == pytest.approx(share * 2.0 * 150 / 60, rel=0.01)


def test_a_fish_brakes_without_a_jerk_stands_and_backs(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, library)
    move = Move(fish, library, sea, Clock())
    places = [fish.fish.position[0, 0]]
    for tick in range(240):
        fish.motor.throttle[0] = 0.0 if tick < 120 else -1.0
        move()
        places.append(fish.fish.position[0, 0])
    speed = np.diff(places) * 60
    assert speed[:20].mean() > 0.5
    assert np.abs(speed[45:120]).max() < 1e-9
    assert speed[-15:].mean() == pytest.approx(PACES[0] * 2.0, rel=0.01)
    assert np.abs(np.diff(speed)).max() < 1.2 * BRAKING * 2.0


def test_a_turn_is_played_as_captured_whatever_the_throttle(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, library)
    fish.motor.throttle[0] = 0.0
    move = Move(fish, library, sea, Clock())
    for _ in range(60):
        move()
    assert fish.motor.pace[0] == 0.0
    fish.motor.wanted[0] = library.segment[0, Pattern.TURN_LEFT]
    for _ in range(42):
        move()
    assert fish.motor.pace[0] == 1.0


def test_gliding_as_the_paper_prints_it_stands_and_runs_straight_to_the_new_shape(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, captured)
    move = Move(fish, captured, sea, Clock(), gliding="paper")
    move()
    before = pose(fish, captured, body=True)[0]
    place, axes = fish.fish.position[0].copy(), fish.fish.rotation[0].copy()
    fish.motor.wanted[0] = captured.segment[0, Pattern.TURN_SHARP_LEFT]
    move()
    length, shapes = int(fish.motor.warp_length[0]), [before, pose(fish, captured, body=True)[0]]
    to = captured.shape[fish.motor.warp_to[0]]
    gap = np.sqrt(((before - to) ** 2).sum(axis=1).max())
    assert length == np.ceil(gap / WARP_STEP) > 1
    for _ in range(length - 1):
        move()
        shapes.append(pose(fish, captured, body=True)[0])
    assert np.array_equal(fish.fish.position[0], place)
    assert np.array_equal(fish.fish.rotation[0], axes)
    np.testing.assert_allclose(shapes[-1], to, atol=1e-6)
    np.testing.assert_allclose(
        np.diff(shapes, axis=0), np.tile((to - before) / length, (length, 1, 1)), atol=1e-6
    )
    move()
    assert not np.array_equal(fish.fish.position[0], place)
