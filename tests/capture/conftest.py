"""The two species that are shipped, in the numbers of FINDINGS 1b, and their files."""

from pathlib import Path

import pytest

import assets
from components.body import Body, Swim
from components.repertoire import Repertoire, load

SPECIES = {
    "sardine": (
        Body(
            station=(0.11, 0.28, 0.47, 0.66, 0.82),
            half_width=(0.036, 0.050, 0.047, 0.032, 0.013),
            half_height=(0.060, 0.088, 0.085, 0.058, 0.026),
            tail_span=0.105,
        ),
        Swim(0.341, 0.554, 152.8, 4.0),
    ),
    "blue_tang": (
        Body(
            station=(0.11, 0.27, 0.46, 0.65, 0.80),
            half_width=(0.040, 0.058, 0.054, 0.036, 0.016),
            half_height=(0.120, 0.180, 0.185, 0.125, 0.042),
            tail_span=0.140,
        ),
        Swim(0.286, 0.423, 142.7, 3.0),
    ),
}


@pytest.fixture(params=sorted(SPECIES))
def name(request: pytest.FixtureRequest) -> str:
    """Each shipped species in turn."""
    return str(request.param)


@pytest.fixture
def body(name: str) -> Body:
    return SPECIES[name][0]


@pytest.fixture
def swim(name: str) -> Swim:
    return SPECIES[name][1]


@pytest.fixture
def shipped_file(name: str) -> Path:
    return Path(str(assets.__file__)).parent / "repertoires" / f"{name}.npz"


@pytest.fixture
def shipped(shipped_file: Path) -> Repertoire:
    return load(shipped_file)
