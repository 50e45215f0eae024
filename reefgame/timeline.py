"""A dive's past: snapshots and orders, from which any moment of it comes back, to the bit (DESIGN 2).

Looking back changes nothing: the newest state is kept aside and put back. Memory is bounded: at most `MOST` snapshots
of at most `BUDGET` bytes together; when there are more, every second one goes, so that a moment of a long dive is
played again from at most a few seconds before. A dive of half an hour with 200 fishes takes about 50 MB, moods
included. Where somebody looks, a few more are kept for a while: a step back is as quick as a step ahead.
"""

from bisect import bisect_right
from collections import deque
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s, Int8s, Int64s
from components.clock import TICKS_PER_SECOND
from components.command import Command
from reefgame.snapshot import Snapshot
from reefgame.world import World

MOST: Final = 240
BUDGET: Final = 64 << 20
"[bytes]"
NEAR_EVERY: Final = 20
"""[ticks] between the snapshots that are kept around a moment that is looked at ..."""
MOST_NEAR: Final = 24
"""... and how many of them."""
MOOD_EVERY: Final = TICKS_PER_SECOND // 4
"""[ticks] between two looks at what every fish feels."""
MOOD_BUDGET: Final = 24 << 20
"""[bytes], older moods are forgotten first."""
FEELINGS: Final = ("hunger", "libido", "fear")
_FULL: Final = 255.0


class Mood(NamedTuple):
    """What every fish felt at a tick."""

    tick: int
    id: Int64s
    feeling: NDArray[np.uint8]
    "hunger, libido and fear in 255ths, (n, 3) uint8"
    intention: Int8s


def size_of(snapshot: Snapshot) -> int:
    """Return the bytes that a snapshot holds."""
    return sum(column.nbytes for table in snapshot.tables.values() for column in table.values())


class Timeline:
    """What happened in `world` since this was made; told of every tick at the present."""

    def __init__(self, world: World, most: int = MOST, budget: int = BUDGET) -> None:
        self.world = world
        self.newest = self.oldest = world.clock.now
        "ticks between which the dive can be seen"
        self._most, self._budget = most, budget
        self._every = TICKS_PER_SECOND
        self._shots: dict[int, Snapshot] = {self.newest: world.snapshot()}
        self._bytes = size_of(self._shots[self.newest])
        self._changed: list[int] = []
        self._orders: list[Command] = []
        self._moods: deque[Mood] = deque()
        self._mood_bytes = 0
        self._present: Snapshot | None = None
        self._near: dict[int, Snapshot] = {}

    @property
    def at_present(self) -> bool:
        """Whether the world stands at its newest state."""
        return self._present is None

    @property
    def bytes(self) -> int:
        """What snapshots and moods take."""
        return self._bytes + self._mood_bytes

    def tick(self, command: Command) -> None:
        """Note the tick that the world has just taken at the present, under `command`."""
        if not self._orders or self._orders[-1] != command:
            self._changed.append(self.newest)
            self._orders.append(command)
        self.newest = self.world.clock.now
        if self.newest % MOOD_EVERY == 0:
            self._feel()
        if self.newest % self._every == 0:
            self._keep()

    def command(self, tick: int) -> Command:
        """Return the orders of a tick that has been played."""
        at = bisect_right(self._changed, tick) - 1
        return self._orders[at] if at >= 0 else Command()

    def seek(self, tick: int) -> None:
        """Bring the world to how it stood before `tick` was played, `oldest` to `newest`."""
        tick = max(self.oldest, min(self.newest, tick))
        if self._present is None:
            self._present = self.world.snapshot()
        if tick == self.newest:
            self.to_present()
            return
        from_here = self.world.clock.now
        shots = self._shots | self._near
        shot = max(at for at in shots if at <= tick)
        if not shot <= from_here <= tick:
            self.world.restore(shots[shot])
        while self.world.clock.now < tick:
            self.world.tick(self.command(self.world.clock.now))
            self._keep_near(self.world.clock.now, tick)

    def to_present(self) -> None:
        """Bring the world to its newest state."""
        if self._present is not None:
            self.world.restore(self._present)
            self._present = None
            self._near.clear()

    def catch_up(self) -> None:
        """Say that the world was ticked while it stood in the past: it may have come to the present."""
        if self.world.clock.now >= self.newest:
            self.to_present()

    def feelings(self, identity: int, until: int, seconds: float) -> tuple[Int64s, Float64s]:
        """Return ticks (m,) and hunger, libido and fear (m, 3) of a fish in the `seconds` up to the tick `until`."""
        first = until - round(seconds * TICKS_PER_SECOND)
        ticks: list[int] = []
        felt: list[NDArray[np.uint8]] = []
        for mood in reversed(self._moods):
            if mood.tick < first:
                break
            rows = np.flatnonzero(mood.id == identity)
            if mood.tick <= until and len(rows):
                ticks.append(mood.tick)
                felt.append(mood.feeling[rows[0]])
        values = np.array(felt[::-1], np.float64).reshape(-1, len(FEELINGS)) / _FULL
        return np.array(ticks[::-1], np.int64), values

    def _keep_near(self, now: int, tick: int) -> None:
        """Take a snapshot on the last way to `tick`; the one taken longest ago goes."""
        if now % NEAR_EVERY or tick - now > MOST_NEAR * NEAR_EVERY:
            return
        self._near[now] = self.world.snapshot()
        if len(self._near) > MOST_NEAR:
            del self._near[next(iter(self._near))]

    def _feel(self) -> None:
        fish, mind = self.world.population.fish, self.world.population.mind
        rows = slice(fish.count)
        felt = np.stack((mind.hunger[rows], mind.libido[rows], mind.fear[rows]), axis=1)
        feeling = np.asarray(np.round(_FULL * np.clip(felt, 0.0, 1.0)), np.uint8)
        ids, about = fish.id[rows].copy(), mind.intention[rows].copy()
        self._moods.append(Mood(self.newest, ids, feeling, about))
        self._mood_bytes += ids.nbytes + feeling.nbytes + about.nbytes
        while self._mood_bytes > MOOD_BUDGET and len(self._moods) > 1:
            old = self._moods.popleft()
            self._mood_bytes -= old.id.nbytes + old.feeling.nbytes + old.intention.nbytes

    def _keep(self) -> None:
        """Take a snapshot; where there are too many, keep every second one and the first."""
        shot = self._shots[self.newest] = self.world.snapshot()
        self._bytes += size_of(shot)
        while (len(self._shots) > self._most or self._bytes > self._budget) and len(
            self._shots
        ) > 2:
            self._every *= 2
            kept = {at: s for at, s in self._shots.items() if at % self._every == 0}
            self._shots = {self.oldest: self._shots[self.oldest], **kept}
            self._bytes = sum(map(size_of, self._shots.values()))
