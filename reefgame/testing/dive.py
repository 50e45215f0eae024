"""A level played headless by a scripted pilot, and recorded."""

import io
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from components.clock import TICKS_PER_SECOND
from reefgame.autopilot import PilotScript
from reefgame.content import load
from reefgame.replay import Recorder
from reefgame.world import World


@dataclass(frozen=True)
class Dive:
    """What came of a scripted dive."""

    world: World
    "as it stands after the last tick"
    replay: str
    "the recording, as text"
    ticks: int
    "ticks played"

    @property
    def won(self) -> bool:
        """Whether every objective of the level was met; False for a level without one."""
        done = self.world.objective.live("done")
        return bool(len(done) and done.all())


def play(
    level: str | Path,
    pilot: PilotScript,
    seconds: float,
    seed: int = 0,
    mods: Sequence[Path] = (),
    checksum_every: int = TICKS_PER_SECOND,
    until_won: bool = True,
    live: int = 0,
) -> Dive:
    """Play `level` with the scripted pilot for at most `seconds` of simulated time and record it.

    The `live` fishes nearest the submarine run the muscle model.
    Raise ContentError where the level or a mod is at fault.
    """
    world = World.build(load(level, mods=mods), seed, live)
    stream = io.StringIO()
    recorder = Recorder(world, stream, world.level.name, checksum_every)
    dive = Dive(world, "", 0)
    ticks = 0
    for _ in range(round(seconds * TICKS_PER_SECOND)):
        command = pilot(world)
        world.tick(command)
        recorder.tick(command)
        ticks += 1
        if until_won and dive.won:
            break
    recorder.finish()
    return Dive(world, stream.getvalue(), ticks)
