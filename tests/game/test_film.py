"""Films: whole or not at all, with every frame in order."""

from pathlib import Path

import av
import numpy as np
import pytest

from reefgame.autopilot import tour
from reefgame.cli import main
from reefgame.film import FRAMES_PER_SECOND, Film, NoFilmError
from reefgame.testing import play


def frames(path: Path) -> list[np.ndarray]:
    with av.open(str(path)) as container:
        assert container.streams.video[0].average_rate == FRAMES_PER_SECOND
        return [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]


def test_a_film_holds_every_frame_in_order(tmp_path: Path) -> None:
    film = Film(tmp_path / "a.mp4", 64, 48)
    for level in range(0, 250, 10):
        film.add(np.full((48, 64, 3), level, np.uint8))
    film.close()
    brightness = [float(frame.mean()) for frame in frames(tmp_path / "a.mp4")]
    assert len(brightness) == 25
    assert np.allclose(brightness, np.arange(0, 250, 10), atol=6)
    assert [path.name for path in tmp_path.iterdir()] == ["a.mp4"]


def test_a_film_given_up_leaves_nothing(tmp_path: Path) -> None:
    film = Film(tmp_path / "a.mp4", 64, 48)
    film.add(np.zeros((48, 64, 3), np.uint8))
    film.discard()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("size", [(63, 48), (64, 47)])
def test_odd_sizes_are_refused_before_anything_is_written(
    tmp_path: Path, size: tuple[int, int]
) -> None:
    with pytest.raises(NoFilmError, match="must be even"):
        Film(tmp_path / "a.mp4", *size)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_written_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(NoFilmError) as caught:
        Film(tmp_path / "file" / "a.mp4", 64, 48)
    assert "cannot be written" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_replay_becomes_a_film_and_a_picture(tmp_path: Path) -> None:
    replay, video, picture = (tmp_path / name for name in ("d.replay", "d.mp4", "d.png"))
    replay.write_text(play("visitors", tour, 1.0, seed=4).replay, encoding="ascii")
    status = main(
        [
            "replay",
            str(replay),
            "--video",
            str(video),
            "--picture",
            str(picture),
            "--size",
            "160x90",
        ]
    )
    assert status == 0
    shown = frames(video)
    assert len(shown) == FRAMES_PER_SECOND
    assert shown[0].shape == (90, 160, 3)
    assert shown[0].std() > 5, "a sea, not a bare colour"
    assert not np.array_equal(shown[0], shown[-1])
    assert picture.read_bytes().startswith(b"\x89PNG")
