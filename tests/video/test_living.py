"""Clips of living fishes: every frame is good by FINDINGS 4's definition (issue 6, Numbers)."""

from collections.abc import Callable
from pathlib import Path

import pytest

from tools.video.follow import Choices, follow


@pytest.mark.parametrize(("name", "frames"), [("trout.avi", 57), ("sunfish_BCF_red.avi", 11)])
def test_every_frame_of_a_living_fish_is_good(
    living: Callable[[str], Path], name: str, frames: int
) -> None:
    followed = follow(living(name))
    assert len(followed.assembled.fault) == frames
    assert not followed.assembled.fault.any()
    assert followed.notes == ()


def test_the_trouts_head_points_left_and_its_tail_beats_twice(
    living: Callable[[str], Path],
) -> None:
    followed = follow(living("trout.avi"), Choices(rate=250.0))
    motion, beat = followed.assembled.motion, followed.assembled.beat
    assert (motion.axis[:, 0, 0] < motion.axis[:, -1, 0]).all()
    assert motion.rate == 250.0
    assert beat.beats == pytest.approx(2.16, abs=0.1)
    assert beat.certainty > 0.95


def test_the_rate_follows_from_how_often_the_tail_beats(living: Callable[[str], Path]) -> None:
    followed = follow(living("trout.avi"), Choices(beats=8.0))
    assert followed.assembled.motion.rate / followed.assembled.beat.period == pytest.approx(8.0)
