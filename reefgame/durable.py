"""Small files that survive a crash and a second instance (issue 2, bad input; DESIGN 9).

A file is replaced whole or not at all, and by one writer at a time.
"""

import json
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Final

from components.whole_file import write_whole

if sys.platform == "win32":
    import msvcrt

    def _try_lock(file: IO[bytes]) -> None:
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _try_lock(file: IO[bytes]) -> None:
        fcntl.flock(file.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)


LOCK_PATIENCE: Final = 2.0
"""[s] that a writer waits for another instance before it gives up."""


class UnreadableError(Exception):
    """A saved file does not hold what it should: one line, `file:line:column: what is wrong`."""


def write(path: Path, text: str) -> None:
    """Replace the file `path` by `text` so that a crash leaves the old file or the new.

    Raise OSError. Call it under `exclusive(path)`: the draft beside the file has a fixed name, so a
    killed game leaves at most one.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, text.encode(), path.with_name(f".{path.name}.draft"))


@contextmanager
def exclusive(path: Path) -> Iterator[None]:
    """Hold the lock that goes with `path`; it ends with the process, however that ends.

    Raise OSError where there can be no lock, or where another holds it for LOCK_PATIENCE.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    deadline = time.monotonic() + LOCK_PATIENCE
    with path.with_name(f".{path.name}.lock").open("ab") as file:
        while True:
            try:
                _try_lock(file)
                break
            except OSError:
                if time.monotonic() > deadline:
                    raise TimeoutError("another instance of the game holds its lock") from None
                time.sleep(0.01)
        yield


def set_aside(path: Path) -> Path:
    """Rename a file that cannot be read to `NAME.bad-N`, N the first free, and return its new path.

    Raise OSError.
    """
    number = 1
    while (aside := path.with_name(f"{path.name}.bad-{number}")).exists():
        number += 1
    path.replace(aside)
    return aside


def read_object(path: Path) -> tuple[dict[str, object], str]:
    """Return the JSON object in `path` and its text; an empty one where there is no file.

    Raise UnreadableError where it is no such object, OSError where it cannot be read.
    """
    try:
        text = path.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        return {}, ""
    except UnicodeDecodeError as error:
        raise UnreadableError(f"{path}:1:1: this is not UTF-8 text: {error.reason}") from None
    try:
        value = json.loads(text, parse_constant=_refuse_constant)
    except json.JSONDecodeError as error:
        raise UnreadableError(f"{path}:{error.lineno}:{error.colno}: {error.msg}") from None
    except (RecursionError, ValueError) as error:
        raise UnreadableError(f"{path}:1:1: {error}") from None
    if not isinstance(value, dict):
        raise UnreadableError(f"{path}:1:1: a JSON object is expected, in {{ }}")
    return value, text


def _refuse_constant(name: str) -> object:
    raise ValueError(f"{name} is no number")


def place(text: str, key: str) -> str:
    """Return `line:column` of the first place where `key` stands as a JSON key in `text`."""
    at = max(text.find(json.dumps(key)), 0)
    line = text.count("\n", 0, at) + 1
    return f"{line}:{at - (text.rfind(chr(10), 0, at) + 1) + 1}"
