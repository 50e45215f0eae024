"""Drift: the flow carries food and fishes (papers/002, section 2: one field for all that the water moves).

Food goes with the water, besides its patch's own drift, and stays in its patch's ball: who leaves it comes back on the
other side, or, where the flow would push it out there too, anywhere in it. A fish holds its place against what it swims
at cruise without effort; what is faster carries it off. Nothing is carried out of the world, into ground or into rock.
It runs between move and feed, so that what is drawn between two ticks, and what fishes see of each other's speed, holds
the way that the water gave.
"""

from math import sqrt
from typing import Final, NamedTuple

import numba
import numpy as np

from components import chance
from components.arrays import Float64s, Int32s, Int64s
from components.clock import TICK_SECONDS, Clock
from components.field import Field, field_of, flow_near
from components.fish import Population
from components.food import FoodTable, PatchTable
from components.kernels import Launch, inlined, loop, row
from components.scatter import place
from components.senses import SenseTable
from components.singularity import SingularityTable
from components.sphere_grid import (
    SphereGrid,
    empty,
    fill_lists,
    list_spheres,
    lists_none,
    sphere_grid,
)
from components.table import Columns
from components.terrain import Terrain, berth, confine

FASTEST: Final = 4.0
"""[m/s] at which the flow carries anything, however strong it is."""

_CRUISE: Final = 1
"""Row of `SenseTable.speed`: the medium gear's."""
_BERTH: Final = 0.03
_CONFINE_EVERY: Final = 16
_PIECES: Final = 16
_SERIAL_BELOW: Final = 8192
"""Particles that one thread carries sooner than it would wake the others."""
_FEW_FISHES: Final = 500


class Water(NamedTuple):
    """The flow at a tick, as drifting reads it."""

    field: Field
    grid: SphereGrid
    tick: int


class Plankton(NamedTuple):
    """The columns of food and patches that drifting reads and writes."""

    position: Float64s
    last_position: Float64s
    patch: Int32s
    returns: Int64s
    eaten_by: Int64s
    around: Float64s
    within: Float64s
    drift: Float64s


class Carried(NamedTuple):
    """The columns of fishes that drifting reads and writes."""

    species: Int32s
    length: Float64s
    position: Float64s


