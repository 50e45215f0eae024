"""Capture: the shipped repertoires are what the code makes, on any CPU, and move like living fishes."""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from components.arrays import Float64s
from components.body import Body, Fin, Swim
from components.repertoire import (
    Pattern,
    Repertoire,
    Segment,
    heading_change,
    mean_speed,
    mirrored,
    save,
)
from systems.motor.body_frame import body_frame
from systems.motor.muscle_model import body_model
from tools.capture.bend import largest_joint
from tools.capture.capture import GEARS, capture, fingerprint
from tools.capture.cut import beat_start
from tools.capture.measure import measure_swim
from tools.capture.record import Recording

CAPTURE_AND_SAVE = """
import sys
from pathlib import Path
from components.body import Body, Fin, Swim
from components.repertoire import save
from tools.capture.capture import capture
save(Path(sys.argv[1]), capture({body!r}, {swim!r}))
"""


def played(segment: Segment, cycles: int) -> tuple[Float64s, Float64s, Float64s]:
    """Return o, R and world nodes at each frame, from R = 1 at the origin."""
    origin, rotation = np.zeros(3), np.eye(3)
    origins, rotations, nodes = [origin], [rotation], []
    for _ in range(cycles):
        for m, t, d in zip(segment.rotation, segment.translation, segment.shape, strict=True):
            origin = origin + rotation @ t
            rotation = rotation @ m
            origins.append(origin)
            rotations.append(rotation)
            nodes.append(origin + d @ rotation.T)
    return np.array(origins), np.array(rotations), np.array(nodes)


def test_every_shipped_repertoire_is_rebuilt_byte_for_byte(
    body: Body, swim: Swim, shipped_file: Path, tmp_path: Path
) -> None:
    save(tmp_path / "again.npz", capture(body, swim))
    assert (tmp_path / "again.npz").read_bytes() == shipped_file.read_bytes()


