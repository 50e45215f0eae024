"""The few that are perceived from afar, sorted anew each tick: who hunts, who may be a mate, and food (FINDINGS 5)."""

from typing import NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.food import FoodTable
from components.ground import Terrain
from components.kernels import row
from components.senses import SenseTable
from components.table import Columns
from systems.mind.crowd import Crowd
from systems.mind.sparse import Sparse, divided, make_sparse, sort_sparse


class Larder(NamedTuple):
    """The columns of food by which minds find it."""

    position: Float64s
    last_position: Float64s
    returns: Int64s
    eaten_by: Int64s


class Room(NamedTuple):
    """Where the few are sorted, and scratch for it; (capacity,) each."""

    hunters: Sparse
    "the fishes of species that eat others"
    willing: Sparse
    "the fishes that court or would answer a mate, of species that do not school"
    food: Sparse
    "the food in the water"
    there: Int8s
    "1 for each particle in the water"
    what: Int32s
    others: Int32s
    keys: Int32s
    x: Float64s
    y: Float64s
    z: Float64s


@row
def _list_fishes(
    crowd: Crowd, hunts: Int8s, schooling: Int8s, hunters: Int32s, willing: Int32s
) -> tuple[int, int]:
    """List, in the order of the crowd, who of those copied eats others, and who courts or would and does not school.

    Return how many each are; (capacity,) each.
    """
    species, ready, courting = crowd.species, crowd.ready, crowd.courting
    many = few = 0
    for k in range(crowd.stretch[0], crowd.stretch[1]):
        hunters[many], willing[few] = k, k
        many += hunts[species[k]] != 0
        few += ((ready[k] != 0) | (courting[k] >= 0)) & (schooling[species[k]] == 0)
    return many, few


@row
def _list_edible(number: int, now: int, larder: Larder, room: Room) -> int:
    """List the rows of the food in the water and mark it `there`; return how many."""
    many = 0
    for k in range(number):
        edible = larder.returns[k] <= now and larder.eaten_by[k] < 0
        room.there[k] = edible
        room.what[many] = k
        many += edible
        x, y, z = larder.position[k, 0], larder.position[k, 1], larder.position[k, 2]
        room.x[k], room.y[k], room.z[k] = x, y, z
    return many


@row
def sort_few(
    crowd: Crowd, fishes: int, hunters: int, senses: SenseTable, larder: Larder, particles: int, now: int,
    depth: float, least: float, room: Room,
) -> tuple[Sparse, Sparse, Sparse]:  # fmt: skip
    """Sort the hunters and willing copied, and the food in the water, into their room; return them in this order.

    There are `fishes` in all, of whom `hunters` eat others. Cells are at least `least` [m] wide; `depth` [m] is the
    world's.
    """
    what, others, keys = room.what, room.others, room.keys
    copied = max(crowd.stretch[1] - crowd.stretch[0], 1)
    many, few = _list_fishes(crowd, senses.hunts, senses.schooling, what, others)
    x, y, z = crowd.x, crowd.y, crowd.z
    hunting = sort_sparse(room.hunters, depth, least, many, hunters, x, y, z, what, keys)
    for k in range(many):
        # Many a mind looks at all of these, who stand far apart in the crowd.
        hunter = room.hunters.what[k]
        room.hunters.size[k], room.hunters.kind[k] = crowd.length[hunter], crowd.species[hunter]
    courting = sort_sparse(
        room.willing, depth, least, few, few * fishes // copied, x, y, z, others, keys
    )
    many = _list_edible(particles, now, larder, room)
    edible = sort_sparse(room.food, depth, least, many, many, room.x, room.y, room.z, what, keys)
    return (
        divided(room.hunters, hunting), divided(room.willing, courting), divided(room.food, edible)
    )  # fmt: skip


class Few:
    """Scratch: room for the few."""

    def __init__(self, terrain: Terrain, food: FoodTable) -> None:
        self.terrain, self.food = terrain, food
        self._larder = Columns(Larder, food)
        self._fit(16)

    def larder(self) -> Larder:
        """Return the columns of food; stale when its table grows."""
        return self._larder()

    def prepare(self, fishes: int) -> None:
        """Make room for so many fishes, and for the food that there is."""
        number = max(fishes, self.food.count)
        if number > len(self.room.there):
            self._fit(2 * number)

    def _fit(self, number: int) -> None:
        hunters, willing, food = (make_sparse(self.terrain, number) for _ in range(3))
        what, others, keys = (np.zeros(number, np.int32) for _ in range(3))
        x, y, z = (np.zeros(number) for _ in range(3))
        there = np.zeros(number, np.int8)
        self.room = Room(hunters, willing, food, there, what, others, keys, x, y, z)
