"""Wandering: swim at leisure to one place after another (papers/004).

A place is drawn by chance: beside a home point of the species where there are any, beside a rock where there are
rocks, else anywhere within reach. A pacifist that sees the submarine sometimes comes to look.
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s
from components.chance import WANDER, uniform
from components.ground import Terrain, ground_height
from components.kernels import inlined, row
from components.mind import Role
from components.vector import point

PACIFIST: Final = int(Role.PACIFIST)

_STRAY: Final = 4.0
_LIFT: Final = 0.7
_SLOPE: Final = 0.3
_LEAP: Final = 12.0
_CURIOUS: Final = 0.35
_LONGEST: Final = 8.0
_LOOK_FROM: Final = 4.0


@row
def _near_home(terrain: Terrain, kind: int, u: float) -> int:
    """Return one of the species' home points, drawn by u in [0, 1), or -1."""
    homes = 0
    for k in range(len(terrain.home)):
        homes += terrain.home_species[k] == kind
    wanted = int(u * homes)
    for k in range(len(terrain.home)):
        if terrain.home_species[k] == kind:
            if wanted == 0:
                return k
            wanted -= 1
    return -1


@row
def choose_place(
    terrain: Terrain, kind: int, x: float, y: float, seed: int, now: int, identity: int
) -> tuple[float, float]:
    """Return a place (x, y) [m] to wander to from (x, y)."""
    u, v = uniform(seed, WANDER, 4 * now, identity), uniform(seed, WANDER, 4 * now + 1, identity)
    a = 2.0 * uniform(seed, WANDER, 4 * now + 2, identity) - 1.0
    b = 2.0 * uniform(seed, WANDER, 4 * now + 3, identity) - 1.0
    home = _near_home(terrain, kind, u)
    if home >= 0:
        tx, ty = terrain.home[home, 0] + _STRAY * a, terrain.home[home, 1] + _STRAY * b
    elif len(terrain.rock_centre) > 0 and v < 0.75:
        rock = int(u * len(terrain.rock_centre))
        room = _STRAY + max(terrain.rock_radii[rock, 0], terrain.rock_radii[rock, 1])
        tx, ty = terrain.rock_centre[rock, 0] + room * a, terrain.rock_centre[rock, 1] + room * b
    else:
        tx, ty = x + _LEAP * a, y + _LEAP * b
    far = sqrt(tx * tx + ty * ty)
    inside = 0.8 * terrain.radius
    if far > inside:
        tx, ty = tx * inside / far, ty * inside / far
    return tx, ty


@row
def depart(
    terrain: Terrain,
    kind: int,
    x: float,
    y: float,
    z: float,
    low: float,
    high: float,
    speed: float,
    seed: int,
    now: int,
    identity: int,
    out: Float64s,
) -> int:
    """Write the unit direction to a new place between z `low` and `high`, (3,); return its tick."""
    tx, ty = choose_place(terrain, kind, x, y, seed, now, identity)
    u = uniform(seed, WANDER, 4 * now + 1, -1 - identity)
    bottom = ground_height(terrain.height, terrain.extent, terrain.cell, tx, ty) + 0.5
    tz = max(low, bottom) + _LIFT * u * u * u * max(high - max(low, bottom), 0.0)
    dx, dy, dz = tx - x, ty - y, tz - z
    level = sqrt(dx * dx + dy * dy)
    point(out, dx + 1e-6, dy, min(max(dz, -_SLOPE * level), _SLOPE * level))
    seconds = min(max(level / max(speed, 0.05), 2.0), _LONGEST)
    return now + int(60.0 * seconds)


@inlined
def wander(
    role: int, direction: Float64s, drawn: float, away: Float64s, sight: float, out: Float64s
) -> tuple[int, float]:
    """Write the wanted direction, (3,); return gear and urgency. `drawn` is this leg's chance.

    `away` [m] is the offset from the submarine.
    """
    out[0], out[1], out[2] = direction[0], direction[1], direction[2]
    far = sqrt(away[0] * away[0] + away[1] * away[1] + away[2] * away[2])
    if role == PACIFIST and drawn < _CURIOUS and _LOOK_FROM < far < 2.0 * sight:
        out[0], out[1], out[2] = -away[0] / far, -away[1] / far, -away[2] / far
        return 1, 0.1
    return (1 if drawn > 0.75 else 0), 0.1
