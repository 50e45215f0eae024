"""The command line: what each command does, and how it refuses."""

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from reefgame import recordings
from reefgame.autopilot import tour
from reefgame.bench.run import NAMES
from reefgame.content import ContentError
from reefgame.replay import read_replay
from reefgame.testing import play

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    """A dive of two seconds in a file."""
    path = tmp_path / "dive.replay"
    path.write_text(play("visitors", tour, 2.0, seed=4).replay, encoding="ascii")
    return path


def test_a_recording_is_verified(reefgame: Run, recording: Path) -> None:
    status, out, _ = reefgame("replay", recording, "--verify")
    assert status == 0
    assert out.startswith("120 ticks, 2 checksums of 13 tables equal")


def test_a_recording_cut_short_is_verified_to_its_last_checksum(
    reefgame: Run, recording: Path
) -> None:
    text = recording.read_text()
    recording.write_text(text[: text.rindex("#") - 2])
    status, out, _ = reefgame("replay", recording, "--verify")
    assert status == 0
    assert out.startswith("60 ticks")
    assert "cut short" in out


@pytest.mark.parametrize("shown", [(), ("--video", "dive.mp4"), ("--picture", "best.png")])
def test_a_recording_cut_before_its_first_tick_has_nothing_to_show(
    reefgame: Run, recording: Path, shown: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(recording.parent)
    recording.write_text("".join(recording.read_text().splitlines(keepends=True)[:6]))
    status, _, err = reefgame("replay", recording.name, *shown)
    assert status == 1
    assert err.startswith("dive.replay:6:1: no tick was recorded after the header")
    assert err.count("\n") == 1
    assert [path.name for path in Path().iterdir()] == ["dive.replay"]


def test_a_changed_command_is_a_desync_named_in_one_line(reefgame: Run, recording: Path) -> None:
    lines = recording.read_text().splitlines(keepends=True)
    assert "=" in lines[6]
    lines[6] = "0 throttle=1\n"
    recording.write_text("".join(lines))
    status, _, err = reefgame("replay", recording, "--verify")
    assert status == 1
    assert "desync in commands" in err
    assert "between ticks 0 and 59" in err


def test_a_replay_is_recorded_again_with_finer_checksums(
    reefgame: Run, recording: Path, tmp_path: Path
) -> None:
    fine = tmp_path / "fine.replay"
    assert reefgame("replay", recording, "--checksum-every", 1, "-o", fine)[0] == 0
    old, new = read_replay(recording), read_replay(fine)
    assert list(old.play()) == list(new.play())
    assert len(new.checksums) == 120
    assert new.checksums[59] == old.checksums[59]


@pytest.mark.parametrize(
    ("line", "other", "message"),
    [
        ("game ", "game 0.0.1\n", ":2:1: recorded with reefgame 0.0.1, this is"),
        ("content ", "content 00\n", ":4:1: recorded with other content of level 'visitors'"),
        ("level ", "level visitor\n", "there is no level 'visitor'; did you mean 'visitors'?"),
    ],
)
def test_a_replay_of_another_game_or_content_says_so(
    reefgame: Run, recording: Path, line: str, other: str, message: str
) -> None:
    lines = recording.read_text().splitlines(keepends=True)
    changed = [other if text.startswith(line) else text for text in lines]
    recording.write_text("".join(changed))
    status, _, err = reefgame("replay", recording, "--verify")
    assert status == 1
    assert message in err
    assert err.count("\n") == 1


def test_soak_writes_what_every_fish_did(reefgame: Run, tmp_path: Path) -> None:
    trace = tmp_path / "trace.npz"
    status, out, _ = reefgame("soak", "visitors", "--ticks", 300, "--seed", 3, "--trace", trace)
    assert status == 0
    assert "fish " in out
    with np.load(trace, allow_pickle=False) as data:
        samples, fishes = data["intention"].shape
        assert samples == 50
        assert data["position"].shape == (samples, fishes, 3)
        alive = data["intention"] >= 0
        assert np.isfinite(data["position"][alive]).all()
        assert np.isnan(data["position"][~alive]).all()
        for name in ("hunger", "libido", "fear"):
            assert ((data[name][alive] >= 0.0) & (data[name][alive] <= 1.0)).all()
            assert np.isnan(data[name][~alive]).all()
        assert data["hunger"][alive].std() > 0.0
        assert (data["why"][alive] >= 0).all()
        assert data["focus"].shape == data["swallowed"].shape == (samples, fishes)


def test_a_headless_dive_is_won_recorded_and_proven(reefgame: Run, tmp_path: Path) -> None:
    path = tmp_path / "won.replay"
    status, out, _ = reefgame("play", "first_dive", "--headless", "--seed", 5, "--record", path)
    assert status == 0
    assert "won after" in out
    assert reefgame("replay", path, "--verify")[0] == 0


def test_a_dive_without_a_file_is_kept(reefgame: Run) -> None:
    assert reefgame("play", "first_dive", "--headless")[0] == 0
    assert len(recordings.kept()) == 1


def test_only_the_last_five_dives_are_kept() -> None:
    folder = recordings.folder()
    folder.mkdir(parents=True)
    for number in range(7):
        (folder / f"old-{number}.replay").write_text("")
    dive = play("visitors", tour, 0.1)
    recording = recordings.Recording(dive.world)
    recording.close()
    assert len(recordings.kept()) == recordings.KEPT
    assert recording.path in recordings.kept()


def test_an_unwritable_folder_costs_the_recording_not_the_dive(
    reefgame: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("")
    monkeypatch.setattr(recordings, "folder", lambda: blocked / "replays")
    status, out, err = reefgame("play", "first_dive", "--headless")
    assert status == 0
    assert "won after" in out
    assert err == "warning: this dive is not recorded: Not a directory\n"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("play", "frist_dive", "--headless"), "there is no level 'frist_dive'"),
        (("play", "first_dive", "--size", "0x0"), "size '0x0': two numbers from 1 to"),
        (("shot", "first_dive", "--size", "9x", "-o", "x.png"), "size '9x': two numbers"),
        (("play", "first_dive", "--seed", "-1"), "seed '-1': a whole number from 0 to"),
        (
            ("play", "first_dive", "--live", "51"),
            "number of fishes '51': a whole number from 0 to 50",
        ),
        (("soak", "visitors", "--ticks", "1", "--live", "-1"), "number of fishes '-1'"),
        (("soak", "first_dive", "--ticks", "-5"), "number of ticks '-5': a whole number"),
        (("shot", "first_dive", "--from", "1,2", "-o", "x.png"), "point '1,2': three numbers"),
        (("replay", "none.replay", "--verify"), "none.replay:1:1: cannot be read: No such file"),
        (("bench", "speed"), "no bench is called 'speed'; there are motor, minds"),
        (("shot", "-o", "x.png"), "shot needs a level's name, --species NAME or --flora NAME"),
        (("play", "first_dive", "--headless", "--record", "/dev/null/x"), "/dev/null/x: cannot"),
    ],
)
def test_bad_values_are_one_line_and_status_one(
    reefgame: Run, arguments: tuple[str, ...], message: str
) -> None:
    status, _, err = reefgame(*arguments)
    assert status == 1
    assert message in err
    assert err.count("\n") == 1
    assert "Traceback" not in err


