"""What the command line says, and shows while long work goes on: a bar on a terminal, nothing in a pipe."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TypeAlias

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

Report: TypeAlias = Callable[[float, str], None]
"""Called with the fraction done, 0 to 1, and what is being done."""


class InputError(Exception):
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
    """Print a line of result."""
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


def complain(text: str) -> None:
    """Print a line about what is wrong, on the standard error."""
    sys.stderr.write(text + "\n")
    sys.stderr.flush()
