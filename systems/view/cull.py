"""Which fishes are seen, how finely, and the records by which the GPU draws them (papers/000, 7.1, 7.3; FINDINGS 8).

One point stands for a fish; the frustum is enlarged by the fish's length. What the water hides is left out. The level
of detail follows the length on the picture in pixels. For the view only: nothing here feeds back into the simulation.
"""

from dataclasses import dataclass, field
from math import floor, pi, sin, sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float32s, Float64s, Int32s, Int64s
from components.camera import Camera
from components.fish import Population
from components.kernels import row
from components.motor import shown_between
from components.rotation import between

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
species and part behind the shape that the warp leaves, fin phase; tint, shine and gape."""
GAPES: Final = 64
"""Steps of an opening mouth: 2 n is added to the shine, which is 1 at most, where n of them are open."""
MOST_PART: Final = 0.9999
"""Most that a part adds to a species' number: as float32 it must not reach the next."""
LEVELS: Final = 3
CARD: Final = 2
"""The coarsest level: its fishes are too small to show how they turn within a tick."""


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
    edge_x: float
    "1 / cosine of half the horizontal field of view"
    edge_y: float
    "1 / cosine of half the vertical field of view"
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
    part: Float64s
    last_part: Float64s
    warp_from: Int32s
    warp_part: Float64s
    warp_to: Int32s
    warp_weight: Float64s
    last_warp_weight: Float64s
    gape: Float64s


def view_of(camera: Camera, height: float, aspect: float, visibility: float) -> View:
    """Return the view of `camera` on a target `height` pixels high and `aspect` times as wide."""
    axes = np.stack((camera.right, camera.up, camera.forward))
    slope = camera.slope
    return View(
        np.asarray(camera.eye, np.float64),
        axes,
        slope * aspect,
        slope,
        sqrt(1.0 + (slope * aspect) ** 2),
        sqrt(1.0 + slope**2),
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
    if aside > depth * view.slope_x + length * view.edge_x:
        return -1
    above = abs(dx * view.axes[1, 0] + dy * view.axes[1, 1] + dz * view.axes[1, 2])
    if above > depth * view.slope_y + length * view.edge_y:
        return -1
    distance = sqrt(dx * dx + dy * dy + dz * dz)
    if distance > view.reach + length:
        return -1
    seen = view.pixels * length / max(distance - 0.5 * length, 1e-3)
    if seen < LEAST_PIXELS:
        return -1
    if seen >= CLOSE_PIXELS:
        return 0
    return 1 if seen >= FAR_PIXELS else CARD


@row
def quaternion(r: Float64s, out: Float32s) -> None:
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
def write_shape(fish: Drawn, i: int, alpha: float, after: Int32s, out: Float32s) -> None:
    """Write which shapes the fish in row i shows, and its species with the part behind the shape its warp leaves."""
    last, now = fish.last_warp_weight[i], fish.warp_weight[i]
    out[8], out[9], out[10] = shown_between(
        fish.last_shape_row[i],
        fish.last_part[i],
        fish.shape_row[i],
        fish.part[i],
        alpha,
        after,
    )
    out[11] = last + (now - last) * alpha
    out[12], out[13] = fish.warp_from[i], fish.warp_to[i]
    out[14] = fish.species[i] + min(fish.warp_part[i], MOST_PART)


@row
def write_manner(
    identity: int, length: float, shine: float, seconds: float, fins: bool, out: Float32s
) -> None:
    """Write a fish's own tint, and where its paired fins are in their stroke if they are drawn."""
    chance = identity * 0.6180339887498949
    other = identity * 0.7548776662466927
    chance -= floor(chance)
    other -= floor(other)
    out[15] = 0.0
    if fins:
        rate = 1.1 + 0.6 * sqrt(0.2 / (0.05 + length))
        out[15] = 2.0 * pi * ((seconds * rate + chance) % 10.0) + 0.5 * sin(seconds + 9.0 * other)
    bright = 0.93 + 0.14 * chance
    out[16], out[17] = bright * (0.985 + 0.03 * other), bright
    out[18], out[19] = bright * (1.015 - 0.03 * other), shine


@row
def select(
    fish: Drawn,
    count: int,
    view: View,
    alpha: float,
    seconds: float,
    shine: Float64s,
    after: Int32s,
    axes: Float64s,
    records: Float32s,
    distances: Float32s,
    counts: Int64s,
) -> None:
    """Write the records of the fishes that are seen, level by level, and their distances; see `Culling`."""
    counts[:] = 0
    for i in range(count):
        now = fish.position[i]
        level = level_at(view, now[0], now[1], now[2], fish.length[i])
        if level < 0:
            continue
        slot = counts[level]
        counts[level] = slot + 1
        out = records[level, slot]
        distance = 0.0
        for c in range(3):
            last = fish.last_position[i, c]
            place = last + (now[c] - last) * alpha
            out[c] = place
            distance += (place - view.eye[c]) * (place - view.eye[c])
        distances[level, slot] = distance
        out[3] = fish.length[i]
        if level < CARD:
            between(fish.last_rotation[i], fish.rotation[i], alpha, axes)
            quaternion(axes, out[4:8])
        else:
            quaternion(fish.rotation[i], out[4:8])
        write_shape(fish, i, alpha, after, out)
        gloss = shine[fish.species[i]] + 2.0 * floor(GAPES * fish.gape[i] + 0.5)
        write_manner(fish.id[i], fish.length[i], gloss, seconds, level < CARD, out)


def drawn(population: Population) -> Drawn:
    """Return the columns of `population` that are drawn; they go stale when it grows."""
    tables = (population.fish, population.motor, population.mind)
    owners = (next(t for t in tables if name in t.columns) for name in Drawn._fields)
    return Drawn(*(getattr(t, name) for t, name in zip(owners, Drawn._fields, strict=True)))


@dataclass
class Culling:
    """Chooses and describes what is drawn. Reads fishes, motors and minds; writes its own scratch only."""

    shine: Float64s
    "of each species' skin, (species,)"
    after: Int32s
    "the shape row that follows each, `RepertoireLibrary.after`, (E,)"
    counts: Int64s = field(default_factory=lambda: np.zeros(LEVELS, np.int64))
    "fishes seen at each level, (3,)"

    def __post_init__(self) -> None:
        self._axes = np.zeros((3, 3))
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
            self.after,
            self._axes,
            self._records,
            self._distances,
            self.counts,
        )

    def records(self, level: int) -> Float32s:
        """Return the records of a level, (n, 20); those with blended fins from the farthest to the nearest."""
        count = int(self.counts[level])
        seen = self._records[level, :count]
        if level == CARD or count < 2:
            return seen
        sorted_records: Float32s = seen[np.argsort(-self._distances[level, :count])]
        return sorted_records

    def _room(self, capacity: int) -> None:
        self._records = np.zeros((LEVELS, capacity, RECORD), np.float32)
        self._distances = np.zeros((LEVELS, capacity), np.float32)
