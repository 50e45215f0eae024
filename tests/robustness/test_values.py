"""Values and content at fault: sizes, seeds, ticks, replays without end, mods that are broken."""

from collections.abc import Callable
from pathlib import Path

import pytest

from reefgame import replay
from reefgame.world import World
from systems.view.target import MOST_PIXELS

Run = Callable[..., tuple[int, str, str]]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("shot", "visitors", "--size", "99999x1", "-o", "x.png"), "size '99999x1': two numbers"),
        (("shot", "visitors", "--size", "-1x5", "-o", "x.png"), "size '-1x5': two numbers"),
        (("shot", "visitors", "--size", "٣x٣", "-o", "x.png"), "size '٣x٣': two numbers"),
        (("shot", "visitors", "--tick", "-1", "-o", "x.png"), "number of ticks '-1': a whole"),
        (("shot", "visitors", "--seed", "-7", "-o", "x.png"), "seed '-7': a whole number from 0"),
        (("soak", "visitors", "--ticks", "1.5"), "number of ticks '1.5': a whole number"),
        (("soak", "visitors", "--ticks", "9" * 30), f"number of ticks '{'9' * 30}': a whole"),
        (("soak", "visitors", "--ticks", "1", "--seed", "9" * 19), f"seed '{'9' * 19}': a whole"),
        (("replay", "x.replay", "--checksum-every", "-1"), "number of ticks '-1': a whole"),
        (("shot", "visitors", "--at", "nan,0,0", "-o", "x.png"), "point 'nan,0,0': three numbers"),
        (("shot", "visitors", "--at", "1e9,0,0", "-o", "x.png"), "point '1e9,0,0': three numbers"),
        (("shot", "visitors", "--species", "sardine", "-o", "x.png"), "one of them"),
        (("play", "a" * 5000, "--headless"), "there is no level 'aaaa"),
        (("check", "a" * 5000), "File name too long"),
        (("replay", "a" * 5000), "cannot be read: File name too long"),
        (("list", "mods", "--mod", "missing"), "missing:1:1: there is no such folder"),
        (("new", "species", "../x"), "'../x'"),
    ],
)
def test_a_bad_value_is_one_line_and_nothing_is_written(
    arguments: tuple[str, ...],
    message: str,
    reefgame: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    status, out, err = reefgame(*arguments)
    assert (status, out) == (1, "")
    assert message in err
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_no_ticks_are_a_soak_of_the_first_moment(reefgame: Run, tmp_path: Path) -> None:
    status, out, _ = reefgame("soak", "visitors", "--ticks", 0, "--trace", tmp_path / "t.npz")
    assert status == 0
    assert "clock " in out
    assert (tmp_path / "t.npz").is_file()


def test_a_picture_beyond_what_opengl_draws_is_one_line(reefgame: Run, tmp_path: Path) -> None:
    size = ("--tick", 0, "--size", "16384x16384", "-o", tmp_path / "x.png")
    status, _, err = reefgame("shot", "visitors", *size)
    assert status == 1
    assert err.startswith("size 16384x16384: ")
    assert err.count("\n") == 1
    assert MOST_PIXELS < 16384 * 16384
    assert list(tmp_path.iterdir()) == []


def test_a_film_of_an_odd_size_is_one_line_before_the_dive(
    reefgame: Run, recording: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(World, "tick", lambda *_: pytest.fail("the dive began"))
    film = recording.with_suffix(".mp4")
    status, _, err = reefgame("replay", recording, "--video", film, "--size", "641x361")
    assert (status, err) == (1, "a film's width and height must be even, not 641x361\n")
    assert list(recording.parent.iterdir()) == [recording]


def test_work_beyond_the_memory_is_one_line(
    reefgame: Run, recording: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def too_much(*_: object) -> None:
        raise MemoryError

    monkeypatch.setattr(World, "tick", too_much)
    assert reefgame("soak", "visitors", "--ticks", 1) == (
        1,
        "",
        "this needs more memory than there is\n",
    )


def test_a_replay_without_end_is_not_read_into_memory(
    reefgame: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(replay, "LARGEST", 1 << 20)
    message = "/dev/zero:1:1: larger than 1 MiB: no replay is\n"
    assert reefgame("replay", "/dev/zero", "--verify") == (1, "", message)


def test_a_folder_is_no_replay(reefgame: Run, tmp_path: Path) -> None:
    message = f"{tmp_path}:1:1: cannot be read: Is a directory\n"
    assert reefgame("replay", tmp_path) == (1, "", message)


@pytest.mark.parametrize(
    "arguments",
    [
        ("soak", "visitors", "--ticks", "1"),
        ("shot", "visitors", "--tick", "0", "--size", "8x8", "-o", "x.png"),
        ("replay", "dive.replay", "--verify"),
        ("play", "first_dive", "--headless"),
        ("list", "species"),
        ("list", "levels"),
    ],
)
def test_a_broken_installed_mod_is_told_once_and_the_rest_goes_on(
    arguments: tuple[str, ...],
    reefgame: Run,
    recording: Path,
    broken_mod: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(recording.parent)
    status, out, err = reefgame(*arguments)
    assert status == 0
    assert out
    assert err.splitlines() == [
        f"warning: the installed mod {broken_mod} is disabled:",
        f"  {broken_mod}/species/cod.yaml:2:10: must be a number, such as 1.5, is the text 'big'",
    ]


def test_list_mods_shows_what_is_disabled_and_why(reefgame: Run, broken_mod: Path) -> None:
    status, out, err = reefgame("list", "mods")
    assert (status, err) == (0, "")
    assert out.count("disabled") == 1
    assert f"{broken_mod}/species/cod.yaml:2:10: must be a number" in out


def test_a_level_of_a_disabled_mod_says_why_it_is_missing(reefgame: Run, broken_mod: Path) -> None:
    status, _, err = reefgame("soak", "broken:reef", "--ticks", 1)
    assert status == 1
    assert "there is no level 'broken:reef'" in err
    assert f"{broken_mod}/species/cod.yaml:2:10: must be a number" in err


def test_a_broken_mod_that_is_given_is_fatal(reefgame: Run, broken_mod: Path) -> None:
    status, out, err = reefgame("soak", "visitors", "--ticks", 1, "--mod", broken_mod)
    assert (status, out) == (1, "")
    assert err == (
        f"{broken_mod}/species/cod.yaml:2:10: must be a number, such as 1.5, is the text 'big'\n"
    )


@pytest.mark.parametrize("damage", ["truncated", "pickled"])
def test_a_damaged_repertoire_in_a_mod_is_one_line_with_its_file(
    damage: str, reefgame: Run, broken_mod: Path, installed: Path
) -> None:
    (broken_mod / "species" / "cod.yaml").write_text("like: sardine\n", encoding="utf-8")
    (broken_mod / "levels").mkdir()
    level = (installed / "levels" / "visitors.yaml").read_text(encoding="utf-8")
    assert "sardine" in level
    (broken_mod / "levels" / "reef.yaml").write_text(level.replace("sardine", "cod"), "utf-8")
    (broken_mod / "repertoires").mkdir()
    shipped = (installed / "assets" / "repertoires" / "sardine.npz").read_bytes()
    bad = broken_mod / "repertoires" / "cod.npz"
    bad.write_bytes(shipped[: len(shipped) // 2] if damage == "truncated" else b"cos\nsystem\n.")
    status, out, err = reefgame("soak", "broken:reef", "--ticks", 1)
    assert (status, out) == (1, "")
    assert err.startswith(f"{bad}:1:1: not a usable repertoire: ")
    assert err.count("\n") == 1
