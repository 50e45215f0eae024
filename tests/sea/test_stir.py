"""Stirring: key frames, what carries singularities, the submarine's wash (papers/002, section 5.2)."""

from collections.abc import Callable

import numpy as np
import pytest

from components.arrays import Float64s
from components.command import FULL, Command
from components.field import field_of, flow, pack
from components.singularity import NOBODY, SUBMARINE
from reefgame.world import World
from systems.sea.stir import ASTERN, WASH, Stir

Pool = Callable[..., World]
TRACK = (
    "{kind: source, speed_m_per_s: 1, core_m: 0.5, reach_m: 8, track: {between: linear, loop: true,"
    " frames: [{at_s: 0, at_m: [0, 0, -4]}, {at_s: 2, at_m: [4, 0, -4], strength: -1},"
    " {at_s: 4, at_m: [0, 0, -4]}]}}"
)
FOLLOWED = (
    "{kind: whirlwind, speed_m_per_s: 1, reach_m: 3, axis: [1, 0, 0],"
    " attached: {species: barracuda, offset_m: [-0.5, 0.1, 0]}}"
)
HUNTERS = "{species: barracuda, count: 2, around_m: [0, 0, -5], within_m: 2, restock_s: null}"


def stir(world: World) -> None:
    """Let the world's singularities alone do what a tick has them do."""
    next(system for system in world.systems if isinstance(system, Stir))()


def at(world: World, *point: float) -> Float64s:
    """Return the flow at a point [m/s]."""
    return np.array(flow(field_of(world.singularities), world.clock.now, *point))


def test_key_frames_lead_a_source_round_and_turn_it_into_a_hole(pool: Pool) -> None:
    world = pool(TRACK)
    seen = []
    for tick in (0, 60, 120, 180, 240, 300):
        world.clock.tick[0] = tick
        stir(world)
        table = world.singularities
        seen.append((*table.position[0].round(9).tolist(), float(table.intensity[0])))
    assert seen == [
        (0.0, 0.0, -4.0, 0.25), (2.0, 0.0, -4.0, 0.0), (4.0, 0.0, -4.0, -0.25),
        (2.0, 0.0, -4.0, 0.0), (0.0, 0.0, -4.0, 0.25), (2.0, 0.0, -4.0, 0.0),
    ]  # fmt: skip


def test_speed_and_core_are_what_the_level_says(pool: Pool) -> None:
    world = pool(
        "{kind: source, at_m: [0, 0, -5], speed_m_per_s: 2, core_m: 0.5, softening_m: 0.001}"
    )
    stir(world)
    assert at(world, 0.01, 0.0, -5.0)[0] == pytest.approx(2.0, rel=0.02)
    assert at(world, 0.5, 0.0, -5.0)[0] == pytest.approx(1.0, rel=0.01)


def test_a_singularity_rides_on_the_oldest_fish_of_its_species_and_then_on_the_next(
    pool: Pool,
) -> None:
    world = pool(
        FOLLOWED,
        fishes=f"{HUNTERS}, {{species: sardine, count: 1, around_m: [9, 9, -5], within_m: 1}}",
    )
    table, fish = world.singularities, world.population.fish
    first, second = sorted(fish.live("id")[fish.live("species") == 0].tolist())
    for identity in (first, second):
        stir(world)
        row = world.population.row(identity)
        assert table.attached[0] == identity
        expected = fish.position[row] + fish.rotation[row] @ [-0.5, 0.1, 0.0]
        np.testing.assert_allclose(table.position[0], expected, atol=1e-12)
        np.testing.assert_allclose(table.axis[0], fish.rotation[row, :, 0], atol=1e-12)
        assert np.abs(at(world, *(expected + np.array([0.0, 0.3, 0.1])))).max() > 0.1
        world.spawn.remove(identity)
    stir(world)
    assert (table.attached[0], table.there[0]) == (NOBODY, 0)
    assert at(world, *table.position[0] + 0.1).tolist() == [0.0, 0.0, 0.0]
    assert not pack(table, 0.0)[0].any()


def test_a_rock_carries_what_is_attached_to_it(pool: Pool) -> None:
    world = pool(
        "{kind: source, speed_m_per_s: 1, attached: {rock: 0, offset_m: [2, 1, 0]}, reach_m: 3}"
    )
    stir(world)
    c, s = world.terrain.rock_axes[0]
    expected = world.terrain.rock_centre[0] + [2 * c, 2 * s, 1.0]
    np.testing.assert_allclose(world.singularities.position[0], expected, atol=1e-12)


def test_the_wash_blows_astern_as_strong_as_the_engine_is_set(pool: Pool) -> None:
    world = pool()
    table, ship = world.singularities, world.submarine
    assert (table.count, table.attached[0]) == (1, SUBMARINE)
    ship.yaw[0], ship.pitch[0] = 0.7, 0.3
    for throttle in (1.0, 0.5, -0.5, 0.0):
        ship.throttle[0] = throttle
        stir(world)
        ahead = np.array([np.cos(0.3) * np.cos(0.7), np.cos(0.3) * np.sin(0.7), np.sin(0.3)])
        place = ship.position[0] + ASTERN[0] * ahead
        np.testing.assert_allclose(at(world, *place), -WASH * throttle * ahead, atol=1e-9)
        assert at(world, *(ship.position[0] + 3.0 * ahead)).tolist() == [0.0, 0.0, 0.0]


def test_driving_makes_wash_and_no_submarine_makes_none(pool: Pool) -> None:
    world = pool()
    for _ in range(60):
        world.tick(Command(throttle=FULL))
    assert world.singularities.intensity[0] > 0.3
    world.submarine.count = 0
    world.tick()
    assert world.singularities.there[0] == 0


def test_a_restored_world_stirs_the_same_bits(pool: Pool) -> None:
    fishes = f"{HUNTERS}, {{species: sardine, count: 5, around_m: [3, 0, -6], within_m: 1}}"
    world, other = (pool(f"{TRACK}, {FOLLOWED}", fishes=fishes) for _ in range(2))
    for _ in range(40):
        world.tick(Command(throttle=FULL))
    other.restore(world.snapshot())
    for _ in range(40):
        world.tick()
        other.tick()
    assert other.checksums() == world.checksums()
    assert "singularities" in world.checksums()
