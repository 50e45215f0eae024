"""Think: every mind, fifteen times a second (papers/000 sections 3.2 and 6; papers/004).

One loop over the fishes in cell order calls perceive, feel, intend and behave in turn for each. A quarter of them
thinks in a tick, by blocks of 3 x 3 columns, so that neighbours share the look around their cell; who crosses between
blocks thinks at the latest after eight ticks. Nothing of what was perceived is kept but the focus, the intention and
its reason.
"""

from typing import Final

import numba

from components.arrays import Float64s, Int8s
from components.chance import WHIM, uniform
from components.clock import TICKS_PER_SECOND, Clock
from components.fish import Population
from components.food import FoodTable
from components.ground import Terrain
from components.habitat import STILL, Habitat, daylight
from components.index import Places
from components.kernels import Launch, loop, merged, row
from components.mind import SUBMARINE, Role, Why
from components.senses import SenseTable
from components.submarine import SubmarineTable
from components.table import Columns
from systems.mind.act import NONE, act, place_of
from systems.mind.attention import (
    BATCH,
    NO_DANGER,
    Attention,
    Thoughts,
    make_attention,
    make_thoughts,
)
from systems.mind.crowd import Crowd
from systems.mind.few import Few
from systems.mind.grid import PIECES, SERIAL_BELOW, Grid, Plan, scattered
from systems.mind.intend import (
    AVOID_FISH,
    EAT,
    ESCAPE,
    MATE,
    OBEY,
    SCHOOL,
    Held,
    Percept,
    intend,
)
from systems.mind.notice import (
    notice_company,
    notice_hunters,
    notice_obstacles,
    notice_shoals,
    notice_submarine,
)
from systems.mind.scene import Minds, Scene
from systems.mind.shoal import Shoals
from systems.mind.sparse import Sparse
from systems.mind.want import curiosity, habits, is_timid, want_mates, want_meals

LATEST_TICKS: Final = 8
"""[ticks] after which a fish thinks, whoever's turn it is."""

_PLAYER: Final = int(Why.PLAYER)
_CURIOSITY: Final = int(Why.CURIOSITY)
_PREDATOR: Final = int(Role.PREDATOR)


@merged
def _take_up(
    scene: Scene, me: int, minds: Minds, intention: int, memory: int, threat: bool
) -> None:
    """Remember what begins, what is interrupted, and what courtship ends with it."""
    i = scene.crowd.row[me]
    previous = minds.intention[i]
    if intention != previous or threat:
        minds.since[i] = scene.now
    if memory >= 0 and memory != minds.memory[i]:
        minds.memory_focus[i] = minds.focus[i]
    courts = intention == MATE or memory == MATE
    begins = intention == MATE and previous != MATE and minds.courtship[i] == NONE
    if begins or (not courts and minds.courtship[i] != NONE):
        minds.courtship[i], minds.courtship_since[i] = NONE, scene.now
    minds.intention[i], minds.memory[i] = intention, memory


@merged
def _attend(crowd: Crowd, intention: int, why: int, thoughts: Thoughts, k: int) -> int:
    """Return the focus that passes: what the intention is about."""
    predator, scare = thoughts.predator[k], thoughts.scare[k]
    when, meets = thoughts.when[k], thoughts.meets[k]
    if intention == EAT:
        return int(thoughts.meal[k])
    if intention == MATE:
        return int(crowd.id[thoughts.mate[k]])
    if intention == SCHOOL and thoughts.found[k] > 0:
        return int(crowd.id[thoughts.near[k, 0]])
    if intention == ESCAPE and predator >= 0 and thoughts.worst[k] > scare:
        return int(crowd.id[predator])
    if intention == AVOID_FISH and when < NO_DANGER and when <= meets:
        return int(crowd.id[thoughts.other[k]])
    submarine = (
        why == _CURIOSITY
        or (intention == ESCAPE and scare > 0.0)
        or (intention == AVOID_FISH and meets < when)
    )
    return SUBMARINE if submarine else -1


@merged
def _decide_one(scene: Scene, minds: Minds, thoughts: Thoughts, k: int) -> None:
    """Choose one mind's intention, and what it is about."""
    crowd, senses, me = scene.crowd, scene.senses, thoughts.me[k]
    i, kind = crowd.row[me], crowd.species[me]
    role, previous = senses.role[kind], thoughts.previous[k]
    much, thoughts.rise[k] = habits(scene, me)
    curious = 0.0
    if scene.submarines > 0:
        curious = curiosity(
            role, senses.curiosity[kind], senses.sight[kind], scene.habitat.visibility,
            thoughts.away[k], scene.seed, scene.now, crowd.id[me],
        )  # fmt: skip
    company = 0
    if senses.schooling[kind] != 0:
        company = thoughts.found[k] + int(thoughts.number[k] > 0.0)
    collision = min(thoughts.when[k], thoughts.meets[k])
    percept = Percept(
        thoughts.obstacle[k], collision, collision < NO_DANGER, is_timid(role, senses.hunted[kind]),
        minds.fear[i], minds.danger[i], company, minds.hunger[i], minds.libido[i],
        thoughts.meal[k] != -1, thoughts.mate[k] >= 0, role == _PREDATOR, minds.focus[i] >= 0,
        much, curious,
        minds.hunger[i] == minds.libido[i]
        and uniform(scene.seed, WHIM, scene.now, crowd.id[me]) < 0.5,
    )  # fmt: skip
    held = Held(previous, minds.why[i], minds.since[i], minds.memory[i])
    intention, why, value, memory = intend(scene.now, held, percept)
    _take_up(scene, me, minds, intention, memory, collision < NO_DANGER)
    minds.why[i], minds.why_value[i] = why, value
    minds.focus[i] = _attend(crowd, intention, why, thoughts, k)


