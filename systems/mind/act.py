"""Acting: the behaviour routine of the intention, told what it needs to know of the focus (papers/004).

The focus of attention lets one target pass. What else was perceived remains as motor preferences: depth, the rim and
a predator farther off bend the wanted direction a little, and never turn it round (FINDINGS 2).
"""

from math import nan, sqrt
from typing import Final

from components.arrays import Float64s
from components.chance import WANDER as LEG
from components.chance import uniform
from components.ground import Terrain, ground_height
from components.kernels import inlined, merged, row
from components.mind import FOOD, SUBMARINE, Courtship, Role
from components.vector import level_off, point
from systems.mind.attention import Attention, Thoughts
from systems.mind.behave.avoid_fish import avoid_fish, avoid_submarine, jostle
from systems.mind.behave.avoid_static_obstacle import avoid_static_obstacle, choose_side
from systems.mind.behave.eat import eat
from systems.mind.behave.escape import escape, find_shelter
from systems.mind.behave.leave import leave
from systems.mind.behave.mate import JILTED, MATED, mate
from systems.mind.behave.school import heed, roam, school
from systems.mind.behave.wander import depart, nearest_home, visit, wander
from systems.mind.crowd import Crowd, place_of
from systems.mind.intend import (
    AVOID_FISH,
    AVOID_OBSTACLE,
    EAT,
    ESCAPE,
    LEAVE,
    MATE,
    OBEY,
    SCHOOL,
    WANDER,
)
from systems.mind.perceive import HORIZON
from systems.mind.scene import Minds, Scene
from systems.mind.seek import is_male

NONE: Final = int(Courtship.NONE)

_PREDATOR: Final = int(Role.PREDATOR)
_RIM_FROM: Final = 0.72
_RIM_PUSH: Final = 0.9
_DEPTH_PUSH: Final = 0.7
_DEPTH_SOFT: Final = 1.5
_CALM_SLOPE: Final = 0.45
_STEEPEST: Final = 0.8
_SHUN: Final = 0.8
SCHOOL_FLATNESS: Final = 0.7
"""How much less a school climbs and dives than it would."""

_SHELTER_WITHIN: Final = 8.0
_RING: Final = 3.5
_WIDE_RING: Final = 6.0


@row
def liked_depth(
    terrain: Terrain, x: float, y: float, length: float, deep: float, shallow: float
) -> tuple[float, float]:
    """Return the lowest and highest z [m] that a fish likes at (x, y), between `deep` and `shallow` [m]."""
    floor = ground_height(terrain.height, terrain.extent, terrain.cell, x, y)
    low = max(deep, floor + 1.2 * length + 0.3)
    high = min(shallow, -1.2 * length - 0.2)
    if low > high:
        low = high = 0.5 * (low + high)
    return low, high


@inlined
def _travel(
    scene: Scene, kind: int, x: float, y: float, cohort: int, roaming: Float64s
) -> tuple[float, float, float]:
    """Return where a cohort travels: about the nearest home point of its kind, or the reef where it has none.

    What `roam` says of the cohort is remembered in `roaming`, (8,), for its next fish.
    """
    if roaming[0] != cohort:
        roaming[0] = cohort
        roaming[1], roaming[2], roaming[3] = roam(scene.seed, cohort, scene.now, 1.0)
    terrain = scene.terrain
    home = nearest_home(terrain, kind, x, y)
    if home < 0:
        return terrain.radius * roaming[1], terrain.radius * roaming[2], roaming[3]
    stray = terrain.home[home, 3]
    return (
        terrain.home[home, 0] + stray * roaming[1],
        terrain.home[home, 1] + stray * roaming[2],
        roaming[3],
    )


@row
def _stay_in_range(
    radius: float, x: float, y: float, z: float, low: float, high: float, out: Float64s
) -> None:
    """Lean the wanted direction towards the liked depth and away from the rim."""
    if z > high:
        out[2] -= _DEPTH_PUSH * min((z - high) / _DEPTH_SOFT, 1.0)
    elif z < low:
        out[2] += _DEPTH_PUSH * min((low - z) / _DEPTH_SOFT, 1.0)
    far = (x * x + y * y) / (radius * radius)
    if far > _RIM_FROM * _RIM_FROM:
        push = _RIM_PUSH * min((far - _RIM_FROM * _RIM_FROM) / (1.0 - _RIM_FROM * _RIM_FROM), 1.0)
        out[0] -= push * x / radius
        out[1] -= push * y / radius


@row
def _shun(danger: Float64s, fear: float, out: Float64s) -> None:
    """Lean the wanted direction away from a predator, `danger` as `heed` writes it, that does not frighten yet."""
    dx, dy, dz = danger[0], danger[1], danger[2]
    size = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2])
    push = _SHUN * fear * size / (sqrt(dx * dx + dy * dy + dz * dz) + 1e-9)
    out[0], out[1], out[2] = out[0] - push * dx, out[1] - push * dy, out[2] - 0.5 * push * dz


