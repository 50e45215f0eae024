"""Live: the fishes nearest the submarine run the muscle model, everyone else replays (papers/000, 9.1).

Chosen by distance from the simulated pilot, never from the camera, so that replays agree. A fish in live physics is
asked to leave only for one that is a fifth nearer, so nobody comes and goes at every tick.
"""

from typing import Final, NamedTuple

import numba
import numpy as np

from components.arrays import Float32s, Float64s, Int8s, Int64s
from components.clock import Clock
from components.fish import Population
from components.kernels import loop, row
from components.live import ENTERING, FREE, LEAVING, LIVE, LiveTable
from components.repertoire import RepertoireLibrary
from components.submarine import SubmarineTable
from components.terrain import Terrain
from systems.motor.columns import Bodies, Motors, bodies, motors
from systems.motor.hand_over import (
    at_rate,
    begin,
    enter,
    faded,
    fall_back,
    free,
    leave,
    left,
    may_enter,
    may_leave,
    publish,
    show,
    shows,
)
from systems.motor.live_step import (
    FARTHEST,
    FARTHEST_AT_FIRST,
    Hull,
    Scratch,
    Slots,
    scratch,
    scratch_of,
    slots,
    step,
)
from systems.motor.strokes import Strokes
from systems.motor.track import Track

CHOOSE_TICKS: Final = 6
"""[ticks] between two looks at who is nearest."""

PIECES: Final = 16
"""Into which the slots are dealt for the threads."""

LOYALTY: Final = 0.64
"""By which the squared distance of a live fish is made less: a rival must be a fifth nearer."""

NEVER: Final = -1


class Ranking(NamedTuple):
    """The nearest found so far, nearest first; N places."""

    row: Int64s
    key: Float64s
    "[m^2], (N,)"


@row
def play(
    s: int, i: int, first: int, slots: Slots, fish: Bodies, motor: Motors, track: Track,
    strokes: Strokes, terrain: Terrain, hull: Hull, work: Scratch, shape: Float32s,
) -> None:  # fmt: skip
    """Advance slot `s` by a tick; its fish stands in row `i`, -1 where it is gone."""
    stage = slots.stage[s]
    if i < 0 or (stage == LEAVING and faded(s, i, first, motor)):
        free(s, slots)
        return
    if stage == LEAVING:
        if shows(s, motor.last_shape_row[i], first):
            left(s, i, slots, motor, track)
        return
    segment = motor.segment[i]
    slots.entry[s] = motor.shape_row[i]
    farthest = FARTHEST * (1.0 + 2.0 * motor.warp_weight[i])
    if stage == ENTERING:
        farthest = FARTHEST_AT_FIRST
        if not may_enter(i, motor, track, strokes):
            free(s, slots)
            return
        begin(s, i, slots, fish, motor, track)
    if strokes.known[segment] == 0:
        # Replay has left the last shape for this segment already, as for any change.
        slots.stage[s] = LEAVING
    elif step(s, i, slots, fish, motor, track, strokes, terrain, hull, work, farthest):
        show(s, i, first, slots, motor)
        if not at_rate(i, motor) and may_leave(s, i, slots, motor, track):
            publish(s, first, slots, track, shape)
            leave(s, i, first, slots, motor, track)
    elif stage == ENTERING:
        free(s, slots)
    else:
        fall_back(s, i, first, slots, motor, track)


@row
def play_piece(
    piece: int, rows: Int64s, first: int, slots: Slots, fish: Bodies, motor: Motors, track: Track,
    strokes: Strokes, terrain: Terrain, hull: Hull, work: Scratch, shape: Float32s,
) -> None:  # fmt: skip
    """Advance every slot of a piece of the work; `rows` are all slots' fishes', (C,)."""
    own = scratch_of(work, piece)
    for s in range(piece, len(rows), PIECES):
        if slots.stage[s] != FREE:
            play(s, rows[s], first, slots, fish, motor, track, strokes, terrain, hull, own, shape)
            publish(s, first, slots, track, shape)


@loop
def play_all(
    rows: Int64s, first: int, slots: Slots, fish: Bodies, motor: Motors, track: Track,
    strokes: Strokes, terrain: Terrain, hull: Hull, work: Scratch, shape: Float32s,
) -> None:  # fmt: skip
    """Advance every slot; `rows` are their fishes', (C,). Threads share no fish."""
    for piece in numba.prange(PIECES):
        play_piece(
            piece, rows, first, slots, fish, motor, track, strokes, terrain, hull, work, shape
        )


@row
def publish_all(first: int, slots: Slots, track: Track, shape: Float32s) -> None:
    """Copy all slots' shapes to the library and its track."""
    for s in range(len(slots.id)):
        publish(s, first, slots, track, shape)


