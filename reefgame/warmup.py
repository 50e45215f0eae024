"""The first launch compiles the tick's kernels, and shows it: a bar that moves with every kernel (DESIGN 8, 9).

What is compiled lies in the cache that components/kernels.py keeps, beside an empty file that says it is there, named
by all sources and the processor; a later launch finds that file and does nothing. Where it is wrong, as after part of
the cache was deleted, kernels are compiled where they are first called: that costs the bar, no more.
"""

import hashlib
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, Final

import llvmlite.binding
import numba
import numpy as np
from numba.core import event

from components.anemone import Cap
from components.camera import camera_at
from components.clock import TICKS_PER_SECOND
from components.command import FULL, Command
from components.fibre import Tuft
from components.field import PACKED
from components.garden import Garden
from components.kernels import CACHED, sources_hash
from reefgame.console import Report, progress_bar
from reefgame.content import load
from reefgame.world import World
from systems.sea.bend import LEAST_NODES, NumbaBender
from systems.view.cull import Culling, view_of
from systems.view.fibre_strips import RING, fibres_of, write_strips

DOING: Final = "compiling kernels (first launch only)"
_KERNELS: Final = 175
"""Kernels that a first launch compiles, callees included; only the bar's length stands on it."""
_LIVE_KERNELS: Final = 69
"""... and those of live physics."""

_BENT: Final = LEAST_NODES // 8 + 1
"""Fibres of eight nodes that are bent in parallel."""
_LEVEL: Final = "first_dive"


def warm_up(report: Report | None = None, live: bool = False) -> None:
    """Compile every kernel of the tick, unless the cache holds them all; tell `report`, else a bar on a terminal.

    Those of live physics are among them where `live`.

    It is called before the first tick and never needs to be: without a terminal to show a bar on, it does nothing.
    """
    if is_warm(live):
        return
    if report is not None:
        _compile_all(report, live)
    elif sys.stderr is not None and sys.stderr.isatty():
        with progress_bar(DOING) as bar:
            _compile_all(bar, live)


def is_warm(live: bool = False) -> bool:
    """Return whether a launch has nothing to compile, by all that can be told at once."""
    return bool(numba.config.DISABLE_JIT) or (CACHED and stamp(live).exists())


def stamp(live: bool = False) -> Path:
    """Return the file whose presence says that kernels of these sources for this processor are in the cache."""
    processor = numba.config.CPU_NAME or llvmlite.binding.get_host_cpu_name()
    text = f"{sources_hash(Path(__file__))} {processor} {numba.config.CPU_FEATURES}"
    digest = hashlib.blake2b(text.encode(), digest_size=16).hexdigest()
    return Path(numba.config.CACHE_DIR) / f"{digest}{'.live' if live else ''}.compiled"


def compile_backwards() -> None:
    """Compile from the last system of the tick to the first, and before that what a frame needs.

    A second process does this while the first compiles forwards: what one has put into the cache the other reads, so
    they meet about half-way.
    """
    world = _world()
    ship, people = world.submarine, world.population
    camera = camera_at(ship.position[0], float(ship.yaw[0]), 0.0)
    view = view_of(camera, 360.0, 16.0 / 9.0, world.level.water.visibility_m)
    Culling(np.zeros(len(world.species)), world.library.after)(people, view, 0.5, 0.0)
    for system in reversed(world.systems):
        system()
    compile_garden()


def compile_garden() -> None:
    """Compile what bends and draws plants, which the level of the first tick has none of."""
    roots = np.zeros((_BENT, 1, 3))
    roots[:, 0, 0] = np.arange(_BENT)
    points = roots + np.linspace(0.0, 1.0, 8)[:, None] * (0.0, 0.0, 1.0)
    thin = np.full(8, 0.01)
    garden = Garden([Tuft(points, thin), Tuft(points, thin, guides=0)])
    nothing, one = np.zeros((0, PACKED), np.float32), np.zeros(1, np.int32)
    NumbaBender().step(garden, nothing, 1.0 / TICKS_PER_SECOND)
    rings = np.zeros((8, RING), np.float32)
    write_strips(fibres_of(garden), one, one + 8, one, np.zeros(RING), rings)


def _world(live: int = 0) -> World:
    """Return a world in which all that a tick can hold is there: an anemone, too."""
    return World.build(load(_LEVEL), live=live, caps=[Cap((0.0, 0.0, -5.0), 1.0, holds=0.1)])


def _second_process() -> "subprocess.Popen[bytes] | None":
    """Start the other half of the work where it can help; whatever becomes of it costs time, no more."""
    if not CACHED or (os.cpu_count() or 1) < 2:
        return None
    program = "from reefgame.warmup import compile_backwards; compile_backwards()"
    quiet = subprocess.DEVNULL
    with suppress(OSError):
        return subprocess.Popen(
            [sys.executable, "-c", program], stdin=quiet, stdout=quiet, stderr=quiet
        )
    return None


@contextmanager
def counting_kernels(report: Report, expected: int) -> Iterator[None]:
    """Tell `report` of every kernel that is compiled while the block runs, as a part of `expected`."""
    listener = _Counter(report, expected)
    event.register("numba:compile", listener)
    try:
        yield
    finally:
        event.unregister("numba:compile", listener)


class _Counter(event.Listener):  # type: ignore[misc]  # numba is untyped
    """Counts the kernels that numba has compiled, each when it is done: callees come before callers."""

    def __init__(self, report: Report, expected: int) -> None:
        self._report = report
        self._expected = expected
        self._done = 0

    def on_start(self, _: Any) -> None:
        """Nothing is told when a kernel begins."""

    def on_end(self, _: Any) -> None:
        """Tell that one more is done."""
        self._done += 1
        self._report(min(self._done / self._expected, 1.0), DOING)


def _compile_all(report: Report, live: bool) -> None:
    report(0.0, DOING)
    beside = _second_process()
    with counting_kernels(report, _KERNELS + (_LIVE_KERNELS if live else 0)):
        world = _world(int(live))
        # The wash makes the water flow: then drift carries fishes, too.
        world.tick(Command(throttle=FULL))
        world.checksums()
        world.restore(world.snapshot())
    if beside is not None:
        beside.wait()
    report(1.0, DOING)
    if CACHED:
        with suppress(OSError):
            stamp(live).touch()
