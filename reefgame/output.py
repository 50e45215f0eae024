"""Files that a command writes where the user asked (DESIGN 8; issue 2, bad input).

They are refused before the work begins where they cannot be written, and are written whole or not at all: what stood
there before stays until the new file is complete.
"""

import errno
import os
import uuid
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from reefgame.console import InputError


def check_output(path: Path | None) -> None:
    """Raise InputError, one line, where no file can be written at `path`; None is fine."""
    if path is None:
        return
    try:
        _check(path)
    except OSError as error:
        raise unwritable(path, error) from None


def unwritable(path: Path, error: OSError) -> InputError:
    """Return the one line that says why `path` cannot be written."""
    return InputError(f"{path}: cannot be written: {error.strerror or error}")


def _check(path: Path) -> None:
    folder = path.absolute().parent
    # Not exists(): where the folder may not be entered, or its name is too long, that is told.
    folder.stat()
    if not folder.is_dir():
        raise OSError(errno.ENOTDIR, os.strerror(errno.ENOTDIR))
    with suppress(FileNotFoundError):
        path.stat()
        if path.is_dir():
            raise OSError(errno.EISDIR, os.strerror(errno.EISDIR))
        if not path.is_file():
            raise OSError(errno.EINVAL, "it is a device, not a file")
    if not os.access(folder, os.W_OK):
        raise OSError(errno.EACCES, os.strerror(errno.EACCES))


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Give the block a name to write under; the file takes the name `path` when the block is through.

    Where the block fails or is interrupted nothing of it stays, and what `path` held does. An OSError, as of a full
    disk, becomes an InputError of one line.
    """
    check_output(path)
    target = path.resolve()
    fresh = target.with_name(f".{uuid.uuid4().hex[:12]}{target.suffix}")
    try:
        yield fresh
        fresh.replace(target)
    except OSError as error:
        raise unwritable(path, error) from None
    finally:
        with suppress(OSError):
            fresh.unlink()
