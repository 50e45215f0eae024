"""Feed: open mouths suck in what they are about and swallow it (papers/004, eating and ingesting).

A mouth that the mind has opened claims the prey or particle that it attends to, once it is near enough to the nose;
of several mouths the nearest has it. For a fifth of a second the victim is drawn to the mouth, whatever it does
itself; then it is gone, and its grams are in the stomach. Who is sucked in lets go of what it had in its mouth.
"""

from math import sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.clock import TICKS_PER_SECOND, Clock
from components.fish import Population
from components.food import FoodTable, PatchTable, in_stomach
from components.index import Places, row_of
from components.kernels import Launch, inlined, row
from components.mind import FOOD, Intention
from components.senses import FISH_GRAMS, SWALLOWED, SenseTable
from components.table import Columns
from systems.play.spawn import Spawn

SUCK_TICKS: Final = TICKS_PER_SECOND // 5
"""[ticks] in which a victim is drawn to the mouth, at the most."""
OPEN: Final = 0.5
"""Gape from which a mouth sucks in."""

_EAT: Final = int(Intention.EAT)
_OBEY: Final = int(Intention.OBEY)


class Mouths(NamedTuple):
    """The columns of fishes and minds that feeding reads and writes."""

    id: Int64s
    species: Int32s
    length: Float64s
    position: Float64s
    last_position: Float64s
    rotation: Float64s
    last_rotation: Float64s
    intention: Int8s
    focus: Int64s
    gape: Float64s
    swallowed_by: Int64s
    eaten: Float64s
    ate_at: Int64s


class Larder(NamedTuple):
    """The columns of food and patches."""

    position: Float64s
    last_position: Float64s
    meal: Float64s
    patch: Int32s
    returns: Int64s
    eaten_by: Int64s
    returns_after: Int64s


@inlined
def _mouth(
    position: Float64s, rotation: Float64s, i: int, ahead: float
) -> tuple[float, float, float]:
    """Return the nose [m] of row i, `ahead` [m] of its origin."""
    return (
        position[i, 0] + ahead * rotation[i, 0, 0],
        position[i, 1] + ahead * rotation[i, 1, 0],
        position[i, 2] + ahead * rotation[i, 2, 0],
    )


@row
def draw_in(
    mouths: Mouths, eater: int, senses: SenseTable, place: Float64s, last: Float64s
) -> bool:
    """Draw what was at `last` (3,) a tick ago to the eater's mouth; return whether it is in."""
    kind, length = mouths.species[eater], mouths.length[eater]
    ahead = senses.nose[kind] * length
    x, y, z = _mouth(mouths.position, mouths.rotation, eater, ahead)
    u, v, w = _mouth(mouths.last_position, mouths.last_rotation, eater, ahead)
    u, v, w = last[0] - u, last[1] - v, last[2] - w
    gap = sqrt(u * u + v * v + w * w)
    step = senses.mouth[kind] * length / SUCK_TICKS
    left = max(1.0 - step / gap, 0.0) if gap > step else 0.0
    place[0], place[1], place[2] = x + left * u, y + left * v, z + left * w
    return left == 0.0


@row
def fill(mouths: Mouths, eater: int, senses: SenseTable, grams: float, now: int) -> None:
    """Add a bite to the eater's stomach."""
    kind = mouths.species[eater]
    left = in_stomach(mouths.eaten[eater], mouths.ate_at[eater], now, senses.digestion[kind])
    mouths.eaten[eater] = left + grams / senses.meal[kind]
    mouths.ate_at[eater] = now


@row
def list_held(mouths: Mouths, count: int, places: Places, held: Int64s, holder: Int64s) -> int:
    """List the rows of who is in a mouth and of who holds each, -1 where that has let go; return their number."""
    many = 0
    for i in range(count):
        if mouths.swallowed_by[i] >= 0:
            eater = row_of(places, mouths.swallowed_by[i])
            if eater >= 0 and mouths.swallowed_by[eater] >= 0:
                eater = -1
            held[many], holder[many], many = i, eater, many + 1
    return many


@row
def suck_fishes(
    mouths: Mouths,
    many: int,
    senses: SenseTable,
    now: int,
    held: Int64s,
    holder: Int64s,
    busy: Int8s,
    swallowed: Int64s,
) -> int:
    """Draw in the `many` fishes that are held, and write the ids of those that are in; return their number.

    `busy`, (count,), is told whose mouth is full.
    """
    number = 0
    for at in range(many):
        i, eater = held[at], holder[at]
        if eater < 0:
            mouths.swallowed_by[i] = -1
            continue
        busy[eater] = 1
        if draw_in(mouths, eater, senses, mouths.position[i], mouths.last_position[i]):
            grams = FISH_GRAMS * mouths.length[i] * mouths.length[i] * mouths.length[i]
            fill(mouths, eater, senses, grams, now)
            swallowed[number] = mouths.id[i]
            number += 1
    return number


@row
def suck_food(
    mouths: Mouths,
    larder: Larder,
    count: int,
    places: Places,
    senses: SenseTable,
    now: int,
    busy: Int8s,
) -> None:
    """Draw in the particles that are held; those that are in are gone until they return."""
    for k in range(count):
        if larder.eaten_by[k] < 0:
            continue
        eater = row_of(places, larder.eaten_by[k])
        if eater < 0 or mouths.swallowed_by[eater] >= 0:
            larder.eaten_by[k] = -1
            continue
        busy[eater] = 1
        for axis in range(3):
            larder.last_position[k, axis] = larder.position[k, axis]
        if draw_in(mouths, eater, senses, larder.position[k], larder.last_position[k]):
            fill(mouths, eater, senses, larder.meal[k], now)
            larder.eaten_by[k] = -1
            larder.returns[k] = now + 1 + larder.returns_after[larder.patch[k]]


