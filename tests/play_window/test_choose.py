"""`reefgame video --choose` as a user has it: a window, a real click on a fish, and what is followed."""

import os
import subprocess
import sys
from pathlib import Path
from queue import Queue
from threading import Thread

import pytest

from components.repertoire_file import load as load_repertoire
from reefgame.content import load_species
from tools.video.motion_file import load
from tools.video.synthetic import Setting, SyntheticClip
from tools.video.writing import LOSSLESS, write_film

PATIENCE = 120.0


@pytest.fixture
def clip(tmp_path: Path, installed: Path) -> Path:
    """A film of a small fish."""
    segments = load_repertoire(installed / "assets" / "repertoires" / "sardine.npz").segments
    tank = Setting(width=320, height=240, body_length=150.0, travels=False)
    film = SyntheticClip(load_species("sardine").body, segments[1], tank)
    path = tmp_path / "sardine.mkv"
    write_film(path, film.frames(30), 60.0, LOSSLESS)
    return path


@pytest.mark.parametrize("deed", ["click", "escape"])
def test_a_click_or_escape_ends_the_choice_and_a_motion_is_written(
    display: str, clip: Path, user_folders: Path, deed: str
) -> None:
    environment = os.environ | {"DISPLAY": display, "REEFGAME_TRACE": "1"}

    def hands(*arguments: str) -> str:
        command = ["xdotool", *arguments]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        return done.stdout.strip()

    output = clip.with_suffix(".motion")
    command = [sys.executable, "-m", "reefgame.cli", "video", str(clip), "--choose"]
    with subprocess.Popen(
        [*command, "-o", str(output)],
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        lines = _until(process, "screen choose")
        window = hands("search", "--sync", "--onlyvisible", "--name", "^reefgame$").split()[0]
        hands("windowfocus", "--sync", window)
        if deed == "click":
            (x, y), *_ = (line.split()[2:] for line in lines if line.startswith("fish 0"))
            hands("mousemove", "--window", window, "5", "5", "click", "1")
            hands("mousemove", "--window", window, x, y, "click", "1")
        else:
            hands("key", "Escape")
        out, err = process.communicate(timeout=PATIENCE)
    assert process.returncode == 0, err
    assert ("followed: --select" if deed == "click" else "followed: the largest") in err
    assert ("chosen" in out.splitlines()) == ("missed" in out.splitlines()) == (deed == "click")
    assert load(output).count == 30


def _until(process: "subprocess.Popen[str]", last: str) -> list[str]:
    """Return what a process prints up to a line."""
    assert process.stdout is not None
    stream, lines = process.stdout, list[str]()
    told: Queue[str] = Queue()

    def read() -> None:
        for line in stream:
            told.put(line.rstrip("\n"))
            if line.rstrip("\n") == last:
                return
        told.put(last)

    Thread(target=read, daemon=True).start()
    while not lines or lines[-1] != last:
        lines.append(told.get(timeout=PATIENCE))
    return lines


@pytest.mark.parametrize("display_name", ["", ":987"])
def test_without_a_display_one_line_names_select(clip: Path, display_name: str) -> None:
    output = clip.with_suffix(".motion")
    done = subprocess.run(
        [sys.executable, "-m", "reefgame.cli", "video", str(clip), "--choose", "-o", str(output)],
        env=os.environ | {"DISPLAY": display_name},
        capture_output=True,
        text=True,
        check=False,
        timeout=PATIENCE,
    )
    assert done.returncode == 1
    (line,) = done.stderr.splitlines()
    assert line.startswith("no display")
    assert "--select X,Y" in line
    assert not output.exists()