@row
def rank(ranking: Ranking, ids: Int64s, i: int, key: float) -> None:
    """Put row `i` into its place among the nearest; equal distances go by id."""
    last = len(ranking.row) - 1
    at = last + 1
    while at > 0:
        other = ranking.row[at - 1]
        if other >= 0 and (
            ranking.key[at - 1] < key or (ranking.key[at - 1] == key and ids[other] < ids[i])
        ):
            break
        at -= 1
    if at > last:
        return
    for place in range(last, at, -1):
        ranking.row[place], ranking.key[place] = ranking.row[place - 1], ranking.key[place - 1]
    ranking.row[at], ranking.key[at] = i, key


@row
def find_nearest(
    ids: Int64s, held: Int8s, fish: Bodies, motor: Motors, track: Track, strokes: Strokes,
    pilot: Float64s, ranking: Ranking,
) -> None:  # fmt: skip
    """Rank the fishes that are live or may be by distance from `pilot`, (3,); `held` is their slot's stage, (n,)."""
    for place in range(len(ranking.row)):
        ranking.row[place], ranking.key[place] = NEVER, np.inf
    for i in range(len(held)):
        x = fish.position[i, 0] - pilot[0]
        y = fish.position[i, 1] - pilot[1]
        z = fish.position[i, 2] - pilot[2]
        key = x * x + y * y + z * z
        if held[i] == LIVE:
            key *= LOYALTY
        if key > ranking.key[len(ranking.key) - 1] or held[i] == LEAVING:
            continue
        if held[i] == LIVE or may_enter(i, motor, track, strokes):
            rank(ranking, ids, i, key)


@row
def change_over(
    rows: Int64s, ids: Int64s, held: Int8s, first: int, slots: Slots, fish: Bodies, motor: Motors,
    track: Track, ranking: Ranking,
) -> None:  # fmt: skip
    """Let the live fishes that are not among the nearest leave, as soon as they swim plainly, and the nearest that are
    not live enter."""
    for place in range(len(ranking.row)):
        i = ranking.row[place]
        if i >= 0 and held[i] == LIVE:
            held[i] = -LIVE
    busy = 0
    for s in range(len(rows)):
        if slots.stage[s] == LIVE:
            if held[rows[s]] == LIVE and may_leave(s, rows[s], slots, motor, track):
                leave(s, rows[s], first, slots, motor, track)
            else:
                busy += 1
    s = 0
    for place in range(len(ranking.row)):
        i = ranking.row[place]
        if i < 0 or held[i] != FREE:
            continue
        while s < len(rows) and slots.stage[s] != FREE:
            s += 1
        if s == len(rows) or busy == len(ranking.row):
            return
        busy += 1
        slots.id[s] = ids[i]
        enter(s, i, slots, fish, motor, track)


class Live:
    """Reads submarine, clock, terrain, library, steer, segment, frame, held and wanted; writes the live table, the
    last rows of library and track, and of live fishes position, rotation, shape rows and warp."""

    def __init__(
        self,
        table: LiveTable,
        population: Population,
        library: RepertoireLibrary,
        track: Track,
        strokes: Strokes,
        submarine: SubmarineTable,
        terrain: Terrain,
        clock: Clock,
    ) -> None:
        """Serve half as many fishes as `table` has rows; `library` and `track` end in twice as many rows."""
        self.table = table
        self.population = population
        self.library = library
        self.track = track
        self.strokes = strokes
        self.submarine = submarine
        self.terrain = terrain
        self.clock = clock
        self.first = len(library.shape) - 2 * table.count
        self._work = scratch(PIECES)
        most = table.count // 2
        self._ranking = Ranking(np.full(most, NEVER, np.int64), np.full(most, np.inf))

    def __call__(self) -> None:
        """Advance the fishes in live physics by a tick; now and then choose anew."""
        columns = slots(self.table)
        rows = self.population.rows(columns.id)
        fish, motor = bodies(self.population.fish), motors(self.population.motor)
        ship = self.submarine
        hull = Hull(ship.position[0], ship.velocity[0])
        play_all(
            *(rows, self.first, columns, fish, motor, self.track, self.strokes),
            *(self.terrain, hull, self._work, self.library.shape),
        )
        if self.clock.now % CHOOSE_TICKS == 0:
            self._choose(rows, columns, fish, motor)

    def restored(self) -> None:
        """Make the library's rows equal to the table's after the table was restored."""
        publish_all(self.first, slots(self.table), self.track, self.library.shape)

    def _choose(self, rows: Int64s, columns: Slots, fish: Bodies, motor: Motors) -> None:
        count, ids = self.population.count, self.population.fish.id
        held = np.zeros(count, np.int8)
        staying = columns.stage != FREE
        held[rows[staying]] = columns.stage[staying]
        track, ranking = self.track, self._ranking
        find_nearest(
            ids, held, fish, motor, track, self.strokes, self.submarine.position[0], ranking
        )
        change_over(rows, ids, held, self.first, columns, fish, motor, track, ranking)