@inlined
def _wander(
    terrain: Terrain, kind: int, identity: int, x: float, y: float, z: float, pace: float,
    low: float, high: float, seed: int, now: int, until: int, leg: Float64s, out: Float64s,
) -> tuple[int, float, float, int]:  # fmt: skip
    """Set out anew where the `leg` has ended, then wander; the last returned is the tick of its end."""
    if now >= until:
        until = depart(terrain, kind, x, y, z, low, high, pace, seed, now, identity, leg)
    gear, urgency, throttle = wander(leg, uniform(seed, LEG, until, identity), out)
    return gear, urgency, throttle, until


@row
def _go_for(
    crowd: Crowd, me: int, prey: int, food: int, position: Float64s, last: Float64s,
    speeds: Float64s, nose: float, mouth: float, hunger: float, now: int, out: Float64s,
) -> tuple[int, float, float, float]:  # fmt: skip
    """Go for the prey at a place of the crowd, else for the food of a row; `position` [m] is food's, `last` before."""
    if prey >= 0:
        dx, dy, dz = crowd.x[prey], crowd.y[prey], crowd.z[prey]
        s = crowd.speed[prey]
        vx, vy, vz = s * crowd.hx[prey], s * crowd.hy[prey], s * crowd.hz[prey]
    else:
        dx, dy, dz = position[food, 0], position[food, 1], position[food, 2]
        vx, vy, vz = (
            60.0 * (dx - last[food, 0]),
            60.0 * (dy - last[food, 1]),
            60.0 * (dz - last[food, 2]),
        )
    return eat(
        crowd, me, speeds, dx - crowd.x[me], dy - crowd.y[me], dz - crowd.z[me], vx, vy, vz, nose,
        mouth, hunger, prey >= 0, now, out,
    )  # fmt: skip


@row
def _avoid(
    crowd: Crowd, me: int, submarine: bool, away: Float64s, other: int, when: float,
    heading: Float64s, out: Float64s,
) -> tuple[int, float, float]:  # fmt: skip
    """Leave the way of the fish, or the submarine, in focus; without any, go on as before."""
    if submarine:
        return avoid_submarine(crowd, me, away, min(when, HORIZON), out)
    if other >= 0:
        return avoid_fish(crowd, me, other, min(when, HORIZON), out)
    out[0], out[1], out[2] = heading[0], heading[1], heading[2]
    return 1, 0.2, 1.0


@inlined
def heed_worst(
    crowd: Crowd, me: int, predator: int, scare: float, away: Float64s, velocity: Float64s,
    danger: Float64s,
) -> None:  # fmt: skip
    """Write what schooling and fleeing heed of the most dangerous predator, else of the submarine, (7,)."""
    if predator >= 0:
        s = crowd.speed[predator]
        heed(
            crowd.x[predator] - crowd.x[me], crowd.y[predator] - crowd.y[me],
            crowd.z[predator] - crowd.z[me], s * crowd.hx[predator], s * crowd.hy[predator],
            s * crowd.hz[predator], crowd.length[predator], danger,
        )  # fmt: skip
    elif scare > 0.1:
        heed(
            -away[0], -away[1], -away[2], velocity[0, 0], velocity[0, 1], velocity[0, 2], 1.0, danger
        )  # fmt: skip
    else:
        danger[6] = 0.0


@merged
def _court(
    scene: Scene, me: int, minds: Minds, focus: int, high: float, out: Float64s
) -> tuple[int, float, float]:
    """Court the partner in focus, and keep account of the phases."""
    crowd, i = scene.crowd, scene.crowd.row[me]
    kind, identity = crowd.species[me], crowd.id[me]
    partner = place_of(scene.places, crowd, focus)
    answers = crowd.phase[partner] if crowd.courting[partner] == identity else NONE
    gear, urgency, throttle, phase = mate(
        crowd, me, partner, is_male(scene.seed, identity), minds.courtship[i],
        minds.courtship_since[i], answers, scene.senses.speed[kind], scene.now, high, out,
    )  # fmt: skip
    if phase in (MATED, JILTED):
        waited = 0 if phase == MATED else int(0.5 * scene.senses.breeding[kind])
        minds.mated_at[i], phase = scene.now - waited, NONE
    if phase != minds.courtship[i]:
        minds.courtship[i], minds.courtship_since[i] = phase, scene.now
    return gear, urgency, throttle


@merged
def _flee(
    scene: Scene, thoughts: Thoughts, k: int, attention: Attention, piece: int
) -> tuple[int, float, float]:
    """Flee from all predators seen and from the submarine: who does not school, to shelter."""
    crowd, me = scene.crowd, thoughts.me[k]
    kind, danger, shelter = crowd.species[me], thoughts.danger[k], attention.shelter[piece]
    sheltered = scene.senses.schooling[kind] == 0 and danger[6] > 0.0
    if sheltered:
        sheltered = find_shelter(
            scene.terrain, kind, crowd.x[me], crowd.y[me], crowd.z[me], danger[0], danger[1],
            _SHELTER_WITHIN, shelter,
        )  # fmt: skip
    return escape(
        crowd, me, thoughts.hunters[k], thoughts.seen[k], thoughts.away[k], thoughts.scare[k],
        shelter, sheltered, thoughts.shoal[k], thoughts.number[k], scene.seed, scene.now,
        attention.out[piece],
    )  # fmt: skip


