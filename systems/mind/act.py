"""Acting: the behaviour routine of the intention, told what it needs to know of the focus (papers/004).

The focus of attention lets one target pass. What else was perceived remains as motor preferences: depth, the rim and
a predator farther off bend the wanted direction a little, and never turn it round (FINDINGS 2).
"""

from math import sqrt
from typing import Final

from components.arrays import Float64s
from components.chance import WANDER, uniform
from components.ground import ground_height
from components.index import row_of
from components.kernels import inlined, row
from components.mind import FOOD, SUBMARINE, Courtship, Role
from components.vector import level_off, point
from systems.mind.behave.avoid_fish import avoid_fish, avoid_submarine
from systems.mind.behave.avoid_static_obstacle import avoid_static_obstacle, choose_side
from systems.mind.behave.eat import eat
from systems.mind.behave.escape import escape, find_shelter
from systems.mind.behave.leave import leave
from systems.mind.behave.mate import JILTED, MATED, mate
from systems.mind.behave.school import heed, roam, school
from systems.mind.behave.wander import depart, visit, wander
from systems.mind.intend import (
    AVOID_FISH,
    AVOID_OBSTACLE,
    EAT,
    ESCAPE,
    LEAVE,
    MATE,
    SCHOOL,
)
from systems.mind.perceive import HORIZON, Attention
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
_SHELTER_WITHIN: Final = 8.0
_RING: Final = 3.5
_WIDE_RING: Final = 6.0


@inlined
def place_of(scene: Scene, identity: int) -> int:
    """Return where the fish `identity` stands in the crowd, -1 where it lives no more."""
    if identity < 0:
        return -1
    i = row_of(scene.places, identity)
    return scene.crowd.place[i] if i >= 0 else -1


@inlined
def liked_depth(scene: Scene, me: int) -> tuple[float, float]:
    """Return the lowest and highest z [m] that the fish likes where it is."""
    crowd, terrain, kind = scene.crowd, scene.terrain, scene.crowd.species[me]
    floor = ground_height(terrain.height, terrain.extent, terrain.cell, crowd.x[me], crowd.y[me])
    length = crowd.length[me]
    low = max(scene.senses.deep[kind], floor + 1.2 * length + 0.3)
    high = min(scene.senses.shallow[kind], -1.2 * length - 0.2)
    if low > high:
        low = high = 0.5 * (low + high)
    return low, high


@inlined
def _stay_in_range(scene: Scene, me: int, low: float, high: float, out: Float64s) -> None:
    """Lean the wanted direction towards the liked depth and away from the rim."""
    crowd, radius = scene.crowd, scene.terrain.radius
    x, y, z = crowd.x[me], crowd.y[me], crowd.z[me]
    if z > high:
        out[2] -= _DEPTH_PUSH * min((z - high) / _DEPTH_SOFT, 1.0)
    elif z < low:
        out[2] += _DEPTH_PUSH * min((low - z) / _DEPTH_SOFT, 1.0)
    far = (x * x + y * y) / (radius * radius)
    if far > _RIM_FROM * _RIM_FROM:
        push = _RIM_PUSH * min((far - _RIM_FROM * _RIM_FROM) / (1.0 - _RIM_FROM * _RIM_FROM), 1.0)
        out[0] -= push * x / radius
        out[1] -= push * y / radius


@inlined
def _shun(scene: Scene, me: int, predator: int, fear: float, out: Float64s) -> None:
    """Lean the wanted direction away from a predator that does not frighten yet."""
    crowd = scene.crowd
    dx, dy, dz = (
        crowd.x[me] - crowd.x[predator],
        crowd.y[me] - crowd.y[predator],
        crowd.z[me] - crowd.z[predator],
    )
    size = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2])
    push = _SHUN * fear * size / (sqrt(dx * dx + dy * dy + dz * dz) + 1e-9)
    out[0], out[1], out[2] = out[0] + push * dx, out[1] + push * dy, out[2] + 0.5 * push * dz


@row
def _wander(scene: Scene, me: int, minds: Minds, out: Float64s) -> tuple[int, float, float]:
    """Set out anew where the leg has ended, then wander."""
    crowd, senses, i = scene.crowd, scene.senses, scene.crowd.row[me]
    kind, identity = crowd.species[me], crowd.id[me]
    low, high = liked_depth(scene, me)
    if scene.now >= minds.wander_until[i]:
        minds.wander_until[i] = depart(
            scene.terrain, kind, crowd.x[me], crowd.y[me], crowd.z[me], low, high,
            max(senses.speed[kind, 0], 0.3) * crowd.length[me], scene.seed, scene.now, identity,
            minds.wander[i],
        )  # fmt: skip
    drawn = uniform(scene.seed, WANDER, minds.wander_until[i], identity)
    gear, urgency, throttle = wander(minds.wander[i], drawn, out)
    _stay_in_range(scene, me, low, high, out)
    return gear, urgency, throttle


