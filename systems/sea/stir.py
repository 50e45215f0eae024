"""Stir: singularities follow their key frames and what carries them: fishes, the submarine (papers/002, section 5.2).

Behind the submarine's propeller stands a jet as strong as the engine is set, the wash; in reverse it runs the other
way. A singularity that a species carries is on its fish of the lowest id, and on the next one when that is gone.
"""

from typing import Final

import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.clock import TICK_SECONDS, Clock
from components.fish import Population
from components.index import Places, row_of
from components.kernels import row
from components.singularity import (
    FREE,
    NOBODY,
    SUBMARINE,
    KeyFrames,
    SingularityKind,
    SingularityTable,
    play_tracks,
)
from components.submarine import SubmarineTable
from components.trigonometry import cosine, sine

WASH: Final = 1.6
"""[m/s] of the wash at full throttle."""
WASH_REACH: Final = 2.0
"""[m] of the wash around its middle."""
ASTERN: Final = (-2.6, 0.0, 0.0)
"""[m] from the cockpit's eye to that middle, in the submarine's axes."""


def wash(table: SingularityTable) -> None:
    """Add the submarine's wash to the table: a jet that blows astern."""
    rows = table.append(1)
    table.kind[rows], table.attached[rows] = SingularityKind.DIRECTIONAL, SUBMARINE
    table.drive[rows], table.reach[rows], table.offset[rows] = WASH, WASH_REACH, ASTERN
    table.carried_axis[rows] = (-1.0, 0.0, 0.0)


@row
def turned(axes: Float64s, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Return a vector in world axes whose components along the columns of `axes`, (3, 3), are x, y and z."""
    return (
        axes[0, 0] * x + axes[0, 1] * y + axes[0, 2] * z,
        axes[1, 0] * x + axes[1, 1] * y + axes[1, 2] * z,
        axes[2, 0] * x + axes[2, 1] * y + axes[2, 2] * z,
    )


@row
def _ride(
    k: int,
    place: Float64s,
    axes: Float64s,
    offset: Float64s,
    carried_axis: Float64s,
    position: Float64s,
    axis: Float64s,
) -> None:
    """Put singularity k where its carrier at `place` [m], (3,), with its `axes`, (3, 3), has it."""
    x, y, z = turned(axes, offset[k, 0], offset[k, 1], offset[k, 2])
    position[k, 0], position[k, 1], position[k, 2] = place[0] + x, place[1] + y, place[2] + z
    axis[k, 0], axis[k, 1], axis[k, 2] = turned(
        axes, carried_axis[k, 0], carried_axis[k, 1], carried_axis[k, 2]
    )


@row
def lowest_of(species: int, kinds: Int32s, ids: Int64s, count: int) -> int:
    """Return the lowest id among the first `count` fishes that are of the species, `NOBODY` where there is none."""
    found = NOBODY
    for i in range(count):
        if kinds[i] == species and (found < 0 or ids[i] < found):
            found = ids[i]
    return found


@row
def ride_fishes(
    attached: Int64s,
    carrier: Int32s,
    offset: Float64s,
    carried_axis: Float64s,
    position: Float64s,
    axis: Float64s,
    there: Int8s,
    count: int,
    places: Places,
    kinds: Int32s,
    ids: Int64s,
    place: Float64s,
    rotation: Float64s,
) -> None:
    """Let those of `attached`, (n,), that fishes carry go along; `count` fishes live."""
    for k in range(len(attached)):
        if carrier[k] >= 0 and row_of(places, attached[k]) < 0:
            attached[k] = lowest_of(carrier[k], kinds, ids, count)
        if attached[k] == FREE or attached[k] == SUBMARINE:
            continue
        i = row_of(places, attached[k])
        there[k] = 1 if i >= 0 else 0
        if i >= 0:
            _ride(k, place[i], rotation[i], offset, carried_axis, position, axis)


@row
def ride_submarine(
    attached: Int64s,
    drive: Float64s,
    offset: Float64s,
    carried_axis: Float64s,
    position: Float64s,
    axis: Float64s,
    intensity: Float64s,
    there: Int8s,
    ships: int,
    place: Float64s,
    throttle: Float64s,
    axes: Float64s,
) -> None:
    """Let those that the submarine carries go along; the engine drives what it drives. `axes`: the hull's, (3, 3)."""
    for k in range(len(attached)):
        if attached[k] != SUBMARINE:
            continue
        there[k] = 1 if ships > 0 else 0
        if ships > 0:
            _ride(k, place[0], axes, offset, carried_axis, position, axis)
            if drive[k] != 0.0:
                intensity[k] = drive[k] * throttle[0]


@row
def hull_axes(yaw: float, pitch: float, axes: Float64s) -> None:
    """Write the hull's axes, (3, 3): columns ahead, up and to the right, from yaw and pitch [rad]."""
    c, s, level, lift = cosine(yaw), sine(yaw), cosine(pitch), sine(pitch)
    axes[0, 0], axes[1, 0], axes[2, 0] = level * c, level * s, lift
    axes[0, 1], axes[1, 1], axes[2, 1] = -lift * c, -lift * s, level
    axes[0, 2], axes[1, 2], axes[2, 2] = s, -c, 0.0


class Stir:
    """Reads key frames, submarine, fishes and clock; writes singularities."""

    def __init__(
        self,
        singularities: SingularityTable,
        keys: KeyFrames,
        submarine: SubmarineTable,
        population: Population,
        clock: Clock,
    ) -> None:
        self.singularities, self.keys = singularities, keys
        self.submarine, self.population, self.clock = submarine, population, clock
        self._axes = np.zeros((3, 3))

    def __call__(self) -> None:
        """Bring all singularities where they are in this tick."""
        table, ship, fish = self.singularities, self.submarine, self.population.fish
        play_tracks(table, self.keys, self.clock.now * TICK_SECONDS)
        attached = table.attached[: table.count]
        if ship.count:
            hull_axes(float(ship.yaw[0]), float(ship.pitch[0]), self._axes)
        ride_submarine(
            attached, table.drive, table.offset, table.carried_axis, table.position, table.axis,
            table.intensity, table.there, ship.count, ship.position, ship.throttle, self._axes,
        )  # fmt: skip
        ride_fishes(
            attached, table.carrier, table.offset, table.carried_axis, table.position, table.axis,
            table.there, self.population.count, self.population.index.places, fish.species,
            fish.id, fish.position, fish.rotation,
        )  # fmt: skip
