"""bench view: frames a second of first_dive, and what of a frame is our own Python and not OpenGL."""

from collections.abc import Iterator
from statistics import median
from time import perf_counter

from components.clock import TICKS_PER_SECOND
from reefgame.autopilot import tour
from reefgame.bench.case import Case
from reefgame.bench.step import crowded
from reefgame.filming import cockpit
from reefgame.scene import Scene
from reefgame.world import World
from systems.view.gl_time import GLTime
from systems.view.target import Target

_FRAMES = 120
_WARM = 10


def measure() -> Iterator[Case]:
    """Yield frames/s at 640x360 with 60 fishes, the simulation's ticks between frames left out."""
    world = crowded(60)
    for _ in range(5 * TICKS_PER_SECOND):
        world.tick(tour(world))
    for quality in ("low", "high"):
        frame, own = _frame_times(world, quality)
        case = f"fishes=60 size=640x360 quality={quality}"
        bound = ">= 25" if quality == "low" else ""
        yield Case(case, 1.0 / frame, "frames/s", bound=bound)
        yield Case(f"{case} part=python", own * 1e3, "ms", bound="< 3")


def _frame_times(world: World, quality: str) -> tuple[float, float]:
    """Return the median seconds of a frame, and of it the seconds spent outside OpenGL."""
    target = Target(640, 360)
    scene = Scene(world, quality)
    target.bind()
    whole, own = [], []
    with GLTime() as watch:
        for frame in range(_WARM + _FRAMES):
            world.tick(tour(world))
            watch.finish()
            watch.seconds, start = 0.0, perf_counter()
            scene.draw(cockpit(world), 1.0, 640, 360, frame / TICKS_PER_SECOND)
            watch.finish()
            whole.append(perf_counter() - start)
            own.append(whole[-1] - watch.seconds)
    return median(whole[_WARM:]), median(own[_WARM:])