@row
def _push_near(water: Water, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Return what `push` does, having asked what is near."""
    u, v, w = flow_near(water.field, water.grid, water.tick, x, y, z)
    size = sqrt(u * u + v * v + w * w)
    if size <= FASTEST:
        return u, v, w
    scale = FASTEST / size
    u, v, w = scale * u, scale * v, scale * w
    if not u * u + v * v + w * w <= 2.0 * FASTEST * FASTEST:
        return 0.0, 0.0, 0.0
    return u, v, w


@inlined
def push(water: Water, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Return the velocity [m/s] at which the flow carries what is at a point [m]: finite, at most `FASTEST`."""
    # Most of a sea is still, and a call hands over the whole field.
    if lists_none(water.grid, x, y):
        return 0.0, 0.0, 0.0
    return _push_near(water, x, y, z)


@row
def appear(
    terrain: Terrain,
    seed: int,
    now: int,
    particle: int,
    around: Float64s,
    within: float,
    position: Float64s,
) -> None:
    """Put a particle anywhere in the free water of the ball `within` [m] of `around`, into position[particle]."""
    place(seed, chance.FOOD_PLACE, now, particle, around, within, position[particle])
    confine(terrain, position, particle, _BERTH)


@inlined
def _leaves(
    p: Float64s, around: Float64s, within: float, u: float, v: float, w: float
) -> tuple[bool, float]:
    """Say whether what is at p (3,) and moves by (u, v, w) leaves the ball; return also how far along [m^2/s]."""
    x, y, z = p[0] - around[0], p[1] - around[1], p[2] - around[2]
    along = x * u + y * v + z * w
    return along > 0.0 and x * x + y * y + z * z > within * within, along


@inlined
def carry(p: Float64s, around: Float64s, within: float, u: float, v: float, w: float) -> bool:
    """Move a particle's place p (3,) by a tick of (u, v, w) [m/s]; return whether it came back on the other side."""
    beyond, along = _leaves(p, around, within, u, v, w)
    step = TICK_SECONDS
    if beyond:
        step = -2.0 * along / (u * u + v * v + w * w)
    p[0] += step * u
    p[1] += step * v
    p[2] += step * w
    return beyond


@inlined
def _drift_one(
    terrain: Terrain, water: Water, seed: int, k: int, plankton: Plankton
) -> tuple[bool, bool]:
    """Carry particle k; return whether it came back into its ball, and whether there was a flow."""
    patch, p = plankton.patch[k], plankton.position[k]
    around, within, drift = plankton.around[patch], plankton.within[patch], plankton.drift[patch]
    u, v, w = push(water, p[0], p[1], p[2])
    flows = u != 0.0 or v != 0.0 or w != 0.0
    back = carry(p, around, within, u + drift[0], v + drift[1], w + drift[2])
    if back:
        u, v, w = push(water, p[0], p[1], p[2])
        if u != 0.0 or v != 0.0 or w != 0.0:
            flows = True
            if _leaves(p, around, within, u + drift[0], v + drift[1], w + drift[2])[0]:
                appear(terrain, seed, water.tick, k, around, within, plankton.position)
    return back, flows


@row
def drift_some(
    terrain: Terrain, water: Water, seed: int, plankton: Plankton, begin: int, end: int
) -> None:
    """Carry the particles begin..end that are in the water; let those come back whose tick it is."""
    position, last, now = plankton.position, plankton.last_position, water.tick
    for k in range(begin, end):
        if plankton.returns[k] > now or plankton.eaten_by[k] >= 0:
            continue
        patch, flows = plankton.patch[k], False
        fresh = plankton.returns[k] == now
        if fresh:
            appear(terrain, seed, now, k, plankton.around[patch], plankton.within[patch], position)
        for axis in range(3):
            last[k, axis] = position[k, axis]
        if not fresh:
            fresh, flows = _drift_one(terrain, water, seed, k, plankton)
        if fresh or flows or (now + k) % _CONFINE_EVERY == 0:
            confine(terrain, position, k, _BERTH)
        if fresh:
            for axis in range(3):
                last[k, axis] = position[k, axis]


@loop
def drift_all(
    terrain: Terrain,
    field: Field,
    grid: SphereGrid,
    tick: int,
    seed: int,
    plankton: Plankton,
    count: int,
) -> None:
    """Carry all particles, on all threads."""
    for piece in numba.prange(_PIECES):
        water = Water(field, grid, tick)
        begin, end = count * piece // _PIECES, count * (piece + 1) // _PIECES
        drift_some(terrain, water, seed, plankton, begin, end)


@row
def carry_some(
    terrain: Terrain, water: Water, speed: Float64s, fishes: Carried, begin: int, end: int
) -> None:
    """Carry the fishes of rows begin..end by what flows faster than they cruise; `speed` [BL/s], (S, 3)."""
    position = fishes.position
    for i in range(begin, end):
        x, y, z = position[i, 0], position[i, 1], position[i, 2]
        if lists_none(water.grid, x, y):
            continue
        u, v, w = _push_near(water, x, y, z)
        size, length = sqrt(u * u + v * v + w * w), fishes.length[i]
        held = speed[fishes.species[i], _CRUISE] * length
        if size <= held:
            continue
        step = TICK_SECONDS * (1.0 - held / size)
        position[i, 0], position[i, 1], position[i, 2] = x + step * u, y + step * v, z + step * w
        confine(terrain, position, i, berth(length))


@loop
def carry_all(
    terrain: Terrain,
    field: Field,
    grid: SphereGrid,
    tick: int,
    speed: Float64s,
    fishes: Carried,
    count: int,
) -> None:
    """Carry all fishes, on all threads."""
    for piece in numba.prange(_PIECES):
        water = Water(field, grid, tick)
        begin, end = count * piece // _PIECES, count * (piece + 1) // _PIECES
        carry_some(terrain, water, speed, fishes, begin, end)


@row
def drift_few(
    terrain: Terrain,
    water: Water,
    seed: int,
    plankton: Plankton,
    particles: int,
    speed: Float64s,
    fishes: Carried,
    number: int,
) -> None:
    """Carry particles and fishes on this thread: one kernel, for handing over the sea takes longer than the rest."""
    drift_some(terrain, water, seed, plankton, 0, particles)
    carry_some(terrain, water, speed, fishes, 0, number)


@row
def _list_felt(field: Field, grid: SphereGrid, felt: Float64s) -> int:
    """Write how far [m] each singularity is felt now, (n,), and list them; return what `fill_lists` does."""
    for k in range(len(felt)):
        felt[k] = field.reach[k] if field.there[k] != 0 and field.intensity[k] != 0.0 else 0.0
    return fill_lists(grid, field.position, felt)


class Drift:
    """Reads singularities, patches, senses, terrain and clock; writes food and the fishes' position."""

    def __init__(
        self,
        singularities: SingularityTable,
        population: Population,
        food: FoodTable,
        patches: PatchTable,
        senses: SenseTable,
        terrain: Terrain,
        clock: Clock,
    ) -> None:
        self.singularities, self.population = singularities, population
        self.food, self.patches, self.senses = food, patches, senses
        self.terrain, self.clock = terrain, clock
        self._plankton = Columns(Plankton, food, patches)
        self._carried = Columns(Carried, population.fish)
        self._grid = sphere_grid(terrain.radius)
        self._list_felt, self._drift_few = Launch(_list_felt), Launch(drift_few)
        self._drift_some, self._drift_all = Launch(drift_some), Launch(drift_all)
        self._carry_some, self._carry_all = Launch(carry_some), Launch(carry_all)
        self._look_up()

    def __call__(self) -> None:
        """Let food and fishes drift for a tick."""
        water, seed, terrain = self.water(), int(self.clock.seed[0]), self.terrain
        count, plankton = self.food.count, self.plankton()
        number, fishes, speed = self.population.count, self._carried(), self.senses.speed
        if count < _SERIAL_BELOW and number < _FEW_FISHES:
            self._drift_few(terrain, water, seed, plankton, count, speed, fishes, number)
            return
        if count < _SERIAL_BELOW:
            self._drift_some(terrain, water, seed, plankton, 0, count)
        else:
            self._drift_all(terrain, *water, seed, plankton, count)
        if empty(water.grid):
            return
        if number < _FEW_FISHES:
            self._carry_some(terrain, water, speed, fishes, 0, number)
        else:
            self._carry_all(terrain, *water, speed, fishes, number)

    def water(self) -> Water:
        """Return the flow of this tick; stale when singularities come or go, or after the next call."""
        if self._size != (self.singularities.count, self.singularities.capacity):
            self._look_up()
        field, felt = self._field, self._felt
        if self._list_felt(field, self._grid, felt) > len(self._grid.listed):
            self._grid = list_spheres(self._grid, field.position, felt)
        return Water(field, self._grid, self.clock.now)

    def plankton(self) -> Plankton:
        """Return the columns of food and patches; they go stale when either grows."""
        return self._plankton()

    def _look_up(self) -> None:
        self._size = self.singularities.count, self.singularities.capacity
        self._field = field_of(self.singularities)
        self._felt = np.zeros(self.singularities.count)
