"""Machines that lack OpenGL, a display, folders to write to or somebody who reads; and games that are killed."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numba
import pytest

from reefgame import recordings
from reefgame.autopilot import idle
from reefgame.console import InputError, complain, say
from reefgame.content import load
from reefgame.recordings import Recording
from reefgame.replay import read_replay
from reefgame.testing import play
from reefgame.world import World

Run = Callable[..., tuple[int, str, str]]
PATIENCE = 240.0
"""[s] that a dive may take to begin: the first game of a machine compiles its kernels."""
NO_OPENGL = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent", "LIBGL_DRIVERS_PATH": "/nonexistent"}


@pytest.mark.parametrize(
    "arguments",
    [
        ("shot", "visitors", "--tick", "0", "-o", "out.png"),
        ("replay", "dive.replay", "--video", "out.mp4", "--picture", "out.png"),
    ],
)
def test_without_opengl_one_line_and_nothing_written(
    arguments: tuple[str, ...], process: Run, recording: Path
) -> None:
    status, out, err = process(*arguments, **NO_OPENGL)
    assert (status, out) == (1, "")
    assert err.startswith("no OpenGL 3.3: ")
    assert err.count("\n") == 1
    assert list(recording.parent.iterdir()) == [recording]


def test_a_replay_without_a_display_is_one_line_that_names_headless(
    process: Run, recording: Path
) -> None:
    status, out, err = process("replay", recording, DISPLAY="")
    assert (status, out) == (1, "")
    assert err.startswith("no display")
    assert "--headless" in err
    assert err.count("\n") == 1


def test_folders_that_cannot_be_written_cost_time_and_a_warning(
    process: Run, tmp_path: Path
) -> None:
    blocked = tmp_path / "blocked"
    blocked.write_text("a file where a folder should be")
    places = dict.fromkeys(("XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"), str(blocked))
    status, out, err = process("play", "first_dive", "--headless", **places)
    assert status == 0
    assert "won after" in out
    assert err == "warning: this dive is not recorded: Not a directory\n"
    assert list(tmp_path.iterdir()) == [blocked]


def test_a_cache_that_cannot_be_written_costs_nothing_else(process: Run, tmp_path: Path) -> None:
    blocked = tmp_path / "blocked"
    blocked.write_text("a file where a folder should be")
    # Compiled kernels are at hand, so that it costs no time either: the other caches are meant.
    places = {"XDG_CACHE_HOME": str(blocked), "NUMBA_CACHE_DIR": str(numba.config.CACHE_DIR)}
    assert process("list", "species", **places)[0] == 0
    status, out, err = process("soak", "visitors", "--ticks", "1", **places)
    assert (status, err) == (0, "")
    assert "fish " in out
    assert list(tmp_path.iterdir()) == [blocked]


def _long_dive(folder: Path) -> list[str]:
    """Return the command of a dive that nobody can win for fifty minutes."""
    mod = folder / "slow"
    (mod / "levels").mkdir(parents=True)
    (mod / "mod.yaml").write_text('id: slow\ntitle: Slow\nversion: "1"\n', encoding="utf-8")
    reef = (Path(__file__).parents[1] / "content" / "samples" / "reef.yaml").read_text("utf-8")
    late = reef.replace(
        "{species: sardine, count: 48,", "{species: sardine, count: 48, arrives_s: 3000,"
    )
    assert late != reef
    (mod / "levels" / "wait.yaml").write_text(late, encoding="utf-8")
    return ["play", "slow:wait", "--mod", str(mod), "--headless"]


def _wait_for(condition: Callable[[], bool], process: "subprocess.Popen[bytes]") -> None:
    deadline = time.monotonic() + PATIENCE
    while not condition() and process.poll() is None and time.monotonic() < deadline:
        time.sleep(0.01)
    assert condition()


def _diving(number: int) -> bool:
    """Return whether so many dives are recorded, each with two checksums or more."""
    kept = recordings.kept()
    return len(kept) == number and all(path.read_text().count(" # ") > 1 for path in kept)


def test_dives_killed_side_by_side_leave_recordings_that_play(
    reefgame: Run, user_folders: Path, tmp_path: Path
) -> None:
    command = _long_dive(tmp_path)
    program = [sys.executable, "-m", "reefgame.cli", *command]
    games = [subprocess.Popen(program, stdout=subprocess.DEVNULL) for _ in range(2)]
    try:
        _wait_for(lambda: _diving(2), games[0])
    finally:
        for game in games:
            game.send_signal(signal.SIGKILL)
            game.wait(30)
    for path in recordings.kept():
        replay = read_replay(path)
        assert not replay.ended
        assert replay.ticks >= 120
        status, out, err = reefgame("replay", path, "--verify", "--mod", command[3])
        assert (status, err) == (0, "")
        assert "the recording was cut short" in out


def test_ctrl_c_ends_a_dive_with_status_130_and_a_whole_recording(
    user_folders: Path, tmp_path: Path
) -> None:
    program = [sys.executable, "-m", "reefgame.cli", *_long_dive(tmp_path)]
    game = subprocess.Popen(program, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        _wait_for(lambda: _diving(1), game)
        game.send_signal(signal.SIGINT)
        out, err = game.communicate(timeout=PATIENCE)
    finally:
        game.kill()
    assert (game.returncode, out, err) == (130, b"", b"")
    (path,) = recordings.kept()
    assert read_replay(path).ended


def test_games_at_once_record_into_files_of_their_own(user_folders: Path) -> None:
    world = play("visitors", idle, 0.0).world
    games = [Recording(world) for _ in range(recordings.KEPT)]
    assert len({game.path for game in games}) == recordings.KEPT
    for game in games:
        game.close()
    assert sorted(recordings.kept()) == sorted(
        str_path for str_path in (g.path for g in games) if str_path
    )


def test_a_recording_that_another_game_removes_in_between_is_passed_over(
    user_folders: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = recordings.folder()
    folder.mkdir(parents=True)
    (folder / "a.replay").write_text("")
    # A link to nothing is listed and cannot be looked at, as a file that has just been removed.
    (folder / "b.replay").symlink_to(folder / "gone")
    assert recordings.kept() == [folder / "a.replay"]
    recording = Recording(play("visitors", idle, 0.0).world)
    recording.close()
    assert recording.warning is None


def test_a_dive_left_before_its_first_tick_is_a_replay_of_nothing(
    tmp_path: Path, reefgame: Run
) -> None:
    world = World.build(load("visitors"))
    recording = Recording(world, tmp_path / "none.replay")
    recording.close()
    status, out, _ = reefgame("replay", tmp_path / "none.replay", "--verify")
    assert status == 0
    assert out.startswith("0 ticks, 0 checksums")


SHELL = "{python} -m reefgame.cli schema level {where}; echo status $? >&2"


@pytest.mark.parametrize(
    ("where", "said"),
    [
        (">/dev/full", "standard output: cannot be written: No space left on device\nstatus 1\n"),
        (">&-", "status 0\n"),
        ("<&- >&-", "status 0\n"),
        ("| true", "status 0\n"),
        ("| head -1", "status 0\n"),
    ],
)
def test_an_output_that_is_full_closed_or_unread_is_no_traceback(where: str, said: str) -> None:
    shell = SHELL.format(python=sys.executable, where=where)
    done = subprocess.run(["sh", "-c", shell], capture_output=True, text=True, check=False)
    assert done.stderr == said


def test_nobody_reading_ends_with_status_one_and_silence() -> None:
    read, write = os.pipe()
    os.close(read)
    arguments = [sys.executable, "-m", "reefgame.cli", "schema", "level"]
    done = subprocess.run(arguments, stdout=write, stderr=subprocess.PIPE, check=False)
    os.close(write)
    assert (done.returncode, done.stderr) == (1, b"")


def test_a_closed_error_stream_never_gets_into_a_picture(tmp_path: Path) -> None:
    command = f"{sys.executable} -m reefgame.cli replay none.replay -o out 0<&- 1>&- 2>&-"
    done = subprocess.run(["sh", "-c", command], cwd=tmp_path, check=False)
    assert done.returncode == 1
    assert list(tmp_path.iterdir()) == []


def test_what_a_terminal_cannot_show_is_escaped(monkeypatch: pytest.MonkeyPatch) -> None:
    read, write = os.pipe()
    with open(read, encoding="ascii") as reader:  # noqa: PTH123 (a descriptor)
        with open(write, "w", encoding="ascii") as narrow:  # noqa: PTH123 (a descriptor)
            monkeypatch.setattr(sys, "stdout", narrow)
            monkeypatch.setattr(sys, "stderr", narrow)
            say("Récif \udcff")
            complain("été")
            monkeypatch.undo()
        assert reader.read() == "R\\xe9cif \\udcff\n\\xe9t\\xe9\n"


def test_a_full_output_is_the_users_to_mend(monkeypatch: pytest.MonkeyPatch) -> None:
    with Path("/dev/full").open("w", encoding="utf-8") as full:
        monkeypatch.setattr(sys, "stdout", full)
        with pytest.raises(InputError, match="standard output: cannot be written: No space left"):
            say("a line")
        monkeypatch.undo()