@row
def _visit(scene: Scene, me: int, away: Float64s, out: Float64s) -> tuple[int, float, float]:
    """Look at the submarine: predators from farther off."""
    crowd, kind = scene.crowd, scene.crowd.species[me]
    ring = _WIDE_RING if scene.senses.role[kind] == _PREDATOR else _RING + crowd.length[me]
    low, high = liked_depth(scene, me)
    gear, urgency, throttle = visit(crowd, me, scene.senses.speed[kind], away, ring, scene.now, out)
    _stay_in_range(scene, me, low, high, out)
    return gear, urgency, throttle


@inlined
def _school(
    scene: Scene, me: int, minds: Minds, attention: Attention, piece: int, found: int,
    number: float, alarm: float, obstacle: float,
) -> tuple[int, float, float]:  # fmt: skip
    """School among the neighbours seen."""
    crowd, i = scene.crowd, scene.crowd.row[me]
    low, high = liked_depth(scene, me)
    x, y, up = roam(scene.seed, minds.cohort[i], scene.now, scene.terrain.radius)
    spacing = scene.senses.spacing[crowd.species[me]] * crowd.length[me]
    out, blocked = attention.out[piece], min(max(3.0 - 2.0 * obstacle, 0.0), 1.0)
    gear, urgency, throttle = school(
        crowd, me, attention.near[piece], attention.distance[piece], found, attention.shoal[piece],
        number, spacing, x, y, low + up * (high - low), minds.gear[i], alarm,
        attention.danger[piece], attention.normal[piece], blocked, out,
    )  # fmt: skip
    _stay_in_range(scene, me, low, high, out)
    out[2] *= 0.7
    return gear, urgency, throttle


@row
def _eat(
    scene: Scene, me: int, minds: Minds, focus: int, out: Float64s
) -> tuple[int, float, float, float]:
    """Go for the prey or food in focus; without any, search."""
    crowd, senses, i = scene.crowd, scene.senses, scene.crowd.row[me]
    kind, prey = crowd.species[me], place_of(scene, focus)
    if prey >= 0:
        dx, dy, dz = (
            crowd.x[prey] - crowd.x[me],
            crowd.y[prey] - crowd.y[me],
            crowd.z[prey] - crowd.z[me],
        )
        s = crowd.speed[prey]
        vx, vy, vz = s * crowd.hx[prey], s * crowd.hy[prey], s * crowd.hz[prey]
    elif focus <= FOOD:
        k, place, last = FOOD - focus, scene.food_position, scene.food_last
        dx, dy, dz = place[k, 0] - crowd.x[me], place[k, 1] - crowd.y[me], place[k, 2] - crowd.z[me]
        vx, vy, vz = (
            60.0 * (place[k, 0] - last[k, 0]),
            60.0 * (place[k, 1] - last[k, 1]),
            60.0 * (place[k, 2] - last[k, 2]),
        )
    else:
        gear, urgency, throttle = _wander(scene, me, minds, out)
        return max(gear, 1), urgency, throttle, 0.0
    return eat(
        crowd, me, senses.speed[kind], dx, dy, dz, vx, vy, vz, senses.nose[kind],
        senses.mouth[kind], minds.hunger[i], prey >= 0, scene.now, out,
    )  # fmt: skip


@row
def _mate(
    scene: Scene, me: int, minds: Minds, other: int, out: Float64s
) -> tuple[int, float, float]:
    """Court the partner, and keep account of the phases."""
    crowd, i = scene.crowd, scene.crowd.row[me]
    answers = crowd.phase[other] if crowd.courting[other] == crowd.id[me] else NONE
    kind, (_, high) = crowd.species[me], liked_depth(scene, me)
    gear, urgency, throttle, phase = mate(
        crowd, me, other, is_male(scene.seed, crowd.id[me]), minds.courtship[i],
        minds.courtship_since[i], answers, scene.senses.speed[kind], scene.now, high, out,
    )  # fmt: skip
    if phase == MATED:
        minds.mated_at[i], phase = scene.now, NONE
    elif phase == JILTED:
        minds.mated_at[i], phase = scene.now - int(0.5 * scene.senses.breeding[kind]), NONE
    elif phase == minds.courtship[i]:
        return gear, urgency, throttle
    minds.courtship[i], minds.courtship_since[i] = phase, scene.now
    return gear, urgency, throttle


@row
def _escape(
    scene: Scene, me: int, attention: Attention, piece: int, seen: int, scare: float, number: float
) -> tuple[int, float, float]:  # fmt: skip
    """Flee from all predators seen and from the submarine."""
    crowd, kind, out = scene.crowd, scene.crowd.species[me], attention.out[piece]
    away, danger, shelter = attention.away[piece], attention.danger[piece], attention.shelter[piece]
    sheltered = False
    if scene.senses.schooling[kind] == 0 and danger[6] > 0.0:
        sheltered = find_shelter(
            scene.terrain, kind, crowd.x[me], crowd.y[me], crowd.z[me], danger[0], danger[1],
            _SHELTER_WITHIN, shelter,
        )  # fmt: skip
    return escape(
        crowd, me, attention.hunters[piece], seen, away, scare, shelter, sheltered,
        attention.shoal[piece], number, scene.seed, scene.now, out,
    )  # fmt: skip


