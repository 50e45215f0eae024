"""A bare seabed, the game's own flora, and a garden grown of one plant."""

from collections.abc import Callable

import pytest

from components.flora import Flora, Growth, Plant
from components.ground import Terrain
from components.landscape import build_terrain
from reefgame.content import read_flora
from tools.grow.plants import grow

SPECIES = (
    "actinia",
    "anthopleura",
    "anthothoe",
    "stomphia",
    "magnificent_anemone",
    "seagrass",
    "kelp",
    "sea_fan",
    "soft_coral",
)


@pytest.fixture(scope="session")
def seabed() -> Terrain:
    """Flat sand 10 m down."""
    return build_terrain(12.0, 10.0, 0.0, 8.0, 1)


@pytest.fixture(scope="session")
def floras() -> dict[str, Flora]:
    """All flora of the base game by name."""
    return {name: read_flora(name) for name in SPECIES}


@pytest.fixture
def grown(seabed: Terrain, floras: dict[str, Flora]) -> Callable[..., Growth]:
    """Grow one plant in the middle: its species, scale, seed, and the normal that it stands on."""

    def grower(
        name: str,
        scale: float = 1.0,
        seed: int = 1,
        up: tuple[float, float, float] = (0.0, 0.0, 1.0),
        yaw: float = 0.0,
    ) -> Growth:
        plant = Plant(name, (0.0, 0.0, -10.0), up, yaw, scale, seed)
        return grow([plant], floras, seabed)

    return grower
