"""bench motor: what replaying captured motion costs against simulating it, one thread (papers/000, Table 3).

The fishes and the muscle model take turns in one run, many short spells each; a figure is the median of its spells. The
dynamics are one sardine's frame of four substeps, by the banded solver and by LU of the whole 69 x 69 matrix, which is
the paper's way.
"""

from collections.abc import Callable, Iterator
from statistics import median
from time import perf_counter
from typing import Final

import numba
import numpy as np

from components.fish import Population
from components.live import MOST_LIVE
from components.repertoire import Pattern, pack
from reefgame.bench.case import Case, in_turn
from reefgame.bench.step import crowded
from reefgame.content import load, load_species, read_species
from reefgame.content.anatomy import body_of, swim_of
from reefgame.world import World
from systems.motor.biomechanics import advance, workspace
from systems.motor.columns import Bodies, Motors, bodies, motors
from systems.motor.contract import Stroke
from systems.motor.live import Live
from systems.motor.move import advance as play
from systems.motor.muscle_model import body_model
from systems.motor.pose import reconstruct, replay
from systems.motor.track import Track, track
from tools.peers.dense_dynamics import dense_advance

_FISHES: Final = 1000
_CALLS: Final = 50
_FRAMES: Final = 60
_DENSE_FRAMES: Final = 10
_LIVE_TICKS: Final = 480
_ROUNDS: Final = 25
_WARPING: Final = 1 / 6
_CROWD: Final = 100_000
_COPIES: Final = 1.8
_RATE: Final = 0.9


def measure() -> Iterator[Case]:
    """Yield microseconds a fish of replay and of the whole of move, against a frame of dynamics."""
    spells = (
        _replay(),
        _full(),
        _dynamics(advance, _FRAMES),
        _dynamics(dense_advance, _DENSE_FRAMES),
    )
    times = in_turn(spells, _ROUNDS)
    per = (_CALLS * _FISHES, _CALLS * _FISHES, _FRAMES, _DENSE_FRAMES)
    bare, full, banded, dense = (1e6 * t / n for t, n in zip(times, per, strict=True))
    fishes = f"fishes={_FISHES}"
    us = "us a fish"
    yield Case(f"{fishes} part=replay", bare, us, bound="<= 0.035")
    yield Case(f"{fishes} part=full warping={_WARPING:.2f}", full, us, bound="<= 0.06")
    yield Case("part=dynamics", banded, "us a frame", bound="<= 45")
    yield Case(f"{fishes} part=replay against=dense", bare, us, dense, dense / bare, ">= 3500")
    yield Case(f"{fishes} part=replay against=banded", bare, us, banded, banded / bare)
    few = f"part=live fishes={MOST_LIVE}"
    frames = 1e-3 * MOST_LIVE * banded
    live = 1e3 * _live()
    yield Case(few, live, "ms a tick", frames, frames / live, "<= 3")
    yield from _crowd()


def _live() -> float:
    """Return the seconds that live physics takes of a tick, the median of some seconds of `first_dive`, one thread."""
    threads = numba.get_num_threads()
    numba.set_num_threads(1)
    world = World.build(load("first_dive"), 1, MOST_LIVE)
    times = [_seconds_live(world) for _ in range(_LIVE_TICKS)]
    numba.set_num_threads(threads)
    return median(times[_LIVE_TICKS // 4 :])


def _seconds_live(world: World) -> float:
    """Take a tick; return the seconds that live physics took."""
    spent = 0.0
    for system in world.systems:
        start = perf_counter()
        system()
        if isinstance(system, Live):
            spent = perf_counter() - start
    world.clock.tick[0] += 1
    return spent


def _crowd() -> Iterator[Case]:
    """Yield what the nodes of a hundred thousand fishes cost against copying as many bytes, one thread both, and what
    fishes cost that swim at a rate of their own."""
    people, fish, motor, data = _warping(_CROWD)
    nodes = np.empty((people.count, 3, 24), np.float32)
    copy = np.zeros_like(nodes)

    def pose() -> None:
        reconstruct(people.count, fish, motor, data.shape, data.after, nodes)

    posed, copied = in_turn((pose, lambda: np.copyto(copy, nodes)), _ROUNDS)
    yield Case(
        f"fishes={_CROWD} part=pose against=copy",
        1e3 * posed,
        "ms",
        1e3 * copied,
        copied / posed,
        f"ratio >= {1 / _COPIES:.2f}",
    )
    captured, rated = in_turn((_full(), _full(rate=_RATE)), _ROUNDS)
    per = 1e6 / (_CALLS * _FISHES)
    name = f"fishes={_FISHES} part=full rate={_RATE} against=rate=1"
    yield Case(name, per * rated, "us a fish", per * captured, captured / rated)


def _replay() -> Callable[[], None]:
    """Return a spell of eqs. 10 to 12 for all fishes: pose and 23 nodes in float32."""
    library = pack([load_species("sardine").repertoire])
    data = track(library)
    swim = int(library.segment[0, Pattern.SWIM_MEDIUM])
    first, length = int(library.start[swim]), int(library.length[swim])
    frame = (np.arange(_FISHES) % length).astype(np.int32)
    size = np.full(_FISHES, 0.2)
    rotation, position = np.tile(np.eye(3), (_FISHES, 1, 1)), np.zeros((_FISHES, 3))
    nodes = np.empty((_FISHES, 3, 24), np.float32)

    def spell() -> None:
        for _ in range(_CALLS):
            replay(first, length, frame, size, data, rotation, position, nodes)

    return spell


def _warping(fishes: int) -> tuple[Population, Bodies, Motors, Track]:
    """Return so many fishes, a sixth of them in a warp that does not end, its offset at nearly full weight."""
    world = crowded(fishes)
    people = world.population
    motor = motors(people.motor)
    motor.warp_length[: people.count : round(1 / _WARPING)] = 1 << 30
    motor.warp_weight[: people.count : round(1 / _WARPING)] = 1.0
    return people, bodies(people.fish), motor, track(world.library)


def _full(rate: float = 1.0) -> Callable[[], None]:
    """Return a spell of whole replay: segments, warps, steering and balance, then all nodes."""
    people, fish, motor, data = _warping(_FISHES)
    motor.throttle[: people.count] = motor.pace[: people.count] = rate
    nodes = np.empty((people.count, 3, 24), np.float32)

    def spell() -> None:
        for _ in range(_CALLS):
            play(0, people.count, fish, motor, data)
            reconstruct(people.count, fish, motor, data.shape, data.after, nodes)

    return spell


def _dynamics(step: Callable[..., None], frames: int) -> Callable[[], None]:
    """Return a spell of `frames` frames of a sardine swimming at cruise."""
    _, file = read_species("sardine")
    swim = swim_of(file)
    model = body_model(body_of(file), swim)
    stroke = Stroke(swim.contraction_middle, swim.contraction_rear, 2.6, 60, 0.0)
    position, velocity, work = model.start.copy(), np.zeros((23, 3)), workspace(model)
    clock = [0]

    def spell() -> None:
        for _ in range(frames):
            step(model, stroke, clock[0], position, velocity, work)
            clock[0] += 1

    return spell
