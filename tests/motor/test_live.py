"""Live physics: who is simulated, and that nobody sees when a fish goes over to muscles or back to replay."""

from typing import Final

import numpy as np
import pytest

from components.arrays import Float64s, Int64s
from components.live import ENTERING, LIVE
from components.repertoire import Pattern
from reefgame.content import Content, load
from reefgame.world import World
from systems.motor.columns import motors
from systems.motor.hand_over import leave, may_leave
from systems.motor.live import CHOOSE_TICKS, Live
from systems.motor.live_step import slots
from systems.motor.move import Move
from systems.motor.pose import pose

CONTENT: Final = load("first_dive")
JUMP: Final = 0.02
"""[BL] that a node may move at a hand-over beyond what it moves anyway."""


def _live_of(world: World) -> Live:
    return next(system for system in world.systems if isinstance(system, Live))


def _held(world: World, *stages: int) -> Int64s:
    """Return the slots of these stages."""
    return np.flatnonzero(np.isin(world.live.live("stage"), stages))


def _rows(world: World, held: Int64s) -> Int64s:
    return world.population.rows(world.live.id[held])


def _swum(live: int = 12, ticks: int = 20, seed: int = 1, content: Content = CONTENT) -> World:
    world = World.build(content, seed, live)
    for _ in range(ticks):
        world.tick()
    return world


class _Drill:
    """Fishes that nobody controls but the test: random segments and rates, Move and Live alone."""

    def __init__(self) -> None:
        self.world = World.build(CONTENT, 1, 50)
        self.live = _live_of(self.world)
        self.move = next(s for s in self.world.systems if isinstance(s, Move))
        self.random = np.random.default_rng(4)

    def demand(self) -> None:
        """Ask some fishes that do not turn for another segment, a speed of their own and another course."""
        count, motor = self.world.population.count, self.world.population.motor
        swims = self.world.library.loops[motor.segment[:count]] == 1
        ask = np.flatnonzero(swims & (self.random.random(count) < 0.015))
        species = self.world.population.fish.species[ask]
        patterns = self.random.integers(0, len(Pattern), len(ask))
        motor.wanted[ask] = self.world.library.segment[species, patterns]
        motor.throttle[ask] = self.random.choice([1.0, 1.0, 0.85, 1.2, 1.4], len(ask))
        motor.steer[:count] = self.random.normal(0.0, 0.004, (count, 3))

    def tick(self) -> None:
        """Move, and simulate."""
        self.move()
        self.live()
        self.world.clock.tick[0] += 1

    def nodes(self, rows: Int64s) -> tuple[Float64s, Float64s]:
        """Return nodes in body axes and in the world, both in BL, (n, 23, 3)."""
        people, library = self.world.population, self.world.library
        size = people.fish.length[rows, None, None]
        body, world = pose(people, library, rows, body=True), pose(people, library, rows)
        return body.astype(np.float64), world.astype(np.float64) / size

    def leave(self, held: Int64s) -> None:
        """Hand the fishes of these slots back."""
        columns, motor = slots(self.world.live), motors(self.world.population.motor)
        for s, i in zip(held, _rows(self.world, held), strict=True):
            leave(s, i, self.live.first, columns, motor, self.live.track)

    def ready(self) -> Int64s:
        """Return the slots whose fishes may leave."""
        held, motor = _held(self.world, LIVE), motors(self.world.population.motor)
        columns, track = slots(self.world.live), self.live.track
        fit = [
            may_leave(s, i, columns, motor, track)
            for s, i in zip(held, _rows(self.world, held), strict=True)
        ]
        ready: Int64s = held[np.array(fit, bool)]
        return ready


def _farthest(one: tuple[Float64s, Float64s], other: tuple[Float64s, Float64s]) -> list[float]:
    """Return by how much each fish's nodes differ, in the body or in the world, whichever is more."""
    apart = [np.sqrt(((a - b) ** 2).sum(-1)).max(1) for a, b in zip(one, other, strict=True)]
    return list(np.maximum(*apart))


def _taken_over(drill: _Drill) -> list[float]:
    """Take a tick; return the jumps of those that begin to be simulated against what replay would have shown."""
    world = drill.world
    held = _held(world, ENTERING)
    drill.move()
    replayed = drill.nodes(_rows(world, held))
    drill.live()
    shown = drill.nodes(_rows(world, held))
    world.clock.tick[0] += 1
    begun = world.live.stage[held] == LIVE
    return [jump for jump, did in zip(_farthest(shown, replayed), begun, strict=True) if did]


def _given_back(drill: _Drill) -> list[float]:
    """Hand half of those that may leave back; return their jumps in a tick against what physics would have shown."""
    world, held = drill.world, drill.ready()
    held = held[drill.random.random(len(held)) < 0.5]
    rows, before = _rows(world, held), world.snapshot()
    drill.tick()
    simulated = drill.nodes(rows)
    world.restore(before)
    drill.leave(held)
    drill.tick()
    return _farthest(drill.nodes(rows), simulated)


@pytest.mark.parametrize("wanted", [500, pytest.param(5_000, marks=pytest.mark.prove)])
def test_no_hand_over_makes_a_node_jump(wanted: int) -> None:
    drill = _Drill()
    entering: list[float] = []
    leaving: list[float] = []
    while min(len(entering), len(leaving)) < wanted:
        drill.demand()
        entering += _taken_over(drill)
        if drill.world.clock.now % CHOOSE_TICKS == 3:
            leaving += _given_back(drill)
    assert max(entering) < JUMP
    assert max(leaving) < JUMP
