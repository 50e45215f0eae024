"""Live physics: who is simulated, and that nobody sees when a fish goes over to muscles or back to replay."""

from dataclasses import replace
from typing import Final

import numba
import numpy as np
import pytest

from components.arrays import Float64s, Int64s
from components.live import ENTERING, LEAVING, LIVE
from components.repertoire import Pattern
from components.segment import MIRROR_IMAGES
from components.submarine import HULL_RADIUS
from reefgame.content import Content, load
from reefgame.schedule import System
from reefgame.world import World
from systems.motor.columns import Bodies, Motors, bodies, motors
from systems.motor.contract import contract
from systems.motor.hand_over import leave, may_leave
from systems.motor.live import CHOOSE_TICKS, Live
from systems.motor.live_step import slots
from systems.motor.pose import pose
from systems.motor.strokes import stroke_of
from systems.motor.swim import Swim

CONTENT: Final = load("first_dive")
JUMP: Final = 0.02
"""[BL] that a node may move at a hand-over beyond what it moves anyway."""


def _live_of(world: World) -> Live:
    return next(system for system in world.systems if isinstance(system, Live))


def _swim_of(world: World) -> Swim:
    return next(system for system in world.systems if isinstance(system, Swim))


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

    def __init__(self, live: int = 50) -> None:
        self.world = World.build(CONTENT, 1, live)
        self.live = _live_of(self.world)
        self.move = _swim_of(self.world).move
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


def test_the_nearest_fishes_are_simulated_and_never_more() -> None:
    drill = _Drill(12)
    world = drill.world
    for _ in range(3):
        drill.tick()
    fish, count = world.population.fish, world.population.count
    away = np.linalg.norm(fish.position[:count] - world.submarine.position[0], axis=1)
    nearest = set(fish.id[np.argsort(away)[:12]].tolist())
    live = set(world.live.id[_held(world, LIVE)].tolist())
    assert len(live) == 12
    assert len(live & nearest) >= 11
    for _ in range(120):
        world.tick()
        assert len(_held(world, ENTERING, LIVE)) <= 12


def test_a_live_fish_is_given_up_only_for_one_that_is_a_fifth_nearer() -> None:
    drill = _Drill(1)
    world, live = drill.world, drill.live
    for _ in range(2):
        drill.tick()
    fish, held = world.population.fish, _held(world, LIVE)
    own = int(_rows(world, held)[0])
    rival = (own + 1) % world.population.count
    fish.position[: world.population.count] += 50.0
    stayed = []
    for near in (2.7, 2.45, 2.2):
        for _ in range(40):
            drill.tick()
            fish.position[own] = world.submarine.position[0] + (3.0, 0.0, 0.0)
            fish.position[rival] = world.submarine.position[0] + (0.0, near, 0.0)
            live._choose(_rows(world, np.arange(2)), slots(world.live), *_columns(world))
        stayed.append(
            bool(world.live.stage[held[0]] == LIVE and world.live.id[held[0]] == fish.id[own])
        )
    assert stayed == [True, True, False]


def _columns(world: World) -> tuple[Bodies, Motors]:
    return bodies(world.population.fish), motors(world.population.motor)


def test_a_simulated_fish_swims_as_a_replayed_one() -> None:
    """Speed, course and shape over a second, of fishes that both ways are asked the same."""
    ways = []
    for fishes in (0, 50):
        world = World.build(CONTENT, 1, fishes)
        moving: list[System] = [_swim_of(world).move, *([_live_of(world)] if fishes else [])]
        rows = np.arange(world.population.count)
        order = np.argsort(world.population.fish.id[rows])
        for tick in range(70):
            if tick == 10:
                start = world.population.fish.position[rows].copy()
                world.population.motor.steer[rows] = (0.0, 0.0, 0.005)
            for system in moving:
                system()
            world.clock.tick[0] += 1
        way = (world.population.fish.position[rows] - start)[order]
        ways.append(way / world.population.fish.length[rows][order, None])
    gone = np.linalg.norm(ways[0], axis=1)
    apart = np.linalg.norm(ways[1] - ways[0], axis=1)
    assert gone.mean() > 0.8
    assert (apart / gone).mean() < 0.05


def test_a_restored_dive_goes_on_to_the_same_bits() -> None:
    world = _swum(ticks=40)
    assert len(_held(world, LIVE))
    saved = world.snapshot()
    ends = []
    other = _swum(ticks=7, seed=1)
    for again in (world, other):
        again.restore(saved)
        for _ in range(45):
            again.tick()
        ends.append(again.checksums())
    assert ends[0] == ends[1]
    assert "live" in ends[0]


def test_rows_and_threads_change_nothing() -> None:
    ends = []
    threads = numba.get_num_threads()
    for alone in (False, True):
        numba.set_num_threads(1 if alone else threads)
        world = _swum(ticks=9)
        order = np.arange(world.population.count)
        world.population.reorder(order[::-1].copy() if alone else order)
        for _ in range(75):
            world.tick()
        world.population.reorder(np.argsort(world.population.fish.live("id")))
        ends.append(world.checksums())
    numba.set_num_threads(threads)
    assert ends[0] == ends[1]


