"""Live physics in recordings: it stands in the header, and a dive with it plays to the same checksums anywhere."""

import io
import os
import subprocess
import sys
from pathlib import Path

import pytest

from reefgame.autopilot import tour
from reefgame.content import load
from reefgame.content.errors import ContentError
from reefgame.replay import Recorder, Replay, read_replay, verify
from reefgame.testing import play
from reefgame.world import World

HEADER = (
    "reefgame replay 1\ngame 0.1.0\nlevel first_dive\ncontent 00ff\nseed 7\nchecksum-every 60\n"
)
PROGRAM = """
from reefgame.autopilot import tour
from reefgame.testing import play
print(play("first_dive", tour, 4, seed=3, live=20).replay)
"""


def read(tmp_path: Path, text: str) -> Replay:
    path = tmp_path / "a.replay"
    path.write_text(text, encoding="ascii")
    return read_replay(path)


def test_a_dive_with_live_fishes_is_proven_from_its_header(tmp_path: Path) -> None:
    dive = play("first_dive", tour, 3, seed=3, live=20)
    assert "\nlive 20\n" in dive.replay
    replay = read(tmp_path, dive.replay)
    assert replay.live == 20
    assert all("live" in sums for sums in replay.checksums.values())
    assert verify(replay, World.build(load("first_dive"), 3, replay.live)) is None
    desync = verify(replay, World.build(load("first_dive"), 3))
    assert desync is not None
    assert "fish" in desync.tables


def test_a_header_without_live_physics_means_none(tmp_path: Path) -> None:
    assert read(tmp_path, HEADER + "30 turn=1\n31 end\n").live == 0
    assert read(tmp_path, HEADER + "live 0\n30 turn=1\n31 end\n").ticks == 32
    stream = io.StringIO()
    Recorder(World.build(load("first_dive"), 1), stream, "first_dive")
    assert "live" not in stream.getvalue()


@pytest.mark.parametrize("value", ["51", "-1", "x", "", "1.5"])
def test_a_bad_number_of_live_fishes_names_its_line(tmp_path: Path, value: str) -> None:
    with pytest.raises(ContentError, match=r"a\.replay:7:1: .* is not a whole number from 0 to 50"):
        read(tmp_path, HEADER + f"live {value}\n31 end\n")


@pytest.mark.prove
def test_live_physics_computes_the_same_bits_on_another_processor() -> None:
    here = play("first_dive", tour, 4, seed=3, live=20).replay
    other = os.environ | {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM], capture_output=True, text=True, check=True, env=other
    )
    assert done.stdout.strip() == here.strip()
