"""Golden frames of papers/002's figures, from the scenes of tests/scenes/sea and the level that is a seascape."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from reefgame.content import load
from reefgame.picture import picture
from reefgame.testing import read_scene
from reefgame.testing.photograph import photograph
from reefgame.viewpoint import viewpoint
from reefgame.world import World
from systems.view.target import UInt8s

WIDTH, HEIGHT = 320, 180
SameFrame = Callable[[str, UInt8s], bool]
FIGURES = {
    "attract": "Figs. 1 and 16",
    "repel": "Fig. 1",
    "source": "Fig. 12",
    "hole": "Fig. 12",
    "whirlwind": "Fig. 12",
    "current": "Fig. 3",
    "key_frames": "Fig. 15",
    "school_passes": "Fig. 13",
    "other_plants": "Fig. 18",
}
MOVED = 24
"""Of 255, in any channel: more than dithering, less than a tentacle elsewhere."""


@pytest.mark.golden
@pytest.mark.parametrize("name", FIGURES)
def test_a_figure_of_the_paper_looks_as_it_did(
    name: str, checkout: Path, same_frame: SameFrame
) -> None:
    """And its control does not: what the figure shows is in the picture."""
    scene = read_scene(checkout / "tests" / "scenes" / "sea" / f"{name}.yaml")
    assert FIGURES[name].rpartition(" ")[2] in scene.file.why
    assert scene.control is not None
    drawn = photograph(scene, WIDTH, HEIGHT, "low")
    still = photograph(scene.control, WIDTH, HEIGHT, "low")
    away = np.abs(drawn.astype(np.int16) - still).max(axis=2)
    assert (away > MOVED).mean() > 0.01
    assert same_frame(f"sea_{name}", drawn)


@pytest.mark.golden
def test_the_anemone_garden_is_a_seascape(same_frame: SameFrame) -> None:
    """papers/002, Fig. 17: various anemones, fishes and seagrass in one picture."""
    world = World.build(load("anemone_garden"), 1)
    assert len({plant.flora for plant in world.plants}) >= 9
    assert len({*world.population.fish.live("species").tolist()}) >= 6
    for _ in range(60):
        world.tick()
    drawn = picture(world, viewpoint(world), WIDTH, HEIGHT, 1.0, "low")
    assert same_frame("sea_scape", drawn)
