"""Hold: tentacles hold a small fish that touches them, carry it to the mouth, and the anemone eats it (papers/002, 1).

One fish at a time: of those that touch at once the one of the lowest id. It struggles, as the stung do, but for some
seconds it is drawn to the middle; then it is gone, replaced as one that a hunter ate, and the anemone digests.
"""

from typing import Final, NamedTuple

import numpy as np

from components.anemone import AnemoneTable
from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.clock import TICKS_PER_SECOND, Clock
from components.fish import Population
from components.index import Places, row_of
from components.kernels import inlined, row
from components.senses import SenseTable
from components.sphere_grid import SphereGrid, empty, list_spheres, sphere_grid, square_at
from components.table import Columns
from components.terrain import Terrain, berth, confine
from systems.play.spawn import Spawn

HOLD_TICKS: Final = 4 * TICKS_PER_SECOND
"""[ticks] from being touched to being gone."""
DIGEST_TICKS: Final = 30 * TICKS_PER_SECOND
"""[ticks] after a meal in which tentacles sting and hold nobody."""

_PULL: Final = 0.06
"""Part of the way to the middle that a tick draws the held."""


class Tentacles(NamedTuple):
    """The columns of anemones; units and shapes stand in `AnemoneTable`."""

    centre: Float64s
    radius: Float64s
    holds: Float64s
    prey: Int64s
    since: Int64s
    sated_until: Int64s


class Victims(NamedTuple):
    """The columns of fishes and minds that holding reads and writes."""

    id: Int64s
    species: Int32s
    length: Float64s
    position: Float64s
    swallowed_by: Int64s


@inlined
def _is_held(tentacles: Tentacles, grid: SphereGrid, square: int, identity: int) -> bool:
    held = False
    for at in range(grid.first[square], grid.first[square + 1]):
        held |= tentacles.prey[grid.listed[at]] == identity
    return held


@row
def take(
    tentacles: Tentacles,
    grid: SphereGrid,
    at_home: Int8s,
    count: int,
    victims: Victims,
    now: int,
) -> None:
    """Let each anemone that holds nothing take hold of a small fish among its tentacles."""
    for i in range(count):
        if at_home[victims.species[i]] != 0 or victims.swallowed_by[i] >= 0:
            continue
        x, y, z = victims.position[i, 0], victims.position[i, 1], victims.position[i, 2]
        square = square_at(grid, x, y)
        if _is_held(tentacles, grid, square, victims.id[i]):
            continue
        for at in range(grid.first[square], grid.first[square + 1]):
            k = grid.listed[at]
            if victims.length[i] > tentacles.holds[k] or now < tentacles.sated_until[k]:
                continue
            u, v = x - tentacles.centre[k, 0], y - tentacles.centre[k, 1]
            w, far = z - tentacles.centre[k, 2], tentacles.radius[k]
            if u * u + v * v + w * w >= far * far:
                continue
            held, fresh = tentacles.prey[k], tentacles.since[k] == now
            if held < 0 or (fresh and victims.id[i] < held):
                tentacles.prey[k], tentacles.since[k] = victims.id[i], now
                break


@row
def draw_in(
    tentacles: Tentacles,
    number: int,
    terrain: Terrain,
    places: Places,
    victims: Victims,
    now: int,
    eaten: Int64s,
) -> int:
    """Draw the held to the middle, write the ids of those whose time is over into `eaten`; return their number."""
    many = 0
    for k in range(number):
        i = row_of(places, tentacles.prey[k])
        if i < 0:
            tentacles.prey[k] = -1
            continue
        for axis in range(3):
            way = tentacles.centre[k, axis] - victims.position[i, axis]
            victims.position[i, axis] += _PULL * way
        confine(terrain, victims.position, i, berth(victims.length[i]))
        if now - tentacles.since[k] >= HOLD_TICKS:
            eaten[many], many = victims.id[i], many + 1
            tentacles.prey[k], tentacles.sated_until[k] = -1, now + DIGEST_TICKS
    return many


class Hold:
    """Reads senses, terrain and clock; writes anemones, the held fishes' position, and through spawn the population."""

    def __init__(
        self,
        anemones: AnemoneTable,
        population: Population,
        senses: SenseTable,
        terrain: Terrain,
        spawn: Spawn,
        clock: Clock,
    ) -> None:
        self.anemones, self.population, self.senses = anemones, population, senses
        self.terrain, self.spawn, self.clock = terrain, spawn, clock
        number = anemones.count
        reach = np.where(anemones.holds[:number] > 0.0, anemones.radius[:number], 0.0)
        self._grid = list_spheres(sphere_grid(terrain.radius), anemones.centre[:number], reach)
        self._tentacles = Columns(Tentacles, anemones)
        self._victims = Columns(Victims, population.fish, population.mind)
        self._eaten = np.zeros(number, np.int64)

    def __call__(self) -> None:
        """Take hold, draw in and eat."""
        number, people, now = self.anemones.count, self.population, self.clock.now
        if empty(self._grid):
            return
        tentacles, victims = self._tentacles(), self._victims()
        places = people.index.places
        take(tentacles, self._grid, self.senses.at_home, people.count, victims, now)
        many = draw_in(tentacles, number, self.terrain, places, victims, now, self._eaten)
        for identity in sorted(self._eaten[:many].tolist()):
            self.spawn.lose(identity)
