"""Snapshots: restored anywhere, the checksums that follow are equal (DESIGN 2)."""

from hypothesis import given, settings
from hypothesis import strategies as st

from components.command import Command
from reefgame.content import load
from reefgame.world import World

CONTENT = load("visitors")
COMMANDS = st.builds(
    Command,
    throttle=st.integers(-100, 100),
    turn=st.integers(-100, 100),
    pitch=st.integers(-100, 100),
    rise=st.integers(-100, 100),
    stop=st.integers(0, 1),
    photograph=st.integers(0, 1),
    become=st.integers(0, 1),
    eat=st.integers(0, 1),
    hide=st.integers(0, 1),
    view=st.integers(0, 1),
)


@settings(max_examples=12)
@given(
    seed=st.integers(0, 2**62),
    before=st.integers(0, 200),
    after=st.integers(1, 200),
    detour=st.integers(0, 120),
    command=COMMANDS,
    added=st.integers(0, 20),
)
def test_a_restored_world_goes_on_with_the_same_bits(
    seed: int, before: int, after: int, detour: int, command: Command, added: int
) -> None:
    world = World.build(CONTENT, seed)
    for _ in range(before):
        world.tick(command)
    saved = world.snapshot()
    for _ in range(after):
        world.tick(command)
    expected = world.checksums()

    for _ in range(detour):
        world.tick(Command(throttle=-100, turn=3))
    world.spawn.add(0, added, world.submarine.position[0], 2.0)
    world.restore(saved)
    assert len(world.entities) == world.population.count
    for _ in range(after):
        world.tick(command)
    assert world.checksums() == expected


def test_a_snapshot_serves_another_world_of_the_same_level() -> None:
    world, other = World.build(CONTENT, 4), World.build(CONTENT, 9)
    for _ in range(100):
        world.tick(Command(throttle=50))
    other.restore(world.snapshot())
    for _ in range(50):
        world.tick()
        other.tick()
    assert world.checksums() == other.checksums()


def test_a_snapshot_does_not_follow_the_world() -> None:
    world = World.build(CONTENT, 4)
    saved = world.snapshot()
    first = world.checksums()
    world.tick(Command(throttle=50))
    assert world.checksums() != first
    world.restore(saved)
    assert world.checksums() == first
