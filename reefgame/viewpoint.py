"""Where a picture of a world is best taken from: side-on to its school, over the ground, clear of rocks."""

from collections.abc import Iterator
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from components.camera import Camera, camera_towards
from components.terrain import clearance, ground, sees
from reefgame.filming import COCKPIT_SLOPE, cockpit
from reefgame.world import World

_FAR: Final = (2.5, 3.0, 3.6)
"""[m] distances tried from the middle of a school that is one metre wide."""
_SIDES: Final = 32
_FREE: Final = 0.45
"""[m] of water that an eye needs around it."""
_OVER_GROUND: Final = 0.65
"""[m] least height of the eye."""
_HIGH: Final = 0.38
"""Where the school stands in the picture: 0 in the middle, 1 at the upper border."""
_ASPECT: Final = 1.6


def viewpoint(world: World) -> Camera:
    """Return the camera from which the largest group of fishes, others and rocks make the best picture.

    The submarine's own where there is no fish or no free place near them.
    """
    fish = world.population.fish
    if not fish.count:
        return cockpit(world)
    species = fish.live("species")
    group = species == np.bincount(species).argmax()
    views = [camera for camera in _candidates(world, group) if _free(world, camera)]
    return max(views, key=lambda camera: _worth(world, camera, group), default=cockpit(world))


def _candidates(world: World, group: NDArray[np.bool_]) -> Iterator[Camera]:
    """Yield cameras all round the group, a little lower than it, that hold it in their upper half."""
    terrain, fish = world.terrain, world.population.fish
    place = fish.position[: fish.count][group]
    middle = np.median(place, axis=0)
    wide = float(np.clip(2.0 * np.median(np.abs(place - middle), axis=0).max(), 0.8, 2.5))
    for angle in np.arange(_SIDES) * (2.0 * np.pi / _SIDES):
        for metres in _FAR:
            far = metres * wide**0.6
            away = np.array([np.cos(angle), np.sin(angle), -0.30]) * far
            eye = middle + away
            floor = ground(terrain.height, terrain.extent, terrain.cell, eye[0], eye[1])[0]
            eye[2] = min(max(eye[2], floor + _OVER_GROUND), -0.6)
            down = np.array([0.0, 0.0, _HIGH * COCKPIT_SLOPE * far])
            yield camera_towards(eye, middle - down, COCKPIT_SLOPE)


def _free(world: World, camera: Camera) -> bool:
    x, y, z = camera.eye
    ahead = camera.eye + 2.0 * camera.forward
    return bool(
        clearance(world.terrain, x, y, z)[0] > _FREE and sees(world.terrain, camera.eye, ahead)
    )


def _worth(world: World, camera: Camera, group: NDArray[np.bool_]) -> float:
    """Return how good a picture `camera` takes: fishes from the side, others close, rocks in the corners."""
    fish = world.population.fish
    place, heading = fish.position[: fish.count], fish.rotation[: fish.count, :, 0]
    across, height, ahead = _seen(camera, place)
    inside = (ahead > 0.0) & (np.abs(across) < 0.95) & (np.abs(height) < 0.95)
    side_on = np.abs(heading @ camera.right)
    readable = inside & ~group & (ahead > 0.9) & (ahead < 2.8)
    crowding = ((ahead < 1.0) & (ahead > -0.3) & (np.abs(across) < 1.5)).sum()
    hidden = sum(not sees(world.terrain, camera.eye, at) for at in place[group][::6])
    clear = float((inside & group).sum() / group.sum())
    others = float((side_on[readable] > 0.5).sum())
    school = 2.0 * float(side_on[group].mean()) + 3.0 * clear - 0.3 * hidden
    return school + 0.6 * min(others, 5.0) - 0.4 * float(crowding) + _corners(world, camera)


def _corners(world: World, camera: Camera) -> float:
    """Return up to 1 for rocks close by, low in the picture and aside, fewer points for one in the middle."""
    centre = world.terrain.rock_centre
    across, height, ahead = _seen(camera, centre)
    near = (ahead > 0.8) & (ahead < 4.0) & (height < -0.2) & (height > -1.7)
    left = (near & (across < -0.35) & (across > -1.1)).any()
    right = (near & (across > 0.35) & (across < 1.1)).any()
    middle = (near & (np.abs(across) < 0.3) & (ahead < 2.5)).any()
    return 0.5 * float(left) + 0.5 * float(right) - 0.4 * float(middle)


def _seen(camera: Camera, place: Float64s) -> tuple[Float64s, Float64s, Float64s]:
    """Return where places [m], (n, 3), are in the picture, -1 to 1 across and up, and how far ahead [m]."""
    away = place - camera.eye
    ahead = away @ camera.forward
    scale = camera.slope * np.maximum(ahead, 1e-3)
    return away @ camera.right / (scale * _ASPECT), away @ camera.up / scale, ahead
