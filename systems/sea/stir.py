"""Stir: singularities follow their key frames and what carries them: fishes, the submarine (papers/002, section 5.2).

Behind the submarine's propeller stands a jet as strong as the engine is set, the wash; in reverse it runs the other
way. A singularity that a species carries is on its fish of the lowest id, and on the next one when that is gone.
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.clock import TICK_SECONDS, Clock
from components.fish import Population
from components.index import Places, row_of
from components.kernels import Launch, row
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
from components.table import Columns
from components.trigonometry import cosine, sine

WASH: Final = 1.6
"""[m/s] of the wash at full throttle."""
WASH_REACH: Final = 2.0
"""[m] of the wash around its middle."""
ASTERN: Final = (-2.6, 0.0, 0.0)
"""[m] from the cockpit's eye to that middle, in the submarine's axes."""


class Stirred(NamedTuple):
    """The columns of singularities that stirring reads and writes."""

    position: Float64s
    axis: Float64s
    intensity: Float64s
    attached: Int64s
    carrier: Int32s
    offset: Float64s
    carried_axis: Float64s
    drive: Float64s
    there: Int8s
    track: Int32s


class Carriers(NamedTuple):
    """The columns of fishes."""

    id: Int64s
    species: Int32s
    position: Float64s
    rotation: Float64s


class Hull(NamedTuple):
    """The columns of the submarine."""

    position: Float64s
    yaw: Float64s
    pitch: Float64s
    throttle: Float64s


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
def _ride(k: int, place: Float64s, axes: Float64s, stirred: Stirred) -> None:
    """Put singularity k where its carrier at `place` [m], (3,), with its `axes`, (3, 3), has it."""
    offset, carried_axis = stirred.offset, stirred.carried_axis
    position, axis = stirred.position, stirred.axis
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
    stirred: Stirred, number: int, fishes: Carriers, count: int, places: Places
) -> None:
    """Let those of `number` singularities that fishes carry go along; `count` fishes live."""
    attached, carrier = stirred.attached, stirred.carrier
    for k in range(number):
        if carrier[k] >= 0 and row_of(places, attached[k]) < 0:
            attached[k] = lowest_of(carrier[k], fishes.species, fishes.id, count)
        if attached[k] == FREE or attached[k] == SUBMARINE:
            continue
        i = row_of(places, attached[k])
        stirred.there[k] = 1 if i >= 0 else 0
        if i >= 0:
            _ride(k, fishes.position[i], fishes.rotation[i], stirred)


@row
def hull_axes(yaw: float, pitch: float, axes: Float64s) -> None:
    """Write the hull's axes, (3, 3): columns ahead, up and to the right, from yaw and pitch [rad]."""
    c, s, level, lift = cosine(yaw), sine(yaw), cosine(pitch), sine(pitch)
    axes[0, 0], axes[1, 0], axes[2, 0] = level * c, level * s, lift
    axes[0, 1], axes[1, 1], axes[2, 1] = -lift * c, -lift * s, level
    axes[0, 2], axes[1, 2], axes[2, 2] = s, -c, 0.0


@row
def ride_submarine(stirred: Stirred, number: int, hull: Hull, ships: int, axes: Float64s) -> None:
    """Let those that the submarine carries go along; the engine drives what it drives. `axes`: scratch, (3, 3)."""
    if ships > 0:
        hull_axes(hull.yaw[0], hull.pitch[0], axes)
    for k in range(number):
        if stirred.attached[k] != SUBMARINE:
            continue
        stirred.there[k] = 1 if ships > 0 else 0
        if ships > 0:
            _ride(k, hull.position[0], axes, stirred)
            if stirred.drive[k] != 0.0:
                stirred.intensity[k] = stirred.drive[k] * hull.throttle[0]


@row
def stir(
    stirred: Stirred, number: int, keys: KeyFrames, seconds: float, hull: Hull, ships: int, axes: Float64s,
    fishes: Carriers, count: int, places: Places,
) -> None:  # fmt: skip
    """Bring `number` singularities where they are at a time [s]; `axes` (3, 3) is scratch."""
    play_tracks(
        keys, stirred.track, stirred.attached, stirred.position, stirred.intensity, number, seconds
    )
    ride_submarine(stirred, number, hull, ships, axes)
    ride_fishes(stirred, number, fishes, count, places)


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
        self._stirred, self._hull = Columns(Stirred, singularities), Columns(Hull, submarine)
        self._fishes = Columns(Carriers, population.fish)
        self._axes, self._stir = np.zeros((3, 3)), Launch(stir)

    def __call__(self) -> None:
        """Bring all singularities where they are in this tick."""
        people, number = self.population, self.singularities.count
        self._stir(
            self._stirred(), number, self.keys, self.clock.now * TICK_SECONDS, self._hull(),
            self.submarine.count, self._axes, self._fishes(), people.count, people.index.places,
        )  # fmt: skip