@inlined
def _reach(mouths: Mouths, eater: int, senses: SenseTable, at: Float64s) -> float:
    """Return how far [m] a place (3,) is from the eater's nose."""
    ahead = senses.nose[mouths.species[eater]] * mouths.length[eater]
    x, y, z = _mouth(mouths.position, mouths.rotation, eater, ahead)
    x, y, z = at[0] - x, at[1] - y, at[2] - z
    return sqrt(x * x + y * y + z * z)


@row
def _edible(
    mouths: Mouths, i: int, larder: Larder, food: int, places: Places, senses: SenseTable, now: int
) -> bool:
    """Say whether what row i attends to is free to be claimed by it, and near enough to its mouth."""
    focus, kind, length = mouths.focus[i], mouths.species[i], mouths.length[i]
    reach = senses.mouth[kind] * length
    if focus >= 0:
        prey = row_of(places, focus)
        if prey < 0 or mouths.swallowed_by[prey] >= 0:
            return False
        fits = mouths.length[prey] <= SWALLOWED * length
        eats = senses.eats[kind, mouths.species[prey]] != 0
        return bool(fits and eats and _reach(mouths, i, senses, mouths.position[prey]) <= reach)
    k = FOOD - focus
    if k < 0 or k >= food or larder.returns[k] > now or larder.eaten_by[k] >= 0:
        return False
    return bool(senses.grazes[kind] and _reach(mouths, i, senses, larder.position[k]) <= reach)


@row
def _claim(
    mouths: Mouths, i: int, places: Places, senses: SenseTable, holder: Int64s, at: Float64s
) -> None:
    """Make row i the holder (1,) of what is at a place, if it is nearer than who claimed it this tick."""
    if holder[0] >= 0:
        other = row_of(places, holder[0])
        mine, its = _reach(mouths, i, senses, at), _reach(mouths, other, senses, at)
        if its < mine or (its == mine and holder[0] < mouths.id[i]):
            return
    holder[0] = mouths.id[i]


@row
def open_mouths(
    mouths: Mouths,
    count: int,
    larder: Larder,
    food: int,
    places: Places,
    senses: SenseTable,
    now: int,
    busy: Int8s,
    claims: Int64s,
) -> None:
    """Let every open, empty mouth claim what it attends to; the nearest has it, then the lowest id.

    `claims` (count,) is scratch: first who can claim is found, while nobody has yet.
    """
    number = 0
    for i in range(count):
        about = mouths.intention[i]
        if (about != _EAT and about != _OBEY) or mouths.gape[i] <= OPEN or busy[i]:
            continue
        if mouths.swallowed_by[i] < 0 and _edible(mouths, i, larder, food, places, senses, now):
            claims[number] = i
            number += 1
    for at in range(number):
        i = claims[at]
        focus = mouths.focus[i]
        if focus >= 0:
            prey = row_of(places, focus)
            holder = mouths.swallowed_by[prey : prey + 1]
            _claim(mouths, i, places, senses, holder, mouths.position[prey])
        else:
            k = FOOD - focus
            holder = larder.eaten_by[k : k + 1]
            _claim(mouths, i, places, senses, holder, larder.position[k])


@row
def ingest(
    mouths: Mouths,
    count: int,
    larder: Larder,
    food: int,
    places: Places,
    senses: SenseTable,
    now: int,
    held: Int64s,
    holder: Int64s,
    busy: Int8s,
    swallowed: Int64s,
) -> int:
    """Draw in who and what is held, then let open mouths claim; write who is in and return their number.

    `held`, `holder` and `busy` (count,) are scratch. One kernel, for handing over a hundred columns takes longer
    than the rest.
    """
    busy[:count] = 0
    many = list_held(mouths, count, places, held, holder)
    number = suck_fishes(mouths, many, senses, now, held, holder, busy, swallowed)
    suck_food(mouths, larder, food, places, senses, now, busy)
    open_mouths(mouths, count, larder, food, places, senses, now, busy, held)
    return number


class Feed:
    """Reads senses, patches and clock; writes food, fishes, minds, and through spawn the population."""

    def __init__(
        self,
        population: Population,
        food: FoodTable,
        patches: PatchTable,
        senses: SenseTable,
        spawn: Spawn,
        clock: Clock,
    ) -> None:
        self.population, self.food, self.patches = population, food, patches
        self.senses, self.spawn, self.clock = senses, spawn, clock
        self._mouths = Columns(Mouths, population.fish, population.mind)
        self._larder = Columns(Larder, food, patches)
        self._ingest = Launch(ingest)
        self._room(16)

    def __call__(self) -> None:
        """Let mouths suck, and those who are swallowed leave the world."""
        now, count, food = self.clock.now, self.population.count, self.food.count
        if count > len(self._held):
            self._room(2 * count)
        larder, mouths = self._larder(), self._mouths()
        places = self.population.index.places
        scratch = self._held, self._holder, self._busy, self._swallowed
        number = self._ingest(mouths, count, larder, food, places, self.senses, now, *scratch)
        if number:
            for identity in sorted(self._swallowed[:number].tolist()):
                self.spawn.lose(identity)

    def _room(self, capacity: int) -> None:
        self._held = np.zeros(capacity, np.int64)
        self._holder = np.zeros(capacity, np.int64)
        self._swallowed = np.zeros(capacity, np.int64)
        self._busy = np.zeros(capacity, np.int8)
