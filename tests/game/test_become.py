"""The player becomes a fish, steers it, and comes back: from orders in a recording alone."""

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from components.arrays import Float64s
from components.command import Command
from components.mind import FOOD, Intention, Why
from reefgame.content import load
from reefgame.eyes import eyes
from reefgame.replay import read_replay, verify
from reefgame.testing import play
from reefgame.world import World

EASY = Path(__file__).parents[1] / "screens" / "easy.yaml"
CONTENT = load("first_dive")


def diver(seed: int = 1) -> World:
    """Return a world in which the player has just become a fish."""
    world = World.build(CONTENT, seed)
    world.tick()
    world.tick(Command(become=1))
    assert world.avatar.attached
    return world


def row(world: World) -> int:
    return world.population.row(int(world.avatar.fish[0]))


def ahead(world: World) -> Float64s:
    return np.array(world.population.fish.rotation[row(world), :, 0], np.float64)


def swim(world: World, ticks: int, **orders: int) -> World:
    for _ in range(ticks):
        world.tick(Command(**orders))
    return world


def speed(world: World) -> float:
    fish, at = world.population.fish, row(world)
    return 60.0 * float(np.linalg.norm(fish.position[at] - fish.last_position[at]))


def test_the_fish_before_the_bow_is_the_one_nearest_the_middle() -> None:
    world = diver()
    fish, ship = world.population.fish, world.submarine
    mind = world.population.mind
    assert mind.intention[row(world)] == Intention.OBEY
    assert mind.why[row(world)] == Why.PLAYER
    way = fish.position[row(world)] - ship.position[0]
    assert np.linalg.norm(way) < 15.5
    assert way @ np.array([np.cos(ship.yaw[0]), np.sin(ship.yaw[0]), 0.0]) > 0.7 * np.linalg.norm(
        way
    )


def test_where_no_fish_is_before_the_bow_nothing_happens_and_it_is_told() -> None:
    world = World.build(CONTENT, 1)
    world.submarine.yaw[0] = np.pi
    world.submarine.pitch[0] = 1.0
    world.tick(Command(become=1))
    assert not world.avatar.attached
    assert world.avatar.refused_at[0] == 0


def test_a_button_held_counts_once_and_pressed_again_lets_go() -> None:
    world = diver()
    swim(world, 30, become=1)
    assert world.avatar.fish[0] >= 0
    at = row(world)
    swim(world, 1)
    swim(world, 1, become=1)
    assert not world.avatar.attached
    assert world.population.mind.intention[at] != Intention.OBEY
    assert world.population.mind.gape[at] == 0.0


@pytest.mark.parametrize(("order", "side"), [(100, 1.0), (-100, -1.0)])
def test_the_helm_turns_the_fish_to_its_side_and_it_holds_its_course(
    order: int, side: float
) -> None:
    world = swim(diver(), 60)
    before = ahead(world)
    swim(world, 40, turn=order)
    after = ahead(world)
    assert side * (before[0] * after[1] - before[1] * after[0]) > 0.5
    swim(world, 40)
    held = ahead(world)
    swim(world, 60)
    assert held @ ahead(world) > 0.95


def test_full_throttle_is_fast_and_full_stop_brakes() -> None:
    slow = speed(swim(diver(), 60))
    world = swim(diver(), 120, throttle=100)
    assert speed(world) > 1.5 * slow
    assert world.population.motor.gear[row(world)] == 2
    assert speed(swim(world, 60, stop=1)) < 0.1 * slow


def test_the_nose_goes_up_and_down_as_ordered() -> None:
    assert ahead(swim(diver(), 90, pitch=100))[2] > 0.3
    assert ahead(swim(diver(), 60, rise=-100))[2] < -0.2


def test_the_player_eats_what_is_before_the_mouth() -> None:
    world = swim(diver(), 30)
    at, mind, food = row(world), world.population.mind, world.food
    fish = world.population.fish
    mind.eaten[at] = 0.0
    food.position[:, 2] = food.last_position[:, 2] = -1.0
    food.position[0] = food.last_position[0] = fish.position[at] + 2.0 * fish.length[at] * ahead(
        world
    )
    food.returns[0] = -1
    swim(world, 1, eat=1)
    assert mind.focus[row(world)] == FOOD
    assert mind.gape[row(world)] == 1.0
    swim(world, 90, eat=1)
    assert mind.eaten[row(world)] > 0.0
    assert food.returns[0] > world.clock.now
    swim(world, 1)
    assert mind.gape[row(world)] == 0.0


