"""Capture: the shipped repertoires are what the code makes, on any CPU, and move like living fishes."""

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import assets
from components.arrays import Float64s
from components.body import Body, Fin, Swim
from components.repertoire import (
    Pattern,
    Repertoire,
    Segment,
    heading_change,
    mirrored,
    save,
)
from systems.motor.body_frame import body_frame
from systems.motor.muscle_model import body_model
from tools.capture.capture import capture, fingerprint
from tools.capture.cut import beat_start
from tools.capture.measure import measure_swim
from tools.capture.record import Recording

Play = Callable[[Segment, int], tuple[Float64s, Float64s, Float64s]]
ASSETS = Path(str(assets.__file__)).parent
NINE = sorted(path.stem for path in (ASSETS / "species").glob("*.yaml"))
SAMPLED = [
    pytest.param(name, marks=[] if name == "blue_tang" else pytest.mark.prove) for name in NINE
]

CAPTURE_AND_SAVE = """
import sys
from pathlib import Path
from components.body import Body, Fin, Swim
from components.repertoire import save
from tools.capture.capture import capture
save(Path(sys.argv[1]), capture({body!r}, {swim!r}))
"""


@pytest.mark.parametrize("name", SAMPLED)
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


@pytest.mark.prove
def test_a_plain_processor_with_nothing_compiled_rebuilds_all_nine(tmp_path: Path) -> None:
    env = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": "", "XDG_CACHE_HOME": str(tmp_path)}
    species = [str(path) for path in sorted((ASSETS / "species").glob("*.yaml"))]
    out = tmp_path / "out"
    command = [sys.executable, "-m", "reefgame.cli", "capture", *species, "-o", str(out)]
    subprocess.run(command, env={**os.environ, **env}, check=True, timeout=900)
    made = {path.name: path.read_bytes() for path in out.iterdir()}
    assert made == {path.name: path.read_bytes() for path in (ASSETS / "repertoires").iterdir()}
    assert len(made) == 9


def test_progress_runs_to_the_end_and_says_what_is_done(body: Body, swim: Swim) -> None:
    told: list[tuple[float, str]] = []
    capture(body, swim, lambda fraction, what: told.append((fraction, what)))
    assert [what for _, what in told] == [
        "swim slow", "swim medium", "swim fast", "turn left", "turn sharp left", "fast start left",
    ]  # fmt: skip
    assert told[-1][0] == 1.0
    assert sorted(fraction for fraction, _ in told) == [fraction for fraction, _ in told]


@pytest.mark.parametrize("name", NINE)
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


def test_entries_hold_shapes_in_the_body_axes_of_their_own_frame(
    shipped: Repertoire, played: Play
) -> None:
    segment = shipped.segments[Pattern.SWIM_MEDIUM]
    origins, rotations, nodes = played(segment, 1)
    origin, rotation = np.zeros(3), np.zeros((3, 3))
    for k, shown in enumerate(nodes):
        body_frame(shown, origin, rotation)
        assert np.allclose(origin, origins[k + 1], atol=1e-6)
        assert np.allclose(rotation, rotations[k + 1], atol=1e-5)


def test_a_mirrored_turn_is_the_same_turn_to_the_right(shipped: Repertoire, played: Play) -> None:
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


def test_faults_name_what_is_unlike_a_fish(shipped: Repertoire, played: Play) -> None:
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
