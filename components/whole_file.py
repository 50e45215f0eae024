"""Files that are whole or not there: a crash, a full disk or a power cut leaves the old file or the new."""

import os
import sys
import uuid
from contextlib import suppress
from pathlib import Path


def write_whole(path: Path, content: bytes, draft: Path | None = None) -> None:
    """Replace the file `path` by `content`. Raise OSError, with what stood there untouched.

    `draft` is the file beside `path` that is written first, by default one that nobody else writes;
    a process that is killed leaves it.
    """
    fresh = draft or path.with_name(f".{path.name}.{uuid.uuid4().hex[:12]}")
    try:
        with fresh.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        fresh.replace(path)
    finally:
        with suppress(OSError):
            fresh.unlink()
    _settle(path.parent)


def _settle(folder: Path) -> None:
    """Make a rename last over a power cut, where the system lets folders be opened."""
    if sys.platform == "win32":
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
