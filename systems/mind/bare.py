"""Bare schooling: neighbours and the rule of Reynolds alone, in the same grid and loop as whole minds.

Benches hold the whole mind, and scipy's k-d tree, against it. No game runs it.
"""

from math import sqrt
from typing import Final

import numba

from components.arrays import Float64s, Int8s, Int64s
from components.clock import TICKS_PER_SECOND, Clock
from components.fish import Population
from components.ground import Terrain
from components.kernels import Launch, loop, row
from components.senses import SenseTable
from components.vector import point
from systems.mind.grid import PIECES, SERIAL_BELOW, Crowd, Grid, Plan
from systems.mind.perceive import (
    Attention,
    find_runs,
    gather,
    make_attention,
    nearest_of_kind,
    reach_of,
    see_around,
)

_SEPARATION: Final = 2.2
_ELBOW: Final = 1.4
_COHESION: Final = 0.45
_FLATTEN: Final = 0.8


@row
def _flock(
    crowd: Crowd, me: int, spacing: float, found: int, near: Int64s, distance: Float64s,
    out: Float64s,
) -> None:  # fmt: skip
    """Write the wanted direction: keep apart, swim as they swim, stay with them."""
    ax, ay, az = crowd.hx[me], crowd.hy[me], crowd.hz[me]
    sx = sy = sz = cx = cy = cz = 0.0
    elbow = 1.0 / (_ELBOW * spacing)
    for k in range(found):
        other = near[k]
        dx, dy, dz = (
            crowd.x[other] - crowd.x[me],
            crowd.y[other] - crowd.y[me],
            crowd.z[other] - crowd.z[me],
        )
        cx, cy, cz = cx + dx, cy + dy, cz + dz
        ax, ay, az = ax + crowd.hx[other], ay + crowd.hy[other], az + crowd.hz[other]
        push = max(1.0 / (sqrt(distance[k]) + 1e-9) - elbow, 0.0)
        sx, sy, sz = sx - push * dx, sy - push * dy, sz - push * dz
    share = 1.0 / (found + 1.0)
    pull = _COHESION * share / spacing
    out[0] = share * ax + _SEPARATION * sx + pull * cx
    out[1] = share * ay + _SEPARATION * sy + pull * cy
    out[2] = share * az + _SEPARATION * _FLATTEN * sz + pull * cz / _FLATTEN


@row
def flock_some(
    turn: int, every: int, begin: int, end: int, plan: Plan, crowd: Crowd, senses: SenseTable,
    heading: Float64s, gear: Int8s, attention: Attention, piece: int,
) -> None:  # fmt: skip
    """Let those of places begin..end whose turn it is school."""
    side = plan.columns
    column = layer = here = -1
    mine = around = 0
    for me in range(begin, end):
        if crowd.column[me] != here:
            here = crowd.column[me]
            mine = here // side // 3 + 2 * (here % side // 3) - turn
        kind = crowd.species[me]
        if (every > 1 and mine & 3 != 0) or senses.schooling[kind] == 0:
            continue
        if crowd.column[me] != column or crowd.layer[me] != layer:
            column, layer = crowd.column[me], crowd.layer[me]
            runs = find_runs(plan, crowd, column, layer, attention.runs[piece])
            around = gather(crowd, runs, attention, piece)
        length = crowd.length[me]
        reach = reach_of(plan, senses.sight[kind], length)
        many = see_around(crowd, me, reach, around, attention, piece)
        found = nearest_of_kind(crowd, me, many, attention, piece)
        out = attention.out[piece]
        _flock(
            crowd, me, senses.spacing[kind] * length, found, attention.near[piece],
            attention.distance[piece], out,
        )  # fmt: skip
        point(heading[crowd.row[me]], out[0], out[1], out[2])
        gear[crowd.row[me]] = 1


@loop
def flock_all(
    turn: int, every: int, number: int, plan: Plan, crowd: Crowd, senses: SenseTable,
    heading: Float64s, gear: Int8s, attention: Attention,
) -> None:  # fmt: skip
    """Let those school whose turn it is, on all threads."""
    for at in numba.prange(PIECES):
        piece = (at * 27) % PIECES
        begin, end = number * piece // PIECES, number * (piece + 1) // PIECES
        flock_some(
            turn, every, begin, end, plan, crowd, senses, heading, gear, attention, piece
        )  # fmt: skip


class BareSchooling:
    """Reads fishes, senses and clock; writes the schooling fishes' heading and gear."""

    def __init__(
        self,
        population: Population,
        senses: SenseTable,
        terrain: Terrain,
        clock: Clock,
        every: int = 4,
    ) -> None:
        """Let every fish think each `every` ticks: 4 as whole minds do, or 1."""
        self.population, self.senses, self.clock, self.every = population, senses, clock, every
        self.grid = Grid(terrain, senses)
        self._attention = make_attention()
        self._flock_some, self._flock_all = Launch(flock_some), Launch(flock_all)

    def __call__(self) -> None:
        """Advance by one tick."""
        number, now, motor = self.population.count, self.clock.now, self.population.motor
        self.grid.sort(
            self.population, reorder=number >= SERIAL_BELOW and now % TICKS_PER_SECOND == 0
        )
        scene = (self.grid.plan, self.grid.crowd, self.senses, motor.heading, motor.gear)
        if number < SERIAL_BELOW:
            self._flock_some(now, self.every, 0, number, *scene, self._attention, 0)
        else:
            self._flock_all(now, self.every, number, *scene, self._attention)