def test_without_live_fishes_the_state_is_as_ever() -> None:
    world = _swum(live=0, ticks=1)
    assert "live" not in world.checksums()
    assert not [system for system in world.systems if isinstance(system, Live)]
    assert world.library.spare == 0
    with pytest.raises(ValueError, match="51 fishes"):
        World.build(CONTENT, 1, 51)


@pytest.mark.parametrize("broken", [np.nan, np.inf, 400.0])
def test_physics_that_blows_up_leaves_the_fish_as_it_looked_last(broken: float) -> None:
    world = _swum(ticks=20)
    held = _held(world, LIVE)[:1]
    rows = _rows(world, held)
    before = pose(world.population, world.library, rows, body=True)
    world.live.velocity[held[0], 7] = broken
    world.tick()
    rows = world.population.rows(world.live.id[held])
    assert world.live.stage[held[0]] == LEAVING
    shown = pose(world.population, world.library, rows, body=True)
    np.testing.assert_allclose(shown, before, atol=2e-6)
    for _ in range(90):
        world.tick()
        count = world.population.count
        assert np.isfinite(world.population.fish.position[:count]).all()
        assert np.isfinite(pose(world.population, world.library)).all()
    assert np.isfinite(world.live.live("nodes")).all()


def test_fishes_that_go_free_their_slots() -> None:
    world = _swum(ticks=20)
    gone = world.live.id[_held(world, LIVE)][:5].tolist()
    for identity in gone:
        world.spawn.remove(identity)
    world.tick()
    assert not set(gone) & set(world.live.live("id").tolist())
    for identity in world.population.fish.live("id").tolist():
        world.spawn.remove(identity)
    for _ in range(8):
        world.tick()
    assert (world.live.live("stage") == 0).all()
    assert not world.live.live("nodes").any()


def test_a_live_fish_stays_out_of_the_hull() -> None:
    world = _swum(ticks=20)
    held = _held(world, LIVE)[:1]
    row = int(_rows(world, held)[0])
    size = world.population.fish.length[row]
    nodes = world.live.nodes[held[0]]
    ahead = nodes[0] / np.linalg.norm(nodes[0])
    ship = world.population.fish.position[row] + size * nodes[0] + (HULL_RADIUS - 0.05) * ahead
    live = _live_of(world)
    _swim_of(world).move()
    world.submarine.position[0] = ship
    world.submarine.velocity[0] = 0.0
    live()
    place = world.population.fish.position[row] + size * world.live.nodes[held[0]]
    assert np.linalg.norm(place - ship, axis=1).min() > HULL_RADIUS
    assert world.live.velocity[held[0]].mean(axis=0) @ ahead < 0.05


def test_a_repertoire_without_notes_is_replayed() -> None:
    bare = tuple(
        replace(s, repertoire=replace(s.repertoire, provenance={})) if s.name == "sardine" else s
        for s in CONTENT.species
    )
    world = _swum(ticks=20, content=replace(CONTENT, species=bare))
    names = [
        world.species[k].name
        for k in world.population.fish.species[_rows(world, _held(world, LIVE))]
    ]
    assert names
    assert "sardine" not in names


@pytest.mark.parametrize(
    ("key", "text"),
    [("swim_medium_phase", "abc"), ("swim_medium_phase", "nan"), ("swim_medium_gear", "1.0"),
     ("swim_medium_gear", "0 1")],
)  # fmt: skip
def test_notes_that_tell_nothing_are_no_stroke(key: str, text: str) -> None:
    sardine = next(s for s in CONTENT.species if s.name == "sardine")
    assert stroke_of(sardine, Pattern.SWIM_MEDIUM) is not None
    notes = sardine.repertoire.provenance | {key: text}
    bad = replace(sardine, repertoire=replace(sardine.repertoire, provenance=notes))
    assert stroke_of(bad, Pattern.SWIM_MEDIUM) is None


def test_strokes_to_the_right_mirror_those_to_the_left() -> None:
    sardine = next(s for s in CONTENT.species if s.name == "sardine")
    for left, right in MIRROR_IMAGES:
        one, other = stroke_of(sardine, left), stroke_of(sardine, right)
        assert one is not None
        assert other is not None
        assert (one.turn, one.flight) == (-other.turn, -other.flight)
        length = np.ones(91)
        rest, mirrored = length.copy(), length.copy()
        for step in (3, 40, 90):
            contract(one, length, step, 1 / 240, rest)
            contract(other, length, step, 1 / 240, mirrored)
            np.testing.assert_allclose(mirrored[:12], rest[_OTHER_SIDE], atol=1e-12)


_OTHER_SIDE: Final = np.array([4 * k + m for k in range(3) for m in (1, 0, 3, 2)])
"""The muscle on the other side of each."""
