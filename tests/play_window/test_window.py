"""The game as a player has it: a window, real keys and clicks, from the title to a win and back."""

import os
import signal
import struct
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from reefgame.content import load
from reefgame.progress import Progress
from reefgame.replay import read_replay, verify
from reefgame.world import World

EASY = Path(__file__).parents[1] / "screens" / "easy.yaml"
PATIENCE = 240.0
"""[s] that anything may take."""


def run(*arguments: str, **environment: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        [sys.executable, "-m", "reefgame.cli", "play", *arguments],
        env=os.environ | environment,
        capture_output=True,
        text=True,
        check=False,
        timeout=240,
    )


def test_a_player_dives_steers_photographs_wins_and_returns(game: Any, user_folders: Path) -> None:
    game.expect("screen title")
    game.hands("windowfocus", "--sync", game.window)
    game.hands("key", "Return")
    game.expect("screen dive")
    game.hands("keydown", "w")
    game.expect("deed moved")
    game.hands("keyup", "w", "key", "x")
    game.hands("keydown", "space")
    game.expect("deed rose")
    game.hands("keyup", "space")
    game.hands("key", "F12", "mousemove", "--window", game.window, "320", "180", "click", "1")
    shot = game.expect(r"photograph \d+/4")
    assert int(shot.split()[1].split("/")[0]) >= 4
    game.expect("won")
    game.hands("keydown", "a")
    game.expect("deed turned")
    game.hands("keyup", "a")
    game.expect("screen result")
    game.hands("key", "Escape")
    game.expect("screen title")
    assert len(list((user_folders / "data").rglob("*.png"))) == 1
    (record,) = Progress()._levels.values()
    assert record.wins == 1
    game.hands("key", "Down", "Down", "Return")
    assert game.process.wait(60) == 0
    (replay,) = (user_folders / "data").rglob("*.replay")
    assert read_replay(replay).ended
    assert game.errors == []


def test_a_player_becomes_a_fish_inspects_one_steps_and_looks_back(
    game: Any, user_folders: Path
) -> None:
    game.expect("screen title")
    window = game.window
    game.hands("windowfocus", "--sync", window)
    game.hands("key", "Return")
    game.expect("screen dive")
    game.hands("key", "b")
    game.expect("became fish")
    game.hands("keydown", "w", "keydown", "e")
    (recording,) = wait_for_checksums(user_folders, 1)
    game.hands("keyup", "w", "keyup", "e", "key", "b")
    game.expect("became pilot")
    game.hands("key", "i")
    game.expect("screen inspector")
    game.hands("key", "Tab")
    game.expect(r"chosen Sardine \d+")
    game.hands("key", "period")
    stepped = int(game.expect(r"tick \d+").split()[1])
    game.hands("mousemove", "--window", window, "40", "328", "click", "1")
    game.expect(r"tick \d+")
    assert int(game.seen[-1].split()[1]) < stepped // 2
    game.hands("key", "i")
    game.expect("screen dive")
    game.hands("key", "Escape", "Up", "Return")
    game.expect("screen title")
    assert verify(read_replay(recording), World.build(load(EASY), 1)) is None
    assert game.errors == []


def test_clicks_alone_lead_into_a_dive_in_a_window_made_larger(
    game: Any, user_folders: Path
) -> None:
    game.expect("screen title")
    window = game.window
    game.hands("windowsize", "--sync", window, "800", "500")
    for y in range(100, 460, 12):
        game.hands("mousemove", "--window", window, "200", str(y), "click", "1")
        if game.saw("screen dive", within=1.0):
            break
    assert game.seen[-1] == "screen dive"
    game.hands("windowsize", "--sync", window, "500", "400")
    game.hands("windowfocus", "--sync", window)
    game.hands("key", "F12")
    game.expect("picture: .*")
    (picture,) = (user_folders / "data").rglob("*.png")
    assert struct.unpack(">II", picture.read_bytes()[16:24]) == (500, 400)


def test_losing_the_focus_pauses(game: Any) -> None:
    game.expect("screen title")
    window = game.window
    game.hands("windowfocus", "--sync", window)
    game.hands("key", "Return")
    game.expect("screen dive")
    other = subprocess.Popen(
        [sys.executable, "-c", OTHER_WINDOW], env=game.environment, stdin=subprocess.PIPE
    )
    try:
        stranger = game.hands("search", "--sync", "--name", "^stranger$").split()[0]
        game.hands("windowfocus", "--sync", stranger)
        game.expect("screen pause")
        game.hands("windowfocus", "--sync", window)
        game.hands("key", "Escape")
        game.expect("screen dive")
    finally:
        other.kill()
        other.communicate()
    assert game.process.poll() is None


OTHER_WINDOW = """
import sys
from reefgame.window import open_window
window = open_window((64, 64))
window.set_caption("stranger")
window.dispatch_events()
sys.stdin.read()
"""


def test_a_dive_cut_short_by_a_kill_keeps_progress_and_recording(
    game: Any, user_folders: Path
) -> None:
    game.expect("screen title")
    game.hands("windowfocus", "--sync", game.window)
    game.hands("key", "Return")
    game.expect("screen dive")
    game.hands("key", "Return")
    game.expect("won")
    game.expect("screen result")
    game.hands("key", "Return")
    game.expect("screen dive")
    game.hands("keydown", "w")
    whole, cut = wait_for_checksums(user_folders, 2)
    game.process.send_signal(signal.SIGKILL)
    game.process.wait(30)
    (record,) = Progress()._levels.values()
    assert record.wins == 1
    assert read_replay(whole).ended
    assert not read_replay(cut).ended
    world = World.build(load(EASY), 1)
    assert read_replay(cut).ticks >= 60
    assert verify(read_replay(cut), world) is None


def wait_for_checksums(folder: Path, recordings: int) -> list[Path]:
    """Return the recordings, oldest first, once there are so many and the newest has a checksum."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        found = sorted((folder / "data").rglob("*.replay"))
        if len(found) == recordings and " # " in found[-1].read_text():
            return found
        time.sleep(0.05)
    raise AssertionError(f"no checksum in {found}")


def test_without_a_display_one_line_names_headless() -> None:
    for display in ("", ":987"):
        done = run("first_dive", DISPLAY=display)
        assert done.returncode == 1
        assert done.stdout == ""
        (line,) = done.stderr.splitlines()
        assert "no display" in line
        assert "--headless" in line


def test_without_opengl_one_line_says_what_to_install(display: str) -> None:
    done = run("first_dive", DISPLAY=display, MESA_GL_VERSION_OVERRIDE="2.1")
    assert done.returncode == 1
    (line,) = done.stderr.splitlines()
    assert line.startswith("no OpenGL 3.3: ")
    assert "apt-get install" in line


def test_a_recording_that_cannot_be_written_is_refused_at_once(
    display: str, tmp_path: Path
) -> None:
    (tmp_path / "file").write_text("")
    for record in (tmp_path, tmp_path / "file" / "dive.replay"):
        done = run(str(EASY), "--record", str(record), DISPLAY=display)
        assert done.returncode == 1
        assert done.stderr == f"{record}: cannot be written\n"


@pytest.mark.parametrize("wrong", ["no_such_level", "no/such/level.yaml"])
def test_a_level_that_is_not_there_is_one_line(display: str, wrong: str) -> None:
    done = run(wrong, DISPLAY=display)
    assert done.returncode == 1
    assert len(done.stderr.splitlines()) == 1
    assert "Traceback" not in done.stderr
