"""The world's ground and bounds, as every system imports them (papers/000, 6.2).

The data and its tests stand in ground.py, the hard guarantee in confinement.py, rocks in rocks.py; how a level's
ground is made in landscape.py.
"""

from components.confinement import MARGIN, berth, confine
from components.ground import (
    Terrain,
    clearance,
    ground,
    ground_height,
    ground_normal,
    is_clear,
    rock_clearance,
    rock_distance,
    rock_square,
)
from components.landscape import build_terrain, rock_on_ground
from components.rocks import ROCK_REACH, Rock
from components.sightline import in_sight, sees

__all__ = [
    "MARGIN",
    "ROCK_REACH",
    "Rock",
    "Terrain",
    "berth",
    "build_terrain",
    "clearance",
    "confine",
    "ground",
    "ground_height",
    "ground_normal",
    "in_sight",
    "is_clear",
    "rock_clearance",
    "rock_distance",
    "rock_on_ground",
    "rock_square",
    "sees",
]