@row
def _avoid(
    scene: Scene, me: int, minds: Minds, attention: Attention, piece: int, other: int,
    when: float, out: Float64s,
) -> tuple[int, float, float]:  # fmt: skip
    """Leave the way of the fish, or the submarine, in focus; without any, go on as before."""
    i = scene.crowd.row[me]
    if minds.focus[i] == SUBMARINE:
        return avoid_submarine(scene.crowd, me, attention.away[piece], min(when, HORIZON), out)
    if other >= 0:
        return avoid_fish(scene.crowd, me, other, min(when, HORIZON), out)
    for axis in range(3):
        out[axis] = minds.heading[i, axis]
    return 1, 0.2, 1.0


@row
def _swerve(
    scene: Scene, me: int, minds: Minds, normal: Float64s, obstacle: float, again: bool,
    out: Float64s,
) -> tuple[int, float, float]:  # fmt: skip
    """Swing round the obstacle ahead."""
    crowd, i = scene.crowd, scene.crowd.row[me]
    hx, hy, hz = crowd.hx[me], crowd.hy[me], crowd.hz[me]
    side = choose_side(hx, hy, normal, minds.side[i] if again else 0, crowd.id[me])
    minds.side[i] = side
    near = min(max(1.0 - obstacle, 0.0), 1.0)
    return avoid_static_obstacle(hx, hy, hz, normal, near, side, out)


@row
def _leave(scene: Scene, me: int, rise: float, out: Float64s) -> tuple[int, float, float]:
    """Go to where light and warmth suit, up where `rise` > 0."""
    low, high = liked_depth(scene, me)
    return leave(scene.terrain, scene.crowd, me, rise, low, high, out)


@inlined
def heed_worst(
    scene: Scene, me: int, predator: int, scare: float, away: Float64s, danger: Float64s
) -> None:
    """Write what schooling and fleeing heed of the most dangerous predator, else of the submarine, (7,)."""
    crowd = scene.crowd
    if predator >= 0:
        s = crowd.speed[predator]
        heed(
            crowd.x[predator] - crowd.x[me], crowd.y[predator] - crowd.y[me],
            crowd.z[predator] - crowd.z[me], s * crowd.hx[predator], s * crowd.hy[predator],
            s * crowd.hz[predator], crowd.length[predator], danger,
        )  # fmt: skip
    elif scare > 0.1:
        v = scene.submarine_velocity
        heed(-away[0], -away[1], -away[2], v[0, 0], v[0, 1], v[0, 2], 1.0, danger)
    else:
        danger[6] = 0.0


@inlined
def act(
    scene: Scene, me: int, minds: Minds, attention: Attention, piece: int, previous: int,
    found: int, number: float, other: int, when: float, seen: int, predator: int, scare: float,
    obstacle: float, rise: float,
) -> None:  # fmt: skip
    """Run the behaviour routine of the intention; write heading, gear, urgency, throttle and gape.

    `found`, `number`: neighbours of its kind and its shoal; `other`, `when`: who collides; `seen`, `predator`,
    `scare`: how many predators, the place of the worst, -1 for none, and fear of the submarine; `obstacle`: as
    `Percept` has it; `rise`: where light and warmth lie.
    """
    i, out = scene.crowd.row[me], attention.out[piece]
    intention, focus, gape = minds.intention[i], minds.focus[i], 0.0
    if intention == SCHOOL:
        gear, urgency, throttle = _school(
            scene, me, minds, attention, piece, found, number, minds.fear[i], obstacle
        )
    elif intention == AVOID_OBSTACLE:
        again = previous == AVOID_OBSTACLE
        gear, urgency, throttle = _swerve(
            scene, me, minds, attention.normal[piece], obstacle, again, out
        )
    elif intention == AVOID_FISH:
        gear, urgency, throttle = _avoid(scene, me, minds, attention, piece, other, when, out)
    elif intention == EAT:
        gear, urgency, throttle, gape = _eat(scene, me, minds, focus, out)
    elif intention == MATE:
        gear, urgency, throttle = _mate(scene, me, minds, place_of(scene, focus), out)
    elif intention == ESCAPE:
        gear, urgency, throttle = _escape(scene, me, attention, piece, seen, scare, number)
    elif intention == LEAVE:
        gear, urgency, throttle = _leave(scene, me, rise, out)
    elif focus == SUBMARINE:
        gear, urgency, throttle = _visit(scene, me, attention.away[piece], out)
    else:
        gear, urgency, throttle = _wander(scene, me, minds, out)
    if predator >= 0 and intention not in (SCHOOL, ESCAPE, AVOID_OBSTACLE, AVOID_FISH):
        _shun(scene, me, predator, minds.fear[i], out)
    point(minds.heading[i], out[0], out[1], out[2])
    calm = intention == SCHOOL or intention not in (AVOID_OBSTACLE, AVOID_FISH, EAT, MATE, ESCAPE)
    level_off(minds.heading[i], _CALM_SLOPE if calm else _STEEPEST)
    minds.gear[i], minds.urgency[i], minds.throttle[i] = gear, urgency, throttle
    minds.gape[i] = gape
