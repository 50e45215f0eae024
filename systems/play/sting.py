"""Sting: who swims into an anemone's tentacles and is not at home there is stung, and flees (papers/002, section 1).

A stung fish is as afraid as it can be and swims away from the anemone for some seconds, whatever it was about: a
hunter lets its prey go, which is why a clownfish among tentacles is safe. It is a reflex, and stands over the mind as
the boundaries do: it runs between think and bound. Who is after nobody and flees from nobody keeps clear of anemones.
The player's fish feels the sting and steers itself.
"""

from math import sqrt
from typing import Final, NamedTuple

from components.anemone import AnemoneTable
from components.arrays import Float32s, Float64s, Int8s, Int32s, Int64s
from components.clock import TICKS_PER_SECOND, Clock
from components.fish import Population
from components.kernels import inlined, row
from components.mind import Intention, Why
from components.senses import SenseTable
from components.sphere_grid import SphereGrid, list_spheres, sphere_grid, square_at
from components.table import Columns
from components.terrain import Terrain

STUNG_TICKS: Final = 4 * TICKS_PER_SECOND
"""[ticks] for which the sting of a tentacle is felt."""
SHUNNED: Final = 1.5
"""[m] from a cap within which a stung fish swims away from it."""

_EAT: Final = int(Intention.EAT)
_ESCAPE: Final = int(Intention.ESCAPE)
_OBEY: Final = int(Intention.OBEY)
_STUNG: Final = int(Why.STUNG)
_FAST: Final = 2
_URGENCY: Final = 0.9
_THROTTLE: Final = 1.1
_CLEAR: Final = 1.2
"""Weight of the way out, at a cap's border, against where a fish would go."""


class Feeling(NamedTuple):
    """The columns of fishes, minds and motors that stinging reads and writes."""

    species: Int32s
    length: Float64s
    position: Float64s
    rotation: Float64s
    intention: Int8s
    why: Int8s
    why_value: Float32s
    focus: Int64s
    since: Int64s
    memory: Int8s
    fear: Float64s
    danger: Float64s
    gape: Float64s
    stung_until: Int64s
    heading: Float64s
    gear: Int8s
    urgency: Float64s
    throttle: Float64s


class Caps(NamedTuple):
    """The caps of a level, and where they lie."""

    grid: SphereGrid
    "lists each cap as far as stung fishes shun it"
    centre: Float64s
    radius: Float64s
    stings: Int8s


@inlined
def touched(caps: Caps, x: float, y: float, z: float) -> bool:
    """Say whether a point [m] lies among tentacles that sting."""
    square = square_at(caps.grid, x, y)
    for at in range(caps.grid.first[square], caps.grid.first[square + 1]):
        k = caps.grid.listed[at]
        u, v, w = x - caps.centre[k, 0], y - caps.centre[k, 1], z - caps.centre[k, 2]
        if caps.stings[k] != 0 and u * u + v * v + w * w < caps.radius[k] * caps.radius[k]:
            return True
    return False


