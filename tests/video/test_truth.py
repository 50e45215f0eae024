"""Against rendered swims whose axis is known (issue 6, Numbers): where it lies, where the head is, how it beats."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from components.segment import Pattern
from tools.video.contour import evenly
from tools.video.follow import Followed, follow
from tools.video.synthetic import Setting, SyntheticClip
from tools.video.writing import even, write_film

FRAMES = 60
NINE = (
    "sardine", "anthias", "clownfish", "blue_tang", "butterflyfish", "angelfish", "parrotfish",
    "barracuda", "reef_shark",
)  # fmt: skip


def _followed(clip: SyntheticClip, path: Path, count: int) -> Followed:
    write_film(path, (even(frame) for frame in clip.frames(count)), 60.0)
    return follow(path)


def _errors(followed: Followed, clip: SyntheticClip) -> tuple[float, float]:
    """Return the mean errors at equal arc length and sideways, in per cent of the body's length."""
    motion, length = followed.assembled.motion, clip.setting.body_length
    equal, aside = [], []
    for k, axis in enumerate(motion.axis.astype(np.float64)):
        truth = clip.truth(motion.first + k)
        equal.append(np.hypot(*(axis - evenly(truth, len(axis))).T).mean())
        fine = evenly(truth, 1001)
        aside.append(np.sqrt(((axis[:, None] - fine) ** 2).sum(axis=2).min(axis=1)).mean())
    return float(100.0 * np.mean(equal) / length), float(100.0 * np.mean(aside) / length)


def _heads_right(followed: Followed, clip: SyntheticClip) -> bool:
    motion = followed.assembled.motion
    truth = np.stack([clip.truth(motion.first + k)[[0, -1]] for k in range(motion.count)])
    away = np.hypot(*(motion.axis[:, :1] - truth).transpose(2, 0, 1))
    return bool((away[:, 0] < away[:, 1]).all())


def _check(followed: Followed, clip: SyntheticClip) -> None:
    assembled = followed.assembled
    assert (assembled.fault == 0).mean() >= 0.99
    equal, aside = _errors(followed, clip)
    assert equal <= 0.6
    assert aside <= 0.15
    assert _heads_right(followed, clip)
    assert assembled.beat.period == pytest.approx(len(clip.segment.shape), rel=0.01)


@pytest.mark.parametrize(("name", "travels"), [("sardine", True), ("parrotfish", False)])
def test_the_axis_of_a_rendered_swim_lies_where_it_is(
    swim: Callable[..., SyntheticClip], tmp_path: Path, name: str, travels: bool
) -> None:
    clip = swim(name, Setting(travels=travels))
    _check(_followed(clip, tmp_path / "swim.mp4", FRAMES), clip)


@pytest.mark.prove
@pytest.mark.parametrize("name", NINE)
@pytest.mark.parametrize("travels", [True, False])
@pytest.mark.parametrize("pattern", [Pattern.SWIM_SLOW, Pattern.SWIM_MEDIUM])
def test_the_axes_of_nine_species_lie_where_they_are(
    swim: Callable[..., SyntheticClip], tmp_path: Path, name: str, travels: bool, pattern: Pattern
) -> None:
    clip = swim(name, Setting(travels=travels), pattern)
    _check(_followed(clip, tmp_path / "swim.mp4", 150), clip)


@pytest.mark.prove
@pytest.mark.parametrize("background", ["median", "vibe"])
def test_every_model_that_keeps_a_standing_fish_keeps_its_axis(
    swim: Callable[..., SyntheticClip], tmp_path: Path, background: str
) -> None:
    from tools.video.follow import Choices

    clip = swim("blue_tang", Setting(travels=False))
    path = tmp_path / "swim.mp4"
    write_film(path, (even(frame) for frame in clip.frames(60)), 60.0)
    _check(follow(path, Choices(background=background)), clip)
