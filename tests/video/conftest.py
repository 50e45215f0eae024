"""Clips for the video tools: our own species filmed with known truth, and the two clips of living fishes."""

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import assets
from components.repertoire import load
from components.segment import Pattern
from reefgame.content import read_species
from reefgame.content.anatomy import body_of
from tools.video.images import Grey
from tools.video.synthetic import Setting, SyntheticClip
from tools.video.writing import LOSSLESS, write_film

ASSETS = Path(str(assets.__file__)).parent
SMALL = Setting(width=320, height=240, body_length=150.0, travels=False)

Swim = Callable[..., SyntheticClip]
Film = Callable[..., Path]


@pytest.fixture(scope="session")
def swim() -> Swim:
    """Make a clip in memory of a species that swims."""

    def make(
        name: str, setting: Setting = SMALL, pattern: Pattern = Pattern.SWIM_MEDIUM
    ) -> SyntheticClip:
        body = body_of(read_species(ASSETS / "species" / f"{name}.yaml")[1])
        segments = load(ASSETS / "repertoires" / f"{name}.npz").segments
        return SyntheticClip(body, next(s for s in segments if s.pattern == pattern), setting)

    return make


@pytest.fixture(scope="session")
def frames(swim: Swim) -> list[Grey]:
    """Forty-five small frames of a sardine that holds station: three beats."""
    return list(swim("sardine").frames(45))


@pytest.fixture
def film(tmp_path: Path) -> Film:
    """Write frames to a lossless film; return its path."""

    def make(pictures: list[Grey], name: str = "fish.mkv", rate: float = 30.0) -> Path:
        path = tmp_path / name
        write_film(path, pictures, rate, LOSSLESS)
        return path

    return make


@pytest.fixture(scope="session")
def fish_film(frames: list[Grey], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The sardine's frames as a lossless film."""
    path = tmp_path_factory.mktemp("film") / "sardine.mkv"
    write_film(path, frames, 60.0, LOSSLESS)
    return path


@pytest.fixture(scope="session")
def living(checkout: Path) -> Callable[[str], Path]:
    """Give the clip of a living fish: in REEFGAME_CLIPS, or beside the checkout in shared/clips."""
    folder = Path(os.environ.get("REEFGAME_CLIPS", checkout.parent / "shared" / "clips"))

    def find(name: str) -> Path:
        path = folder / name
        if not path.is_file():
            pytest.skip(f"{name} is not here: set REEFGAME_CLIPS to the folder that holds it")
        return path

    return find


@pytest.fixture(scope="session")
def body_mask() -> Callable[..., Grey]:
    """Draw a fish-like mask: half-widths along an arc of so many degrees, head to the left."""

    def draw(length: float = 200.0, degrees: float = 0.0, size: int = 300) -> Grey:
        y, x = np.mgrid[0:size, 0:size].astype(np.float64)
        s = np.linspace(0.0, 1.0, 800)
        line = _arc(s, length, np.radians(degrees)) + size / 2
        half = length * np.maximum(0.16 * np.sqrt(s) * (1.0 - s) ** 0.8, 0.012)
        mask = np.zeros((size, size), np.bool_)
        for place, reach in zip(line, half, strict=True):
            mask |= (x - place[0]) ** 2 + (y - place[1]) ** 2 <= reach**2
        return mask * np.uint8(255)

    return draw


def _arc(s: np.ndarray, length: float, turn: float) -> np.ndarray:
    """Return places of an arc of this length about the origin, head to the left, (n, 2)."""
    if turn == 0.0:
        return np.stack((length * (s - 0.5), np.zeros_like(s)), axis=-1)
    angle = turn * (s - 0.5)
    radius = length / turn
    return np.stack((radius * np.sin(angle), radius * (1.0 - np.cos(angle))), axis=-1)
