"""The species that are shipped: their bodies and swims as their YAML says, and their files."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import assets
from components.arrays import Float64s
from components.body import Body, Swim
from components.repertoire import Repertoire, Segment, load
from reefgame.content import read_species
from reefgame.content.anatomy import body_of, swim_of

ASSETS = Path(str(assets.__file__)).parent

Play = Callable[[Segment, int], tuple[Float64s, Float64s, Float64s]]


@pytest.fixture(params=["blue_tang", "sardine"])
def name(request: pytest.FixtureRequest) -> str:
    """Two species in turn; a test may name others."""
    return str(request.param)


@pytest.fixture
def body(name: str) -> Body:
    return body_of(read_species(ASSETS / "species" / f"{name}.yaml")[1])


@pytest.fixture
def swim(name: str) -> Swim:
    return swim_of(read_species(ASSETS / "species" / f"{name}.yaml")[1])


@pytest.fixture
def shipped_file(name: str) -> Path:
    return ASSETS / "repertoires" / f"{name}.npz"


@pytest.fixture
def shipped(shipped_file: Path) -> Repertoire:
    return load(shipped_file)


def _played(segment: Segment, cycles: int) -> tuple[Float64s, Float64s, Float64s]:
    origin, rotation = np.zeros(3), np.eye(3)
    origins, rotations, nodes = [origin], [rotation], []
    for _ in range(cycles):
        for m, t, d in zip(segment.rotation, segment.translation, segment.shape, strict=True):
            origin = origin + rotation @ t
            rotation = rotation @ m
            origins.append(origin)
            rotations.append(rotation)
            nodes.append(origin + d @ rotation.T)
    return np.array(origins), np.array(rotations), np.array(nodes)


@pytest.fixture
def played() -> Play:
    """How a segment looks when it is played: o, R and world nodes at each frame, from R = 1 at the origin."""
    return _played
