"""bench view: frames a second of first_dive, alone and with a field of anemones, and what of a frame is our own Python
and not OpenGL."""

from collections.abc import Callable, Iterator
from functools import partial
from statistics import median
from time import perf_counter

import numpy as np

from components.camera import Camera, camera_towards
from components.clock import TICKS_PER_SECOND
from components.flora import Plant
from components.terrain import ground_height
from reefgame.autopilot import tour
from reefgame.bench.case import Case
from reefgame.bench.step import crowded
from reefgame.content import read_flora
from reefgame.filming import COCKPIT_SLOPE, cockpit
from reefgame.scene import Scene
from reefgame.world import World
from systems.view.gl_time import GLTime
from systems.view.target import Target

_FRAMES = 120
_WARM = 10
_SIDE = 6
"""Anemones along a side of the field."""
_CORNER = (-22.6, -3.2)
"""[m] x and y of the field's nearest one, before the bow of the submarine."""
_SPACING = 0.95


def measure() -> Iterator[Case]:
    """Yield frames/s at 640x360 with 60 fishes, the simulation's ticks between frames left out."""
    world = crowded(60)
    for _ in range(5 * TICKS_PER_SECOND):
        world.tick(tour(world))
    for quality in ("low", "high"):
        frame, own = _frame_times(world, quality, lambda: cockpit(world))
        case = f"fishes=60 size=640x360 quality={quality}"
        bound = ">= 25" if quality == "low" else ""
        yield Case(case, 1.0 / frame, "frames/s", bound=bound)
        yield Case(f"{case} part=python", own * 1e3, "ms", bound="< 3")
    for flora in ("stomphia", "actinia"):
        camera = plant_field(world, flora)
        frame, own = _frame_times(world, "low", partial(_still, camera))
        case = f"anemones={_SIDE**2} flora={flora} fishes=60 size=640x360 quality=low"
        yield Case(case, 1.0 / frame, "frames/s", bound=">= 25")
        yield Case(f"{case} part=python", own * 1e3, "ms")


def _still(camera: Camera) -> Camera:
    return camera


def plant_field(world: World, flora: str) -> Camera:
    """Plant a field of anemones of one kind instead of what grows in a world; return an eye that sees it all."""
    terrain = world.terrain
    floor = [
        (_CORNER[0] + _SPACING * (at // _SIDE), _CORNER[1] + _SPACING * (at % _SIDE))
        for at in range(_SIDE**2)
    ]
    high = [ground_height(terrain.height, terrain.extent, terrain.cell, *at) for at in floor]
    world.floras = {flora: read_flora(flora)}
    world.plants = tuple(
        Plant(flora, (*at, z), (0.0, 0.0, 1.0), 77.0 * number, 1.0, number)
        for number, (at, z) in enumerate(zip(floor, high, strict=True))
    )
    middle = np.array([*np.mean(floor, axis=0), np.mean(high)])
    eye, at = middle + np.array([-4.3, 0.0, 1.9]), middle + np.array([-0.4, 0.0, 0.2])
    return camera_towards(eye, at, COCKPIT_SLOPE)


def _frame_times(world: World, quality: str, camera: Callable[[], Camera]) -> tuple[float, float]:
    """Return the median seconds of a frame, and of it the seconds spent outside OpenGL."""
    target = Target(640, 360)
    # What play chooses by itself where it works; the twin bends elsewhere.
    scene = Scene(world, quality, fibres="opencl")
    target.bind()
    whole, own = [], []
    with GLTime() as watch:
        for frame in range(_WARM + _FRAMES):
            world.tick(tour(world))
            watch.finish()
            watch.seconds, start = 0.0, perf_counter()
            scene.draw(camera(), 1.0, 640, 360, frame / TICKS_PER_SECOND)
            watch.finish()
            whole.append(perf_counter() - start)
            own.append(whole[-1] - watch.seconds)
    return median(whole[_WARM:]), median(own[_WARM:])
