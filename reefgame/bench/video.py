"""bench video: how fast a fish is followed at 960x544, the paper's stages beside its Table 3 (papers/003)."""

from collections.abc import Callable, Iterator
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter
from typing import TYPE_CHECKING, Final

import assets
from components.repertoire_file import load
from components.segment import Pattern
from reefgame.bench.case import Case
from reefgame.bench.retargeting import measure_retargeting
from reefgame.content import read_species
from reefgame.content.anatomy import body_of

if TYPE_CHECKING:
    from tools.video.follow import Scene

_FRAMES: Final = 450
_RATE: Final = 30.0
_SPECIES: Final = "parrotfish"
_PAPER: Final = {"background": 12.48, "filter": 9.11, "features": 6.34}
"""[ms] a frame, Table 3: its background subtraction, filter and feature extraction at 960x544."""
_PAPER_RATE: Final = 1000.0 / 39.39
"""Frames a second of the paper's whole pipeline, carp, rendering included."""


def measure() -> Iterator[Case]:
    """Yield ms a frame of each stage alone, and frames a second of the whole: decoding twice to the motion's file."""
    with TemporaryDirectory() as folder:
        clip = Path(folder) / "swim.mp4"
        _film(clip)
        yield from _stages(clip)
        yield _pipeline(clip, Path(folder) / "swim.motion")
    yield from measure_retargeting()


def _film(path: Path) -> None:
    """Film a species of ours that swims round a tank, 960x544, with shadow, noise and beating fins."""
    from tools.video.synthetic import SyntheticClip
    from tools.video.writing import write_film

    root = Path(str(assets.__file__)).parent
    body = body_of(read_species(root / "species" / f"{_SPECIES}.yaml")[1])
    segments = load(root / "repertoires" / f"{_SPECIES}.npz").segments
    swim = next(s for s in segments if s.pattern == Pattern.SWIM_MEDIUM)
    write_film(path, SyntheticClip(body, swim).frames(_FRAMES), _RATE)


def _stages(path: Path) -> Iterator[Case]:
    from tools.video.background import model_of
    from tools.video.features import features_of
    from tools.video.follow import Choices, look
    from tools.video.mask import Segmenter
    from tools.video.reading import Clip

    scene = look(Clip(path), Choices(), lambda _: None)
    greys = [f.grey for f in islice(Clip(path).frames(), 90) if f.grey is not None]
    segmenter = Segmenter(scene.plate, scene.gate, model_of("median", scene.plate))
    segmenter.usual_area, segmenter.wary = scene.usual_area, scene.wary
    seen = [s for s in map(segmenter.find, greys) if s is not None]
    whole = (0, 0, scene.clip.working[0], scene.clip.working[1])
    differing = [segmenter.differing(grey, whole) for grey in greys]
    stages: dict[str, Callable[[], object]] = {
        "background": lambda: [segmenter.differing(grey, whole) for grey in greys],
        "filter": lambda: [segmenter.filtered(*found) for found in differing],
        "features": lambda: [features_of(s, None) for s in seen],
    }
    for part, stage in stages.items():
        seconds = _shortest(stage) / len(greys)
        paper = _PAPER[part]
        yield Case(_name(part), 1e3 * seconds, "ms", paper, paper / (1e3 * seconds))
    yield _decoding(scene)


def _decoding(scene: "Scene") -> Case:
    seconds = _shortest(lambda: sum(1 for _ in scene.clip.frames())) / scene.survey.count
    return Case(_name("decoding"), 1e3 * seconds, "ms")


def _pipeline(path: Path, motion: Path) -> Case:
    from tools.video.follow import follow
    from tools.video.motion_file import save

    seconds = _shortest(lambda: save(motion, follow(path).assembled.motion))
    rate = _FRAMES / seconds
    return Case(
        _name("pipeline"), rate, "frames/s", _PAPER_RATE, rate / _PAPER_RATE, bound="value >= 150"
    )


def _name(part: str) -> str:
    return f"size=960x544 part={part}"


def _shortest(stage: Callable[[], object], rounds: int = 3) -> float:
    """Return the shortest of a few runs [s]: what else the machine does can only lengthen one."""
    times = []
    for _ in range(rounds):
        start = perf_counter()
        stage()
        times.append(perf_counter() - start)
    return min(times)
