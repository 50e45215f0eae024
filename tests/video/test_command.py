"""`reefgame video`: what it writes, what it says, how it ends."""

from pathlib import Path

import av
import pytest

from reefgame.cli import main
from tools.video.motion_file import load


def test_a_clip_becomes_a_motion_and_a_page(
    fish_film: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    output, folder = tmp_path / "fish.motion", tmp_path / "page"
    arguments = ["video", str(fish_film), "-o", str(output), "--report", str(folder)]
    assert main([*arguments, "--fps", "120"]) == 0
    told = capsys.readouterr()
    assert "45 of 45 frames are good" in told.out
    assert str(output) in told.out
    assert told.err == ""
    assert load(output).rate == 120.0
    page = (folder / "index.html").read_text()
    assert page.count("<svg") == 3
    assert "<td>0 to 44</td><td>45</td><td>good</td>" in page
    assert str(tmp_path) not in page
    with av.open(str(folder / "film.mp4")) as film:
        assert film.streams.video[0].codec_context.name == "h264"
        assert sum(1 for _ in film.decode(video=0)) == 45
    assert sorted(path.name for path in folder.iterdir()) == ["film.mp4", "index.html"]


def test_the_same_clip_gives_the_same_bytes(fish_film: Path, tmp_path: Path) -> None:
    one, other = tmp_path / "one.motion", tmp_path / "other.motion"
    for path in (one, other):
        assert main(["video", str(fish_film), "-o", str(path)]) == 0
    assert one.read_bytes() == other.read_bytes()


def test_without_an_output_the_motion_has_the_clips_name(
    fish_film: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["video", str(fish_film), "--hz", "4"]) == 0
    motion = load(tmp_path / "sardine.motion")
    assert motion.rate == pytest.approx(60.0, rel=0.01)


@pytest.mark.parametrize(
    ("option", "value", "told"),
    [
        ("--fps", "0", "rate '0'"),
        ("--fps", "nan", "rate 'nan'"),
        ("--hz", "-3", "rate '-3'"),
        ("--select", "12", "place '12'"),
        ("--select", "9000,3", "lies outside"),
    ],
)
def test_a_value_that_cannot_be_is_told_in_one_line(
    fish_film: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    option: str,
    value: str,
    told: str,
) -> None:
    output = tmp_path / "no.motion"
    assert main(["video", str(fish_film), "-o", str(output), option, value]) == 1
    error = capsys.readouterr().err
    assert told in error
    assert error.count("\n") == 1
    assert not output.exists()


def test_a_clip_without_a_fish_leaves_what_was_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    clip, output = tmp_path / "clip.avi", tmp_path / "old.motion"
    clip.write_text("no clip")
    output.write_text("old")
    assert main(["video", str(clip), "-o", str(output)]) == 1
    assert capsys.readouterr().err == f"{clip}: this is no clip, or it is damaged\n"
    assert output.read_text() == "old"


def test_a_place_that_cannot_be_written_is_told_first(
    fish_film: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["video", str(fish_film), "-o", str(tmp_path / "none" / "a.motion")]) == 1
    assert "cannot be written" in capsys.readouterr().err


def test_wrong_usage_ends_with_two(fish_film: Path) -> None:
    for arguments in (["--background", "magic"], ["--fps", "30", "--hz", "4"]):
        with pytest.raises(SystemExit) as ended:
            main(["video", str(fish_film), *arguments])
        assert ended.value.code == 2
