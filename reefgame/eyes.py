"""Through whose eyes the player looks: the submarine's, or those of the fish that the player is (papers/000, 8.2)."""

from dataclasses import replace
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.camera import Camera, camera_towards
from components.terrain import confine
from reefgame.world import World
from systems.play.judge import viewfinder

FISH_SLOPE: Final = 0.85
"""Least tangent of half the vertical field of view of a fish: it sees nearly all around, a window shows what it can."""
_SIGHTS: Final = 2.5
"""Sights at which the sea fades for a fish: it sees fishes of its size at one, rocks much farther."""
_BEFORE_NOSE: Final = 0.10
"""[BL] of the eye before the nose: the snout does not hide the sea."""
_BEHIND: Final = (1.5, 0.14)
"""[BL] and [m] of the eye behind a fish that the player watches."""
_ABOVE: Final = (0.42, 0.03)
_AHEAD: Final = 1.2
"""[BL] before the fish at which that eye looks."""
_CHASE_SLOPE: Final = 0.48
_BERTH: Final = 0.1


def eyes(world: World, alpha: float, slope: float) -> Camera:
    """Return the player's camera, `alpha` of the way from the last tick to this; `slope` is the cockpit's lens."""
    avatar = world.avatar
    identity = int(avatar.fish[0])
    if identity < 0 or identity not in world.population:
        return replace(viewfinder(world.submarine, alpha), slope=slope)
    row, fish = world.population.row(identity), world.population.fish
    place = fish.last_position[row] + alpha * (fish.position[row] - fish.last_position[row])
    gaze = avatar.last_gaze[0] + alpha * (avatar.gaze[0] - avatar.last_gaze[0])
    length = float(fish.length[row])
    if avatar.behind[0]:
        eye = place - gaze * (_BEHIND[0] * length + _BEHIND[1])
        eye[2] += _ABOVE[0] * length + _ABOVE[1]
        return camera_towards(
            _free(world, eye), place + _AHEAD * length * gaze, min(slope, _CHASE_SLOPE)
        )
    nose = float(world.senses.nose[fish.species[row]])
    eye = place + (nose + _BEFORE_NOSE) * length * gaze
    sight = _SIGHTS * float(world.senses.sight[fish.species[row]])
    return replace(camera_towards(eye, eye + gaze, max(slope, FISH_SLOPE)), sight=sight)


def _free(world: World, eye: Float64s) -> Float64s:
    """Return the nearest place [m] that is out of ground, rocks and air."""
    places = np.array([eye])
    confine(world.terrain, places, 0, _BERTH)
    return np.asarray(places[0], np.float64)
