"""`reefgame video MOTION --target MODEL`: films, sequences and what is refused (papers/003, section 5)."""

import os
import subprocess
import sys
from pathlib import Path

import av
import numpy as np
import pytest

from reefgame.cli import main
from tools.video.motion_file import save
from tools.video.retarget.choose import shipped
from tools.video.retarget.example import example_clip_motion
from tools.video.retarget.picture import read_picture


@pytest.fixture
def motion(tmp_path: Path) -> Path:
    """A motion file of seven frames."""
    path = tmp_path / "swim.motion"
    save(path, example_clip_motion(7))
    return path


def refused(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """Run `reefgame video`, see it fail with one line, and return that."""
    assert main(["video", *arguments]) == 1
    told = capsys.readouterr()
    assert told.out == ""
    (line,) = told.err.splitlines()
    return line


def test_a_film_of_a_model_is_h264_of_every_frame(motion: Path, tmp_path: Path) -> None:
    film = tmp_path / "carp.mp4"
    assert main(["video", str(motion), "--target", "carp", "-o", str(film)]) == 0
    with av.open(str(film)) as found:
        stream = found.streams.video[0]
        assert stream.codec_context.name == "h264"
        assert (stream.width, stream.height) == (960, 544)
        assert len(list(found.decode(stream))) == 7


def test_a_name_without_an_ending_is_a_folder_of_pictures(motion: Path, tmp_path: Path) -> None:
    folder = tmp_path / "shark"
    arguments = [
        "video",
        str(motion),
        "--target",
        "reef_shark",
        "--fins",
        "paper",
        "-o",
        str(folder),
    ]
    assert main(arguments) == 0
    pictures = [read_picture(path)[..., :3] for path in sorted(folder.iterdir())]
    assert [p.shape for p in pictures] == [(544, 960, 3)] * 7
    assert np.abs(pictures[0].astype(int) - pictures[6]).max() > 50


def test_a_folder_that_holds_something_is_left_alone(
    motion: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "full"
    folder.mkdir()
    (folder / "mine.txt").write_text("mine")
    line = refused(capsys, str(motion), "--target", "carp", "-o", str(folder))
    assert "not empty" in line
    assert [path.name for path in folder.iterdir()] == ["mine.txt"]


@pytest.mark.parametrize(
    ("target", "says"),
    [
        ("no_such_fish", "carp, cartoon, flower, lobster, mermaid, whale"),
        ("picture.xyz", "no picture"),
        ("absent.png", "cannot be read"),
        ("absent.glb", "cannot be read"),
        ("absent.obj", "cannot be read"),
    ],
)
def test_a_target_that_is_not_there_is_one_line(
    motion: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], target: str, says: str
) -> None:
    film = tmp_path / "film.mp4"
    assert says in refused(capsys, str(motion), "--target", target, "-o", str(film))
    assert not film.exists()


@pytest.mark.parametrize("name", ["film.avi", "none/film.mp4"])
def test_an_output_that_cannot_be_is_one_line(
    motion: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    output = tmp_path / name
    assert str(output) in refused(capsys, str(motion), "--target", "carp", "-o", str(output))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["swim.motion"]


def test_a_picture_of_ones_own_needs_no_more_than_its_name(
    motion: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    own = tmp_path / "own.png"
    own.write_bytes(shipped()["lobster"].read_bytes())
    film = tmp_path / "own.mp4"
    assert main(["video", str(motion), "--target", str(own), "--head", "up", "-o", str(film)]) == 0
    assert capsys.readouterr().out.splitlines() == [str(film)]
    assert film.stat().st_size > 1000


def test_retouch_without_a_display_says_how_to_edit_all_the_same(motion: Path) -> None:
    run = subprocess.run(
        [sys.executable, "-m", "reefgame.cli", "retouch", str(motion)],
        env=os.environ | {"DISPLAY": ""},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 1
    (line,) = run.stderr.splitlines()
    assert line.startswith("no display")
    assert "tools.video.retouch.session.Session" in line
    assert "--headless" not in line
