"""Which fishes are seen, how finely, and the records by which the GPU draws them (papers/000, 7.1, 7.3; FINDINGS 8).

One point stands for a fish; the frustum is enlarged by the fish's length. What the water hides is left out. The level of
detail follows the length on the picture in pixels. For the view only: nothing here feeds back into the simulation.
"""

from dataclasses import dataclass, field
from math import pi, sin, sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float32s, Float64s, Int32s, Int64s
from components.camera import Camera
from components.fish import Population
from components.kernels import row

CLOSE_PIXELS: Final = 113.0
"""[px] from which a fish is drawn as a B-spline surface."""
FAR_PIXELS: Final = 25.0
"""[px] from which it is drawn as its control points' mesh; smaller ones are cards."""
LEAST_PIXELS: Final = 0.6
"""[px] below which it is left out."""
HIDDEN: Final = 3.0
"""Visibilities at which water hides everything."""
RECORD: Final = 20
"""Numbers in an instance record: origin, length; quaternion; shapes last and now, blend, warp's weight; warp's shapes,
species, fin phase; tint, shine."""
LEVELS: Final = 3


class View(NamedTuple):
    """A camera and its target, as the kernel reads them."""

    eye: Float64s
    "[m], (3,)"
    axes: Float64s
    "rows right, up, forward, (3, 3)"
    slope_x: float
    "tangent of half the horizontal field of view"
    slope_y: float
    "tangent of half the vertical field of view"
    pixels: float
    "[px] of a unit length at unit distance"
    reach: float
    "[m] beyond which water hides everything"


class Drawn(NamedTuple):
    """The columns of the population that are drawn."""

    id: Int64s
    species: Int32s
    length: Float64s
    position: Float64s
    last_position: Float64s
    rotation: Float64s
    last_rotation: Float64s
    shape_row: Int32s
    last_shape_row: Int32s
    warp_from: Int32s
    warp_to: Int32s
    warp_weight: Float64s
    last_warp_weight: Float64s


def view_of(camera: Camera, height: float, aspect: float, visibility: float) -> View:
    """Return the view of `camera` on a target `height` pixels high and `aspect` times as wide."""
    axes = np.stack((camera.right, camera.up, camera.forward))
    slope = camera.slope
    return View(
        np.asarray(camera.eye, np.float64),
        axes,
        slope * aspect,
        slope,
        height / (2.0 * slope),
        HIDDEN * visibility,
    )


@row
def level_at(view: View, x: float, y: float, z: float, length: float) -> int:
    """Return the level of detail, 0 close to 2 card, of a fish at a point of the world [m]; -1 where it is not seen."""
    dx, dy, dz = x - view.eye[0], y - view.eye[1], z - view.eye[2]
    ahead = dx * view.axes[2, 0] + dy * view.axes[2, 1] + dz * view.axes[2, 2]
    if ahead < -length or ahead > view.reach + length:
        return -1
    depth = max(ahead, 0.0)
    aside = abs(dx * view.axes[0, 0] + dy * view.axes[0, 1] + dz * view.axes[0, 2])
    if aside > depth * view.slope_x + length * sqrt(1.0 + view.slope_x * view.slope_x):
        return -1
    above = abs(dx * view.axes[1, 0] + dy * view.axes[1, 1] + dz * view.axes[1, 2])
    if above > depth * view.slope_y + length * sqrt(1.0 + view.slope_y * view.slope_y):
        return -1
    distance = sqrt(dx * dx + dy * dy + dz * dz)
    if distance > view.reach + length:
        return -1
    seen = view.pixels * length / max(distance - 0.5 * length, 1e-3)
    if seen < LEAST_PIXELS:
        return -1
    if seen >= CLOSE_PIXELS:
        return 0
    return 1 if seen >= FAR_PIXELS else 2


@row
def quaternion(r: Float64s, out: Float64s) -> None:
    """Write the unit quaternion (x, y, z, w) of the rotation `r`, (3, 3), to `out`."""
    trace = r[0, 0] + r[1, 1] + r[2, 2]
    if trace > 0.0:
        s = 2.0 * sqrt(trace + 1.0)
        out[0], out[1] = (r[2, 1] - r[1, 2]) / s, (r[0, 2] - r[2, 0]) / s
        out[2], out[3] = (r[1, 0] - r[0, 1]) / s, 0.25 * s
        return
    i = 0
    if r[1, 1] > r[0, 0]:
        i = 1
    if r[2, 2] > r[i, i]:
        i = 2
    j, k = (i + 1) % 3, (i + 2) % 3
    s = 2.0 * sqrt(max(1.0 + r[i, i] - r[j, j] - r[k, k], 1e-12))
    out[i] = 0.25 * s
    out[j], out[k] = (r[j, i] + r[i, j]) / s, (r[k, i] + r[i, k]) / s
    out[3] = (r[k, j] - r[j, k]) / s


