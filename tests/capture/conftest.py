"""The species that are shipped: their bodies and swims as their YAML says, and their files."""

from pathlib import Path

import pytest

import assets
from components.body import Body, Swim
from components.repertoire import Repertoire, load
from reefgame.content import read_species
from reefgame.content.anatomy import body_of, swim_of

ASSETS = Path(str(assets.__file__)).parent


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
