"""Bound: the sense of territory (papers/000, 6.2).

At each tick every fish is tested against ground, rocks, surface and the world's cylinder, where it is and where it
will be; within a distance it is steered inward, whatever its mind wants. `confine`, which move calls, is the hard
guarantee; this is what makes it seldom needed.
"""

from math import sqrt
from typing import Final, NamedTuple

import numba

from components.arrays import Float64s, Int32s
from components.fish import Population
from components.ground import Terrain, clearance, is_clear
from components.kernels import Launch, inlined, loop, row
from components.senses import SenseTable
from components.table import Columns
from components.vector import point

PIECES: Final = 64
SERIAL_BELOW: Final = 500

_ROOM: Final = 0.75
_INWARD: Final = 0.9
_AHEAD_SECONDS: Final = 0.4
_SAFELY: Final = 1.4
_PRESSING: Final = 0.85
"""A boundary is pressing, yet no matter of life and death: nobody makes a fast start into open water."""


class Bounded(NamedTuple):
    """The columns that bounding reads and writes, row for row."""

    species: Int32s
    length: Float64s
    position: Float64s
    last_position: Float64s
    rotation: Float64s
    heading: Float64s
    urgency: Float64s


@inlined
def turn_inward(
    terrain: Terrain, x: float, y: float, z: float, room: float, heading: Float64s
) -> float:
    """Turn the unit `heading`, (3,), inward where (x, y, z) is within `room` [m] of a boundary.

    Return how near it is: 0 at `room` or beyond, 1 at contact.
    """
    d, nx, ny, nz = clearance(terrain, x, y, z, room)
    if d >= room:
        return 0.0
    near = min(1.0 - d / room, 1.0)
    lack = _INWARD * near - (heading[0] * nx + heading[1] * ny + heading[2] * nz)
    if lack > 0.0:
        point(heading, heading[0] + lack * nx, heading[1] + lack * ny, heading[2] + lack * nz)
    return near


@inlined
def _place_ahead(swimmers: Bounded, i: int, ahead: float) -> tuple[float, float, float]:
    """Return the place [m] that is `ahead` [m] of row i."""
    return (
        swimmers.position[i, 0] + ahead * swimmers.rotation[i, 0, 0],
        swimmers.position[i, 1] + ahead * swimmers.rotation[i, 1, 0],
        swimmers.position[i, 2] + ahead * swimmers.rotation[i, 2, 0],
    )


@inlined
def _look_out(swimmers: Bounded, i: int) -> float:
    """Return how far [m] ahead of its middle row i looks out: half its length and where its speed takes it."""
    dx = swimmers.position[i, 0] - swimmers.last_position[i, 0]
    dy = swimmers.position[i, 1] - swimmers.last_position[i, 1]
    dz = swimmers.position[i, 2] - swimmers.last_position[i, 2]
    speed = 60.0 * _AHEAD_SECONDS * sqrt(dx * dx + dy * dy + dz * dz)
    return 0.5 * float(swimmers.length[i]) + speed


@row
def _bound_one(
    terrain: Terrain, i: int, ahead: float, room: float, wide: float, swimmers: Bounded
) -> None:
    """Bound row i, unless all is farther than `wide` [m] from halfway to where it looks."""
    x, y, z = _place_ahead(swimmers, i, 0.5 * ahead)
    if clearance(terrain, x, y, z, wide)[0] > wide:
        return
    heading = swimmers.heading[i]
    x, y, z = _place_ahead(swimmers, i, ahead)
    there = turn_inward(terrain, x, y, z, room, heading)
    x, y, z = _place_ahead(swimmers, i, 0.0)
    here = turn_inward(terrain, x, y, z, room, heading)
    swimmers.urgency[i] = max(swimmers.urgency[i], min(max(here, there), _PRESSING))


@row
def bound_some(terrain: Terrain, girth: Float64s, begin: int, end: int, swimmers: Bounded) -> None:
    """Bound the fishes of rows begin..end."""
    for i in range(begin, end):
        ahead = _look_out(swimmers, i)
        room = (_ROOM + girth[swimmers.species[i]]) * swimmers.length[i]
        wide = room + _SAFELY * 0.5 * ahead
        x, y, z = _place_ahead(swimmers, i, 0.5 * ahead)
        # A call hands over the whole terrain: most fishes need none.
        if not is_clear(terrain, x, y, z, wide):
            _bound_one(terrain, i, ahead, room, wide, swimmers)


@loop
def bound_all(terrain: Terrain, girth: Float64s, number: int, swimmers: Bounded) -> None:
    """Bound all fishes, on all threads."""
    for piece in numba.prange(PIECES):
        begin, end = number * piece // PIECES, number * (piece + 1) // PIECES
        bound_some(terrain, girth, begin, end, swimmers)


class Bound:
    """Reads fishes, senses and terrain; overrides the motors' heading and raises their urgency."""

    def __init__(self, population: Population, senses: SenseTable, terrain: Terrain) -> None:
        self.population, self.senses, self.terrain = population, senses, terrain
        self.columns = Columns(Bounded, population.fish, population.motor)
        self._bound_some, self._bound_all = Launch(bound_some), Launch(bound_all)

    def __call__(self) -> None:
        """Turn inward whoever is near a boundary."""
        number, swimmers = self.population.count, self.columns()
        if number < SERIAL_BELOW:
            self._bound_some(self.terrain, self.senses.girth, 0, number, swimmers)
        else:
            self._bound_all(self.terrain, self.senses.girth, number, swimmers)