@pytest.mark.parametrize("name", ["sardine"])
def test_a_plain_processor_captures_the_same_bytes(
    body: Body, swim: Swim, shipped_file: Path, tmp_path: Path
) -> None:
    program = CAPTURE_AND_SAVE.format(body=body, swim=swim)
    subprocess.run(
        [sys.executable, "-c", program, str(tmp_path / "plain.npz")],
        env={**os.environ, "NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""},
        cwd=tmp_path,
        check=True,
        timeout=300,
    )
    assert (tmp_path / "plain.npz").read_bytes() == shipped_file.read_bytes()


def test_progress_runs_to_the_end_and_says_what_is_done(body: Body, swim: Swim) -> None:
    told: list[tuple[float, str]] = []
    capture(body, swim, lambda fraction, what: told.append((fraction, what)))
    assert [what for _, what in told] == [
        "swim slow", "swim medium", "swim fast", "turn left", "turn sharp left", "fast start left",
    ]  # fmt: skip
    assert told[-1][0] == 1.0
    assert sorted(fraction for fraction, _ in told) == [fraction for fraction, _ in told]


def test_shipped_repertoires_are_current_and_without_warnings(
    body: Body, swim: Swim, shipped: Repertoire
) -> None:
    assert shipped.provenance["fingerprint"] == fingerprint(body, swim)
    assert shipped.provenance["warnings"] == ""


def test_the_fingerprint_follows_what_shapes_motion_alone(body: Body, swim: Swim) -> None:
    own = fingerprint(body, swim)
    finned = replace(body, dorsal=Fin(0.3, 0.7, 0.1), tail_fork=0.2, pectoral_length=0.2)
    assert fingerprint(finned, swim) == own
    assert fingerprint(replace(body, stiffness=1.1), swim) != own
    assert fingerprint(replace(body, tail_span=body.tail_span + 0.01), swim) != own
    assert fingerprint(body, replace(swim, lag_deg=swim.lag_deg + 1)) != own


@pytest.mark.parametrize("pattern", list(GEARS))
def test_a_swim_cycle_goes_straight_for_a_thousand_beats(
    shipped: Repertoire, pattern: Pattern
) -> None:
    segment = shipped.segments[pattern]
    origins, rotations, _ = played(segment, 1000)
    period = len(segment.rotation)
    heading = rotations[:period, :, 0].mean(axis=0)
    course = origins[-1]
    angle = np.linalg.norm(np.cross(heading, course)) / (heading @ course)
    assert np.degrees(angle) < 0.1
    assert np.abs(rotations[-1] - np.eye(3)).max() < 1e-9


def test_entries_hold_shapes_in_the_body_axes_of_their_own_frame(shipped: Repertoire) -> None:
    segment = shipped.segments[Pattern.SWIM_MEDIUM]
    origins, rotations, nodes = played(segment, 1)
    origin, rotation = np.zeros(3), np.zeros((3, 3))
    for k, shown in enumerate(nodes):
        body_frame(shown, origin, rotation)
        assert np.allclose(origin, origins[k + 1], atol=1e-6)
        assert np.allclose(rotation, rotations[k + 1], atol=1e-5)


def test_speed_rises_with_the_gear(shipped: Repertoire) -> None:
    slow, medium, fast = (mean_speed(shipped.segments[gear]) for gear in GEARS)
    assert slow < 0.8 * medium
    assert fast > 1.3 * medium


def test_the_sweep_and_strouhal_number_of_cruise_are_a_fishs(shipped: Repertoire) -> None:
    for pattern in (Pattern.SWIM_MEDIUM, Pattern.SWIM_FAST):
        segment = shipped.segments[pattern]
        _, _, nodes = played(segment, 1)
        tail = nodes[:, 21:, 2].mean(axis=1)
        sweep = np.ptp(tail)
        strouhal = sweep * 60 / len(segment.rotation) / mean_speed(segment)
        assert 0.12 < sweep < 0.24
        assert 0.2 < strouhal < 0.45


def test_the_wave_of_bending_runs_backwards(shipped: Repertoire) -> None:
    segment = shipped.segments[Pattern.SWIM_MEDIUM]
    _, _, nodes = played(segment, 1)
    line = np.stack([nodes[:, 4 * i + 1 : 4 * i + 5, 2].mean(axis=1) for i in range(5)], axis=1)
    bends = line[:, 1:-1] - 0.5 * (line[:, :-2] + line[:, 2:])
    phase = np.angle(np.fft.fft(bends, axis=0)[1])
    lag = (phase[1] - phase[2]) % (2 * np.pi)
    assert 0.2 < lag < np.pi


def test_a_gradual_turn_goes_left_and_ends_in_the_cruising_shape(shipped: Repertoire) -> None:
    turn, cruise = shipped.segments[Pattern.TURN_LEFT], shipped.segments[Pattern.SWIM_MEDIUM]
    assert 20 < np.degrees(heading_change(turn)) < 40
    assert len(turn.rotation) % len(cruise.rotation) == 0
    assert np.abs(turn.shape[-1] - cruise.shape[-1]).max() < 0.01
    assert mean_speed(turn) > 0.85 * mean_speed(cruise)
    assert not turn.loops


def test_a_sharp_turn_takes_60_degrees_in_a_second_or_so_and_ends_in_the_beat(
    shipped: Repertoire,
) -> None:
    turn, cruise = shipped.segments[4], shipped.segments[Pattern.SWIM_MEDIUM]
    assert turn.pattern is Pattern.TURN_SHARP_LEFT
    assert not turn.loops
    assert len(turn.rotation) <= 72
    beats = [cruise] * 2
    assert net_turn_deg([*beats, turn, *beats], shipped, len(turn.rotation)) > 60
    away = np.abs(cruise.shape - turn.shape[-1]).max(axis=(1, 2))
    assert away.min() < 0.01
    assert largest_joint(played(turn, 1)[2][:, :, [0, 2, 1]]) < np.radians(66)


def test_a_fast_start_takes_80_degrees_within_a_second_from_rest(shipped: Repertoire) -> None:
    start, fast = shipped.segments[5], shipped.segments[Pattern.SWIM_FAST]
    assert start.pattern is Pattern.FAST_START_LEFT
    assert 40 <= len(start.rotation) <= 60
    assert np.linalg.norm(start.translation[0]) < 0.02
    origins, rotations, nodes = played(start, 1)
    assert np.degrees(heading_change(start)) > 80
    assert largest_joint(nodes[:, :, [0, 2, 1]]) < np.radians(70)
    assert np.abs(fast.shape - start.shape[-1]).max(axis=(1, 2)).min() < 0.04
    way = origins[-1] - origins[-7]
    assert np.linalg.norm(way) * 10 > 0.9
    assert way @ rotations[-1, :, 0] > 0.9 * np.linalg.norm(way)


def net_turn_deg(segments: list[Segment], shipped: Repertoire, length: int) -> float:
    """Return the turn from the mean heading of the first two beats to that of the last two [degrees], left positive."""
    period = len(shipped.segments[Pattern.SWIM_MEDIUM].rotation)
    rotation, ahead = np.eye(3), []
    for segment in segments:
        for m in segment.rotation:
            rotation = rotation @ m
            ahead.append(rotation[:, 0])
    x = np.array(ahead)
    before, after = x[: 2 * period].mean(axis=0), x[2 * period + length :].mean(axis=0)
    cross = before[2] * after[0] - before[0] * after[2]
    return float(np.degrees(np.arctan2(cross, before @ after)))


def test_a_mirrored_turn_is_the_same_turn_to_the_right(shipped: Repertoire) -> None:
    turn = shipped.segments[Pattern.TURN_LEFT]
    right = mirrored(turn, Pattern.TURN_RIGHT)
    assert heading_change(right) == -heading_change(turn)
    left_nodes, right_nodes = played(turn, 1)[2], played(right, 1)[2]
    swapped = [0, *(4 * r + 1 + s for r in range(5) for s in (1, 0, 3, 2)), 21, 22]
    assert np.allclose(right_nodes, left_nodes[:, swapped] * (1, 1, -1), atol=1e-9)
    again = mirrored(right, Pattern.TURN_LEFT)
    assert np.array_equal(again.rotation, turn.rotation)
    assert np.array_equal(again.shape, turn.shape)


def test_a_body_that_cannot_swim_is_an_error_or_a_warning(body: Body) -> None:
    limp = capture(body, Swim(0.05, 0.05, 0.0, 4.0))
    assert "swim_medium" in limp.provenance["warnings"]


def test_a_fish_that_does_not_move_its_head_has_no_beat(body: Body, swim: Swim) -> None:
    still = body_model(body, swim).start
    frames = 40
    ahead = np.zeros((frames, 3))
    ahead[:, 0] = np.arange(frames)
    rotation = np.tile(np.eye(3), (frames, 1, 1))
    recording = Recording(np.tile(still, (frames, 1, 1)), ahead, rotation)
    with pytest.raises(ValueError, match="does not swim"):
        beat_start(recording, 10)


@pytest.mark.parametrize("shift", range(10))
def test_a_crossing_at_a_frame_never_slips_between_two_beats(
    body: Body, swim: Swim, shift: int
) -> None:
    period, frames = 10, 43
    k = np.arange(frames)
    aside = np.sin(2 * np.pi * (k - shift) / period) - 1e-9 * (k - 30)
    rotation = np.tile(np.eye(3), (frames, 1, 1))
    rotation[:, 1, 0] = aside
    origin = np.stack((k, 0 * k, 0 * k), axis=1).astype(np.float64)
    nodes = np.tile(body_model(body, swim).start, (frames, 1, 1))
    start = beat_start(Recording(nodes, origin, rotation), period)
    assert (start - shift) % period == pytest.approx(period, abs=1e-6) or (
        (start - shift) % period == pytest.approx(0, abs=1e-6)
    )
    assert 0 <= round(start) < frames - period


def test_faults_name_what_is_unlike_a_fish(shipped: Repertoire) -> None:
    segment = shipped.segments[Pattern.SWIM_MEDIUM]
    period = len(segment.rotation)
    origins, rotations, nodes = played(segment, 3)
    world = np.stack((nodes[..., 0], -nodes[..., 2], nodes[..., 1]), axis=-1)
    level = np.stack((origins[1:, 0], -origins[1:, 2], origins[1:, 1]), axis=-1)
    axes = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]]) @ rotations[1:]
    good = measure_swim(Recording(world, level, axes), segment, period)
    assert good.faults() == []
    bad = replace(good, closure=1.0, strouhal=0.9, sweep=0.5, backward=False)
    assert len(bad.faults()) == 4
