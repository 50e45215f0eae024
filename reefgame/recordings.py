"""The dives that are kept: every dive is recorded, the last five stay in the user's data folder (DESIGN 7).

A name holds the level, the time and the process, so two games at once never write to one file. A disk that fails in
the middle costs the recording, not the dive.
"""

import os
from contextlib import suppress
from datetime import datetime
from pathlib import Path
from typing import Final, TextIO

from platformdirs import user_data_path

from components.command import Command
from reefgame.console import InputError
from reefgame.replay import Recorder
from reefgame.world import World

KEPT: Final = 5
SUFFIX: Final = ".replay"


def folder() -> Path:
    """Return where recordings are kept."""
    return user_data_path("reefgame") / "replays"


def kept() -> list[Path]:
    """Return the recordings that are kept, the newest first."""
    ages = []
    for path in folder().glob(f"*{SUFFIX}"):
        # Another game may remove it between the two looks.
        with suppress(OSError):
            ages.append((path.stat().st_mtime, path.name, path))
    return [path for *_, path in sorted(ages, reverse=True)]


class Recording:
    """A dive's recording on disk, from the world's first tick to `close`."""

    def __init__(self, world: World, asked: Path | None = None) -> None:
        """Begin, in the file the player asked for or among the kept.

        Raise InputError where a file that was asked for cannot be written.
        """
        self.path: Path | None = None
        "the file, None where nothing can be written"
        self.warning: str | None = None
        "one line that says why nothing is recorded, None while all is well"
        self._stream: TextIO | None = None
        self._recorder: Recorder | None = None
        try:
            self._begin(world, asked)
        except OSError as error:
            self._give_up(error)
            if asked is not None:
                raise InputError(f"{asked}: cannot be written: {error.strerror}") from None

    def tick(self, command: Command) -> None:
        """Record the command of the tick that the world has just taken."""
        if self._recorder is not None:
            try:
                self._recorder.tick(command)
            except OSError as error:
                self._give_up(error)

    def close(self) -> None:
        """Finish the recording: it is whole."""
        if self._recorder is not None:
            try:
                self._recorder.finish()
            except OSError as error:
                self._give_up(error)
        if self._stream is not None:
            # What a full disk did not take is still in the stream's buffer.
            with suppress(OSError):
                self._stream.close()
        self._recorder = None

    def _begin(self, world: World, asked: Path | None) -> None:
        path = asked or _next_path(world.level.name)
        path.parent.mkdir(parents=True, exist_ok=True)
        self._stream = path.open("w", encoding="ascii", newline="\n")
        self._recorder = Recorder(world, self._stream, world.level.name)
        self.path = path
        for old in kept()[KEPT:]:
            with suppress(OSError):
                old.unlink()

    def _give_up(self, error: OSError) -> None:
        self.warning = f"this dive is not recorded: {error.strerror or error}"
        self.path = self._recorder = None
        if self._stream is not None:
            with suppress(OSError):
                self._stream.close()
            self._stream = None


def _next_path(level: str) -> Path:
    now = datetime.now().astimezone()
    name = level.replace(":", ".")
    return folder() / f"{name}-{now:%Y%m%d-%H%M%S-%f}-{os.getpid()}{SUFFIX}"
