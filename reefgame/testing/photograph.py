"""The picture of a scene, as its file's `picture` says: golden frames and docs show it."""

import numpy as np

from components.camera import camera_towards
from components.clock import TICKS_PER_SECOND
from reefgame.filming import COCKPIT_SLOPE
from reefgame.picture import picture
from reefgame.testing.scene import Scene
from reefgame.testing.stage import Director, stage
from systems.view.target import UInt8s


def photograph(
    scene: Scene, width: int, height: int, quality: str = "high", seed: int = 0
) -> UInt8s:
    """Return what is seen of a scene, (height, width, 3), its fibres settled by numba.

    Raise ValueError where the scene's file has no `picture`.
    """
    view = scene.file.picture
    if view is None:
        raise ValueError(f"the scene {scene.name} has no `picture`")
    world, direct = stage(scene, seed), Director(scene)
    for _ in range(round(view.at_s * TICKS_PER_SECOND)):
        direct(world)
        world.tick()
    camera = camera_towards(np.array(view.eye_m), np.array(view.at_m), COCKPIT_SLOPE)
    return picture(world, camera, width, height, view.at_s, quality)
