"""bench memory: peak resident memory of whole processes, and growth over a long dive."""

import json
import subprocess
import sys
from collections.abc import Iterator
from typing import Final

from reefgame.bench.case import Case

_PEAK: Final = """
import json, resource, sys
def peak():
    try:
        # Not ru_maxrss: a child begins with its parent's.
        with open("/proc/self/status") as file:
            return next(int(line.split()[1]) for line in file if line.startswith("VmHWM")) / 1024
    except OSError:
        most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        return most / (2**20 if sys.platform == "darwin" else 1024)
def now():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 2**20
"""
_HEADLESS: Final = (
    _PEAK
    + """
from reefgame.bench.step import crowded
world = crowded(FISHES)
for _ in range(600):
    world.tick()
print(json.dumps(peak()))
"""
)
_DRAWN: Final = (
    _PEAK
    + """
from reefgame.bench.step import crowded
from reefgame.filming import draw
from reefgame.scene import Scene
from systems.view.target import Target
world = crowded(60)
target = Target(1280, 720)
scene = Scene(world)
for _ in range(60):
    world.tick()
    draw(scene, target, world)
print(json.dumps(peak()))
"""
)
_GROWTH: Final = (
    _PEAK
    + """
from reefgame.autopilot import tour
from reefgame.bench.step import crowded
world = crowded(60)
for _ in range(4000):
    world.tick(tour(world))
before = now()
for _ in range(20000):
    world.tick(tour(world))
print(json.dumps(now() - before))
"""
)


def measure() -> Iterator[Case]:
    """Yield peak memory [MiB] headless, with 10,000 fishes and drawn, and growth over 20,000 ticks."""
    small = _child(_HEADLESS.replace("FISHES", "60"))
    yield Case("part=headless fishes=60", small, "MiB", bound="<= 350")
    large = _child(_HEADLESS.replace("FISHES", "10000"))
    yield Case("part=headless fishes=10000", large, "MiB", bound="<= 80 more than 60")
    yield Case("part=added fishes=10000", large - small, "MiB", bound="<= 80")
    yield Case("part=drawn size=1280x720", _child(_DRAWN), "MiB", bound="<= 700")
    yield Case("part=growth ticks=20000", _child(_GROWTH), "MiB", bound="no growth")


def peak_of(program: str) -> float:
    """Return the peak resident memory [MiB] of a process that runs `program`."""
    return _child(f"{_PEAK}{program}\nprint(json.dumps(peak()))\n")


def _child(program: str) -> float:
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    return float(json.loads(done.stdout.splitlines()[-1]))
