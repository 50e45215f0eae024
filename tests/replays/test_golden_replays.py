"""Golden replays: dives of closed-loop pilots that every machine must play to the same bits (DESIGN 7).

`make bless` records them anew; a commit that moves them says why.
"""

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from reefgame.autopilot import Photographer, PilotScript, tour
from reefgame.content import load
from reefgame.replay import read_replay, verify
from reefgame.testing import play
from reefgame.world import World

HERE = Path(__file__).parent
DEMONSTRATION = HERE.parents[1] / "levels" / "demonstration.replay"


@dataclass(frozen=True)
class Golden:
    """One golden replay: who plays what, for how long."""

    path: Path
    level: str
    pilot: Callable[[], PilotScript]
    seconds: float
    seed: int
    wins: bool = False


GOLDEN = {
    "won": Golden(
        DEMONSTRATION, "first_dive", lambda: Photographer(18.0, pace=0.7), 24.0, 7, wins=True
    ),
    "tour": Golden(HERE / "tour.replay", "first_dive", lambda: tour, 30.0, 11),
    "visitors": Golden(HERE / "visitors.replay", "visitors", lambda: tour, 30.0, 3),
}


@pytest.mark.golden
@pytest.mark.parametrize("name", GOLDEN)
def test_a_golden_replay_plays_to_the_same_bits(name: str, bless: bool) -> None:
    golden = GOLDEN[name]
    if bless:
        dive = play(golden.level, golden.pilot(), golden.seconds, golden.seed, until_won=False)
        golden.path.write_text(dive.replay, encoding="ascii", newline="\n")
    replay = read_replay(golden.path)
    content = load(replay.level)
    assert replay.content == content.hash, "content has changed: make bless, and say why"
    world = World.build(content, replay.seed)
    assert verify(replay, world) is None
    assert replay.ended
    assert bool(world.objective.live("done").all()) == golden.wins


def test_the_visitors_come_and_go() -> None:
    replay = read_replay(GOLDEN["visitors"].path)
    world = World.build(load(replay.level), replay.seed)
    counts = set()
    given = 0
    for command in replay.play():
        world.tick(command)
        counts.add(world.population.count)
        given = max(given, int(world.roster.next_id[0]))
    assert len(counts) >= 3, "groups arrive and leave"
    assert given > min(counts), "fishes were added after the start"
    assert len(world.entities) == world.population.count


CROWD = """
from reefgame.autopilot import tour
from reefgame.bench.step import crowded
world = crowded(700)
for _ in range(150):
    world.tick(tour(world))
print(world.checksums())
"""
MACHINES = {
    "one thread": {"NUMBA_NUM_THREADS": "1"},
    "two threads": {"NUMBA_NUM_THREADS": "2"},
    "another processor": {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""},
}


def crowd_on(environment: dict[str, str]) -> str:
    """Return the checksums of a crowd large enough for the parallel kernels, run in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-c", CROWD],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_threads_and_processor_change_no_bit() -> None:
    sums = {machine: crowd_on(environment) for machine, environment in MACHINES.items()}
    assert "fish" in sums["one thread"]
    assert len(set(sums.values())) == 1, sums
