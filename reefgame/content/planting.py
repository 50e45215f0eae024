"""Where a level's plants stand: on the ground or on the implicit rocks, apart from each other.

The places of anemones are simulation truth, so they keep the bit rule: chance is drawn from named streams, the rest is
+ - * / sqrt. A level's plants stand alike in every dive.
"""

from collections.abc import Mapping
from math import sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s
from components.chance import PLANT, draw, uniform
from components.flora import Flora, Plant, Stand
from components.ground import (
    Terrain,
    ground_height,
    ground_normal,
    rock_clearance,
    rock_distance,
    rock_square,
    to_rock,
)
from reefgame.content.schema.level import Level
from reefgame.content.schema.plants import PlantPlace

SHALLOWEST: Final = -0.3
"""[m] z that no plant's root passes."""

_TRIES: Final = 60
_STEEPEST: Final = 0.45
"""z of the normal of the steepest rock that chance plants on."""

_CROWDED: Final = 0.5
"""Share of their room that plants set by hand keep free at least."""


class Surface(NamedTuple):
    """The topmost solid at a place of the plan."""

    point: tuple[float, float, float]
    "[m]"
    normal: tuple[float, float, float]
    rock: int
    "-1: sand"


class Planting(NamedTuple):
    """A level's plants, and which of its groups found no room for all of theirs."""

    plants: tuple[Plant, ...]
    found: tuple[int, ...]
    "plants that stand, by entry of `plants:`"
    crowded: tuple[tuple[int, int], ...]
    "entries set by hand, and the entry of the plant that they stand in"


def surface(terrain: Terrain, x: float, y: float) -> Surface:
    """Return the topmost of ground and rocks at (x, y) [m], with its unit normal."""
    height, extent, cell = terrain.height, terrain.extent, terrain.cell
    z, rock = ground_height(height, extent, cell, x, y), -1
    square = rock_square(terrain, x, y)
    for k in terrain.rock_list[terrain.rock_first[square] : terrain.rock_first[square + 1]]:
        a, b, c = terrain.rock_radii[k]
        u, v, _ = to_rock(terrain, k, x, y, 0.0)
        inside = 1.0 - (u / a) * (u / a) - (v / b) * (v / b)
        top = terrain.rock_centre[k, 2] + c * sqrt(inside) if inside > 0.0 else z
        if top > z:
            z, rock = float(top), int(k)
    if rock < 0:
        return Surface((x, y, z), ground_normal(height, extent, cell, x, y), rock)
    _, p, q, r = rock_clearance(terrain, rock, x, y, z)
    size = sqrt(p * p + q * q + r * r)
    return Surface((x, y, z), (p / size, q / size, r / size), rock)


class _Beds:
    """The plants that stand already, and the room that they take."""

    def __init__(self, terrain: Terrain, floras: Mapping[str, Flora], seed: int, most: int) -> None:
        self.terrain, self.floras, self.seed = terrain, floras, seed
        self.plants: list[Plant] = []
        self.entry: list[int] = []
        self._place: Float64s = np.zeros((most, 3))
        self._room: Float64s = np.zeros(most)

    def room(self, flora: str, scale: float) -> float:
        """Return the radius [m] that a plant takes."""
        return self.floras[flora].room * scale

    def nearest(self, point: tuple[float, float, float], room: float) -> tuple[float, int]:
        """Return the least part of their common room that lies between a place and a plant, and which plant."""
        count = len(self.plants)
        if count == 0:
            return np.inf, -1
        away = self._place[:count] - point
        x, y, z = away[:, 0], away[:, 1], away[:, 2]
        part = np.sqrt(x * x + y * y + z * z) / (self._room[:count] + room)
        least = int(part.argmin())
        return float(part[least]), least

    def add(self, plant: Plant, entry: int) -> None:
        """Let a plant stand."""
        at = len(self.plants)
        self._place[at], self._room[at] = plant.position, self.room(plant.flora, plant.scale)
        self.plants.append(plant)
        self.entry.append(entry)


def planting(level: Level, floras: Mapping[str, Flora], terrain: Terrain) -> Planting:
    """Return the level's plants, in the order of its file; `floras` are those that it names."""
    most = sum(place.count for place in level.plants)
    beds = _Beds(terrain, floras, level.seabed.seed, most)
    crowded: list[tuple[int, int]] = []
    for entry, place in enumerate(level.plants):
        if place.at_m is None:
            _scatter(beds, entry, place)
            continue
        point, normal, _ = surface(terrain, *place.at_m)
        scale, shape = place.scale[0], _shape(beds.seed, entry, 0)
        free, other = beds.nearest(point, beds.room(place.flora, scale))
        if free < _CROWDED:
            crowded.append((entry, beds.entry[other]))
        beds.add(Plant(place.flora, point, normal, place.yaw_deg, scale, shape), entry)
    found = tuple(beds.entry.count(entry) for entry in range(len(level.plants)))
    return Planting(tuple(beds.plants), found, tuple(crowded))


def _shape(seed: int, entry: int, number: int) -> int:
    return int(draw(seed, PLANT, entry, number)) & 0x7FFFFFFF


def _scatter(beds: _Beds, entry: int, place: PlantPlace) -> None:
    """Let a group's plants stand where chance finds room for them."""
    low, high = place.scale
    for number in range(place.count):
        for attempt in range(_TRIES):
            u, v, size, turn = (
                uniform(beds.seed, PLANT, entry, 4 * (number * _TRIES + attempt) + part + (1 << 40))
                for part in range(4)
            )
            scale = low + (high - low) * size
            spot = _spot(beds, place, 2.0 * u - 1.0, 2.0 * v - 1.0, scale)
            if spot is not None:
                shape = _shape(beds.seed, entry, number)
                beds.add(Plant(place.flora, *spot[:2], 360.0 * turn, scale, shape), entry)
                break


def _spot(beds: _Beds, place: PlantPlace, u: float, v: float, scale: float) -> Surface | None:
    """Return the surface at a part (u, v) of a group's circle, or None where its plant cannot stand."""
    if place.around_m is None or u * u + v * v > 1.0:
        return None
    x, y = place.around_m[0] + place.within_m * u, place.around_m[1] + place.within_m * v
    if x * x + y * y > beds.terrain.radius * beds.terrain.radius:
        return None
    found, room = surface(beds.terrain, x, y), beds.room(place.flora, scale)
    on = place.stands or beds.floras[place.flora].stands
    if found.point[2] > SHALLOWEST or not _suits(beds.terrain, found, on, room):
        return None
    return found if beds.nearest(found.point, room)[0] >= 1.0 else None


def _suits(terrain: Terrain, found: Surface, on: Stand, room: float) -> bool:
    """Return whether a plant may stand on sand away from rocks, or on a rock that is not too steep."""
    if found.rock >= 0:
        return on != "sand" and found.normal[2] >= _STEEPEST
    square = rock_square(terrain, found.point[0], found.point[1])
    near = terrain.rock_list[terrain.rock_first[square] : terrain.rock_first[square + 1]]
    return on != "rock" and all(
        rock_distance(terrain, int(k), *found.point) > 0.5 * room for k in near
    )
