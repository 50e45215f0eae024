"""What the player achieved in each level, safe against crashes and a second instance (DESIGN 9).

A dive's result is merged into what the file holds at that moment, under a lock, so neither of two
games undoes the other's best. Where the folder cannot be written the game plays on: results wait in
memory for the next chance. A file that cannot be read is kept aside before a new one is written.
"""

import json
from dataclasses import asdict, dataclass
from math import inf
from pathlib import Path
from typing import Final

from platformdirs import user_data_path

from reefgame.durable import UnreadableError, exclusive, read_object, set_aside, write

VERSION: Final = 1


@dataclass(frozen=True)
class Record:
    """The best of all dives in one level."""

    score: int = 0
    seconds: float | None = None
    "[s] of the quickest win, None before the first"
    count: int = 0
    "most animals that one photograph counted"
    wins: int = 0

    def with_result(self, result: "Result") -> "Record":
        """Return the record after one more dive."""
        best = self.seconds
        if result.won:
            best = result.seconds if best is None else min(best, result.seconds)
        return Record(
            max(self.score, result.score),
            best,
            max(self.count, result.count),
            self.wins + int(result.won),
        )


@dataclass(frozen=True)
class Result:
    """How one dive ended."""

    level: str
    score: int
    seconds: float
    "[s] of the dive, up to success where there was one"
    count: int
    "most animals that one photograph counted"
    won: bool


def progress_path() -> Path:
    """Return where progress is kept."""
    return user_data_path("reefgame") / "progress.json"


class Progress:
    """The records of all levels; `warnings` holds one line for everything that went wrong."""

    def __init__(self, path: Path | None = None) -> None:
        self.path = path or progress_path()
        self.warnings: list[str] = []
        self._waiting: list[Result] = []
        self._warned = False
        self._levels: dict[str, Record] = {}
        try:
            self._levels = _read(self.path)
        except UnreadableError as error:
            self.warnings.append(f"{error}; it will be kept beside the progress made from now on")
        except OSError as error:
            self._warn_once(f"{self.path}: progress cannot be read: {error.strerror or error}")

    def record(self, level: str) -> Record:
        """Return the record of `level`, an empty one where nobody has dived yet."""
        return self._levels.get(level, Record())

    def add(self, result: Result) -> None:
        """Merge a dive's result into the file; without a file to write, into memory."""
        self._waiting.append(result)
        try:
            with exclusive(self.path):
                levels = _merged(self._read_again(), self._waiting)
                write(self.path, _text(levels))
        except OSError as error:
            self._levels = _merged(self._levels, [result])
            self._warn_once(f"{self.path}: progress cannot be saved: {error.strerror or error}")
            return
        self._levels = levels
        self._waiting.clear()

    def _read_again(self) -> dict[str, Record]:
        try:
            return _read(self.path)
        except UnreadableError:
            set_aside(self.path)
            return {}

    def _warn_once(self, warning: str) -> None:
        if not self._warned:
            self.warnings.append(warning)
        self._warned = True


def _merged(levels: dict[str, Record], results: list[Result]) -> dict[str, Record]:
    merged = dict(levels)
    for result in results:
        merged[result.level] = merged.get(result.level, Record()).with_result(result)
    return merged


def _text(levels: dict[str, Record]) -> str:
    records = {name: asdict(record) for name, record in sorted(levels.items())}
    return json.dumps({"version": VERSION, "levels": records}, indent=2) + "\n"


def _read(path: Path) -> dict[str, Record]:
    found, text = read_object(path)
    if not text:
        return {}
    version = found.get("version")
    if version != VERSION:
        raise UnreadableError(f"{path}:1:1: version {VERSION} is expected, not {version!r}")
    levels = found.get("levels")
    if not isinstance(levels, dict):
        raise UnreadableError(f"{path}:1:1: levels are missing")
    return {str(name): _as_record(str(name), value, path) for name, value in levels.items()}


def _as_record(name: str, value: object, path: Path) -> Record:
    whole = value if isinstance(value, dict) else {}
    counts = [whole.get(key) for key in ("score", "count", "wins")]
    seconds = whole.get("seconds")
    if not all(type(count) is int and count >= 0 for count in counts) or not (
        seconds is None or (type(seconds) in (int, float) and 0 <= seconds < inf)
    ):
        raise UnreadableError(f"{path}:1:1: the record of level {name!r} is damaged")
    return Record(whole["score"], seconds, whole["count"], whole["wins"])
