"""What the command line says, and shows while long work goes on: a bar on a terminal, nothing in a pipe."""

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TextIO, TypeAlias

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

from components.fault import FaultError

Report: TypeAlias = Callable[[float, str], None]
"""Called with the fraction done, 0 to 1, and what is being done."""


class InputError(FaultError):
    """What the user gave is at fault; the message is one line, the exit status 1."""


@contextmanager
def progress_bar(what: str) -> Iterator[Report]:
    """Show a bar on a terminal while the block runs; give it a function to report with."""
    console = Console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, disable=not sys.stderr.isatty()) as bar:
        task = bar.add_task(what, total=1.0)

        def report(fraction: float, doing: str = what) -> None:
            bar.update(task, completed=min(fraction, 1.0), description=doing)

        yield report


def say(text: str) -> None:
    """Print a line of result. Raise BrokenPipeError where nobody reads, InputError where it cannot be written."""
    try:
        _print(text, sys.stdout)
    except BrokenPipeError:
        abandon_output()
        raise
    except OSError as error:
        abandon_output()
        raise InputError(f"standard output: cannot be written: {error.strerror}") from None


def complain(text: str) -> None:
    """Print a line about what is wrong, on the standard error."""
    with suppress(OSError):
        _print(text, sys.stderr)


def open_streams() -> None:
    """Put the null device where the shell closed standard input, output or error.

    Else the next file to be opened would take the number, and what a library prints would go into it.
    """
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
    if sys.stdout is None:
        sys.stdout = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115 (to the end)
    if sys.stderr is None:
        sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115 (to the end)


def abandon_output() -> None:
    """Send what is still to be printed to the null device: Python flushes once more as it ends."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _print(text: str, stream: TextIO) -> None:
    encoding = stream.encoding or "utf-8"
    stream.write(text.encode(encoding, "backslashreplace").decode(encoding) + "\n")
    stream.flush()
