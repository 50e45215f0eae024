"""A plant alone on sand, as docs/sea.md shows each flora: `reefgame shot --flora NAME`."""

from typing import Final

import numpy as np

from components.camera import camera_towards
from components.flora import Flora
from components.species import Species
from reefgame.bed import growth_of
from reefgame.content import Content
from reefgame.content.schema.level import Level
from reefgame.picture import picture
from reefgame.world import World
from systems.view.target import UInt8s

_SLOPE: Final = 0.41
_ABOVE: Final = 0.42
_MARGIN: Final = 0.95
_ACROSS: Final = 112.0
"""[deg] at which a fan faces the eye."""
_TALL: Final = 1.5
"""[m] half the height of what is seen from the side."""


def plant_portrait(
    flora: Flora, company: Species, width: int, height: int, seconds: float = 0.0
) -> UInt8s:
    """Return a plant of scale 1 in a slow current, (height, width, 3); no fish of `company` is seen."""
    world = World.build(Content(_level(flora, company), (company,), "", (), {flora.name: flora}))
    points = np.concatenate([tuft.points.reshape(-1, 3) for tuft in growth_of(world).tufts])
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    wide = float(np.hypot(half[0], half[1])) * height / width
    away = _MARGIN * max(wide, float(half[2])) / _SLOPE + float(max(half[0], half[1]))
    # Tall plants are seen from the side, low ones from above.
    above = _ABOVE if half[2] < _TALL else 0.0
    eye = middle + away * np.array([-0.92, -0.38, above])
    return picture(world, camera_towards(eye, middle, _SLOPE), width, height, seconds)


def _level(flora: Flora, company: Species) -> Level:
    """Return a bare sea bed with one plant in its middle."""
    return Level.model_validate(
        {
            "name": "portrait",
            "title": flora.title,
            "world": {"radius_m": 30.0, "depth_m": 11.0},
            "seabed": {"relief_m": 0.4},
            "flow": ({"kind": "current", "speed_m_per_s": 0.12, "axis": (0.4, -1.0, 0.0)},),
            "plants": ({"flora": flora.name, "at_m": (0.0, 0.0), "yaw_deg": _ACROSS},),
            "submarine": {"at_m": (-20.0, 0.0, -5.0)},
            "objective": {
                "photograph": {"species": company.name, "count": 1, "within_m": 5.0},
            },
        }
    )
