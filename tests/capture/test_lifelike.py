"""The nine species as shipped swim, turn and flee like living fishes (FINDINGS 1b, 3)."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import assets
from components.arrays import Float64s
from components.body import Body, Swim
from components.repertoire import Pattern, Repertoire, Segment, load, mean_speed
from systems.motor import controllers
from systems.motor.muscle_model import body_model
from tools.capture.bend import largest_joint
from tools.capture.measure import CLOSURE_LIMIT
from tools.capture.record import record

Play = Callable[[Segment, int], tuple[Float64s, Float64s, Float64s]]
ASSETS = Path(str(assets.__file__)).parent
NINE = sorted(path.stem for path in (ASSETS / "species").glob("*.yaml"))
LARGE = {"barracuda", "reef_shark"}
GEARS = (Pattern.SWIM_SLOW, Pattern.SWIM_MEDIUM, Pattern.SWIM_FAST)

pytestmark = pytest.mark.parametrize("name", NINE)


def segment(repertoire: Repertoire, pattern: Pattern) -> Segment:
    return next(s for s in repertoire.segments if s.pattern == pattern)


def on_from(cycle: Segment, entry: int) -> Segment:
    """Return a cycle that begins at another of its entries."""
    return replace(
        cycle,
        rotation=np.roll(cycle.rotation, -entry, axis=0),
        translation=np.roll(cycle.translation, -entry, axis=0),
        shape=np.roll(cycle.shape, -entry, axis=0),
    )


def after(cycle: Segment, shape: Float64s) -> Segment:
    """Return the cycle from the entry on that follows the shape nearest to `shape`."""
    away = np.abs(cycle.shape - shape).max(axis=(1, 2))
    return on_from(cycle, int(away.argmin()) + 1)


def widths(nodes: Float64s) -> Float64s:
    """Return how far nose, five rings and tail sweep from side to side [BL], of nodes on a course along x."""
    aside = nodes[:, :, 2]
    line = [aside[:, :1], aside[:, 1:21].reshape(-1, 5, 4).mean(2), aside[:, 21:].mean(1)[:, None]]
    return np.asarray(np.ptp(np.concatenate(line, axis=1), axis=0))


def turned_deg(before: Float64s, to: Float64s) -> float:
    """Return the angle to the left from one direction to another [degrees], y up."""
    cross = before[2] * to[0] - before[0] * to[2]
    return float(np.degrees(np.arctan2(cross, before[0] * to[0] + before[2] * to[2])))


def joint_deg(nodes: Float64s) -> float:
    return float(np.degrees(largest_joint(np.ascontiguousarray(nodes[:, :, [0, 2, 1]]))))


def test_cruise_sweeps_and_advances_as_a_fish_does(
    name: str, shipped: Repertoire, played: Play
) -> None:
    cruise = segment(shipped, Pattern.SWIM_MEDIUM)
    sweep = widths(played(cruise, 1)[2])
    speed = mean_speed(cruise)
    assert 0.2 < sweep[6] * 60 / len(cruise.rotation) / speed < 0.45
    assert 0.12 < sweep[6] < 0.24
    assert sweep[0] < 0.5 * sweep[6]
    assert sweep[2] < sweep[3] < sweep[4] < sweep[5] < sweep[6]
    if name not in LARGE:
        assert 1 < speed < 3


def test_the_wave_of_bending_runs_backwards_and_grows(shipped: Repertoire, played: Play) -> None:
    nodes = played(segment(shipped, Pattern.SWIM_MEDIUM), 1)[2]
    line = np.stack([nodes[:, 4 * i + 1 : 4 * i + 5, 2].mean(axis=1) for i in range(5)], axis=1)
    bends = line[:, 1:-1] - 0.5 * (line[:, :-2] + line[:, 2:])
    wave = np.fft.fft(bends, axis=0)[1]
    assert 0.2 < np.angle(wave[1] / wave[2]) < np.pi
    assert np.abs(wave[0]) < np.abs(wave[2])


@pytest.mark.parametrize("pattern", GEARS)
def test_a_beat_ends_in_the_shape_that_it_began_with(shipped: Repertoire, pattern: Pattern) -> None:
    closure = shipped.provenance[pattern.name.lower()].split("closure ")[1].split()[0]
    assert float(closure) < CLOSURE_LIMIT
    beat = segment(shipped, pattern)
    steps = np.abs(np.diff(beat.shape, axis=0)).max(axis=(1, 2))
    assert np.abs(beat.shape[0] - beat.shape[-1]).max() < 1.2 * steps.max()


@pytest.mark.parametrize("pattern", GEARS)
def test_a_thousand_beats_go_straight(shipped: Repertoire, pattern: Pattern) -> None:
    beat = segment(shipped, pattern)
    rotation, way = np.eye(3), np.zeros(3)
    ahead, legs = [], []
    for _ in range(1000):
        began = way
        for m, t in zip(beat.rotation, beat.translation, strict=True):
            way = way + rotation @ t
            rotation = rotation @ m
            ahead.append(rotation[:, 0])
        legs.append(way - began)
    headings = np.array(ahead).reshape(1000, -1, 3).mean(axis=1)
    assert angle_deg(headings[0], headings[-1]) < 0.1
    assert angle_deg(headings[0], way) < 0.1
    assert angle_deg(legs[0], legs[-1]) < 0.001
    assert abs(turned_deg(np.array([1.0, 0.0, 0.0]), way)) < 0.1


def angle_deg(one: Float64s, other: Float64s) -> float:
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other)))


def test_speed_rises_with_the_gear(shipped: Repertoire) -> None:
    slow, medium, fast = (mean_speed(segment(shipped, gear)) for gear in GEARS)
    assert slow < 0.8 * medium
    assert fast > 1.3 * medium


def test_a_gradual_turn_goes_left_and_ends_in_the_cruising_shape(
    shipped: Repertoire, played: Play
) -> None:
    turn, cruise = segment(shipped, Pattern.TURN_LEFT), segment(shipped, Pattern.SWIM_MEDIUM)
    rotation = played(turn, 1)[1][-1]
    heading = played(cruise, 1)[1][1:, :, 0].mean(axis=0)
    assert 25 < turned_deg(heading, rotation @ heading) < 35
    assert len(turn.rotation) % len(cruise.rotation) == 0
    assert np.abs(turn.shape[-1] - cruise.shape[-1]).max() < 0.01
    assert mean_speed(turn) > 0.85 * mean_speed(cruise)
    assert not turn.loops


def test_a_sharp_turn_takes_60_degrees_in_a_second_or_so_and_ends_in_the_beat(
    name: str, shipped: Repertoire, played: Play
) -> None:
    turn, cruise = segment(shipped, Pattern.TURN_SHARP_LEFT), segment(shipped, Pattern.SWIM_MEDIUM)
    note = shipped.provenance
    phase = float(note["turn_sharp_left_phase"]) - float(note["swim_medium_phase"])
    entry = round(phase / (2 * np.pi) * len(cruise.rotation))
    _, rotations, nodes = played(turn, 1)
    before = played(on_from(cruise, entry), 1)[1][1:, :, 0].mean(axis=0)
    then = played(after(cruise, turn.shape[-1]), 1)[1][1:, :, 0].mean(axis=0)
    assert turned_deg(before, rotations[-1] @ then) >= (40 if name == "reef_shark" else 60)
    assert len(turn.rotation) <= 72
    assert np.abs(cruise.shape - turn.shape[-1]).max(axis=(1, 2)).min() < 0.01
    assert joint_deg(nodes) < 66
    assert not turn.loops


def test_a_fast_start_is_a_c_from_rest_into_the_fast_beat(
    name: str, shipped: Repertoire, played: Play
) -> None:
    start, fast = segment(shipped, Pattern.FAST_START_LEFT), segment(shipped, Pattern.SWIM_FAST)
    origins, rotations, nodes = played(start, 1)
    assert 40 <= len(start.rotation) <= 60
    assert np.linalg.norm(start.translation[0]) < 0.03
    early = [
        turned_deg(rotations[0, :, 0], r[:, 0]) for r in rotations[: 10 if name in LARGE else 6]
    ]
    assert max(early) > 60
    assert joint_deg(nodes) < 70
    assert np.abs(fast.shape - start.shape[-1]).max(axis=(1, 2)).min() < 0.04
    way = origins[-1] - origins[-7]
    assert np.linalg.norm(way) * 10 > 0.9
    assert way @ rotations[-1, :, 0] > 0.9 * np.linalg.norm(way)


def test_a_fast_start_turns_80_degrees_within_a_second(
    name: str, shipped: Repertoire, played: Play
) -> None:
    start, fast = segment(shipped, Pattern.FAST_START_LEFT), segment(shipped, Pattern.SWIM_FAST)
    _, rotations, _ = played(start, 1)
    then = played(after(fast, start.shape[-1]), 1)[1][1:, :, 0].mean(axis=0)
    assert turned_deg(rotations[0, :, 0], rotations[-1] @ then) >= 80


@pytest.mark.prove
def test_speed_rises_with_frequency(body: Body, swim: Swim) -> None:
    model = body_model(body, swim)
    speeds = []
    for pace in (0.5, 0.7, 0.9, 1.1, 1.3, 1.5, 1.7):
        stroke = controllers.swim(swim, 1.0, pace)
        period = stroke.period // 4
        run = record(model, stroke, 600)
        speeds.append(np.linalg.norm(run.origin[-1] - run.origin[-1 - period]) * 60 / period)
    assert speeds == sorted(speeds)
    assert speeds[-1] > 2 * speeds[0]


def test_the_shipped_files_are_read_whole(shipped_file: Path) -> None:
    held = {s.pattern for s in load(shipped_file).segments}
    assert held == {*GEARS, Pattern.TURN_LEFT, Pattern.TURN_SHARP_LEFT, Pattern.FAST_START_LEFT}
