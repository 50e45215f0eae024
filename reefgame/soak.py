"""Soak: run a level headless for many ticks and, for researchers, write what every fish did (DESIGN 8).

The trace is an npz without pickle: `tick` (T,), and for the T samples of N fishes (NaN and -1 where a fish does not
live) `id` (N,), `species` (N,), `position` [m] (T, N, 3), `heading` (T, N, 3), `intention` (T, N), an
`Intention`, `why` (T, N), the `Why` of it, `focus` (T, N), the id attended to, -1 for none, -2 for the submarine,
-16 - k for particle k of food, `hunger`, `libido` and `fear` (T, N), 0 to 1, `swallowed` (T, N), the id of the fish
that sucks it in, -1 for none, and `segment` (T, N). Samples wait in a temporary file: memory does not grow with T.
"""

import tempfile
import zipfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import IO, Any, Final

import numpy as np

from components.arrays import AnyArray
from reefgame.autopilot import PilotScript, idle
from reefgame.output import replacing, unwritable
from reefgame.world import World

SAMPLE_EVERY: Final = 6
"""[ticks] between two samples of a trace."""

_COLUMNS: Final[dict[str, tuple[str, tuple[int, ...], float]]] = {
    "position": ("<f8", (3,), np.nan),
    "heading": ("<f8", (3,), np.nan),
    "intention": ("|i1", (), -1),
    "why": ("|i1", (), -1),
    "focus": ("<i8", (), -1),
    "hunger": ("<f4", (), np.nan),
    "libido": ("<f4", (), np.nan),
    "fear": ("<f4", (), np.nan),
    "swallowed": ("<i8", (), -1),
    "segment": ("<i4", (), -1),
}
"""What is sampled of each fish: type, shape, and what stands where it does not live."""

_RECORD: Final = np.dtype(
    [("id", "<i8"), *((name, kind, shape) for name, (kind, shape, _) in _COLUMNS.items())]
)


class Trace:
    """Collects samples of all fishes in a temporary file; rows of a sample are aligned by id when written.

    A context manager: the temporary file, which has no name, is gone as it ends. Raise InputError, one line, where
    there is no room for it beside `path`.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        try:
            self._file: IO[bytes] = tempfile.TemporaryFile(dir=path.absolute().parent)  # noqa: SIM115
        except OSError as error:
            raise unwritable(path, error) from None
        self._ticks: list[int] = []
        self._counts: list[int] = []
        self._species: dict[int, int] = {}

    def __enter__(self) -> "Trace":
        return self

    def __exit__(self, *_: object) -> None:
        # What a full disk did not take is still in the file's buffer.
        with suppress(OSError):
            self._file.close()

    def sample(self, world: World) -> None:
        """Add the world as it stands."""
        people, n = world.population, world.population.count
        fish, mind = people.fish, people.mind
        records = np.empty(n, _RECORD)
        records["id"], records["position"] = fish.id[:n], fish.position[:n]
        records["heading"] = fish.rotation[:n, :, 0]
        for name in ("intention", "why", "focus", "hunger", "libido", "fear"):
            records[name] = getattr(mind, name)[:n]
        records["swallowed"], records["segment"] = mind.swallowed_by[:n], people.motor.segment[:n]
        try:
            self._file.write(records.tobytes())
        except OSError as error:
            raise unwritable(self._path, error) from None
        self._ticks.append(world.clock.now)
        self._counts.append(n)
        self._species.update(zip(fish.id[:n].tolist(), fish.species[:n].tolist(), strict=True))

    def save(self) -> None:
        """Write the npz, whole or not at all. Raise InputError where it cannot be written."""
        ids = np.array(sorted(self._species), np.int64)
        kinds = np.array([self._species[identity] for identity in ids.tolist()], np.int32)
        plain: dict[str, AnyArray] = {
            "tick": np.array(self._ticks, np.int64),
            "id": ids,
            "species": kinds,
        }
        with (
            replacing(self._path) as fresh,
            zipfile.ZipFile(fresh, "w", zipfile.ZIP_DEFLATED) as archive,
        ):
            for name, values in plain.items():
                with archive.open(f"{name}.npy", "w") as member:
                    np.lib.format.write_array(member, values, allow_pickle=False)
            for name in _COLUMNS:
                with archive.open(f"{name}.npy", "w", force_zip64=True) as member:
                    self._write(member, name, ids)

    def _write(self, member: IO[bytes], name: str, ids: AnyArray) -> None:
        """Write one array, sample by sample."""
        kind, shape, nothing = _COLUMNS[name]
        header: dict[str, Any] = {
            "descr": kind,
            "fortran_order": False,
            "shape": (len(self._ticks), len(ids), *shape),
        }
        np.lib.format.write_array_header_1_0(member, header)
        self._file.seek(0)
        for count in self._counts:
            records = np.frombuffer(self._file.read(count * _RECORD.itemsize), _RECORD)
            sample = np.full((len(ids), *shape), nothing, kind)
            sample[np.searchsorted(ids, records["id"])] = records[name]
            member.write(sample.tobytes())


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
