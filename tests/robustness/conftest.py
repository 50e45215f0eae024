"""Runs the command line in this process, or as one of its own where descriptors and signals matter."""

import os
import resource
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import NamedTuple

import pytest
from platformdirs import user_data_path

from reefgame.autopilot import tour
from reefgame.cli import main
from reefgame.testing import play


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


@pytest.fixture
def process(tmp_path: Path) -> Callable[..., Said]:
    """A function that runs `reefgame ARGUMENT...` as a process, with further environment."""

    def run(*arguments: object, **environment: str) -> Said:
        done = subprocess.run(
            [sys.executable, "-m", "reefgame.cli", *map(str, arguments)],
            env=os.environ | environment,
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )
        return Said(done.returncode, done.stdout, done.stderr)

    return run


@pytest.fixture(scope="session")
def two_seconds() -> str:
    """The recording of a dive of two seconds."""
    return play("visitors", tour, 2.0, seed=4).replay


@pytest.fixture
def recording(tmp_path: Path, two_seconds: str) -> Path:
    """A recording in a file, the only one of an else empty working folder."""
    path = tmp_path / "dive.replay"
    path.write_text(two_seconds, encoding="ascii")
    return path


@pytest.fixture
def full_disk() -> Callable[[int], AbstractContextManager[None]]:
    """A function: no file may grow beyond so many bytes while its block runs."""

    @contextmanager
    def limited(most: int) -> Iterator[None]:
        soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, hard))
        try:
            yield
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))

    return limited


@pytest.fixture
def broken_mod(user_folders: Path) -> Path:
    """An installed mod with a fault in its species."""
    root = user_data_path("reefgame") / "mods" / "broken"
    (root / "species").mkdir(parents=True)
    (root / "mod.yaml").write_text('id: broken\ntitle: A mod\nversion: "1"\n', encoding="utf-8")
    (root / "species" / "cod.yaml").write_text("like: sardine\nsize_cm: big\n", encoding="utf-8")
    return root
