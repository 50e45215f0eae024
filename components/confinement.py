"""The hard guarantee that nobody leaves the world or enters ground or rock (papers/000, 6.2).

Rocks are held off as ellipsoids grown by the margin: leaving one along the ray from its centre is
exact in one step. Where rock and ground meet in a wedge the way out is level; where all fails, the
nearest free column serves.
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s
from components.ground import Terrain, beyond, ground_height, rock_square, to_rock
from components.kernels import inlined, row

MARGIN: Final = 0.5
"""How far a fish's origin keeps from ground, rocks, surface and rim, over its length."""

WIDEST_MARGIN: Final = 0.9
"""[m]: shallow water must stay passable to giants."""

_ROUNDS: Final = 12
_LEVEL_FROM: Final = 3
_FARTHEST: Final = 1e12
_BEYOND: Final = 1.000001
_RINGS: Final = 400
_RING_STEP: Final = 0.25


@row
def _into_cylinder(terrain: Terrain, p: Float64s, margin: float) -> bool:
    limit = max(terrain.radius - margin, 0.0)
    out = sqrt(p[0] * p[0] + p[1] * p[1])
    if out <= limit:
        return False
    scale = limit / out / _BEYOND
    p[0] *= scale
    p[1] *= scale
    return True


@row
def _into_water(terrain: Terrain, p: Float64s, margin: float) -> bool:
    low = ground_height(terrain.height, terrain.extent, terrain.cell, p[0], p[1]) + margin
    z = max(low, min(p[2], -margin))
    moved = bool(z != p[2])
    p[2] = z
    return moved


@row
def _out_of_rock(terrain: Terrain, rock: int, p: Float64s, margin: float, level: bool) -> bool:
    a = terrain.rock_radii[rock, 0] + margin
    b = terrain.rock_radii[rock, 1] + margin
    c = terrain.rock_radii[rock, 2] + margin
    u, v, w = to_rock(terrain, rock, p[0], p[1], p[2])
    flat = (u / a) * (u / a) + (v / b) * (v / b)
    upright = (w / c) * (w / c)
    if flat + upright >= 1.0:
        return False
    if flat + upright < 1e-12:
        u, flat = 1e-6 * a, 1e-12
        level = True
    if level and flat > 1e-13:
        scale = sqrt((1.0 - upright) / flat) * _BEYOND
        u, v = u * scale, v * scale
    else:
        scale = _BEYOND / sqrt(flat + upright)
        u, v, w = u * scale, v * scale, w * scale
    cosine, sine = terrain.rock_axes[rock, 0], terrain.rock_axes[rock, 1]
    p[0] = terrain.rock_centre[rock, 0] + cosine * u - sine * v
    p[1] = terrain.rock_centre[rock, 1] + sine * u + cosine * v
    p[2] = terrain.rock_centre[rock, 2] + w
    return True


@row
def _out_of_rocks(terrain: Terrain, p: Float64s, margin: float, level: bool) -> bool:
    moved = False
    square = rock_square(terrain, p[0], p[1])
    for k in range(terrain.rock_first[square], terrain.rock_first[square + 1]):
        rock = terrain.rock_list[k]
        # Most rocks of a square are far: their bounding sphere tells without a division.
        near = not beyond(terrain, rock, p[0], p[1], p[2], margin)
        if near and _out_of_rock(terrain, rock, p, margin, level):
            moved = True
    return moved


@row
def _column_floor(terrain: Terrain, x: float, y: float, margin: float) -> float:
    """Return the lowest z above ground and all rocks over (x, y), with the margin."""
    floor = ground_height(terrain.height, terrain.extent, terrain.cell, x, y) + margin
    for rock in range(len(terrain.rock_centre)):
        u, v, _ = to_rock(terrain, rock, x, y, 0.0)
        u /= terrain.rock_radii[rock, 0] + margin
        v /= terrain.rock_radii[rock, 1] + margin
        inside = 1.0 - u * u - v * v
        if inside > 0.0:
            top = (terrain.rock_radii[rock, 2] + margin) * sqrt(inside) * _BEYOND
            floor = max(floor, terrain.rock_centre[rock, 2] + top + 1e-9)
    return floor


@row
def _to_free_column(terrain: Terrain, p: Float64s, margin: float) -> None:
    """Put p on the nearest column, ring by ring in eight directions, that has free water."""
    x, y = p[0], p[1]
    limit = terrain.radius - margin
    for ring in range(_RINGS):
        far = ring * _RING_STEP
        for k in range(8):
            diagonal = 0.7071067811865476 if k & 1 else 1.0
            dx = 0.0 if k in (2, 6) else (diagonal if k in (0, 1, 7) else -diagonal)
            dy = 0.0 if k in (0, 4) else (diagonal if k in (1, 2, 3) else -diagonal)
            tx, ty = x + far * dx, y + far * dy
            if tx * tx + ty * ty <= limit * limit:
                floor = _column_floor(terrain, tx, ty, margin)
                if floor <= -margin:
                    p[0], p[1], p[2] = tx, ty, max(floor, min(p[2], -margin))
                    return


@inlined
def berth(length: float) -> float:
    """Return how far [m] the origin of a fish of this length [m] keeps from all that bounds the water."""
    return min(MARGIN * length, WIDEST_MARGIN)


@inlined
def _in_open_water(terrain: Terrain, x: float, y: float, z: float, margin: float) -> bool:
    """Say without a call that a point stands free; False where a closer look is needed, and for no number."""
    limit = terrain.radius - margin
    if not (x * x + y * y < limit * limit and z < -margin and limit > 0.0):
        return False
    square = rock_square(terrain, x, y)
    if z > terrain.roof[square] + margin:
        return True
    if not z > ground_height(terrain.height, terrain.extent, terrain.cell, x, y) + margin:
        return False
    near = False
    for k in range(terrain.rock_first[square], terrain.rock_first[square + 1]):
        near |= not beyond(terrain, terrain.rock_list[k], x, y, z, margin)
    return not near


@row
def _bring_out(terrain: Terrain, position: Float64s, row: int, margin: float) -> bool:
    """Move position[row] as `confine` does, having looked closely."""
    p = position[row]
    if not (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] < _FARTHEST):
        p[0] = p[1] = p[2] = 0.0
    moved = False
    for turn in range(_ROUNDS):
        again = _into_cylinder(terrain, p, margin)
        again |= _into_water(terrain, p, margin)
        again |= _out_of_rocks(terrain, p, margin, turn >= _LEVEL_FROM)
        if not again:
            return moved
        moved = True
    _to_free_column(terrain, p, margin)
    return True


@inlined
def confine(terrain: Terrain, position: Float64s, row: int, margin: float) -> bool:
    """Move position[row] [m], of (n, 3), out of ground, rock, surface and rim; return if it moved.

    It keeps `margin` [m] from all of them. What stands free stays untouched, so a second call
    changes nothing. The way from old to new position is the contact's normal. The margin must leave
    water between the highest ground and the surface: below 1 m.
    """
    p = position[row]
    # A call hands over the whole terrain, which takes longer than to see that most stand free.
    if _in_open_water(terrain, p[0], p[1], p[2], margin):
        return False
    return _bring_out(terrain, position, row, margin)