@pytest.mark.parametrize("arguments", [(), ("swim",), ("soak", "first_dive"), ("play", "--fast")])
def test_wrong_usage_is_status_two(reefgame: Run, arguments: tuple[str, ...]) -> None:
    status, _, err = reefgame(*arguments)
    assert status == 2
    assert "usage: reefgame" in err


def test_schema_is_json(reefgame: Run) -> None:
    status, out, _ = reefgame("schema", "species")
    assert status == 0
    assert "size_cm" in json.dumps(json.loads(out))


def test_list_names_the_levels(reefgame: Run) -> None:
    status, out, _ = reefgame("list", "levels")
    assert status == 0
    assert "first_dive" in out


def test_a_new_species_passes_check(reefgame: Run, tmp_path: Path) -> None:
    assert reefgame("new", "mod", "my_reef", "--in", tmp_path)[0] == 0
    status, out, err = reefgame("check", tmp_path / "my_reef")
    assert (status, err) == (0, "")
    assert "no fault" in out


def test_check_complains_with_status_one(reefgame: Run, tmp_path: Path) -> None:
    bad = tmp_path / "bad.yaml"
    bad.write_text("title: [}")
    status, _, err = reefgame("check", bad)
    assert status == 1
    assert "bad.yaml:1:" in err


def test_capture_writes_the_shipped_bytes(reefgame: Run, installed: Path, tmp_path: Path) -> None:
    species = installed / "assets" / "species" / "sardine.yaml"
    status, out, _ = reefgame("capture", species, "-o", tmp_path)
    assert status == 0
    assert "sardine.npz" in out
    shipped = installed / "assets" / "repertoires" / "sardine.npz"
    assert (tmp_path / "sardine.npz").read_bytes() == shipped.read_bytes()


def test_play_of_a_level_at_fault_raises_content_error() -> None:
    with pytest.raises(ContentError, match="there is no level"):
        play("nowhere", tour, 1.0)


def test_the_help_of_bench_names_every_bench(reefgame: Run) -> None:
    status, out, _ = reefgame("bench", "--help")
    assert status == 0
    assert f"{', '.join(NAMES)} or all" in " ".join(out.split())
