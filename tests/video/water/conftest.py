"""Filmed fishes with known truth: our own species' captured swims, without pictures."""

from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import assets
from components.body import Body
from components.repertoire import Repertoire, load
from components.segment import Pattern, Segment
from reefgame.content import read_species
from reefgame.content.anatomy import body_of
from tools.video.motion import Motion
from tools.video.water.film import Film
from tools.video.water.truth import filmed

ASSETS = Path(str(assets.__file__)).parent

FilmOf = Callable[..., Film]


@cache
def _body(name: str) -> Body:
    return body_of(read_species(ASSETS / "species" / f"{name}.yaml")[1])


@cache
def _repertoire(name: str) -> Repertoire:
    return load(ASSETS / "repertoires" / f"{name}.npz")


@pytest.fixture(scope="session")
def body() -> Callable[[str], Body]:
    """The body of a shipped species."""
    return _body


@pytest.fixture(scope="session")
def repertoire() -> Callable[[str], Repertoire]:
    """The repertoire of a shipped species."""
    return _repertoire


@pytest.fixture(scope="session")
def segments() -> Callable[[str], dict[Pattern, Segment]]:
    """The segments of a shipped species."""
    return lambda name: {segment.pattern: segment for segment in _repertoire(name).segments}


@pytest.fixture(scope="session")
def film(segments: Callable[[str], dict[Pattern, Segment]]) -> FilmOf:
    """A film of a shipped species that cruises; further arguments are those of `filmed`."""

    def make(name: str = "sardine", **how: float) -> Film:
        return filmed(_body(name), segments(name)[Pattern.SWIM_MEDIUM], **how)  # type: ignore[arg-type]

    return make


@pytest.fixture(scope="session")
def motion() -> Callable[[Film], Motion]:
    """A film as the motion of a clip; what the water does not read is nought."""

    def make(film: Film) -> Motion:
        n = len(film.axis)
        plain, two = np.zeros(n), np.zeros((n, 2))
        return Motion(
            rate=film.rate, first=0, size=(960, 544), centre=two, direction=plain, head_angle=plain,
            tail_angle=plain, up_angle=np.zeros((n, 3)), low_angle=np.zeros((n, 15)), fin_angle=two,
            head_length=plain, tail_length=plain, up_length=np.zeros((n, 3)), low_length=np.zeros((n, 15)),
            fin_length=two, junction=np.zeros((n, 4, 2)), folded=np.ones((n, 2), bool),
            axis=film.axis.astype(np.float32), half_width=film.half_width.astype(np.float32),
            confidence=film.good.astype(np.float64), fault=(~film.good).astype(np.int8), provenance={},
        )  # fmt: skip

    return make
