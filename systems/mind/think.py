"""Think: every mind, fifteen times a second (papers/000 sections 3.2 and 6; papers/004).

One loop over the fishes in cell order calls perceive, feel, intend and behave in turn for each. A quarter of them
thinks in a tick, side by side in the plan (systems/mind/turns.py). Nothing of what was perceived is kept but the focus,
the predator feared most, the intention and its reason.
"""

import numba

from components.arrays import Float64s, Int8s
from components.clock import TICKS_PER_SECOND, Clock
from components.fish import Population
from components.food import FoodTable
from components.ground import Terrain
from components.habitat import STILL, Habitat
from components.index import Places
from components.kernel_turns import first_turn, next_turn
from components.kernels import Launch, loop, row
from components.senses import SenseTable
from components.submarine import SubmarineTable
from components.table import Columns
from systems.mind.act import act
from systems.mind.attention import (
    BATCH,
    Attention,
    Thoughts,
    make_attention,
    make_thoughts,
)
from systems.mind.crowd import Crowd
from systems.mind.decide import decide
from systems.mind.few import Few
from systems.mind.grid import (
    PIECES,
    SERIAL_BELOW,
    Grid,
    Plan,
    sort_on_all,
    sort_serially,
)
from systems.mind.notice import (
    notice_company,
    notice_hunters,
    notice_obstacles,
    notice_shoals,
    notice_submarine,
)
from systems.mind.scene import Minds, Scene, Stage, look
from systems.mind.shoal import sum_on_all, sum_serially
from systems.mind.sparse import Sparse
from systems.mind.turns import list_turns, quarter, thinking
from systems.mind.want import want_mates, want_meals


@row
def think_some(
    scene: Scene, begin: int, end: int, mine: tuple[int, int], minds: Minds, thoughts: Thoughts,
    attention: Attention, piece: int,
) -> None:  # fmt: skip
    """Let those think whose turn it is, among places begin..end of the crowd: perceive, feel, intend and behave."""
    row, at = piece * BATCH, begin
    while at < end:
        last, at = list_turns(scene, at, end, mine, minds, thoughts, row)
        notice_company(scene, thoughts, row, last, attention, piece)
        notice_shoals(scene, thoughts, row, last)
        notice_hunters(scene, minds, thoughts, row, last, attention, piece)
        notice_obstacles(scene, thoughts, row, last)
        notice_submarine(scene, thoughts, row, last)
        want_meals(scene, minds, thoughts, row, last, attention, piece)
        want_mates(scene, minds, thoughts, row, last, attention, piece)
        decide(scene, minds, thoughts, row, last)
        act(scene, minds, thoughts, row, last, attention, piece)


@row
def think_in_turn(
    scene: Scene, pieces: int, turns: int, share: int, number: int, minds: Minds, thoughts: Thoughts,
    attention: Attention,
) -> None:  # fmt: skip
    """Let one piece after the other of those who think do so, as long as there is one."""
    mine, (begin, end) = quarter(number, scene.now), thinking(number, scene.now)
    piece = next_turn(turns, share, pieces)
    while piece < pieces:
        first = begin + (end - begin) * piece // pieces
        last = begin + (end - begin) * (piece + 1) // pieces
        think_some(scene, first, last, mine, minds, thoughts, attention, piece)
        piece = next_turn(turns, share, pieces)


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
    turns = first_turn()
    for share in numba.prange(pieces):
        scene = Scene(
            now, seed, day, plan, crowd, senses, terrain, habitat, hunters, food, willing, places,
            submarine, submarine_velocity, submarines, food_position, food_last, there,
        )  # fmt: skip
        think_in_turn(scene, pieces, turns, share, number, minds, thoughts, attention)


@row
def think_serially(
    stage: Stage, now: int, seed: int, number: int, particles: int, submarines: int, minds: Minds,
    thoughts: Thoughts, attention: Attention,
) -> None:  # fmt: skip
    """Sort the fishes, look, and think, on this thread."""
    plan, begin_end = stage.plan, thinking(number, now)
    sort_serially(
        number, begin_end, plan, plan.far, plan.block, stage.sorting, stage.rows, stage.crowd
    )
    sum_serially(plan, stage.senses.schooling, stage.crowd)
    scene = look(stage, now, seed, number, particles, submarines)
    think_some(
        scene, begin_end[0], begin_end[1], quarter(number, now), minds, thoughts, attention, 0
    )


@row
def think_on_all(
    pieces: int, stage: Stage, now: int, seed: int, number: int, particles: int, submarines: int,
    minds: Minds, thoughts: Thoughts, attention: Attention,
) -> None:  # fmt: skip
    """Sort the fishes, look, and think, on all threads, to the same bits as `think_serially`."""
    plan, begin_end = stage.plan, thinking(number, now)
    sort_on_all(
        pieces,
        number,
        begin_end,
        plan,
        plan.far,
        plan.block,
        stage.sorting,
        stage.rows,
        stage.crowd,
    )
    sum_on_all(plan, stage.senses.schooling, stage.crowd)
    s = look(stage, now, seed, number, particles, submarines)
    think_all(
        pieces, s.now, s.seed, s.day, s.plan, s.crowd, s.senses, s.terrain, s.habitat, s.hunters, s.food,
        s.willing, s.places, s.submarine, s.submarine_velocity, s.submarines, s.food_position,
        s.food_last, s.there, number, minds, thoughts, attention,
    )  # fmt: skip


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
        self.grid = Grid(population, terrain, senses, habitat.visibility)
        self.few = Few(terrain, self.food)
        self._attention, self._thoughts = make_attention(), make_thoughts()
        self._minds = Columns(Minds, population.mind, population.motor, population.fish)
        self._serially, self._on_all = Launch(think_serially), Launch(think_on_all)

    def __call__(self) -> None:
        """Advance the minds by one tick."""
        number, now = self.population.count, self.clock.now
        if number == 0:
            return
        self.grid.prepare(reorder=number >= SERIAL_BELOW and now % TICKS_PER_SECOND == 0)
        self.few.prepare(number)
        given = (
            self._stage(), now, int(self.clock.seed[0]), number, self.food.count,
            self.submarine.count, self._minds(), self._thoughts, self._attention,
        )  # fmt: skip
        if number < SERIAL_BELOW:
            self._serially(*given)
        else:
            self._on_all(PIECES, *given)

    def _stage(self) -> Stage:
        """Return what the tick's scene is made of."""
        grid, few, submarine = self.grid, self.few, self.submarine
        return Stage(
            grid.plan, grid.sorting, grid.rows(), grid.crowd, self.senses, self.terrain, self.habitat,
            few.larder(), few.room, self.population.index.places, submarine.position,
            submarine.velocity,
        )  # fmt: skip
