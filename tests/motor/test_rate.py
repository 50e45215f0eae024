"""Rate: swims played faster or slower than captured close as captured, and nothing jumps between entries."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from components.arrays import Float32s, Float64s
from components.clock import Clock
from components.fish import Population
from components.motor import KEPT, RATES, gear_for_speed, shown_between
from components.repertoire import Pattern, RepertoireLibrary, pack
from components.repertoire_file import load
from components.terrain import Terrain
from systems.motor.columns import bodies, motors
from systems.motor.control import Control
from systems.motor.move import Move, move_parallel, move_rows
from systems.motor.pose import pose, reconstruct
from systems.motor.rate import GAINING, SETTLING, play_entries
from systems.motor.track import PLANE, rotation_vectors, track

School = Callable[[int, RepertoireLibrary], Population]
CYCLES = 1_000


@pytest.fixture(scope="module")
def nine(installed: Path) -> RepertoireLibrary:
    """The library of all shipped species."""
    folder = installed / "assets" / "repertoires"
    return pack([load(path) for path in sorted(folder.glob("*.npz"))])


def _travel(
    library: RepertoireLibrary, segment: int, rate: float, entries: int
) -> tuple[Float64s, Float64s]:
    """Play so many entries of a segment, the last tick cut to end on the whole; return where and how it ends."""
    played, r, o = track(library), np.eye(3), np.zeros(3)
    frame, part, left = 0, 0.0, float(entries)
    while left > 1e-6:
        step = min(rate, left)
        frame, part, way, axes = play_entries(segment, frame, part, part + step, 1.0, played)
        r, o = r @ np.transpose(axes), o + r @ way
        left -= step
    return r, o


@pytest.mark.parametrize("segment", [0, 1, 2, 10])
@pytest.mark.parametrize("rate", [RATES[0], 0.8317, RATES[1]])
def test_a_thousand_cycles_at_any_rate_go_straight_and_as_far_as_captured(
    captured: RepertoireLibrary, segment: int, rate: float
) -> None:
    length = int(captured.length[segment])
    _, stride = _travel(captured, segment, 1.0, length)
    r, way = _travel(captured, segment, rate, CYCLES * length)
    assert np.degrees(np.abs(r[1:, 0])).max() < 0.1
    np.testing.assert_allclose(r @ r.T, np.eye(3), atol=1e-9)
    np.testing.assert_allclose(way, CYCLES * stride, atol=1e-4 * CYCLES * stride[0], rtol=0)


def test_shares_of_an_entry_add_up_to_it(captured: RepertoireLibrary) -> None:
    played, entry = track(captured), 4
    r, o = np.eye(3), np.zeros(3)
    for begun, end in ((0.0, 0.15), (0.15, 0.8), (0.8, 1.0)):
        frame, part, way, axes = play_entries(0, entry, begun, end, 1.0, played)
        r, o = r @ np.transpose(axes), o + r @ way
    assert (frame, part) == (entry + 1, 0.0)
    np.testing.assert_allclose(r, captured.rotation[entry], atol=1e-8)
    np.testing.assert_allclose(o, captured.translation[entry], atol=1e-10)


def test_rotation_vectors_turn_as_the_captured_rotations(nine: RepertoireLibrary) -> None:
    vector = rotation_vectors(nine.rotation)
    angle = np.linalg.norm(vector, axis=1)
    cross = nine.rotation - nine.rotation.transpose(0, 2, 1)
    sine = np.sqrt((cross**2).sum(axis=(1, 2)) / 8.0)
    arc = np.arcsin(sine)
    assert np.abs(angle - arc)[arc < 0.2].max() < 1e-9
    assert np.abs(angle - arc).max() < 1e-6
    swims = np.repeat(nine.loops == 1, nine.length)
    assert arc[swims].max() < 0.2
    turned = np.einsum("eij,ej->ei", nine.rotation, vector)
    np.testing.assert_allclose(turned, vector, atol=1e-9)


@pytest.mark.parametrize("throttle", [RATES[0], 0.9, 1.3, RATES[1]])
def test_frequency_and_speed_grow_alike_with_the_rate(
    school: School, captured: RepertoireLibrary, sea: Terrain, throttle: float
) -> None:
    fish = school(1, captured)
    fish.motor.throttle[0] = throttle
    move = Move(fish, captured, sea, Clock())
    for _ in range(60):
        move()
    beats, ticks, frame = 0, 600, int(fish.motor.frame[0])
    start = fish.fish.position[0].copy()
    for _ in range(ticks):
        move()
        beats += int(fish.motor.frame[0]) < frame
        frame = int(fish.motor.frame[0])
    medium = captured.segment[0, Pattern.SWIM_MEDIUM]
    assert beats == pytest.approx(throttle * ticks / captured.length[medium], abs=1.0)
    way = fish.fish.position[0] - start
    assert way[0] / 10.0 == pytest.approx(throttle * captured.speed[medium], rel=0.02)


def test_below_the_lowest_rate_the_beat_goes_on_and_strides_shrink(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(1, library)
    fish.motor.throttle[0] = 0.0
    move = Move(fish, library, sea, Clock())
    for _ in range(60):
        move()
    start, phases = fish.fish.position[0].copy(), []
    for _ in range(30):
        move()
        phases.append(fish.motor.frame[0] + fish.motor.part[0])
    np.testing.assert_allclose(np.diff(phases) % 15, RATES[0], atol=1e-9)
    np.testing.assert_allclose(fish.fish.position[0], start, atol=1e-9)


def _shape(library: RepertoireLibrary, row: NDArray[np.int32], part: Float64s) -> Float32s:
    """Return the shapes the share `part` of the way from `row` to the next, (n, 23, 3)."""
    w = part[:, None, None]
    shape = (1 - w) * library.shape[row] + w * library.shape[library.after[row]]
    return shape.astype(np.float32)


def _steered(
    fish: Population, library: RepertoireLibrary, rng: np.random.Generator, share: float
) -> None:
    """Ask a share of the fishes for another segment, and a share for another throttle."""
    n, motor = fish.count, fish.motor
    species = fish.fish.species[:n]
    wanted = library.segment[species, rng.integers(0, len(Pattern), n)]
    motor.wanted[:n] = np.where(rng.random(n) < share, wanted, motor.wanted[:n])
    asked = rng.choice([1.0, 0.7, 1.5, -0.2, 0.0, 0.85, 1.23], n)
    motor.throttle[:n] = np.where(rng.random(n) < 0.05, asked, motor.throttle[:n])


def _mixed(school: School, captured: RepertoireLibrary) -> Population:
    """Return 120 fishes of two species."""
    fish = school(120, captured)
    fish.fish.species[60:120] = 1
    fish.motor.segment[60:120] = fish.motor.wanted[60:120] = captured.segment[1, 1]
    fish.motor.frame[60:120] = 0
    fish.motor.shape_row[60:120] = captured.start[captured.segment[1, 1]] + 19
    return fish


@pytest.mark.parametrize(
    ("ticks", "least"), [(260, 1_000), pytest.param(2_600, 10_000, marks=pytest.mark.prove)]
)
def test_no_change_of_segment_at_any_rate_makes_a_node_jump(
    school: School, captured: RepertoireLibrary, sea: Terrain, ticks: int, least: int
) -> None:
    fish, rng, n = _mixed(school, captured), np.random.default_rng(8), 120
    move, motor = Move(fish, captured, sea, Clock()), fish.motor
    shown, worst, changes, between = pose(fish, captured, body=True), 0.0, 0, 0
    for _ in range(ticks):
        _steered(fish, captured, rng, 0.1)
        segment = motor.segment[:n].copy()
        move()
        before, shown = shown, pose(fish, captured, body=True)
        switched = segment != motor.segment[:n]
        last = np.where(switched, motor.warp_to[:n], motor.last_shape_row[:n])
        own = _shape(captured, motor.shape_row[:n], motor.part[:n])
        own -= _shape(captured, last, np.where(switched, 0.0, motor.last_part[:n]))
        jump = np.sqrt(((shown - before - own) ** 2).sum(-1)).max()
        worst, changes = max(worst, float(jump)), changes + int(switched.sum())
        between += int((switched & (motor.warp_part[:n] > 0)).sum())
    assert changes > least
    assert between > least / 4
    assert worst < 0.03 + 1e-6


def test_what_is_shown_runs_on_between_ticks_and_from_tick_to_tick(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish, rng = _mixed(school, captured), np.random.default_rng(9)
    move = Move(fish, captured, sea, Clock())
    steps = captured.shape[captured.after] - captured.shape
    most = 0.35 * (RATES[1] * np.sqrt((steps**2).sum(-1)).max() + 0.03)
    for _ in range(90):
        _steered(fish, captured, rng, 0.1)
        before = pose(fish, captured, body=True)
        move()
        shown = [pose(fish, captured, alpha=a, body=True) for a in (0.0, 0.35, 0.7, 1.0)]
        np.testing.assert_allclose(shown[0], before, atol=3e-6, rtol=0)
        assert np.sqrt((np.diff(shown, axis=0) ** 2).sum(-1)).max() < most + 1e-5
    assert (fish.motor.part[:120] > 0).sum() > 30
    assert (fish.motor.warp_weight[:120] > 0).any()


def test_the_fast_kernel_shows_shapes_between_entries(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish, rng = _mixed(school, captured), np.random.default_rng(10)
    move = Move(fish, captured, sea, Clock())
    for _ in range(60):
        _steered(fish, captured, rng, 0.1)
        move()
    nodes = np.empty((120, 3, PLANE), np.float32)
    played = track(captured)
    reconstruct(120, bodies(fish.fish), motors(fish.motor), played.shape, played.after, nodes)
    planes = pose(fish, captured).transpose(0, 2, 1)
    np.testing.assert_allclose(nodes[:, :, : PLANE - 1], planes, atol=4e-6)
    weight, part = fish.motor.warp_weight[:120] > 0, fish.motor.part[:120] > 0
    assert (weight & part).any()
    assert (~weight & part).any()


def test_a_fish_asked_for_the_gear_s_own_speed_again_settles_onto_whole_entries(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = school(15, library)
    fish.motor.throttle[:15] = np.linspace(0.7, 1.5, 15)
    move = Move(fish, library, sea, Clock())
    for _ in range(80):
        move()
    assert (fish.motor.part[:15] > 0).sum() > 10
    fish.motor.throttle[:15] = 1.0
    shown = pose(fish, library, body=True)
    for _ in range(int(0.5 / GAINING) + int(0.5 / SETTLING) + 2):
        move()
        before, shown = shown, pose(fish, library, body=True)
        assert np.abs(shown - before).max() < 0.1
    assert (fish.motor.pace[:15] == 1.0).all()
    assert not fish.motor.part[:15].any()
    assert not fish.motor.last_part[:15].any()
    start = fish.fish.position[:15].copy()
    for _ in range(15):
        move()
    way = np.linalg.norm(fish.fish.position[:15] - start, axis=1)
    np.testing.assert_allclose(way, 2.0 * 15 / 60, rtol=0.01)


def test_a_change_of_gear_keeps_the_speed_that_is_asked_for(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish, speed = school(1, captured), 1.6
    own = captured.speed[captured.segment[0, :3]]
    move, motor = Move(fish, captured, sea, Clock()), fish.motor
    places = []
    for tick in range(420):
        gear = 0 if tick < 200 else 1
        motor.wanted[0] = captured.segment[0, gear]
        motor.throttle[0] = speed / own[gear]
        move()
        places.append(fish.fish.position[0].copy())
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1) * 60
    beat = np.convolve(steps[120:], np.ones(20) / 20, "valid")
    assert motor.segment[0] == captured.segment[0, 1]
    assert beat.min() > 0.92 * speed
    assert beat.max() < 1.08 * speed


def test_a_fish_at_a_rate_of_its_own_is_where_it_would_be_when_nobody_looks(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    found = []
    for looks in (True, False):
        fish, rng = _mixed(school, captured), np.random.default_rng(11)
        move = Move(fish, captured, sea, Clock())
        for k in range(600):
            _steered(fish, captured, rng, 0.03)
            move()
            if looks:
                pose(fish, captured, alpha=k / 600)
        found.append((fish.fish.snapshot(), fish.motor.snapshot()))
    for seen, unseen in zip(*found, strict=True):
        for name in seen:
            np.testing.assert_array_equal(seen[name], unseen[name])
    assert found[0][1]["part"].any()


def test_all_threads_compute_the_same_bits_at_any_rate(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    found = []
    for kernel in (partial(move_rows, 0), move_parallel):
        fish, rng = _mixed(school, captured), np.random.default_rng(12)
        for _ in range(40):
            _steered(fish, captured, rng, 0.1)
            kernel(120, bodies(fish.fish), motors(fish.motor), track(captured), sea)
        found.append({**fish.fish.snapshot(), **fish.motor.snapshot()})
    for name, values in found[0].items():
        np.testing.assert_array_equal(values, found[1][name])
    assert found[0]["part"].any()


def test_gears_and_rates_leave_no_speed_out(nine: RepertoireLibrary) -> None:
    for speeds in nine.speed[nine.segment[:, :3]]:
        slow, medium, fast = map(float, speeds)
        for gear in (0, 1, 2):
            for speed in np.linspace(RATES[0] * slow, RATES[1] * fast, 200):
                chosen, throttle = gear_for_speed(float(speed), gear, slow, medium, fast)
                assert RATES[0] - 1e-9 <= throttle <= RATES[1] + 1e-9
                assert throttle * speeds[chosen] == pytest.approx(speed)


def test_a_wavering_demand_changes_no_gear() -> None:
    gear, _ = gear_for_speed(1.42, 0, 1.0, 2.0, 3.0)
    assert gear == 1
    assert KEPT[0] * 2.0 == 1.5
    assert gear_for_speed(1.5, 1, 1.0, 2.0, 3.0) == (1, 0.75)
    assert gear_for_speed(1.39, 0, 1.0, 2.0, 3.0)[0] == 0
    assert gear_for_speed(0.0, 2, 1.0, 2.0, 3.0) == (0, 0.0)


@pytest.mark.parametrize(("throttle", "kept"), [(0.95, True), (1.0, False)])
def test_a_fish_asked_for_a_speed_of_its_own_keeps_its_gear_at_leisure(
    school: School, captured: RepertoireLibrary, sea: Terrain, throttle: float, kept: bool
) -> None:
    fish, clock = school(40, captured), Clock(7)
    fish.motor.throttle[:40] = throttle
    control, move = Control(fish, captured, clock), Move(fish, captured, sea, clock)
    played = set()
    for _ in range(500):
        control()
        move()
        clock.tick[0] += 1
        played.update(captured.pattern[fish.motor.segment[:40]].tolist())
    assert (played == {Pattern.SWIM_MEDIUM}) is kept


@pytest.mark.parametrize(
    ("last", "now", "alpha", "expected"),
    [
        ((3, 0.0), (4, 0.0), 0.25, (3, 4, 0.25)),
        ((1, 0.5), (2, 0.25), 0.5, (1, 2, 0.875)),
        ((1, 0.5), (2, 0.25), 1.0, (2, 3, 0.25)),
        ((3, 0.75), (0, 0.25), 0.5, (4, 0, 0.5)),
        ((2, 0.5), (2, 0.75), 0.5, (2, 3, 0.625)),
        ((1, 0.0), (7, 0.5), 0.5, (1, 7, 0.5)),
    ],
)
def test_between_ticks_neighbouring_rows_are_shown_round_the_loop(
    last: tuple[int, float],
    now: tuple[int, float],
    alpha: float,
    expected: tuple[int, int, float],
) -> None:
    after = np.array([1, 2, 3, 4, 0, 6, 7, 5], np.int32)
    a, b, share = shown_between(*last, *now, alpha, after)
    assert (a, b) == expected[:2]
    assert share == pytest.approx(expected[2])
