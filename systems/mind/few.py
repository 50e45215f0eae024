"""The few that are perceived from afar, sorted anew each tick: who hunts, who may be a mate, and food (FINDINGS 5)."""

from typing import NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.clock import Clock
from components.food import FoodTable
from components.ground import Terrain
from components.kernels import Launch, row
from components.senses import SenseTable
from components.table import Columns
from systems.mind.crowd import Crowd
from systems.mind.sparse import Sparse, SparseGrid, sort_sparse


class Larder(NamedTuple):
    """The columns of food by which minds find it."""

    position: Float64s
    last_position: Float64s
    returns: Int64s
    eaten_by: Int64s


class Lists(NamedTuple):
    """Scratch, (capacity,) each."""

    what: Int32s
    others: Int32s
    keys: Int32s
    x: Float64s
    y: Float64s
    z: Float64s


@row
def _list_fishes(
    number: int, crowd: Crowd, hunts: Int8s, schooling: Int8s, hunters: Int32s, willing: Int32s
) -> tuple[int, int]:
    """List, in the order of the crowd, who eats others, and who courts or would of species that do not school.

    Return how many each are; (capacity,) each.
    """
    species, ready, courting = crowd.species, crowd.ready, crowd.courting
    many = few = 0
    for k in range(number):
        hunters[many], willing[few] = k, k
        many += hunts[species[k]] != 0
        few += ((ready[k] != 0) | (courting[k] >= 0)) & (schooling[species[k]] == 0)
    return many, few


@row
def _list_edible(number: int, now: int, larder: Larder, there: Int8s, lists: Lists) -> int:
    """List the rows of the food in the water and mark it `there`, (capacity,); return how many."""
    many = 0
    for k in range(number):
        edible = larder.returns[k] <= now and larder.eaten_by[k] < 0
        there[k] = edible
        lists.what[many] = k
        many += edible
        x, y, z = larder.position[k, 0], larder.position[k, 1], larder.position[k, 2]
        lists.x[k], lists.y[k], lists.z[k] = x, y, z
    return many


@row
def sort_few(
    crowd: Crowd, fishes: int, hunts: Int8s, schooling: Int8s, larder: Larder, particles: int, now: int,
    depth: float, least: float, lists: Lists, there: Int8s, hunters: Sparse, willing: Sparse, food: Sparse,
) -> tuple[tuple[float, int, int, int], tuple[float, int, int, int], tuple[float, int, int, int]]:  # fmt: skip
    """Sort hunters, the willing and food into their room; return of each what `sort_sparse` does."""
    what, others, keys = lists.what, lists.others, lists.keys
    many, few = _list_fishes(fishes, crowd, hunts, schooling, what, others)
    x, y, z = crowd.x, crowd.y, crowd.z
    hunting = sort_sparse(hunters, depth, least, many, x, y, z, what, keys)
    courting = sort_sparse(willing, depth, least, few, x, y, z, others, keys)
    many = _list_edible(particles, now, larder, there, lists)
    edible = sort_sparse(food, depth, least, many, lists.x, lists.y, lists.z, what, keys)
    return hunting, courting, edible


class Few:
    """Scratch: the grids of the few, made anew each tick."""

    def __init__(self, terrain: Terrain, senses: SenseTable, food: FoodTable, clock: Clock) -> None:
        self.terrain, self.senses, self.food, self.clock = terrain, senses, food, clock
        self.hunters, self.willing = SparseGrid(terrain), SparseGrid(terrain)
        "the fishes that eat others, and those that may be mates of who seeks one"
        self.edible = SparseGrid(terrain)
        "the food in the water"
        self._larder = Columns(Larder, food)
        self._sort = Launch(sort_few)
        self._fit(16)

    def sort(self, crowd: Crowd, fishes: int, least: float) -> None:
        """Sort the few of a crowd of so many fishes, and the food; cells are at least `least` [m] wide."""
        particles, senses = self.food.count, self.senses
        if max(fishes, particles) > len(self.there):
            self._fit(2 * max(fishes, particles))
        hunting, courting, edible = self._sort(
            crowd, fishes, senses.hunts, senses.schooling, self._larder(), particles, self.clock.now,
            self.terrain.depth, least, self._lists, self.there, self.hunters.sparse,
            self.willing.sparse, self.edible.sparse,
        )  # fmt: skip
        self.hunters.divided(*hunting)
        self.willing.divided(*courting)
        self.edible.divided(*edible)

    @property
    def larder(self) -> Larder:
        """The columns of food."""
        return self._larder()

    def _fit(self, number: int) -> None:
        """Make room for `number` fishes or particles."""
        what, others, keys = (np.zeros(number, np.int32) for _ in range(3))
        x, y, z = (np.zeros(number) for _ in range(3))
        self._lists = Lists(what, others, keys, x, y, z)
        self.there = np.zeros(number, np.int8)
        "1 for each particle in the water, (capacity,)"
        for grid in (self.hunters, self.willing, self.edible):
            grid.fit(number)
