"""bench startup: from launching the process to the first frame, with and without compiled kernels at hand."""

import os
import subprocess
import sys
from collections.abc import Iterator
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter
from typing import Final

from reefgame.bench.case import Case

_FIRST_FRAME: Final = """
from reefgame.warmup import warm_up
warm_up(lambda done, what: None)
from reefgame.content import load
from reefgame.filming import draw
from reefgame.scene import Scene
from reefgame.world import World
from systems.view.target import Target
world = World.build(load("first_dive"), 1)
target = Target(1280, 720)
scene = Scene(world)
world.tick()
draw(scene, target, world)
"""
_ROUNDS: Final = 3


def measure() -> Iterator[Case]:
    """Yield seconds to the first frame of first_dive at 1280x720, drawn without a window."""
    with TemporaryDirectory() as cache:
        yield Case("launch=first", _launch({"XDG_CACHE_HOME": cache}), "s", bound="< 40")
        times = [_launch({"XDG_CACHE_HOME": cache}) for _ in range(_ROUNDS)]
        yield Case("launch=second", median(times), "s", bound="< 3")


def _launch(environment: dict[str, str]) -> float:
    start = perf_counter()
    subprocess.run(
        [sys.executable, "-c", _FIRST_FRAME], env={**os.environ, **environment}, check=True
    )
    return perf_counter() - start
