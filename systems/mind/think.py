"""Think: every mind, fifteen times a second (papers/000 sections 3.2 and 6; papers/004).

One loop over the fishes in cell order calls perceive, intend and behave in turn for each. A quarter of them thinks in
a tick, by blocks of 3 x 3 columns, so that neighbours share the look around their cell; who crosses between blocks
thinks at the latest after eight ticks. Nothing of what was perceived is kept but the focus and the intention.
"""

from typing import Final, NamedTuple

import numba

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.chance import WANDER, uniform
from components.clock import TICKS_PER_SECOND, Clock
from components.fish import Population
from components.ground import Terrain, ground_height
from components.kernels import inlined, loop, row
from components.mind import SUBMARINE
from components.senses import SenseTable
from components.submarine import SubmarineTable
from components.vector import level_off, point
from systems.mind.behave.avoid_fish import avoid_fish, avoid_submarine
from systems.mind.behave.avoid_static_obstacle import avoid_static_obstacle
from systems.mind.behave.school import roam, school
from systems.mind.behave.wander import depart, wander
from systems.mind.grid import PIECES, SERIAL_BELOW, Crowd, Grid, Plan
from systems.mind.intend import AVOID_FISH, AVOID_OBSTACLE, SCHOOL, intend
from systems.mind.perceive import (
    HORIZON,
    NO_DANGER,
    Attention,
    feel_ahead,
    find_runs,
    make_attention,
    meet_submarine,
    see_shoal,
    watch,
)

LATEST_TICKS: Final = 8
"""[ticks] after which a fish thinks, whoever's turn it is."""

_RIM_FROM: Final = 0.72
_RIM_PUSH: Final = 0.9
_DEPTH_PUSH: Final = 0.7
_DEPTH_SOFT: Final = 1.5
_CALM_SLOPE: Final = 0.45
_STEEPEST: Final = 0.8


class Minds(NamedTuple):
    """The columns that thinking reads and writes, row for row with the fishes'."""

    intention: Int8s
    focus: Int64s
    since: Int64s
    thought_at: Int64s
    wander_until: Int64s
    wander: Float64s
    cohort: Int32s
    heading: Float64s
    gear: Int8s
    urgency: Float64s


class Scene(NamedTuple):
    """What minds live in during a tick."""

    now: int
    seed: int
    plan: Plan
    crowd: Crowd
    senses: SenseTable
    terrain: Terrain
    submarine: Float64s
    submarine_velocity: Float64s
    submarines: int


@inlined
def _liked_depth(scene: Scene, me: int) -> tuple[float, float]:
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
def _wander(
    scene: Scene, me: int, minds: Minds, away: Float64s, out: Float64s
) -> tuple[int, float]:
    """Set out anew where the leg has ended, then wander; return gear and urgency."""
    crowd, senses, i = scene.crowd, scene.senses, scene.crowd.row[me]
    kind, identity = crowd.species[me], crowd.id[me]
    low, high = _liked_depth(scene, me)
    if scene.now >= minds.wander_until[i]:
        minds.wander_until[i] = depart(
            scene.terrain, kind, crowd.x[me], crowd.y[me], crowd.z[me], low, high,
            max(senses.speed[kind, 0], 0.3) * crowd.length[me], scene.seed, scene.now, identity,
            minds.wander[i],
        )  # fmt: skip
    drawn = uniform(scene.seed, WANDER, minds.wander_until[i], identity)
    gear, urgency = wander(senses.role[kind], minds.wander[i], drawn, away, senses.sight[kind], out)
    _stay_in_range(scene, me, low, high, out)
    return gear, urgency


@inlined
def _school(
    scene: Scene, me: int, minds: Minds, attention: Attention, piece: int, found: int, number: float
) -> tuple[int, float]:
    """School among the neighbours seen; return gear and urgency."""
    crowd, i = scene.crowd, scene.crowd.row[me]
    low, high = _liked_depth(scene, me)
    x, y, up = roam(scene.seed, minds.cohort[i], scene.now, scene.terrain.radius)
    spacing = scene.senses.spacing[crowd.species[me]] * crowd.length[me]
    out = attention.out[piece]
    gear, urgency = school(
        crowd, me, attention.near[piece], attention.distance[piece], found, attention.shoal[piece],
        number, spacing, x, y, low + up * (high - low), minds.gear[i], out,
    )  # fmt: skip
    _stay_in_range(scene, me, low, high, out)
    out[2] *= 0.7
    return gear, urgency


@inlined
def _decide(
    scene: Scene, me: int, minds: Minds, obstacle: float, threat: bool, company: bool
) -> int:
    """Take the intention of this tick and remember since when it holds."""
    i = scene.crowd.row[me]
    previous = minds.intention[i]
    intention = intend(scene.now, previous, minds.since[i], obstacle, threat, company)
    if intention != previous or threat:
        minds.since[i] = scene.now
    minds.intention[i] = intention
    return intention


