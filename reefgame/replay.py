"""Replays: a dive as text, a header and one line per change of command, with checksums in between
(DESIGN 7).

    reefgame replay 1
    game 0.1.0
    level first_dive
    content 5f0c...
    seed 7
    checksum-every 60
    live 10
    0 throttle=100
    59 # fish=0123456789abcdef motor=...
    120 throttle=0 turn=-40
    479 end

A command line holds the tick and what changed; a checksum line the tables after that tick. After the
header `live 10` may tell how many fishes are in live physics at most; without it none are. A dive cut
short by a crash has no end line and plays to its last whole line.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, TextIO

from components.clock import TICKS_PER_SECOND
from components.command import BUTTONS, FULL, Command
from components.live import MOST_LIVE
from reefgame import VERSION
from reefgame.content.errors import ContentError, Problem
from reefgame.world import World

FORMAT: Final = "reefgame replay 1"
MOST_TICKS: Final = 24 * 3600 * TICKS_PER_SECOND
LARGEST: Final = 64 << 20
"[bytes] beyond which no file is read: an hour with a checksum line every tick"
_HEADER = ("game", "level", "content", "seed", "checksum-every")
_LIVE = "live"
_PAIR = re.compile(r"([a-z]+)=(-?[0-9]{1,3})$")
_SUM = re.compile(r"([a-z]+)=([0-9a-f]{16})$")


@dataclass(frozen=True)
class Replay:
    """A recorded dive."""

    level: str
    content: str
    seed: int
    every: int
    "[ticks] between checksums"
    live: int = 0
    "fishes in live physics at most"
    game: str = VERSION
    commands: Mapping[int, Command] = field(default_factory=dict)
    "the command from that tick on"
    checksums: Mapping[int, Mapping[str, int]] = field(default_factory=dict)
    "per table, after that tick"
    ticks: int = 0
    "how many ticks it plays"
    ended: bool = False
    "False for a dive that was cut short"

    def play(self) -> Iterator[Command]:
        """Yield the command of each tick."""
        command = Command()
        for tick in range(self.ticks):
            command = self.commands.get(tick, command)
            yield command


@dataclass(frozen=True)
class Desync:
    """The first difference between a replay and the world that plays it."""

    tick: int
    "the tick whose checksum differs"
    since: int
    "the last tick whose checksums were equal, -1 for the start"
    tables: tuple[str, ...]

    def __str__(self) -> str:
        where = f"at tick {self.tick}"
        if self.tick - self.since > 1:
            where = f"between ticks {self.since + 1} and {self.tick}"
        return f"desync in {', '.join(self.tables)} {where}"


class Recorder:
    """Writes a dive as it happens; every line is flushed, so a crash costs at most the ticks since the last one."""

    def __init__(
        self, world: World, stream: TextIO, level: str, every: int = TICKS_PER_SECOND
    ) -> None:
        self.world = world
        self.stream = stream
        self.every = every
        self._last = Command()
        self._next = world.clock.now
        header = (VERSION, level, world.content.hash, str(world.clock.seed[0]), str(every))
        lines = [f"{key} {value}" for key, value in zip(_HEADER, header, strict=True)]
        lines += [f"{_LIVE} {world.live_fishes}"] if world.live_fishes else []
        self._write("\n".join([FORMAT, *lines]))

    def tick(self, command: Command) -> None:
        """Record the command of the tick that the world has just taken, and the checksums where due."""
        tick, self._next = self._next, self._next + 1
        changed = [
            f"{name}={value}"
            for name, value, old in zip(Command._fields, command, self._last, strict=True)
            if value != old
        ]
        if changed:
            self._write(f"{tick} {' '.join(changed)}")
        self._last = command
        if self._next % self.every == 0:
            sums = " ".join(
                f"{name}={value:016x}" for name, value in self.world.checksums().items()
            )
            self._write(f"{tick} # {sums}")

    def finish(self) -> None:
        """Write the end: the recording is whole. The stream stays open; it is the caller's."""
        if self._next:
            self._write(f"{self._next - 1} end")

    def _write(self, line: str) -> None:
        self.stream.write(line + "\n")
        self.stream.flush()


def read_replay(path: Path) -> Replay:
    """Read a replay. Raise ContentError, `file:line:column: what`, where it is not one."""
    try:
        with path.open("rb") as file:
            data = file.read(LARGEST + 1)
        text = data.decode("ascii")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise _error(path, line, "not a replay: it holds bytes that are not plain text") from None
    except OSError as error:
        raise _error(path, 1, f"cannot be read: {error.strerror}") from None
    if len(data) > LARGEST:
        raise _error(path, 1, f"larger than {LARGEST >> 20} MiB: no replay is")
    return _Reader(path, text).read()


