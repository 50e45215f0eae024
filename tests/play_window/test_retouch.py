"""`reefgame retouch` as an animator has it: a window, real drags, undo, redo, play and save."""

import os
import queue
import re
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tools.video.motion import Motion
from tools.video.motion_file import load, save
from tools.video.retarget.example import example_clip_motion
from tools.video.retarget.intermediate import intermediate
from tools.video.retarget.skeleton import NAMES

PATIENCE = 240.0
"""[s] that an event may take: kernels compile at first."""


class Window:
    """The retouch window as a process, its trace, and a hand with a mouse."""

    def __init__(self, display: str, *arguments: str) -> None:
        self._environment = os.environ | {"DISPLAY": display, "REEFGAME_TRACE": "1"}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "reefgame.cli", "retouch", *arguments],
            env=self._environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self._lines: queue.Queue[str] = queue.Queue()
        self._told = ""
        self.places: dict[str, tuple[int, ...]] = {}
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self._lines.put(line.rstrip("\n"))

    def expect(self, pattern: str) -> "re.Match[str]":
        """Wait until a line matches; remember the places that are told on the way."""
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            try:
                line = self._lines.get(timeout=0.2)
            except queue.Empty:
                assert self.process.poll() is None, self.end()
                continue
            found = re.fullmatch(r"(\w+(?: [a-z]\w*)?) (-?\d+) (-?\d+)(?: (-?\d+))?", line)
            if found:
                self.places[found[1]] = tuple(int(n) for n in found.groups()[1:] if n is not None)
            if match := re.fullmatch(pattern, line):
                return match
        raise AssertionError(f"no {pattern!r}")

    def hands(self, *arguments: str) -> str:
        """Let xdotool do something; return what it says."""
        return subprocess.run(
            ["xdotool", *arguments],
            env=self._environment,
            capture_output=True,
            text=True,
            check=True,
        ).stdout.strip()

    def open(self) -> None:
        """Wait for the window and point at it."""
        self.expect(r"timeline .*")
        self._window = self.hands(
            "search", "--sync", "--onlyvisible", "--name", "^reefgame$"
        ).split()[0]
        self.hands("windowfocus", "--sync", self._window)

    def click(self, name: str) -> None:
        """Click a button."""
        x, y = self.places[f"button {name}"]
        self.hands("mousemove", "--window", self._window, str(x), str(y), "click", "1")

    def drag(self, start: tuple[int, ...], end: tuple[int, ...]) -> None:
        """Drag from one place to another by way of their middle."""
        between = ((start[0] + end[0]) // 2, (start[1] + end[1]) // 2)
        for at, deed in (
            (start, ("mousedown", "1")),
            (between, ()),
            (end, ()),
            (end, ("mouseup", "1")),
        ):
            self.hands("mousemove", "--window", self._window, str(at[0]), str(at[1]), *deed)

    def key(self, name: str) -> None:
        """Press a key."""
        self.hands("key", name)

    def end(self) -> str:
        """End the process; return what it complained about."""
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait(30)
        self._reader.join(10)
        assert self.process.stderr is not None
        assert self.process.stdout is not None
        if not self.process.stderr.closed:
            self._told = self.process.stderr.read()
            self.process.stderr.close()
            self.process.stdout.close()
        return self._told


@pytest.fixture
def motion(tmp_path: Path) -> Path:
    """A motion file of forty frames."""
    path = tmp_path / "swim.motion"
    save(path, example_clip_motion(40))
    return path


@pytest.fixture
def window(display: str, motion: Path, user_folders: Path) -> Iterator[Window]:
    """The window with the carp."""
    window = Window(display, str(motion))
    window.open()
    yield window
    window.end()


def angles_of(motion: Motion) -> "np.ndarray[tuple[int, ...], np.dtype[np.float64]]":
    return intermediate(motion).angles


def test_a_dragged_point_takes_its_neighbours_along_and_is_saved(
    window: Window, motion: Path
) -> None:
    column = NAMES.index("low_axis_angle_12")
    x, y = window.places["handle low_axis_angle_12"]
    window.drag((x, y), (x, y + 40))
    edit = window.expect(r"edited low_axis_angle_12 (\d+) (\d+) (\d+)")
    frame, first, last = (int(n) for n in edit.groups())
    assert first <= frame <= last
    window.click("save")
    window.expect("saved")
    before, after = (
        angles_of(load(motion)),
        angles_of(load(motion.with_name("swim_retouched.motion"))),
    )
    changed = np.flatnonzero(np.abs(after - before).max(axis=1) > 1e-9)
    assert first <= changed.min() <= changed.max() <= last
    assert abs(after[frame, column] - before[frame, column]) > 0.05
    assert np.array_equal(np.delete(after, column, 1), np.delete(before, column, 1))


def test_undo_redo_play_and_the_timeline_answer_to_mouse_and_keys(window: Window) -> None:
    left, right, y = window.places["timeline"]
    window.drag((left + 5, y), ((left + right) // 2, y))
    assert abs(int(window.expect(r"frame (\d+)")[1]) - 20) <= 1
    x, y = window.places["handle head_angle"]
    window.drag((x, y), (x, y - 30))
    window.expect(r"edited head_angle .*")
    window.key("ctrl+z")
    window.expect("undone, 0 left")
    window.click("redo")
    window.expect("redone, 1 left")
    window.click("undo")
    window.expect("undone, 0 left")
    window.key("space")
    window.expect("playing")
    window.click("play")
    window.expect(r"paused \d+")


def test_edits_that_are_not_saved_are_asked_about_once(window: Window) -> None:
    x, y = window.places["handle tail_angle"]
    window.drag((x, y), (x, y + 40))
    window.expect(r"edited tail_angle .*")
    window.key("Escape")
    window.expect("unsaved")
    window.key("Escape")
    assert window.process.wait(60) == 0
    assert window.end() == ""


@pytest.mark.parametrize("content", [b"", b"no motion at all"])
def test_a_broken_motion_is_one_line(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "broken.motion"
    path.write_bytes(content)
    done = subprocess.run(
        [sys.executable, "-m", "reefgame.cli", "retouch", str(path)],
        capture_output=True,
        text=True,
        check=False,
        timeout=PATIENCE,
    )
    assert done.returncode == 1
    (line,) = done.stderr.splitlines()
    assert line.startswith(f"{path}: ")