@row
def between(a: Float64s, b: Float64s, alpha: float, out: Float32s) -> None:
    """Write the normalised blend of two quaternions to `out`, the short way round."""
    dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
    share = -alpha if dot < 0.0 else alpha
    size = 0.0
    for c in range(4):
        a[c] = (1.0 - alpha) * a[c] + share * b[c]
        size += a[c] * a[c]
    size = sqrt(size)
    for c in range(4):
        out[c] = a[c] / size


@row
def write_record(
    fish: Drawn, i: int, alpha: float, seconds: float, shine: Float64s, turns: Float64s, out: Float32s
) -> None:
    """Write the record of the fish in row i, its motion blended between two ticks, but for its place."""
    out[3] = fish.length[i]
    quaternion(fish.last_rotation[i], turns[0])
    quaternion(fish.rotation[i], turns[1])
    between(turns[0], turns[1], alpha, out[4:8])
    last, now = fish.last_warp_weight[i], fish.warp_weight[i]
    out[8], out[9], out[10] = fish.last_shape_row[i], fish.shape_row[i], alpha
    out[11] = last + (now - last) * alpha
    out[12], out[13], out[14] = fish.warp_from[i], fish.warp_to[i], fish.species[i]
    chance = (fish.id[i] * 0.6180339887498949) % 1.0
    other = (fish.id[i] * 0.7548776662466927) % 1.0
    rate = 1.1 + 0.6 * sqrt(0.2 / (0.05 + fish.length[i]))
    out[15] = 2.0 * pi * ((seconds * rate + chance) % 10.0) + 0.5 * sin(seconds + 9.0 * other)
    bright = 0.93 + 0.14 * chance
    out[16], out[17] = bright * (0.985 + 0.03 * other), bright
    out[18], out[19] = bright * (1.015 - 0.03 * other), shine[fish.species[i]]


@row
def select(
    fish: Drawn,
    count: int,
    view: View,
    alpha: float,
    seconds: float,
    shine: Float64s,
    turns: Float64s,
    records: Float32s,
    distances: Float32s,
    counts: Int64s,
) -> None:
    """Write the records of the fishes that are seen, level by level, and their distances; see `Culling`."""
    counts[:] = 0
    for i in range(count):
        x = fish.last_position[i, 0] + (fish.position[i, 0] - fish.last_position[i, 0]) * alpha
        y = fish.last_position[i, 1] + (fish.position[i, 1] - fish.last_position[i, 1]) * alpha
        z = fish.last_position[i, 2] + (fish.position[i, 2] - fish.last_position[i, 2]) * alpha
        level = level_at(view, x, y, z, fish.length[i])
        if level < 0:
            continue
        slot = counts[level]
        counts[level] = slot + 1
        out = records[level, slot]
        out[0], out[1], out[2] = x, y, z
        dx, dy, dz = x - view.eye[0], y - view.eye[1], z - view.eye[2]
        distances[level, slot] = dx * dx + dy * dy + dz * dz
        write_record(fish, i, alpha, seconds, shine, turns, out)


def drawn(population: Population) -> Drawn:
    """Return the columns of `population` that are drawn; they go stale when it grows."""
    fish, motor = population.fish, population.motor
    columns = [getattr(fish if name in fish.columns else motor, name) for name in Drawn._fields]
    return Drawn(*columns)


@dataclass
class Culling:
    """Chooses and describes what is drawn. Reads `FishTable` and `MotorTable`; writes its own scratch only."""

    shine: Float64s
    "of each species' skin, (species,)"
    counts: Int64s = field(default_factory=lambda: np.zeros(LEVELS, np.int64))
    "fishes seen at each level, (3,)"

    def __post_init__(self) -> None:
        self._turns = np.zeros((2, 4))
        self._room(64)

    def __call__(self, population: Population, view: View, alpha: float, seconds: float) -> None:
        """Fill the records for a view, blended by `alpha` between the last tick and now."""
        if population.count > self._records.shape[1]:
            self._room(2 * population.count)
        select(
            drawn(population),
            population.count,
            view,
            alpha,
            seconds,
            self.shine,
            self._turns,
            self._records,
            self._distances,
            self.counts,
        )

    def records(self, level: int) -> Float32s:
        """Return the records of a level, (n, 20); those with blended fins from the farthest to the nearest."""
        count = int(self.counts[level])
        seen = self._records[level, :count]
        if level == LEVELS - 1 or count < 2:
            return seen
        sorted_records: Float32s = seen[np.argsort(-self._distances[level, :count])]
        return sorted_records

    def _room(self, capacity: int) -> None:
        self._records = np.zeros((LEVELS, capacity, RECORD), np.float32)
        self._distances = np.zeros((LEVELS, capacity), np.float32)