def test_the_player_hides_by_the_nearest_rock() -> None:
    world = diver()
    swim(world, 1200, hide=1)
    x, y, _ = world.population.fish.position[row(world)]
    rocks, radii = world.terrain.rock_centre, world.terrain.rock_radii
    far = np.hypot(rocks[:, 0] - x, rocks[:, 1] - y) - radii[:, :2].max(axis=1)
    assert far.min() < 1.2
    assert speed(world) < 0.3


def test_a_fish_that_leaves_the_world_returns_the_player_to_the_helm() -> None:
    world = diver()
    identity = int(world.avatar.fish[0])
    world.spawn.lose(identity)
    world.tick(Command(throttle=50))
    assert not world.avatar.attached
    assert world.avatar.lost_at[0] == world.clock.now - 1
    swim(world, 120, throttle=100)
    assert world.submarine.throttle[0] > 0.5
    assert identity not in world.population


def test_a_snapshot_taken_as_a_fish_goes_on_with_the_same_bits() -> None:
    world = swim(diver(), 40, turn=60)
    saved = world.snapshot()
    swim(world, 60, throttle=80, pitch=-20, eat=1)
    expected = world.checksums()
    swim(world, 2, become=1)
    world.restore(saved)
    swim(world, 60, throttle=80, pitch=-20, eat=1)
    assert world.checksums() == expected


def script() -> Callable[[World], Command]:
    """Return a pilot who becomes a fish, swims about, eats, hides, looks from behind and lets go."""
    plan = {30: {"become": 1}, 31: {"throttle": 60}, 80: {"turn": 80}, 120: {"eat": 1}}
    plan |= {160: {"view": 1}, 161: {"hide": 1, "rise": -30}, 220: {"become": 1}, 221: {}}
    orders: dict[str, int] = {}

    def pilot(world: World) -> Command:
        nonlocal orders
        orders = plan.get(world.clock.now, orders)
        return Command(**orders)

    return pilot


def test_a_dive_as_a_fish_is_recorded_and_proven(tmp_path: Path) -> None:
    dive = play(EASY, script(), seconds=5, seed=3, checksum_every=10)
    assert dive.world.avatar.behind[0] == 1
    assert dive.world.avatar.since[0] == 220
    path = tmp_path / "fish.replay"
    path.write_text(dive.replay)
    replay = read_replay(path)
    assert replay.commands[30].become == 1
    assert verify(replay, World.build(load(EASY), 3)) is None


def test_the_camera_looks_along_the_mean_heading_or_from_behind() -> None:
    world = swim(diver(), 60)
    through = eyes(world, 1.0, 0.5)
    fish = world.population.fish
    gazes = []
    for _ in range(60):
        world.tick()
        gazes.append((eyes(world, 1.0, 0.5).forward.copy(), ahead(world)))
    shaken = np.array([np.cross(a, b)[2] for (_, a), (_, b) in pairwise(gazes)])
    steady = np.array([np.cross(a, b)[2] for (a, _), (b, _) in pairwise(gazes)])
    assert np.abs(steady).mean() < 0.5 * np.abs(shaken).mean()
    assert through.slope > 0.8
    assert through.sight == 2.5 * world.senses.sight[fish.species[row(world)]]
    swim(world, 1, view=1)
    behind = eyes(world, 1.0, 0.5)
    way = fish.position[row(world)] - behind.eye
    assert way @ world.avatar.gaze[0] > 1.5 * fish.length[row(world)]
    assert behind.slope < 0.5


def test_at_the_helm_the_camera_is_the_submarines() -> None:
    world = swim(World.build(CONTENT, 1), 20, throttle=100)
    assert (eyes(world, 1.0, 0.5).eye == world.submarine.position[0]).all()
