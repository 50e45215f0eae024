"""What minds live in during a tick, and the columns that they read and write."""

from typing import Final, NamedTuple

from components.arrays import Float32s, Float64s, Int8s, Int32s, Int64s
from components.ground import Terrain
from components.habitat import Habitat, daylight
from components.index import Places
from components.kernels import row
from components.senses import SenseTable
from systems.mind.crowd import Crowd, Rows, Sorting
from systems.mind.few import Larder, Room, sort_few
from systems.mind.grid import Plan
from systems.mind.sparse import Sparse

COARSE: Final = 3.0
"""Cells of the crowd's grid to a cell of the few's, at least."""


class Scene(NamedTuple):
    """The world as minds find it."""

    now: int
    seed: int
    day: float
    "light just under the surface, 0 to 1"
    plan: Plan
    crowd: Crowd
    senses: SenseTable
    terrain: Terrain
    habitat: Habitat
    hunters: Sparse
    "the fishes of species that eat others"
    food: Sparse
    "the food in the water"
    willing: Sparse
    "the fishes that court or would answer a mate, of species that do not school"
    places: Places
    "the rows of ids"
    submarine: Float64s
    "[m], (K, 3)"
    submarine_velocity: Float64s
    "[m/s], (K, 3)"
    submarines: int
    food_position: Float64s
    "[m] of each particle, (F, 3), by row of the table of food"
    food_last: Float64s
    "[m] a tick ago, (F, 3)"
    there: Int8s
    "1 for each particle in the water, (F,)"


class Stage(NamedTuple):
    """What a scene is made of each tick, and what has room for it."""

    plan: Plan
    sorting: Sorting
    rows: Rows
    crowd: Crowd
    senses: SenseTable
    terrain: Terrain
    habitat: Habitat
    larder: Larder
    room: Room
    places: Places
    submarine: Float64s
    "[m], (K, 3)"
    submarine_velocity: Float64s
    "[m/s], (K, 3)"


@row
def look(stage: Stage, now: int, seed: int, number: int, particles: int, submarines: int) -> Scene:
    """Return the scene of the tick `now`, with `number` fishes, whose crowd is sorted already."""
    hunters, willing, food = sort_few(
        stage.crowd, number, stage.plan.hunters, stage.senses, stage.larder, particles, now,
        stage.terrain.depth, COARSE * stage.plan.cell, stage.room,
    )  # fmt: skip
    return Scene(
        now, seed, daylight(stage.habitat, now), stage.plan, stage.crowd, stage.senses, stage.terrain,
        stage.habitat, hunters, food, willing, stage.places, stage.submarine,
        stage.submarine_velocity, submarines, stage.larder.position, stage.larder.last_position,
        stage.room.there,
    )  # fmt: skip


class Minds(NamedTuple):
    """The columns that thinking reads and writes, row for row with the fishes'."""

    intention: Int8s
    why: Int8s
    why_value: Float32s
    focus: Int64s
    since: Int64s
    thought_at: Int64s
    wander_until: Int64s
    wander: Float64s
    side: Int8s
    memory: Int8s
    memory_focus: Int64s
    hunger: Float64s
    libido: Float64s
    fear: Float64s
    danger: Float64s
    wary_of: Int64s
    eaten: Float64s
    ate_at: Int64s
    mated_at: Int64s
    courtship: Int8s
    courtship_since: Int64s
    gape: Float64s
    swallowed_by: Int64s
    cohort: Int32s
    heading: Float64s
    gear: Int8s
    urgency: Float64s
    throttle: Float64s
