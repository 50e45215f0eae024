"""Think: every mind, fifteen times a second (papers/000 sections 3.2 and 6; papers/004).

One loop over the fishes in cell order calls perceive, feel, intend and behave in turn for each. A quarter of them
thinks in a tick, by blocks of 3 x 3 columns, so that neighbours share the look around their cell; who crosses between
blocks thinks at the latest after eight ticks. Nothing of what was perceived is kept but the focus, the intention and
its reason.
"""

from math import sqrt
from typing import Final

import numba
import numpy as np

from components.arrays import Float64s, Int8s, Int32s
from components.chance import WHIM, uniform
from components.clock import TICKS_PER_SECOND, Clock
from components.fish import Population
from components.food import FoodTable, in_stomach
from components.ground import Terrain
from components.habitat import STILL, Habitat, daylight
from components.index import Places
from components.kernels import loop, merged, row
from components.mind import FOOD, SUBMARINE, Role, Why
from components.senses import SenseTable
from components.submarine import SubmarineTable
from systems.mind.act import NONE, act, heed_worst, liked_depth, place_of
from systems.mind.behave.wander import is_curious, nearest_home
from systems.mind.beware import fear_all, watch_hunters
from systems.mind.feel import (
    FOOD_FAR,
    FOOD_NEAR,
    MATE_FAR,
    MATE_NEAR,
    appetite,
    desire,
    fear_of_submarine,
    hunger_of,
    libido_of,
    speed_of,
    stimulus,
    unease,
)
from systems.mind.grid import PIECES, SERIAL_BELOW, Crowd, Grid, Plan
from systems.mind.intend import (
    AFRAID,
    AVOID_FISH,
    AVOID_OBSTACLE,
    EAT,
    ESCAPE,
    MATE,
    OBEY,
    RELENT,
    SCHOOL,
    WANTING,
    WATCHFUL,
    Held,
    Percept,
    intend,
)
from systems.mind.perceive import (
    NO_DANGER,
    Attention,
    feel_ahead,
    find_runs,
    gather,
    make_attention,
    meet_submarine,
    reach_of,
    see_around,
    watch,
)
from systems.mind.scene import Minds, Scene, minds_of
from systems.mind.seek import LOYALTY, SMELL, is_male, seek, smell_food, suits
from systems.mind.shoal import see_shoal, sum_shoals
from systems.mind.sparse import Sparse, SparseGrid, find_sparse_runs

LATEST_TICKS: Final = 8
"""[ticks] after which a fish thinks, whoever's turn it is."""

SEARCH_EVERY: Final = 8
"""[thoughts] on average between looks round for a mate where none is near."""

_PLAYER: Final = int(Why.PLAYER)
_CURIOSITY: Final = int(Why.CURIOSITY)
_PREY: Final = int(Role.PREY)
_PREDATOR: Final = int(Role.PREDATOR)
_CURIOUS_PREDATOR: Final = 0.3
_NOWHERE: Final = 0.5
_LOSES_SIGHT: Final = 2.0


@merged
def _seek_food(
    scene: Scene, me: int, minds: Minds, plain: float, target: int, attention: Attention, piece: int
) -> tuple[int, float]:
    """Return the focus that food or prey deserves, -1 for none, and its distance [m]. Prey goes before food."""
    crowd, senses, i = scene.crowd, scene.senses, scene.crowd.row[me]
    kind, x, y, z = crowd.species[me], crowd.x[me], crowd.y[me], crowd.z[me]
    eager = minds.intention[i] == EAT or plain + 0.8 > WANTING
    if not eager:
        return -1, NO_DANGER
    if senses.hunts[kind] != 0:
        prey, far = seek(scene, me, target, minds.swallowed_by, False, attention, piece)
        if prey >= 0:
            return crowd.id[prey], far
    if senses.grazes[kind] != 0 and scene.food.number > 0:
        reach = min(SMELL * senses.sight[kind], scene.food.cell)
        food, far = smell_food(scene.food, x, y, z, reach, attention.hunter_runs[piece])
        kept = FOOD - minds.focus[i]
        if food >= 0 and 0 <= kept < len(scene.there) and scene.there[kept] and kept != food:
            place = scene.food_position
            old = speed_of(place[kept, 0] - x, place[kept, 1] - y, place[kept, 2] - z)
            if LOYALTY * old < far:
                food, far = kept, old
        if food >= 0:
            return FOOD - food, far
    return -1, NO_DANGER


