"""Soak: run a level headless for many ticks and, for researchers, write what every fish did (DESIGN 8).

The trace is an npz without pickle: `tick` (T,), and for the T samples of N fishes (NaN and -1 where a fish does not
live) `id` (N,), `species` (N,), `position` [m] (T, N, 3), `heading` (T, N, 3), `intention` (T, N), `segment` (T, N).
"""

from collections.abc import Callable
from pathlib import Path
from typing import Final

import numpy as np

from components.arrays import AnyArray
from reefgame.autopilot import PilotScript, idle
from reefgame.output import replacing
from reefgame.world import World

SAMPLE_EVERY: Final = 6
"""[ticks] between two samples of a trace."""


class Trace:
    """Collects samples of all fishes; rows of a sample are aligned by id when written."""

    def __init__(self) -> None:
        self._samples: list[dict[str, AnyArray]] = []

    def sample(self, world: World) -> None:
        """Add the world as it stands."""
        people = world.population
        n = people.count
        self._samples.append(
            {
                "tick": np.array(world.clock.now),
                "id": people.fish.id[:n].copy(),
                "species": people.fish.species[:n].copy(),
                "position": people.fish.position[:n].copy(),
                "heading": people.fish.rotation[:n, :, 0].copy(),
                "intention": people.mind.intention[:n].copy(),
                "segment": people.motor.segment[:n].copy(),
            }
        )

    def arrays(self) -> dict[str, AnyArray]:
        """Return the trace's arrays, as the module's docstring describes them."""
        ids = np.unique(np.concatenate([*(s["id"] for s in self._samples), np.empty(0, np.int64)]))
        shape = (len(self._samples), len(ids))
        species = np.full(len(ids), -1, np.int32)
        out: dict[str, AnyArray] = {
            "tick": np.array([s["tick"] for s in self._samples], np.int64),
            "id": ids,
            "species": species,
            "position": np.full((*shape, 3), np.nan),
            "heading": np.full((*shape, 3), np.nan),
            "intention": np.full(shape, -1, np.int8),
            "segment": np.full(shape, -1, np.int32),
        }
        for at, sample in enumerate(self._samples):
            columns = np.searchsorted(ids, sample["id"])
            species[columns] = sample["species"]
            for name in ("position", "heading", "intention", "segment"):
                out[name][at, columns] = sample[name]
        return out

    def save(self, path: Path) -> None:
        """Write the npz, whole or not at all. Raise InputError where it cannot be written."""
        with replacing(path) as fresh, fresh.open("wb") as file:
            np.savez_compressed(file, allow_pickle=False, **self.arrays())


def soak(
    world: World,
    ticks: int,
    pilot: PilotScript = idle,
    trace: Trace | None = None,
    report: Callable[[float], None] = lambda _: None,
) -> None:
    """Advance the world by `ticks` under the pilot, sampling it into `trace` ten times a second."""
    for tick in range(ticks):
        if trace is not None and tick % SAMPLE_EVERY == 0:
            trace.sample(world)
        world.tick(pilot(world))
        if tick % 60 == 0:
            report(tick / ticks)