@row
def way_out(caps: Caps, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Return the sum of the directions away from the caps near a point [m], more of the nearer; 0, 0, 0 for none."""
    a, b, c = 0.0, 0.0, 0.0
    square = square_at(caps.grid, x, y)
    for at in range(caps.grid.first[square], caps.grid.first[square + 1]):
        k = caps.grid.listed[at]
        u, v, w = x - caps.centre[k, 0], y - caps.centre[k, 1], z - caps.centre[k, 2]
        far = sqrt(u * u + v * v + w * w) + 1e-9
        near = 1.0 - (far - caps.radius[k]) / SHUNNED
        if caps.stings[k] != 0 and near > 0.0:
            a, b, c = a + near * u / far, b + near * v / far, c + near * w / far
    return a, b, c


@row
def _flee(caps: Caps, i: int, feeling: Feeling, now: int) -> None:
    """Let row i flee from the tentacles that stung it."""
    feeling.fear[i] = feeling.danger[i] = 1.0
    if feeling.intention[i] == _OBEY:
        return
    if feeling.intention[i] != _ESCAPE or feeling.why[i] != _STUNG:
        feeling.since[i] = now
    feeling.intention[i], feeling.why[i] = _ESCAPE, _STUNG
    feeling.why_value[i] = feeling.stung_until[i] - now
    feeling.focus[i], feeling.memory[i], feeling.gape[i] = -1, -1, 0.0
    position, heading = feeling.position[i], feeling.heading[i]
    x, y, z = way_out(caps, position[0], position[1], position[2])
    size = sqrt(x * x + y * y + z * z)
    if size > 1e-9:
        heading[0], heading[1], heading[2] = x / size, y / size, z / size
    feeling.gear[i], feeling.urgency[i], feeling.throttle[i] = _FAST, _URGENCY, _THROTTLE


@row
def keep_clear(caps: Caps, i: int, feeling: Feeling) -> None:
    """Lean the heading of row i away from the caps near it."""
    intention = feeling.intention[i]
    if intention in (_ESCAPE, _OBEY) or (intention == _EAT and feeling.focus[i] >= 0):
        return
    position, heading = feeling.position[i], feeling.heading[i]
    x, y, z = way_out(caps, position[0], position[1], position[2])
    if x == 0.0 and y == 0.0 and z == 0.0:
        return
    x, y, z = heading[0] + _CLEAR * x, heading[1] + _CLEAR * y, heading[2] + _CLEAR * z
    size = sqrt(x * x + y * y + z * z)
    if size > 1e-6:
        heading[0], heading[1], heading[2] = x / size, y / size, z / size


@inlined
def _touches(caps: Caps, i: int, nose: float, feeling: Feeling) -> bool:
    """Say whether the nose or the middle of row i is among tentacles; the nose is `nose` [BL] ahead."""
    x, y, z = feeling.position[i, 0], feeling.position[i, 1], feeling.position[i, 2]
    if touched(caps, x, y, z):
        return True
    ahead, axes = nose * feeling.length[i], feeling.rotation[i]
    return touched(caps, x + ahead * axes[0, 0], y + ahead * axes[1, 0], z + ahead * axes[2, 0])


@inlined
def _is_far(caps: Caps, i: int, ahead: float, feeling: Feeling, now: int) -> bool:
    """Say at a glance that no anemone concerns row i, whose nose is `ahead` [m] of its middle."""
    square = square_at(caps.grid, feeling.position[i, 0], feeling.position[i, 1])
    alone = caps.grid.first[square] == caps.grid.first[square + 1]
    return bool(alone and ahead <= SHUNNED and feeling.stung_until[i] <= now)


@row
def sting_all(
    caps: Caps, at_home: Int8s, nose: Float64s, count: int, feeling: Feeling, now: int
) -> None:
    """Sting those of `count` fishes that touch tentacles, let the stung flee and others keep clear.

    `at_home`, (S,): who is never stung; `nose` [BL] from each species' origin, (S,).
    """
    for i in range(count):
        kind = feeling.species[i]
        if at_home[kind] != 0 or _is_far(caps, i, nose[kind] * feeling.length[i], feeling, now):
            continue
        if _touches(caps, i, nose[kind], feeling):
            feeling.stung_until[i] = now + STUNG_TICKS
        if feeling.stung_until[i] > now:
            _flee(caps, i, feeling, now)
        else:
            keep_clear(caps, i, feeling)


class Sting:
    """Reads anemones, senses and clock; writes minds and what they demand of the motors."""

    def __init__(
        self,
        anemones: AnemoneTable,
        population: Population,
        senses: SenseTable,
        terrain: Terrain,
        clock: Clock,
    ) -> None:
        self.anemones, self.population, self.senses = anemones, population, senses
        self.clock = clock
        self._feeling = Columns(Feeling, population.mind, population.motor, population.fish)
        reach = anemones.radius[: anemones.count] + SHUNNED
        centre = anemones.centre[: anemones.count]
        self._grid = list_spheres(sphere_grid(terrain.radius), centre, reach)

    def __call__(self) -> None:
        """Sting and let flee."""
        anemones, people = self.anemones, self.population
        if anemones.count:
            caps = Caps(self._grid, anemones.centre, anemones.radius, anemones.stings)
            feeling, senses = self._feeling(), self.senses
            now, count = self.clock.now, people.count
            sting_all(caps, senses.at_home, senses.nose, count, feeling, now)
