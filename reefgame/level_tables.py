"""A level's file turned into the tables and constants of a dive: fishes, food, anemones, light and warmth."""

from collections.abc import Mapping, Sequence
from typing import Final, TypeAlias

import numpy as np

from components.anemone import Cap
from components.clock import TICKS_PER_SECOND
from components.cohort import AT_RANDOM, NEVER, CohortTable
from components.flora import Anemone, Flora, Plant, tentacle_cap
from components.food import GONE, FoodTable, PatchTable
from components.habitat import Habitat
from components.species import Species
from components.terrain import Terrain
from reefgame.content.schema.level import Level
from systems.sea.drift import appear

_SHARE: Final = {
    "sunrise": 0.0,
    "morning": 0.125,
    "noon": 0.25,
    "afternoon": 0.375,
    "sunset": 0.5,
    "midnight": 0.75,
}
_COLDER_BELOW: Final = 2.0
_ROOMY: Final = 5.0
"""Radius of the smallest cap that a fish lives in, over its length."""

Point: TypeAlias = tuple[float, ...]


def cohorts_of(level: Level, species: list[str]) -> CohortTable:
    """Return the level's groups; `species` are the names in the order of their rows."""
    table = CohortTable(count=len(level.fishes))
    for at, group in enumerate(level.fishes):
        table.species[at] = species.index(group.species)
        table.number[at] = group.count
        table.around[at] = group.around_m
        table.within[at] = group.within_m
        table.arrives[at] = round(group.arrives_s * TICKS_PER_SECOND)
        table.leaves[at] = _ticks(group.leaves_s, NEVER)
        table.hunger[at] = AT_RANDOM if group.hunger is None else group.hunger
        table.restock[at] = _ticks(group.restock_s, NEVER)
    return table


def _ticks(seconds: float | None, never: int) -> int:
    return never if seconds is None else round(seconds * TICKS_PER_SECOND)


def patches_of(level: Level) -> PatchTable:
    """Return the level's patches of food."""
    table = PatchTable(count=len(level.food))
    for at, patch in enumerate(level.food):
        table.around[at] = patch.around_m
        table.within[at] = patch.within_m
        table.drift[at] = patch.drift_m_per_s
        table.returns_after[at] = _ticks(patch.returns_s, GONE)
    return table


def food_of(level: Level, patches: PatchTable, terrain: Terrain, seed: int) -> FoodTable:
    """Return the particles of the patches, where they are before the first tick."""
    numbers = [patch.particles for patch in level.food]
    table = FoodTable(count=sum(numbers))
    table.patch[: table.count] = np.repeat(np.arange(len(numbers)), numbers)
    table.meal[: table.count] = np.repeat([patch.meal_g for patch in level.food], numbers)
    for particle in range(table.count):
        patch = int(table.patch[particle])
        around, within = patches.around[patch], float(patches.within[patch])
        appear(terrain, seed, 0, particle, around, within, table.position)
    table.last_position[: table.count] = table.position[: table.count]
    return table


def caps_of(plants: Sequence[Plant], floras: Mapping[str, Flora]) -> list[Cap]:
    """Return the caps of the anemones among a level's plants, in their order; `floras` are those plants' by name."""
    caps = []
    for plant in plants:
        form = floras[plant.flora].form
        if isinstance(form, Anemone):
            centre, radius = tentacle_cap(plant, form)
            caps.append(Cap(centre, radius, form.stings, plant.scale * form.holds))
    return caps


def shelters_of(caps: Sequence[Cap], species: Sequence[Species]) -> list[tuple[Point, int]]:
    """Return home points, (x, y, z) and row of the species: amid each anemone that stings, for who finds room in it."""
    return [
        (cap.centre, kind)
        for cap in caps
        for kind, one in enumerate(species)
        if one.temper.at_home and cap.stings and cap.radius >= _ROOMY * one.length
    ]


def habitat_of(level: Level) -> Habitat:
    """Return the level's light and warmth."""
    day, water = level.day, level.water
    bottom = water.surface_c - _COLDER_BELOW if water.bottom_c is None else water.bottom_c
    return Habitat(
        day_ticks=_ticks(day.length_s, 0),
        dawn=_SHARE[day.starts],
        night=float(day.night_light),
        clarity=float(water.light_halves_m),
        surface=float(water.surface_c),
        swing=float(water.swing_c),
        fall=(water.surface_c - bottom) / level.world.depth_m,
        visibility=float(water.visibility_m),
    )