@merged
def decide(scene: Scene, minds: Minds, thoughts: Thoughts, begin: int, end: int) -> None:
    """Choose what each means to do; who obeys the player keeps to that."""
    for k in range(begin, end):
        i = scene.crowd.row[thoughts.me[k]]
        minds.fear[i], minds.thought_at[i] = thoughts.fear[k], scene.now
        minds.danger[i] = max(thoughts.worst[k], thoughts.scare[k])
        if thoughts.previous[k] == OBEY:
            minds.why[i], minds.why_value[i] = _PLAYER, 0.0
        else:
            _decide_one(scene, minds, thoughts, k)


@merged
def list_turns(
    scene: Scene, begin: int, end: int, minds: Minds, thoughts: Thoughts, row: int
) -> tuple[int, int]:
    """List whose turn it is among places begin..end of the crowd, at most `BATCH`, from `row` of the thoughts on.

    Return the row after the last, and the place from which to go on.
    """
    crowd, side = scene.crowd, scene.plan.columns
    here, turn, at, last, me = -1, 0, row, row + BATCH, begin
    while me < end and at < last:
        if crowd.column[me] != here:
            here = crowd.column[me]
            turn = here // side // 3 + 2 * (here % side // 3) - scene.now
        i = crowd.row[me]
        if turn & 3 == 0 or scene.now - minds.thought_at[i] >= LATEST_TICKS:
            previous, target = minds.intention[i], -1
            if previous in (EAT, MATE):
                target = place_of(scene.places, crowd.place, minds.focus[i])
            thoughts.me[at], thoughts.previous[at], thoughts.target[at] = me, previous, target
            at += 1
        me += 1
    return at, me


@row
def think_some(
    scene: Scene, begin: int, end: int, minds: Minds, thoughts: Thoughts, attention: Attention,
    piece: int,
) -> None:  # fmt: skip
    """Let those think whose turn it is, among places begin..end of the crowd: perceive, feel, intend and behave."""
    row, at = piece * BATCH, begin
    while at < end:
        last, at = list_turns(scene, at, end, minds, thoughts, row)
        notice_company(scene, thoughts, row, last, attention, piece)
        notice_shoals(scene, thoughts, row, last)
        notice_hunters(scene, minds, thoughts, row, last, attention, piece)
        notice_obstacles(scene, thoughts, row, last)
        notice_submarine(scene, thoughts, row, last)
        want_meals(scene, minds, thoughts, row, last, attention, piece)
        want_mates(scene, minds, thoughts, row, last, attention, piece)
        decide(scene, minds, thoughts, row, last)
        act(scene, minds, thoughts, row, last, attention, piece)


@loop
def think_all(
    pieces: int,
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
    willing: Sparse,
    places: Places,
    submarine: Float64s,
    submarine_velocity: Float64s,
    submarines: int,
    food_position: Float64s,
    food_last: Float64s,
    there: Int8s,
    number: int,
    minds: Minds,
    thoughts: Thoughts,
    attention: Attention,
) -> None:
    """Let those think whose turn it is, on all threads.

    The scene comes in its parts: numba takes no tuple of tuples into prange.
    """
    for turn in numba.prange(pieces):
        piece = scattered(turn, pieces)
        begin, end = number * piece // pieces, number * (piece + 1) // pieces
        scene = Scene(
            now, seed, day, plan, crowd, senses, terrain, habitat, hunters, food, willing, places, submarine,
            submarine_velocity, submarines, food_position, food_last, there,
        )  # fmt: skip
        think_some(scene, begin, end, minds, thoughts, attention, piece)


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
        self.grid = Grid(population, terrain, senses)
        self.few = Few(terrain, senses, self.food, clock)
        self._attention, self._thoughts = make_attention(), make_thoughts()
        self._shoals = Shoals()
        self._minds = Columns(Minds, population.mind, population.motor, population.fish)
        self._daylight = Launch(daylight)
        self._think_some, self._think_all = Launch(think_some), Launch(think_all)

    def __call__(self) -> None:
        """Advance the minds by one tick."""
        number, now, grid = self.population.count, self.clock.now, self.grid
        if number == 0:
            return
        grid.sort(reorder=number >= SERIAL_BELOW and now % TICKS_PER_SECOND == 0)
        self._shoals.sum(grid.plan, self.senses.schooling, grid.crowd, number)
        self.few.sort(grid.crowd, number, 3.0 * grid.plan.cell)
        scene, minds = self._scene(now), self._minds()
        if number < SERIAL_BELOW:
            self._think_some(scene, 0, number, minds, self._thoughts, self._attention, 0)
        else:
            self._think_all(PIECES, *scene, number, minds, self._thoughts, self._attention)

    def _scene(self, now: int) -> Scene:
        """Return the world as minds find it this tick."""
        few, grid, submarine, larder = self.few, self.grid, self.submarine, self.few.larder
        return Scene(
            now, int(self.clock.seed[0]), self._daylight(self.habitat, now), grid.plan, grid.crowd,
            self.senses, self.terrain, self.habitat, few.hunters.sparse, few.edible.sparse,
            few.willing.sparse, self.population.index.places, submarine.position, submarine.velocity,
            submarine.count, larder.position, larder.last_position, few.there,
        )  # fmt: skip
