"""Where commands write: places that cannot be, disks that are full, work that is interrupted. Nothing is ever lost."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

from components.repertoire_file import load
from reefgame import headless
from reefgame.replay import read_replay
from reefgame.soak import Trace
from reefgame.world import World

Run = Callable[..., tuple[int, str, str]]
Disk = Callable[[int], AbstractContextManager[None]]
SMALL = ("--size", "64x36")


@pytest.fixture
def sardine(installed: Path) -> Path:
    return installed / "assets" / "species" / "sardine.yaml"


@pytest.fixture
def commands(recording: Path, sardine: Path) -> dict[str, list[object]]:
    """Every command that writes where it is told, up to the place."""
    replay: list[object] = ["replay", recording]
    return {
        "shot": ["shot", "visitors", "--tick", 0, *SMALL, "-o"],
        "portrait": ["shot", "--species", "sardine", *SMALL, "-o"],
        "trace": ["soak", "visitors", "--ticks", 60, "--trace"],
        "again": [*replay, "-o"],
        "film": [*replay, *SMALL, "--video"],
        "picture": [*replay, *SMALL, "--picture"],
        "record": ["play", "first_dive", "--headless", "--record"],
        "bench": ["bench", "startup", "--json"],
    }


COMMANDS = ("shot", "portrait", "trace", "again", "film", "picture", "bench")


@pytest.mark.parametrize("name", COMMANDS)
@pytest.mark.parametrize(
    ("place", "reason"),
    [
        ("missing/out.file", "No such file or directory"),
        ("dive.replay/out.file", "Not a directory"),
        (".", "Is a directory"),
        ("x" * 300, "File name too long"),
    ],
)
def test_a_place_that_cannot_be_written_is_one_line_before_the_work(
    name: str,
    place: str,
    reason: str,
    reefgame: Run,
    commands: dict[str, list[object]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(World, "build", lambda *_: pytest.fail("the work began"))
    assert reefgame(*commands[name], tmp_path / place) == (
        1,
        "",
        f"{tmp_path / place}: cannot be written: {reason}\n",
    )
    assert [path.name for path in tmp_path.iterdir()] == ["dive.replay"]


@pytest.mark.parametrize("name", COMMANDS)
def test_a_device_is_never_replaced_by_a_file(
    name: str, reefgame: Run, commands: dict[str, list[object]]
) -> None:
    status, _, err = reefgame(*commands[name], "/dev/full")
    assert (status, err) == (1, "/dev/full: cannot be written: it is a device, not a file\n")
    assert Path("/dev/full").is_char_device()


@pytest.mark.parametrize("name", ["shot", "trace", "again", "film", "picture"])
def test_a_full_disk_is_one_line_and_the_old_file_stays(
    name: str, reefgame: Run, commands: dict[str, list[object]], tmp_path: Path, full_disk: Disk
) -> None:
    out = tmp_path / "out.mp4"
    out.write_text("old")
    with full_disk(512):
        status, said, err = reefgame(*commands[name], out)
    assert (status, said) == (1, "")
    assert err == f"{out}: cannot be written: File too large\n"
    assert out.read_text() == "old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["dive.replay", "out.mp4"]


def test_a_capture_on_a_full_disk_leaves_the_old_file(
    reefgame: Run,
    sardine: Path,
    tmp_path: Path,
    full_disk: Disk,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    shipped = load(sardine.parents[1] / "repertoires" / "sardine.npz")
    monkeypatch.setattr("tools.capture.capture.capture", lambda *_: shipped)
    old = tmp_path / "sardine.npz"
    old.write_text("old")
    with full_disk(512):
        status, _, err = reefgame("capture", sardine, "-o", tmp_path)
    assert (status, err) == (1, f"{old}: cannot be written: File too large\n")
    assert old.read_text() == "old"
    assert list(tmp_path.iterdir()) == [old]


@pytest.mark.parametrize("below", ["", "repertoires"])
def test_a_capture_into_a_file_is_refused_before_it_begins(
    below: str, reefgame: Run, sardine: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tools.capture.capture.capture", lambda *_: pytest.fail("it began"))
    (tmp_path / "file").write_text("mine")
    status, _, err = reefgame("capture", sardine, "-o", tmp_path / "file" / below)
    assert status == 1
    assert err.startswith(f"{tmp_path / 'file' / below / 'sardine.npz'}: cannot be written: ")
    assert err.count("\n") == 1
    assert (tmp_path / "file").read_text() == "mine"


def test_a_recording_asked_for_that_the_disk_cuts_short_is_told_and_plays(
    reefgame: Run, commands: dict[str, list[object]], tmp_path: Path, full_disk: Disk
) -> None:
    out = tmp_path / "out.replay"
    with full_disk(1500):
        status, said, err = reefgame(*commands["record"], out)
    assert status == 1
    assert "won after" in said
    assert err == "warning: this dive is not recorded: File too large\n"
    assert read_replay(out).ticks >= 60
    assert reefgame("replay", out, "--verify")[0] == 0


def test_a_recording_on_a_full_device_is_one_line(
    reefgame: Run, commands: dict[str, list[object]]
) -> None:
    message = "/dev/full: cannot be written: No space left on device\n"
    assert reefgame(*commands["record"], "/dev/full") == (1, "", message)


@pytest.mark.parametrize("name", ["trace", "again", "film", "picture", "shot", "record"])
def test_an_interrupt_is_status_130_and_nothing_half_written(
    name: str,
    reefgame: Run,
    commands: dict[str, list[object]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    out = tmp_path / "out.mp4"
    if name != "record":
        out.write_text("old")

    tick = World.tick

    def interrupted(world: World, *command: object) -> None:
        if world.clock.now == 1:
            raise KeyboardInterrupt
        tick(world, *command)  # type: ignore[arg-type]  # a Command, or none

    arguments = ["shot", "visitors", "--tick", 9, "-o"] if name == "shot" else commands[name]
    monkeypatch.setattr(World, "tick", interrupted)
    assert reefgame(*arguments, out)[0] == 130
    assert sorted(path.name for path in tmp_path.iterdir()) == ["dive.replay", "out.mp4"]
    if name == "record":
        assert read_replay(out).ticks == 1
    else:
        assert out.read_text() == "old"


def test_an_interrupt_while_a_trace_is_written_leaves_nothing(
    reefgame: Run,
    commands: dict[str, list[object]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(Trace, "_write", interrupted)
    assert reefgame(*commands["trace"], tmp_path / "t.npz")[0] == 130
    assert [path.name for path in tmp_path.iterdir()] == ["dive.replay"]


def test_a_link_is_followed_and_not_replaced(
    reefgame: Run, commands: dict[str, list[object]], tmp_path: Path
) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "there")
    assert reefgame(*commands["again"], tmp_path / "link")[0] == 0
    assert (tmp_path / "link").is_symlink()
    assert read_replay(tmp_path / "there").ended


def test_a_replay_may_be_recorded_again_over_itself(
    reefgame: Run, recording: Path, commands: dict[str, list[object]]
) -> None:
    old = recording.read_bytes()
    assert reefgame(*commands["again"], recording)[0] == 0
    assert recording.read_bytes() == old


def test_a_dive_that_is_not_the_replays_is_not_begun(
    reefgame: Run, recording: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(headless, "open_level", lambda *_, **__: pytest.fail("it was loaded"))
    recording.write_text(recording.read_text().replace("\ngame ", "\ngame 9."))
    status, _, err = reefgame("replay", recording, "--verify")
    assert status == 1
    assert f"{recording}:2:1: recorded with reefgame 9." in err