@inlined
def think_one(
    scene: Scene, me: int, minds: Minds, attention: Attention, piece: int, number_of_runs: int
) -> None:
    """Perceive, intend and behave for the fish at place `me` of the crowd."""
    crowd, senses, i = scene.crowd, scene.senses, scene.crowd.row[me]
    kind, out = crowd.species[me], attention.out[piece]
    schooling = senses.schooling[kind] != 0
    reach = min(senses.sight[kind], scene.plan.cell)
    found, other, when = watch(crowd, me, schooling, reach, number_of_runs, attention, piece)
    number = 0.0
    if schooling:
        number = see_shoal(scene.plan, crowd, me, 2.0 * senses.sight[kind], attention.shoal[piece])
    alarm = 0.8 * crowd.length[me] + 0.2
    obstacle = feel_ahead(scene.terrain, crowd, me, 1.5 * alarm, attention.normal[piece])
    obstacle /= alarm
    away = attention.away[piece]
    meets = meet_submarine(
        crowd, me, scene.submarine, scene.submarine_velocity, scene.submarines, away
    )
    threat = min(when, meets) < NO_DANGER
    company = schooling and (found > 0 or number > 0.0)
    intention = _decide(scene, me, minds, obstacle, threat, company)
    minds.focus[i] = -1
    if intention == AVOID_OBSTACLE:
        side = 1.0 if crowd.id[me] & 1 else -1.0
        gear, urgency = avoid_static_obstacle(
            crowd.hx[me], crowd.hy[me], crowd.hz[me], attention.normal[piece],
            min(max(1.0 - obstacle, 0.0), 1.0), side, out,
        )  # fmt: skip
    elif intention == AVOID_FISH:
        if meets < when:
            minds.focus[i] = SUBMARINE
            gear, urgency = avoid_submarine(crowd, me, away, min(meets, HORIZON), out)
        elif other >= 0:
            minds.focus[i] = crowd.id[other]
            gear, urgency = avoid_fish(crowd, me, other, when, out)
        else:
            gear, urgency = 1, 0.2
            for axis in range(3):
                out[axis] = minds.heading[i, axis]
    elif intention == SCHOOL:
        if found > 0:
            minds.focus[i] = crowd.id[attention.near[piece, 0]]
        gear, urgency = _school(scene, me, minds, attention, piece, found, number)
    else:
        gear, urgency = _wander(scene, me, minds, away, out)
    point(minds.heading[i], out[0], out[1], out[2])
    avoiding = intention in (AVOID_OBSTACLE, AVOID_FISH)
    level_off(minds.heading[i], _STEEPEST if avoiding else _CALM_SLOPE)
    minds.gear[i], minds.urgency[i], minds.thought_at[i] = gear, urgency, scene.now


@row
def think_some(
    scene: Scene, begin: int, end: int, minds: Minds, attention: Attention, piece: int
) -> None:
    """Let those think whose turn it is, among places begin..end of the crowd."""
    crowd, side = scene.crowd, scene.plan.columns
    column = layer = -1
    number_of_runs = 0
    for me in range(begin, end):
        turn = crowd.column[me] // side // 3 + 2 * (crowd.column[me] % side // 3) - scene.now
        waited = scene.now - minds.thought_at[crowd.row[me]]
        if turn & 3 != 0 and waited < LATEST_TICKS:
            continue
        if crowd.column[me] != column or crowd.layer[me] != layer:
            column, layer = crowd.column[me], crowd.layer[me]
            number_of_runs = find_runs(scene.plan, crowd, column, layer, attention.runs[piece])
        think_one(scene, me, minds, attention, piece, number_of_runs)


@loop
def think_all(
    now: int,
    seed: int,
    plan: Plan,
    crowd: Crowd,
    senses: SenseTable,
    terrain: Terrain,
    submarine: Float64s,
    submarine_velocity: Float64s,
    submarines: int,
    number: int,
    minds: Minds,
    attention: Attention,
) -> None:
    """Let those think whose turn it is, on all threads.

    The scene comes in its parts: numba takes no tuple of tuples into prange.
    """
    for turn in numba.prange(PIECES):
        piece = (turn * 27) % PIECES
        begin, end = number * piece // PIECES, number * (piece + 1) // PIECES
        scene = Scene(
            now, seed, plan, crowd, senses, terrain, submarine, submarine_velocity, submarines
        )
        think_some(scene, begin, end, minds, attention, piece)


class Think:
    """Reads fishes, senses, terrain, submarine and clock; writes minds and the motors' demands.

    Once a second it puts the fishes' rows in the order of cells, which no result depends on.
    """

    def __init__(
        self,
        population: Population,
        senses: SenseTable,
        terrain: Terrain,
        submarine: SubmarineTable,
        clock: Clock,
    ) -> None:
        self.population, self.senses, self.terrain = population, senses, terrain
        self.submarine, self.clock = submarine, clock
        self.grid = Grid(terrain, senses)
        self._attention = make_attention()

    def __call__(self) -> None:
        """Advance the minds by one tick."""
        number, now = self.population.count, self.clock.now
        if number == 0:
            return
        self.grid.sort(
            self.population, reorder=number >= SERIAL_BELOW and now % TICKS_PER_SECOND == 0
        )
        mind, motor = self.population.mind, self.population.motor
        minds = Minds(
            mind.intention, mind.focus, mind.since, mind.thought_at, mind.wander_until, mind.wander,
            self.population.fish.cohort, motor.heading, motor.gear, motor.urgency,
        )  # fmt: skip
        scene = Scene(
            now, int(self.clock.seed[0]), self.grid.plan, self.grid.crowd, self.senses,
            self.terrain, self.submarine.position, self.submarine.velocity, self.submarine.count,
        )  # fmt: skip
        if number < SERIAL_BELOW:
            think_some(scene, 0, number, minds, self._attention, 0)
        else:
            think_all(*scene, number, minds, self._attention)