@merged
def _seek_mate(
    scene: Scene, me: int, minds: Minds, target: int, found: int, attention: Attention, piece: int
) -> tuple[int, float]:
    """Return the place of the partner, -1 for none, and its distance [m]: the old one first, then who is near."""
    crowd, senses, i = scene.crowd, scene.senses, scene.crowd.row[me]
    male = is_male(scene.seed, crowd.id[me])
    if minds.intention[i] == MATE and target >= 0 and suits(crowd, scene.seed, me, target, male):
        far = speed_of(
            crowd.x[target] - crowd.x[me],
            crowd.y[target] - crowd.y[me],
            crowd.z[target] - crowd.z[me],
        )
        if far < _LOSES_SIGHT * senses.sight[crowd.species[me]]:
            return target, far
    for k in range(found):
        other = attention.near[piece, k]
        if suits(crowd, scene.seed, me, other, male):
            return other, sqrt(attention.distance[piece, k])
    if senses.schooling[crowd.species[me]] != 0:
        return -1, NO_DANGER
    if (scene.now // 4 + crowd.id[me]) % SEARCH_EVERY != 0:
        return -1, NO_DANGER
    return seek(scene, me, -1, minds.swallowed_by, True, attention, piece)


@row
def suit(
    habitat: Habitat, day: float, z: float, bright: int, warm: int, low: float, high: float
) -> tuple[float, float]:
    """Return unease and where to go, as `unease`; none where the liked depth, `low` to `high` [m], ends there."""
    much, way = unease(habitat, day, z, bright, warm)
    if (high - z if way > 0.0 else z - low) < _NOWHERE:
        much = 0.0
    return much, way


@row
def curiosity(
    role: int, chance: float, sight: float, visibility: float, away: Float64s, seed: int, now: int,
    identity: int,
) -> float:  # fmt: skip
    """Return the distance [m] to the submarine, `away`, that a fish comes to look at, else 0."""
    far = speed_of(away[0], away[1], away[2])
    if role == _PREY or far > min(2.0 * sight, visibility):
        return 0.0
    if role == _PREDATOR:
        chance = _CURIOUS_PREDATOR
    return far if is_curious(seed, now, identity, chance) else 0.0


@merged
def think_one(
    scene: Scene,
    me: int,
    minds: Minds,
    attention: Attention,
    piece: int,
    around: int,
    hunter_runs: int,
) -> None:
    """Perceive, feel, intend and behave for the fish at place `me` of the crowd."""
    crowd, senses, i = scene.crowd, scene.senses, scene.crowd.row[me]
    kind, length = crowd.species[me], crowd.length[me]
    schooling, role = senses.schooling[kind] != 0, senses.role[kind]
    timid = role == _PREY or (role != _PREDATOR and senses.hunted[kind] != 0)
    previous = minds.intention[i]
    target = place_of(scene.places, crowd.place, minds.focus[i]) if previous in (EAT, MATE) else -1
    reach = reach_of(scene.plan, senses.sight[kind], length)
    many = see_around(crowd, me, reach, around, attention, piece)
    found, other, when = watch(crowd, me, schooling, target, senses.eats, many, attention, piece)
    number = 0.0
    if schooling:
        far = min(2.0 * senses.sight[kind], scene.habitat.visibility)
        number = see_shoal(scene.plan, crowd, me, far, attention.shoal[piece])
    seen, predator, fear, danger = 0, -1, 0.0, 0.0
    if hunter_runs > 0:
        seen, big, soon = watch_hunters(scene, me, target, hunter_runs, attention, piece)
        if soon < when:
            other, when = big, soon
        fear, danger, predator, seen = fear_all(
            scene, me, seen, attention.hunters[piece], attention.hunter_distance[piece]
        )
    alarm = 0.8 * length + 0.2
    obstacle = feel_ahead(scene.terrain, crowd, me, 1.5 * alarm, attention.normal[piece]) / alarm
    away, scare = attention.away[piece], 0.0
    meets = meet_submarine(
        crowd, me, scene.submarine, scene.submarine_velocity, scene.submarines, away
    )
    if timid and role == _PREY and scene.submarines > 0:
        v = scene.submarine_velocity
        scare = fear_of_submarine(
            senses.wariness[kind], speed_of(v[0, 0], v[0, 1], v[0, 2]),
            speed_of(away[0], away[1], away[2]),
        )  # fmt: skip
    fear, danger = min(fear + scare, 1.0), max(danger, scare)
    threat = min(when, meets) < NO_DANGER
    near = obstacle < (WATCHFUL if previous == AVOID_OBSTACLE else 1.0)
    urgent = near or threat or (timid and fear > AFRAID)

    stomach = in_stomach(minds.eaten[i], minds.ate_at[i], scene.now, senses.digestion[kind])
    plain = appetite(stomach, senses.appetite[kind])
    meal, meal_far, mate, mate_far = -1, NO_DANGER, -1, NO_DANGER
    if not urgent:
        meal, meal_far = _seek_food(scene, me, minds, plain, target, attention, piece)
    tempted = stimulus(length / (meal_far + 1e-9), FOOD_FAR, FOOD_NEAR)
    hunger = hunger_of(plain, tempted)
    wish = 0.0
    if role != _PREDATOR:
        wish = desire(
            float(scene.now - minds.mated_at[i]), senses.breeding[kind], hunger_of(plain, 0.0)
        )
    if not urgent and libido_of(wish, 1.0) > WANTING * RELENT:
        mate, mate_far = _seek_mate(scene, me, minds, target, found, attention, piece)
    libido = libido_of(wish, stimulus(length / (mate_far + 1e-9), MATE_FAR, MATE_NEAR))
    much, rise, curious = 0.0, 0.0, 0.0
    minds_habitat = senses.bright[kind] != 0 or senses.warm[kind] != 0
    if minds_habitat and nearest_home(scene.terrain, kind, crowd.x[me], crowd.y[me]) < 0:
        low, high = liked_depth(
            scene.terrain, crowd.x[me], crowd.y[me], length, senses.deep[kind], senses.shallow[kind]
        )
        much, rise = suit(
            scene.habitat, scene.day, crowd.z[me], senses.bright[kind], senses.warm[kind], low, high
        )
    if scene.submarines > 0:
        curious = curiosity(
            role, senses.curiosity[kind], senses.sight[kind], scene.habitat.visibility, away,
            scene.seed, scene.now, crowd.id[me],
        )  # fmt: skip
    minds.hunger[i], minds.libido[i], minds.fear[i] = hunger, libido, fear
    minds.danger[i], minds.thought_at[i] = danger, scene.now
    heed_worst(crowd, me, predator, scare, away, scene.submarine_velocity, attention.danger[piece])
    if previous == OBEY:
        minds.why[i], minds.why_value[i] = _PLAYER, 0.0
        return
    company = found + (1 if number > 0.0 else 0) if schooling else 0
    held = Held(previous, minds.why[i], minds.since[i], minds.memory[i])
    percept = Percept(
        obstacle, min(when, meets), threat, timid, fear, danger, company, hunger, libido,
        meal != -1, mate >= 0, role == _PREDATOR, minds.focus[i] >= 0, much,
        curious,
        uniform(scene.seed, WHIM, scene.now, crowd.id[me]) < 0.5,
    )  # fmt: skip
    intention, why, value, memory = intend(scene.now, held, percept)
    if intention != previous or threat:
        minds.since[i] = scene.now
    if memory >= 0 and memory != minds.memory[i]:
        minds.memory_focus[i] = minds.focus[i]
    if intention == MATE or memory == MATE:
        if intention == MATE and previous != MATE and minds.courtship[i] == NONE:
            minds.courtship_since[i] = scene.now
    elif minds.courtship[i] != NONE:
        minds.courtship[i], minds.courtship_since[i] = NONE, scene.now
    minds.intention[i], minds.why[i], minds.why_value[i] = intention, why, value
    minds.memory[i] = memory
    focus = -1
    if intention == EAT:
        focus = meal
    elif intention == MATE:
        focus = crowd.id[mate]
    elif intention == SCHOOL and found > 0:
        focus = crowd.id[attention.near[piece, 0]]
    elif intention == ESCAPE and (predator >= 0 or scare > 0.0):
        focus = crowd.id[predator] if predator >= 0 and danger > scare else SUBMARINE
    elif intention == AVOID_FISH and threat:
        focus = SUBMARINE if meets < when else crowd.id[other]
    elif why == _CURIOSITY:
        focus = SUBMARINE
    minds.focus[i] = focus
    act(
        scene, me, minds, attention, piece, previous, found, number, other, min(when, meets), seen,
        predator, scare, obstacle, rise,
    )  # fmt: skip


@row
def think_some(
    scene: Scene, begin: int, end: int, minds: Minds, attention: Attention, piece: int
) -> None:
    """Let those think whose turn it is, among places begin..end of the crowd."""
    crowd, side = scene.crowd, scene.plan.columns
    column = layer = -1
    around = hunter_runs = 0
    for me in range(begin, end):
        turn = crowd.column[me] // side // 3 + 2 * (crowd.column[me] % side // 3) - scene.now
        waited = scene.now - minds.thought_at[crowd.row[me]]
        if turn & 3 != 0 and waited < LATEST_TICKS:
            continue
        if crowd.column[me] != column or crowd.layer[me] != layer:
            column, layer = crowd.column[me], crowd.layer[me]
            runs = find_runs(scene.plan, crowd, column, layer, attention.runs[piece])
            around = gather(crowd, runs, attention, piece)
        hunter_runs = find_sparse_runs(
            scene.hunters, crowd.x[me], crowd.y[me], crowd.z[me], attention.hunter_runs[piece]
        )
        think_one(scene, me, minds, attention, piece, around, hunter_runs)


@loop
def think_all(
    now: int,
    seed: int,
    day: float,
    plan: Plan,
    crowd: Crowd,
    senses: SenseTable,
    terrain: Terrain,
    habitat: Habitat,
    hunters: Sparse,
    food: Sparse,
    places: Places,
    submarine: Float64s,
    submarine_velocity: Float64s,
    submarines: int,
    food_position: Float64s,
    food_last: Float64s,
    there: Int8s,
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
            now, seed, day, plan, crowd, senses, terrain, habitat, hunters, food, places, submarine,
            submarine_velocity, submarines, food_position, food_last, there,
        )  # fmt: skip
        think_some(scene, begin, end, minds, attention, piece)


@row
def _list_hunters(
    number: int, crowd: Crowd, hunts: Int8s, x: Float64s, y: Float64s, z: Float64s, what: Int32s
) -> int:
    """List the fishes that eat others, in the order of the crowd; return how many. (capacity,) each."""
    many = 0
    for k in range(number):
        if hunts[crowd.species[k]] != 0:
            x[many], y[many], z[many], what[many] = crowd.x[k], crowd.y[k], crowd.z[k], k
            many += 1
    return many


class Think:
    """Reads fishes, senses, terrain, submarine, food, habitat and clock; writes minds and the motors' demands.

    Once a second it puts the fishes' rows in the order of cells, which no result depends on.
    """

    def __init__(
        self,
        population: Population,
        senses: SenseTable,
        terrain: Terrain,
        submarine: SubmarineTable,
        clock: Clock,
        food: FoodTable | None = None,
        habitat: Habitat = STILL,
    ) -> None:
        self.population, self.senses, self.terrain = population, senses, terrain
        self.submarine, self.clock = submarine, clock
        self.food, self.habitat = FoodTable() if food is None else food, habitat
        self.grid = Grid(terrain, senses)
        self._hunters, self._meals = SparseGrid(terrain), SparseGrid(terrain)
        self._attention = make_attention()
        self._few = (np.zeros(0), np.zeros(0), np.zeros(0), np.zeros(0, np.int32))

    def __call__(self) -> None:
        """Advance the minds by one tick."""
        number, now = self.population.count, self.clock.now
        if number == 0:
            return
        self.grid.sort(
            self.population, reorder=number >= SERIAL_BELOW and now % TICKS_PER_SECOND == 0
        )
        sum_shoals(self.grid.plan, self.senses.schooling, self.grid.crowd, number)
        scene, minds = self._scene(number), minds_of(self.population)
        if number < SERIAL_BELOW:
            think_some(scene, 0, number, minds, self._attention, 0)
        else:
            think_all(*scene, number, minds, self._attention)

    def _scene(self, number: int) -> Scene:
        """Return the world as minds find it this tick."""
        food, now, edible = self.food, self.clock.now, self._edible()
        return Scene(
            now, int(self.clock.seed[0]), daylight(self.habitat, now), self.grid.plan,
            self.grid.crowd, self.senses, self.terrain, self.habitat, self._hunting(number),
            edible, self.population.index.places, self.submarine.position,
            self.submarine.velocity, self.submarine.count, food.position, food.last_position,
            self._there,
        )  # fmt: skip

    def _hunting(self, number: int) -> Sparse:
        """Return the grid of the fishes that eat others."""
        if number > len(self._few[0]):
            room = 2 * number
            self._few = (np.zeros(room), np.zeros(room), np.zeros(room), np.zeros(room, np.int32))
        x, y, z, what = self._few
        many = _list_hunters(number, self.grid.crowd, self.senses.hunts, x, y, z, what)
        return self._hunters.sort((x, y, z), what, many, 3.0 * self.grid.plan.cell)

    def _edible(self) -> Sparse:
        """Return the grid of the food in the water."""
        food, count = self.food, self.food.count
        there = (food.returns[:count] <= self.clock.now) & (food.eaten_by[:count] < 0)
        self._there = there.astype(np.int8)
        what = np.flatnonzero(there).astype(np.int32)
        place = np.ascontiguousarray(food.position[what].T)
        least = 3.0 * self.grid.plan.cell
        return self._meals.sort((place[0], place[1], place[2]), what, len(what), least)
