"""What is seen of a scene: ten samples a second of every fish, which measures and plots read.

Arrays hold T samples of N fishes, whoever lived at any time, rising by id; NaN and -1 where one does not live.
"""

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from components.arrays import AnyArray, Float64s, Int8s, Int64s
from components.clock import TICKS_PER_SECOND
from components.kernels import row
from components.terrain import Terrain, clearance
from reefgame.world import World

SAMPLE_EVERY: Final = 6
"""[ticks] between samples."""

_FLOATS: Final = ("hunger", "libido", "fear")
_WHOLE: Final = ("intention", "courtship", "focus", "ate_at", "mated_at")


@dataclass(frozen=True)
class Observation:
    """A scene that was watched."""

    groups: tuple[str, ...]
    "names of the groups of fishes"
    seconds: Float64s
    "[s] of the samples, (T,)"
    id: Int64s
    "(N,)"
    group: Int64s
    "which group each belongs to, (N,)"
    length: Float64s
    "[m], (N,)"
    cruise: Float64s
    "[m/s] in medium gear, (N,)"
    fast: Float64s
    "[m/s] in fast gear, (N,)"
    box: Float64s
    "half length, half height, half width [m] of the body, (N, 3)"
    middle: Float64s
    "[m] from the origin forward to the body's middle, (N,)"
    position: Float64s
    "[m], (T, N, 3)"
    rotation: Float64s
    "columns are the body's axes in world axes, (T, N, 3, 3)"
    hunger: Float64s
    "(T, N)"
    libido: Float64s
    "(T, N)"
    fear: Float64s
    "(T, N)"
    intention: Int8s
    "(T, N)"
    courtship: Int8s
    "(T, N)"
    focus: Int64s
    "as `MindTable.focus`, (T, N)"
    ate_at: Int64s
    "tick of the last bite, (T, N)"
    mated_at: Int64s
    "tick of the last mating, (T, N)"
    clear: Float64s
    "[m] least distance of the origin to ground, rocks, rim and surface in any tick since the last sample, (T, N)"
    submarine: Float64s
    "[m], (T, 3); NaN for none"
    terrain: Terrain
    "where it was"

    def of(self, group: str) -> Int64s:
        """Return the columns of a group."""
        return np.flatnonzero(self.group == self.groups.index(group))

    def after(self, seconds: float) -> "Observation":
        """Return what was seen from a time [s] on."""
        late = self.seconds >= seconds
        varying = {
            name: value[late]
            for name, value in vars(self).items()
            if isinstance(value, np.ndarray) and len(value) == len(late) and name in _TIMED
        }
        return Observation(**{**vars(self), **varying})


_TIMED: Final = {
    "seconds", "position", "rotation", "clear", "submarine", *_FLOATS, *_WHOLE,
}  # fmt: skip
_OF_ALL: Final = {"seconds", "submarine"}


@row
def _keep_least(terrain: Terrain, number: int, position: Float64s, least: Float64s) -> None:
    """Keep the least clearance [m] of each origin since it was reset, (n,)."""
    for i in range(number):
        d = clearance(terrain, position[i, 0], position[i, 1], position[i, 2])[0]
        least[i] = min(least[i], d)


class Observer:
    """Samples a world after each tick."""

    def __init__(self, world: World, groups: tuple[str, ...]) -> None:
        self.world, self.groups = world, groups
        self._samples: list[dict[str, Any]] = []
        self._least: Float64s = np.full(0, np.inf)

    def __call__(self) -> None:
        """See what the tick has brought."""
        world = self.world
        fish, number = world.population.fish, world.population.count
        if len(self._least) != number:
            # Rows are not followed across removals: the sample that follows is the shorter.
            self._least = np.full(number, np.inf)
        _keep_least(world.terrain, number, fish.position, self._least)
        if world.clock.now % SAMPLE_EVERY == 0:
            self._sample()
            self._least = np.full(number, np.inf)

    def _sample(self) -> None:
        world = self.world
        fish, mind = world.population.fish, world.population.mind
        sub = world.submarine
        nowhere = np.full(3, np.nan)
        self._samples.append(
            {
                "now": np.array(world.clock.now),
                "submarine": sub.position[0].copy() if sub.count else nowhere,
                "clear": self._least,
                **{name: fish.live(name).copy() for name in ("id", "cohort", "species", "length")},
                **{name: fish.live(name).copy() for name in ("position", "rotation")},
                **{name: mind.live(name).copy() for name in (*_FLOATS, *_WHOLE)},
            }
        )

    def observation(self) -> Observation:
        """Return what was seen, aligned by id."""
        samples, world = self._samples, self.world
        ids = np.unique(np.concatenate([s["id"] for s in samples]))
        cohort, species, length = (_fixed(samples, ids, n) for n in ("cohort", "species", "length"))
        timed: dict[str, Any] = {n: _aligned(samples, ids, n) for n in _TIMED - _OF_ALL}
        box, middle = self._bodies(species)
        speed = world.senses.speed[species] * length[:, None]
        return Observation(
            groups=self.groups,
            seconds=np.array([int(s["now"]) / TICKS_PER_SECOND for s in samples]),
            id=ids,
            group=cohort.astype(np.int64),
            length=length,
            cruise=speed[:, 1],
            fast=speed[:, 2],
            box=box * length[:, None],
            middle=middle * length,
            submarine=np.array([s["submarine"] for s in samples]),
            terrain=world.terrain,
            **timed,
        )

    def _bodies(self, species: Any) -> tuple[Float64s, Float64s]:
        """Return half extents (N, 3) and the middle ahead of the origin (N,), in body lengths."""
        kinds = [kind.body for kind in self.world.species]
        box = np.array([(0.5, max(b.half_height), max(b.half_width)) for b in kinds])
        middle = np.array([b.station[1] - 0.5 for b in kinds])
        return box[species], middle[species]


def _fixed(samples: list[dict[str, Any]], ids: AnyArray, name: str) -> Any:
    """Return what does not change, (N,)."""
    column = np.zeros(len(ids), samples[0][name].dtype)
    for sample in samples:
        column[np.searchsorted(ids, sample["id"])] = sample[name]
    return column


def _aligned(samples: list[dict[str, Any]], ids: AnyArray, name: str) -> AnyArray:
    first = samples[0][name]
    empty = np.nan if first.dtype.kind == "f" else -1
    out = np.full((len(samples), len(ids), *first.shape[1:]), empty, first.dtype)
    for at, sample in enumerate(samples):
        out[at, np.searchsorted(ids, sample["id"])] = sample[name]
    return out
