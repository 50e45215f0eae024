"""Runs the command line in this process, as a user would type it."""

from collections.abc import Callable
from typing import NamedTuple

import pytest

from reefgame.cli import main


class Said(NamedTuple):
    """What a command answered."""

    status: int
    out: str
    err: str


@pytest.fixture
def reefgame(capsys: pytest.CaptureFixture[str]) -> Callable[..., Said]:
    """A function that runs `reefgame ARGUMENT...`."""

    def run(*arguments: object) -> Said:
        try:
            status = main([str(argument) for argument in arguments])
        except SystemExit as stopped:
            status = int(stopped.code or 0)
        said = capsys.readouterr()
        return Said(status, said.out, said.err)

    return run
