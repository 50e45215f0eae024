"""Wandering: swim at leisure to one place after another (papers/004).

A place is drawn by chance: at the nearest home point of the species where there are any, beside a rock where there are
rocks, else anywhere within reach. Pacifists come to look at the submarine, stand before it and go round it; predators
measure it from farther off. Then they lose interest.
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s
from components.chance import CURIOSITY, WANDER, uniform
from components.ground import Terrain, ground_height
from components.kernels import inlined, row
from components.vector import point
from systems.mind.behave.pace import pace
from systems.mind.crowd import Crowd

INTEREST_TICKS: Final = 1800
"""[ticks] for which a fish keeps its interest, or the lack of it."""

LOOK_TICKS: Final = 300
"""[ticks] for which a curious fish stands and looks before it goes round."""

_STRAY: Final = 4.0
_LIFT: Final = 0.7
_SLOPE: Final = 0.3
_LEAP: Final = 12.0
_LONGEST: Final = 8.0
_ELBOW_ROOM: Final = 0.6
_LINGER: Final = 0.35
_LINGER_FROM: Final = 0.62
_BRISK_FROM: Final = 0.75


@row
def nearest_home(terrain: Terrain, kind: int, x: float, y: float) -> int:
    """Return the home point of the species that is nearest to (x, y), or -1."""
    best, nearest = -1, 0.0
    for k in range(len(terrain.home)):
        dx, dy = terrain.home[k, 0] - x, terrain.home[k, 1] - y
        square = dx * dx + dy * dy
        if terrain.home_species[k] == kind and (best < 0 or square < nearest):
            best, nearest = k, square
    return best


@row
def choose_place(
    terrain: Terrain, kind: int, x: float, y: float, seed: int, now: int, identity: int
) -> tuple[float, float]:
    """Return a place (x, y) [m] to wander to from (x, y)."""
    u, v = uniform(seed, WANDER, 4 * now, identity), uniform(seed, WANDER, 4 * now + 1, identity)
    a = 2.0 * uniform(seed, WANDER, 4 * now + 2, identity) - 1.0
    b = 2.0 * uniform(seed, WANDER, 4 * now + 3, identity) - 1.0
    home = nearest_home(terrain, kind, x, y)
    if home >= 0:
        stray = terrain.home[home, 3]
        tx, ty = terrain.home[home, 0] + stray * a, terrain.home[home, 1] + stray * b
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
    home = nearest_home(terrain, kind, x, y)
    if home >= 0:
        high = min(high, terrain.home[home, 2] + terrain.home[home, 3])
    tz = max(low, bottom) + _LIFT * u * u * u * max(high - max(low, bottom), 0.0)
    dx, dy, dz = tx - x, ty - y, tz - z
    level = sqrt(dx * dx + dy * dy)
    point(out, dx + 1e-6, dy, min(max(dz, -_SLOPE * level), _SLOPE * level))
    seconds = min(max(level / max(speed, 0.05), 2.0), _LONGEST)
    return now + int(60.0 * seconds)


@row
def is_curious(seed: int, now: int, identity: int, chance: float) -> bool:
    """Return whether a fish cares to look at something new: for half a minute at a time, by `chance`, 0 to 1."""
    slot = (now + 61 * (identity & 31)) // INTEREST_TICKS
    return uniform(seed, CURIOSITY, slot, identity) < chance


@row
def visit(
    crowd: Crowd, me: int, speeds: Float64s, away: Float64s, ring: float, now: int, out: Float64s
) -> tuple[int, float, float]:
    """Write the wanted direction, (3,), of a fish that looks at the submarine; return gear, urgency, throttle.

    It comes to `ring` [m] from it, `away` [m], (3,), being its offset from it; there it stands and looks, or
    goes round it, in turn. `speeds`: the species' in its gears [BL/s], (3,).
    """
    identity, length = crowd.id[me], crowd.length[me]
    x, y, z = away[0], away[1], away[2]
    far = sqrt(x * x + y * y + z * z) + 1e-9
    beyond = far - ring
    if beyond < -_ELBOW_ROOM:
        out[0], out[1], out[2] = x, y, 0.3 * z
        return 1, 0.3, 1.0
    if beyond > _ELBOW_ROOM:
        out[0], out[1], out[2] = -x, -y, -z
        gear, throttle = pace(speeds, length, max(0.6 * beyond, 0.5 * speeds[0] * length))
        return min(gear, 1), 0.15, min(throttle, 1.0)
    if (now // LOOK_TICKS + identity) & 1:
        out[0], out[1], out[2] = -x, -y, -z
        return 0, 0.3, 0.0
    side = 1.0 if identity & 2 else -1.0
    inward = 0.6 * beyond / (_ELBOW_ROOM * far)
    out[0], out[1] = -side * y / far - inward * x, side * x / far - inward * y
    out[2] = -0.3 * z / far
    return 0, 0.2, 1.0


@inlined
def wander(direction: Float64s, drawn: float, out: Float64s) -> tuple[int, float, float]:
    """Write the wanted direction, (3,); return gear, urgency, throttle. `drawn` is this leg's chance.

    Some legs are brisk, most slow, some nearly a stop.
    """
    out[0], out[1], out[2] = direction[0], direction[1], direction[2]
    throttle = _LINGER if _LINGER_FROM < drawn < _BRISK_FROM else 1.0
    return (1 if drawn > _BRISK_FROM else 0), 0.1, throttle
