"""The first pass over a clip: how long it is, where it is cut, and samples of it for the background (FINDINGS 4)."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from tools.video.images import ClipError, Grey
from tools.video.reading import Clip

SAMPLES: Final = 25
"""Frames that the background is the median of."""
MOST_FRAMES: Final = 100_000
"""Frames beyond which a clip is not read: half an hour at 60 a second."""
_CUT: Final = 24.0
"""Mean change [grey levels] between two frames from which the film is cut there."""
_GRID: Final = 24

Report = Callable[[float], None]


@dataclass(frozen=True)
class Survey:
    """What the first pass found."""

    count: int
    "frames that are there"
    seconds: Float64s
    "when each is shown [s], nan where unknown, (count,)"
    first: int
    "first frame of the longest shot"
    stop: int
    "frame after its last"
    cuts: tuple[int, ...]
    "frames with which another shot begins"
    samples: NDArray[np.uint8]
    "frames of the longest shot at even steps, (n, height, width)"

    @property
    def rate(self) -> float:
        """Frames a second by the frames' own times, 0 where they do not say."""
        steps = np.diff(self.seconds)
        steps = steps[np.isfinite(steps) & (steps > 0.0)]
        if not len(steps):
            return 0.0
        # Containers round times to a thousandth of a second: the mean of the steps that are one frame's.
        usual = np.median(steps)
        return float(1.0 / steps[np.abs(steps - usual) < 0.25 * usual].mean())


@dataclass
class _Sampler:
    """Keeps frames at even steps, between SAMPLES and twice as many, of a shot whose length is not known yet."""

    first: int
    step: int = 1
    count: int = 0
    kept: list[Grey] = field(default_factory=list)

    def add(self, grey: Grey | None) -> None:
        if grey is not None and self.count % self.step == 0:
            self.kept.append(grey)
            if len(self.kept) >= 2 * SAMPLES:
                self.kept = self.kept[::2]
                self.step *= 2
        self.count += 1

    def samples(self) -> NDArray[np.uint8]:
        chosen = np.linspace(0, len(self.kept) - 1, min(SAMPLES, len(self.kept))).round()
        return np.stack([self.kept[int(i)] for i in chosen])


def survey(clip: Clip, report: Report) -> Survey:
    """Read the whole clip once. Raise ClipError where it holds fewer than two different frames."""
    shots, seconds, before = [_Sampler(0)], [], None
    moved = False
    for frame in clip.frames():
        if frame.number >= MOST_FRAMES:
            break
        seconds.append(frame.seconds)
        if frame.grey is not None:
            small = _small(frame.grey)
            change = 0.0 if before is None else float(np.abs(small - before).mean())
            moved = moved or change > 0.0
            if change > _CUT:
                shots.append(_Sampler(frame.number))
                _drop_shorter(shots)
            before = small
        shots[-1].add(frame.grey)
        report(frame.number / max(clip.expected, frame.number + 1))
    if len(seconds) < 2 or not moved:
        raise ClipError(f"{clip.path}: this is a still picture; nothing moves in it")
    longest = max(shots, key=lambda shot: shot.count)
    return Survey(
        count=len(seconds),
        seconds=np.array(seconds),
        first=longest.first,
        stop=longest.first + longest.count,
        cuts=tuple(shot.first for shot in shots[1:]),
        samples=longest.samples(),
    )


def _small(grey: Grey) -> NDArray[np.int16]:
    height, width = grey.shape
    rows, columns = max(1, height // _GRID), max(1, width // _GRID)
    return grey[rows // 2 :: rows, columns // 2 :: columns].astype(np.int16)


def _drop_shorter(shots: list[_Sampler]) -> None:
    """Let go the samples of every ended shot but the longest."""
    longest = max(shots[:-1], key=lambda shot: shot.count)
    for shot in shots[:-1]:
        if shot is not longest:
            shot.kept.clear()
