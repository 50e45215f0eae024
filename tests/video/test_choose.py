"""Choosing a fish by a click, without a window: what is offered, what a click means, and what follows from it."""

from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from reefgame.cli import main
from reefgame.screens.choose_stage import ChooseStage
from tools.video.candidates import FirstSight, first_sight
from tools.video.follow import Choices, Scene, follow, look
from tools.video.images import Grey
from tools.video.reading import Clip

WINDOW = (700, 600)


@pytest.fixture
def two_fishes(film: Callable[..., Path], frames: list[Grey]) -> Path:
    """A film of two fishes, the lower one half as large."""
    both = []
    for frame in frames:
        up, down = (
            cv2.warpAffine(frame, np.array(matrix), (320, 240), borderValue=(255.0,))
            for matrix in (
                [[1.0, 0.0, 0.0], [0.0, 1.0, -60.0]],
                [[0.7, 0.0, 48.0], [0.0, 0.7, 96.0]],
            )
        )
        both.append(np.minimum(up, down))
    return film(both)


@pytest.fixture
def sight(two_fishes: Path) -> FirstSight:
    """What is offered of it."""
    found = first_sight(look(Clip(two_fishes), Choices(), lambda _: None))
    assert found is not None
    return found


def test_both_fishes_are_offered_the_larger_first(sight: FirstSight) -> None:
    assert sight.number == 0
    assert sight.picture.shape == (240, 320, 3)
    upper, lower = (outline.mean(axis=0) for outline in sight.outlines)
    assert upper[1] < 120.0 < lower[1]


def test_a_click_on_an_outline_is_a_place_in_the_clip(sight: FirstSight) -> None:
    stage = ChooseStage(sight)
    for number in range(stage.count):
        x, y = stage.outline(number, *WINDOW).mean(axis=0)
        stage.point(x, y, *WINDOW)
        assert stage.hovered == number
        assert stage.click(x, y, *WINDOW)
        assert stage.chosen == pytest.approx(sight.outlines[number].mean(axis=0), abs=1.0)


@pytest.mark.parametrize("place", [(2.0, 2.0), (350.0, 595.0), (350.0, 300.0)])
def test_a_click_beside_every_fish_chooses_nothing(
    sight: FirstSight, place: tuple[float, float]
) -> None:
    stage = ChooseStage(sight)
    assert not stage.click(*place, *WINDOW)
    assert stage.chosen is None


def test_places_in_a_clip_that_is_worked_on_smaller_are_the_clips(sight: FirstSight) -> None:
    half = FirstSight(sight.number, sight.picture, sight.outlines, 0.5)
    assert half.as_shown((100.0, 30.0)) == (200.0, 60.0)


def test_what_is_chosen_after_the_first_pass_is_followed_as_if_it_were_selected(
    two_fishes: Path, sight: FirstSight
) -> None:
    asked: list[Scene] = []

    def choose(scene: Scene) -> tuple[float, float] | None:
        asked.append(scene)
        return sight.as_shown(tuple(sight.outlines[1].mean(axis=0)))

    chosen = follow(two_fishes, choose=choose).assembled.motion
    place = tuple(float(v) for v in sight.outlines[1].mean(axis=0))
    selected = follow(two_fishes, Choices(select=(place[0], place[1]))).assembled.motion
    assert len(asked) == 1
    np.testing.assert_array_equal(chosen.axis, selected.axis)
    assert chosen.centre[:, 1].min() > 120.0


def test_who_does_not_choose_gets_the_largest(two_fishes: Path) -> None:
    motion = follow(two_fishes, choose=lambda _: None).assembled.motion
    assert motion.centre[:, 1].max() < 120.0


def test_choosing_goes_with_a_clip_alone(
    fish_film: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        main(["video", str(fish_film), "--choose", "--select", "3,4"])
    capsys.readouterr()
    motion = tmp_path / "swim.motion"
    assert main(["video", str(motion), "--choose", "--species", "mine"]) == 1
    assert "need a clip" in capsys.readouterr().err
