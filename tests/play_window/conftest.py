"""A display of its own (Xvfb), the game in it as a process, and real keys and clicks (xdotool)."""

import os
import queue
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import IO

import pytest

EASY = Path(__file__).parents[1] / "screens" / "easy.yaml"
PATIENCE = 240.0
"""[s] that an event may take: the first game of a machine compiles its kernels."""


class Display:
    """An X server without a screen."""

    def __init__(self) -> None:
        read, write = os.pipe()
        command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1024x768x24", "-nolisten"]
        self._server = subprocess.Popen(
            [*command, "tcp"], pass_fds=[write], stderr=subprocess.DEVNULL
        )
        os.close(write)
        with os.fdopen(read) as answer:
            self.name = f":{answer.readline().strip()}"

    def close(self) -> None:
        """Stop the server."""
        self._server.terminate()
        self._server.wait(30)


class Game:
    """`reefgame play` in a window of its own, its trace, and the player's hands."""

    def __init__(self, display: str, *arguments: str) -> None:
        self.environment = os.environ | {"DISPLAY": display, "REEFGAME_TRACE": "1"}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "reefgame.cli", "play", *arguments],
            env=self.environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self._lines: queue.Queue[str] = queue.Queue()
        self.seen: list[str] = []
        self.errors: list[str] = []
        assert self.process.stdout is not None
        assert self.process.stderr is not None
        self._readers = [
            self._reader(self.process.stdout, self._lines.put),
            self._reader(self.process.stderr, self.errors.append),
        ]

    def _reader(self, stream: IO[str], take: object) -> threading.Thread:
        def read() -> None:
            for line in stream:
                take(line.rstrip("\n"))  # type: ignore[operator]  # a bound method of one argument

        thread = threading.Thread(target=read, daemon=True)
        thread.start()
        return thread

    def expect(self, pattern: str) -> str:
        """Wait until the game prints a line that matches; return it."""
        if self.saw(pattern, PATIENCE):
            return self.seen[-1]
        raise AssertionError(f"no {pattern!r} in {self.seen}, {self.errors}")

    def saw(self, pattern: str, within: float) -> bool:
        """Wait until the game prints a line that matches, for at most `within` seconds."""
        deadline = time.monotonic() + within
        while time.monotonic() < deadline:
            try:
                line = self._lines.get(timeout=0.2)
            except queue.Empty:
                assert self.process.poll() is None, (self.seen, self.errors)
                continue
            self.seen.append(line)
            if re.fullmatch(pattern, line):
                return True
        return False

    def hands(self, *arguments: str) -> str:
        """Let xdotool do something; return what it says."""
        done = subprocess.run(
            ["xdotool", *arguments],
            env=self.environment,
            capture_output=True,
            text=True,
            check=True,
        )
        return done.stdout.strip()

    @property
    def window(self) -> str:
        """The window's X id."""
        return self.hands("search", "--sync", "--onlyvisible", "--name", "^reefgame$").split()[0]

    def close(self) -> None:
        """End the game, however it stands."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
        self.process.wait(30)
        for reader in self._readers:
            reader.join(10)
        for stream in (self.process.stdout, self.process.stderr):
            if stream is not None:
                stream.close()


@pytest.fixture(scope="session")
def display() -> Iterator[str]:
    """The name of an X display without a screen."""
    server = Display()
    yield server.name
    server.close()


@pytest.fixture
def game(display: str, user_folders: Path) -> Iterator[Game]:
    """The game in a window of 640x360, the easy level chosen."""
    game = Game(display, str(EASY), "--size", "640x360", "--seed", "1")
    yield game
    game.close()