@merged
def _act_one(
    scene: Scene, minds: Minds, thoughts: Thoughts, k: int, attention: Attention, piece: int
) -> None:
    """Run the behaviour routine of one mind's intention."""
    crowd, senses, terrain, now = scene.crowd, scene.senses, scene.terrain, scene.now
    me, previous, obstacle = thoughts.me[k], thoughts.previous[k], thoughts.obstacle[k]
    i, kind, length, identity = crowd.row[me], crowd.species[me], crowd.length[me], crowd.id[me]
    x, y, z, speeds = crowd.x[me], crowd.y[me], crowd.z[me], senses.speed[kind]
    out, danger, normal = attention.out[piece], thoughts.danger[k], thoughts.normal[k]
    heading = minds.heading[i]
    intention, focus, gape = minds.intention[i], minds.focus[i], 0.0
    low, high = liked_depth(terrain, x, y, length, senses.deep[kind], senses.shallow[kind])
    calm = intention in (SCHOOL, WANDER, LEAVE)
    if intention == SCHOOL:
        to_x, to_y, up = _travel(scene, kind, x, y, minds.cohort[i], attention.roaming[piece])
        blocked = min(max(3.0 - 2.0 * obstacle, 0.0), 1.0)
        gear, urgency, throttle = school(
            crowd, me, thoughts.near[k], thoughts.distance[k], thoughts.found[k],
            thoughts.shoal[k], thoughts.number[k], senses.spacing[kind] * length, to_x, to_y,
            low + up * (high - low), minds.gear[i], minds.fear[i], danger, normal, blocked, out,
        )  # fmt: skip
        out[2] *= SCHOOL_FLATNESS
    elif intention == AVOID_OBSTACLE:
        before = minds.side[i] if previous == AVOID_OBSTACLE else 0
        side = choose_side(crowd.hx[me], crowd.hy[me], normal, before, identity)
        minds.side[i] = side
        gear, urgency, throttle = avoid_static_obstacle(
            crowd.hx[me], crowd.hy[me], crowd.hz[me], normal,
            min(max(1.0 - obstacle, 0.0), 1.0), side, out,
        )  # fmt: skip
    elif intention == AVOID_FISH:
        when = min(thoughts.when[k], thoughts.meets[k])
        gear, urgency, throttle = _avoid(
            crowd, me, focus == SUBMARINE, thoughts.away[k], thoughts.other[k], when, heading, out
        )
    elif intention == EAT and focus != -1:
        prey = place_of(scene.places, crowd, focus)
        gear, urgency, throttle, gape = _go_for(
            crowd, me, prey, FOOD - focus, scene.food_position, scene.food_last, speeds,
            senses.nose[kind], senses.mouth[kind], minds.hunger[i], now, out,
        )  # fmt: skip
    elif intention == MATE:
        gear, urgency, throttle = _court(scene, me, minds, focus, high, out)
    elif intention == ESCAPE:
        gear, urgency, throttle = _flee(scene, thoughts, k, attention, piece)
    elif intention == LEAVE:
        gear, urgency, throttle = leave(terrain, crowd, me, thoughts.rise[k], low, high, out)
    elif focus == SUBMARINE:
        ring = _WIDE_RING if senses.role[kind] == _PREDATOR else _RING + length
        gear, urgency, throttle = visit(crowd, me, speeds, thoughts.away[k], ring, now, out)
    else:
        gear, urgency, throttle, minds.wander_until[i] = _wander(
            terrain, kind, identity, x, y, z, max(speeds[0], 0.3) * length, low, high, scene.seed,
            now, minds.wander_until[i], minds.wander[i], out,
        )  # fmt: skip
        gear = max(gear, 1) if intention == EAT else gear
    if intention in (SCHOOL, ESCAPE):
        jostle(crowd, me, thoughts.near[k], thoughts.distance[k], thoughts.found[k], out)
    if calm:
        _stay_in_range(terrain.radius, x, y, z, low, high, out)
    if thoughts.predator[k] >= 0 and (calm or intention in (EAT, MATE)) and intention != SCHOOL:
        _shun(danger, minds.fear[i], out)
    point(heading, out[0], out[1], out[2])
    level_off(heading, _CALM_SLOPE if calm else _STEEPEST)
    minds.gear[i], minds.urgency[i], minds.throttle[i] = gear, urgency, throttle
    minds.gape[i] = gape


@merged
def act(
    scene: Scene, minds: Minds, thoughts: Thoughts, begin: int, end: int, attention: Attention,
    piece: int,
) -> None:  # fmt: skip
    """Run the behaviour routines of the minds of rows begin..end; write heading, gear, urgency, throttle and gape."""
    attention.roaming[piece, 0] = nan  # no cohort is equal to it
    for k in range(begin, end):
        heed_worst(
            scene.crowd, thoughts.me[k], thoughts.predator[k], thoughts.scare[k], thoughts.away[k],
            scene.submarine_velocity, thoughts.danger[k],
        )  # fmt: skip
        if thoughts.previous[k] != OBEY:
            _act_one(scene, minds, thoughts, k, attention, piece)
