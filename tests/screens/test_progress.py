"""Saved progress survives crashes, a second instance, damage and folders that cannot be written."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from reefgame.durable import exclusive
from reefgame.progress import Progress, Record, Result

WRITER = """
import sys
from pathlib import Path
from reefgame.progress import Progress, Result
path, level, count = Path(sys.argv[1]), sys.argv[2], int(sys.argv[3])
progress = Progress(path)
for at in range(count):
    progress.add(Result(level, 100 + at, 300.0 - at, at % 50, True))
    progress.add(Result("both", int(sys.argv[4]) + at, 90.0, 1, True))
    print(at, flush=True)
assert not progress.warnings, progress.warnings
"""


def writer(path: Path, level: str, count: int, score: int = 0) -> "subprocess.Popen[str]":
    arguments = [sys.executable, "-c", WRITER, str(path), level, str(count), str(score)]
    return subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True)


def win(score: int, seconds: float = 60.0, count: int = 12) -> Result:
    return Result("first_dive", score, seconds, count, True)


def test_the_best_of_each_is_kept_over_games(user_folders: Path) -> None:
    Progress().add(win(1000, 50.0, 12))
    Progress().add(win(900, 40.0, 15))
    Progress().add(Result("first_dive", 0, 5.0, 20, False))
    assert Progress().record("first_dive") == Record(1000, 40.0, 20, 2)
    assert Progress().record("another") == Record()
    assert user_folders in Progress().path.parents


def test_a_killed_game_leaves_whole_progress(tmp_path: Path) -> None:
    path = tmp_path / "progress.json"
    reached = 0
    for _ in range(3):
        with writer(path, "a", 100_000) as game:
            assert game.stdout is not None
            for _ in range(20):
                reached = int(game.stdout.readline())
            os.kill(game.pid, signal.SIGKILL)
        progress = Progress(path)
        assert progress.warnings == []
        assert progress.record("a").score >= 100 + reached
    assert progress.record("a").wins >= 60
    left = {found.name for found in tmp_path.iterdir()}
    assert left <= {"progress.json", ".progress.json.lock", ".progress.json.draft"}


def test_what_a_killed_game_left_is_written_over(tmp_path: Path) -> None:
    path = tmp_path / "progress.json"
    path.with_name(".progress.json.draft").write_text("half a rec")
    Progress(path).add(win(700))
    assert Progress(path).record("first_dive").score == 700
    assert {found.name for found in tmp_path.iterdir()} == {"progress.json", ".progress.json.lock"}


def test_two_games_at_once_lose_nothing_of_each_other(tmp_path: Path) -> None:
    path = tmp_path / "progress.json"
    with writer(path, "a", 40, 5000) as one, writer(path, "b", 40, 100) as other:
        outputs = one.communicate()[0], other.communicate()[0]
    assert (one.returncode, other.returncode) == (0, 0), outputs
    progress = Progress(path)
    assert progress.record("a") == Record(139, 261.0, 39, 40)
    assert progress.record("b") == Record(139, 261.0, 39, 40)
    assert progress.record("both") == Record(5039, 90.0, 1, 80)


@pytest.mark.parametrize(
    "damage",
    [
        b"",
        b"{",
        b"\xff\xfe",
        b"[1, 2]",
        b'{"version": 99, "levels": {}}',
        b'{"version": 1}',
        b'{"version": 1, "levels": {"a": {"score": -3, "count": 1, "wins": 1, "seconds": 2}}}',
        b'{"version": 1, "levels": {"a": {"score": 1, "count": 1, "wins": 1, "seconds": 1e999}}}',
        b'{"version": 1, "levels": {"a": 7}}',
    ],
)
def test_a_damaged_file_is_reported_and_kept_aside(tmp_path: Path, damage: bytes) -> None:
    path = tmp_path / "progress.json"
    path.write_bytes(damage)
    progress = Progress(path)
    assert len(progress.warnings) == 1
    assert progress.warnings[0].startswith(f"{path}:1:")
    assert path.read_bytes() == damage
    progress.add(win(700))
    assert (tmp_path / "progress.json.bad-1").read_bytes() == damage
    assert Progress(path).record("first_dive").score == 700
    assert len(progress.warnings) == 1


def test_a_folder_that_cannot_be_written_costs_one_warning(tmp_path: Path) -> None:
    (tmp_path / "folder").write_text("a file stands where the folder should be")
    progress = Progress(tmp_path / "folder" / "progress.json")
    progress.add(win(500))
    progress.add(win(800))
    assert len(progress.warnings) == 1
    assert progress.record("first_dive") == Record(800, 60.0, 12, 2)


def test_results_that_could_not_be_saved_are_saved_later(tmp_path: Path) -> None:
    folder = tmp_path / "folder"
    folder.write_text("in the way")
    progress = Progress(folder / "progress.json")
    progress.add(win(500))
    folder.unlink()
    progress.add(win(400))
    assert Progress(folder / "progress.json").record("first_dive") == Record(500, 60.0, 12, 2)


def test_a_game_that_holds_the_lock_for_good_delays_but_does_not_stop(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("reefgame.durable.LOCK_PATIENCE", 0.05)
    progress = Progress(tmp_path / "progress.json")
    with exclusive(tmp_path / "progress.json"):
        progress.add(win(500))
    assert "another instance" in progress.warnings[0]
    progress.add(win(300))
    assert Progress(tmp_path / "progress.json").record("first_dive").wins == 2


def test_the_file_says_its_version(tmp_path: Path) -> None:
    path = tmp_path / "progress.json"
    Progress(path).add(win(500))
    assert json.loads(path.read_text())["version"] == 1