def verify(
    replay: Replay, world: World, progress: Callable[[int], None] = lambda _: None
) -> Desync | None:
    """Play the replay in a fresh world; return the first desync, or None where every checksum is equal."""
    since = -1
    for tick, command in enumerate(replay.play()):
        world.tick(command)
        progress(tick)
        expected = replay.checksums.get(tick)
        if expected is not None:
            found = world.checksums()
            differing = tuple(name for name in found if found[name] != expected.get(name))
            if differing:
                return Desync(tick, since, differing)
            since = tick
    return None


def _error(path: Path, line: int, message: str, column: int = 1) -> ContentError:
    return ContentError([Problem(str(path), line, column, message)])


class _Reader:
    """Reads the lines of one replay; a last line without its newline is a crash's and is dropped."""

    def __init__(self, path: Path, text: str) -> None:
        self.path = path
        whole, _, _ = text.replace("\r\n", "\n").rpartition("\n")
        self.lines = whole.split("\n")
        self.commands: dict[int, Command] = {}
        self.checksums: dict[int, dict[str, int]] = {}
        self.command = Command()
        self.latest = -1

    def read(self) -> Replay:
        if self.lines[0] != FORMAT:
            raise _error(self.path, 1, f"not a replay: the first line must be '{FORMAT}'")
        header = self._header()
        live = self._live()
        begun = len(_HEADER) + (1 if live is None else 2)
        ended = False
        for number, line in enumerate(self.lines[begun:], start=begun + 1):
            if ended:
                raise _error(self.path, number, "nothing may follow the end line")
            ended = self._line(number, line)
        ticks = self.latest + 1 if ended else max(self.checksums, default=-1) + 1
        return Replay(
            level=header["level"],
            content=header["content"],
            seed=self._integer(5, header["seed"], 2**62),
            every=max(1, self._integer(6, header["checksum-every"], MOST_TICKS)),
            live=live or 0,
            game=header["game"],
            commands=self.commands,
            checksums=self.checksums,
            ticks=ticks,
            ended=ended,
        )

    def _header(self) -> dict[str, str]:
        header = {}
        for number, key in enumerate(_HEADER, start=2):
            line = self.lines[number - 1] if number <= len(self.lines) else ""
            name, _, value = line.partition(" ")
            if name != key or not value:
                raise _error(self.path, number, f"the header's line '{key} ...' is missing")
            header[key] = value
        return header

    def _live(self) -> int | None:
        """Return what the line after the header says of live physics, None where it says nothing of it."""
        at = len(_HEADER) + 1
        name, _, value = (self.lines[at] if at < len(self.lines) else "").partition(" ")
        return self._integer(at + 1, value, MOST_LIVE) if name == _LIVE else None

    def _integer(self, number: int, text: str, most: int) -> int:
        if not re.fullmatch(r"[0-9]{1,19}", text) or int(text) > most:
            raise _error(self.path, number, f"'{text[:24]}' is not a whole number from 0 to {most}")
        return int(text)

    def _line(self, number: int, line: str) -> bool:
        head, _, rest = line.partition(" ")
        tick = self._integer(number, head, MOST_TICKS)
        if tick < self.latest:
            raise _error(self.path, number, f"tick {tick} stands after tick {self.latest}")
        self.latest = tick
        if rest == "end":
            return True
        if rest.startswith("# "):
            self.checksums[tick] = {
                name: int(value, 16) for name, value in self._pairs(number, rest[2:], _SUM)
            }
        else:
            self._change(number, tick, rest)
        return False

    def _pairs(self, number: int, text: str, form: re.Pattern[str]) -> Iterator[tuple[str, str]]:
        for word in text.split(" "):
            match = form.match(word)
            if match is None:
                raise _error(self.path, number, f"'{word[:40]}' is not understood")
            yield match.group(1), match.group(2)

    def _change(self, number: int, tick: int, text: str) -> None:
        changes = {}
        for name, value in self._pairs(number, text, _PAIR):
            if name not in Command._fields:
                allowed = ", ".join(Command._fields)
                raise _error(self.path, number, f"unknown order '{name}', allowed are {allowed}")
            least, most = (0, 1) if name in BUTTONS else (-FULL, FULL)
            if not least <= int(value) <= most:
                raise _error(self.path, number, f"{name}={value} is not from {least} to {most}")
            changes[name] = int(value)
        self.command = self.command._replace(**changes)
        self.commands[tick] = self.command
