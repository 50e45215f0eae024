"""One picture of a world, drawn without a window: for `reefgame shot`, portraits and tests."""

from components.camera import Camera
from reefgame.console import complain
from reefgame.scene import QUALITIES, Scene
from reefgame.world import World
from systems.sea.choose import Backend
from systems.view.target import Target, UInt8s


def picture(
    world: World,
    camera: Camera,
    width: int,
    height: int,
    seconds: float,
    quality: str = "high",
    fibres: Backend = "numba",
) -> UInt8s:
    """Return what `camera` sees of `world`, (height, width, 3), the top row first; `fibres` bends its plants."""
    with Target(width, height, QUALITIES[quality].samples) as target:
        scene = Scene(world, quality, fibres)
        target.bind()
        scene.draw(camera, 1.0, width, height, seconds)
        drawn = target.read()
        if scene.note:
            complain(scene.note)
        scene.delete()
    return drawn
