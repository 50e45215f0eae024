"""Tests for modders and researchers: dives by scripted pilots, and scenes in which behaviour is measured.

    from reefgame.autopilot import Photographer
    from reefgame.testing import play

    def test_first_dive_can_be_won():
        dive = play("first_dive", Photographer(), seconds=120)
        assert dive.won

A scene is a YAML file of some fifteen lines (tests/scenes has fifteen, and nine of plants): who is in what water, in
what mood, for how long, and what is measured and expected.

    from reefgame.testing import read_scene, watch

    def test_sardines_eat():
        scene = read_scene(Path("scenes/sardines_eat.yaml"))
        assert all(watch(scene, seed).passed for seed in range(3))
"""

from reefgame.testing.dive import Dive, play
from reefgame.testing.fibre_measures import FIBRE_MEASURES
from reefgame.testing.measures import MEASURES
from reefgame.testing.observation import Observation
from reefgame.testing.scene import Scene, read_scene
from reefgame.testing.swaying import Sway, sway
from reefgame.testing.watching import Outcome, observe, watch

__all__ = [
    "FIBRE_MEASURES",
    "MEASURES",
    "Dive",
    "Observation",
    "Outcome",
    "Scene",
    "Sway",
    "observe",
    "play",
    "read_scene",
    "sway",
    "watch",
]
