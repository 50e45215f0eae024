"""The replay reader: what it accepts, what it refuses and how it says so."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.command import Command
from reefgame.content.errors import ContentError
from reefgame.replay import Replay, read_replay

HEADER = (
    "reefgame replay 1\ngame 0.1.0\nlevel first_dive\ncontent 00ff\nseed 7\nchecksum-every 60\n"
)
BODY = "0 throttle=100\n30 throttle=0 turn=-40\n59 # fish=00000000000000ff\n119 # fish=0000000000000001\n"


def read(tmp_path: Path, text: str | bytes) -> Replay:
    path = tmp_path / "a.replay"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return read_replay(path)


def fault(tmp_path: Path, text: str | bytes) -> str:
    with pytest.raises(ContentError) as caught:
        read(tmp_path, text)
    message = str(caught.value)
    assert "\n" not in message
    return message.removeprefix(f"{tmp_path / 'a.replay'}:")


def test_a_whole_replay_gives_every_command_and_checksum(tmp_path: Path) -> None:
    replay = read(tmp_path, HEADER + BODY + "130 end\n")
    assert (replay.level, replay.seed, replay.every, replay.ticks) == ("first_dive", 7, 60, 131)
    assert replay.ended
    commands = list(replay.play())
    assert commands[29] == Command(throttle=100)
    assert commands[30] == Command(throttle=0, turn=-40)
    assert replay.checksums[59] == {"fish": 255}


def test_a_dive_cut_short_plays_to_its_last_checksum(tmp_path: Path) -> None:
    replay = read(tmp_path, HEADER + BODY + "125 pitch=3\n130 thrott")
    assert not replay.ended
    assert replay.ticks == 120


def test_windows_line_ends_are_fine(tmp_path: Path) -> None:
    text = HEADER + BODY + "130 end\n"
    assert read(tmp_path, text.replace("\n", "\r\n")) == read(tmp_path, text)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "1:1: not a replay"),
        ("reefgame replay 2\n", "1:1: not a replay"),
        (HEADER.replace("seed 7\n", ""), "5:1: the header's line 'seed ...' is missing"),
        (HEADER.replace("seed 7", "seed -7"), "5:1: '-7' is not a whole number"),
        (HEADER + "x throttle=1\n", "7:1: 'x' is not a whole number"),
        (HEADER + "5 throttle=1\n4 turn=1\n", "8:1: tick 4 stands after tick 5"),
        (HEADER + "5 throttle=101\n", "7:1: throttle=101 is not from -100 to 100"),
        (HEADER + "5 stop=2\n", "7:1: stop=2 is not from 0 to 1"),
        (HEADER + "5 fly=1\n", "7:1: unknown order 'fly', allowed are throttle, turn"),
        (HEADER + "5 throttle\n", "7:1: 'throttle' is not understood"),
        (HEADER + "5 # fish=zz\n", "7:1: 'fish=zz' is not understood"),
        (HEADER + "5 end\n6 turn=1\n", "8:1: nothing may follow the end line"),
        (HEADER.encode() + b"5 \xff\xfe=1\n", "7:1: not a replay: it holds bytes"),
    ],
)
def test_a_noisy_replay_names_the_line(tmp_path: Path, text: str | bytes, message: str) -> None:
    assert fault(tmp_path, text).startswith(message)


def test_a_missing_replay_is_one_line(tmp_path: Path) -> None:
    with pytest.raises(ContentError, match="cannot be read: No such file"):
        read_replay(tmp_path / "none.replay")


def outcome(path: Path) -> str | None:
    """Return what the reader complains of, or None after playing every command."""
    try:
        replay = read_replay(path)
    except ContentError as error:
        return str(error)
    return None if all(isinstance(command, Command) for command in replay.play()) else "?\n"


@given(noise=st.binary(max_size=300), at=st.integers(0, 400))
def test_any_bytes_give_a_replay_or_one_clear_line(
    tmp_path_factory: pytest.TempPathFactory, noise: bytes, at: int
) -> None:
    good = (HEADER + BODY + "130 end\n").encode()
    path = tmp_path_factory.mktemp("noise") / "a.replay"
    path.write_bytes(good[:at] + noise + good[at:])
    said = outcome(path)
    assert said is None or "\n" not in said
