"""Move: every fish plays its segment, balances its roll and warps from one segment to the next
(papers/000 sections 5.1 and 5.2, appendices A and B; FINDINGS 1 corrects their equations).

Between the gears' speeds a swim is played at a rate, so many entries a tick, the last one in part; braking and
backing are a forward swim with a negative acceleration and a negative speed (section 4.2).
A change of segment keeps playing the new one and adds an offset of shape and of velocity that fades
by a smoothstep: nobody stalls, and no node jumps. It serves fishes seen and unseen alike, so what
the camera does changes nothing.
"""

from typing import Final, Literal

import numba

from components.clock import Clock
from components.fish import Population
from components.kernels import Launch, inlined, loop, row
from components.prefetch import prefetch
from components.repertoire import RepertoireLibrary
from components.table import Columns
from components.terrain import Terrain, berth, confine
from systems.motor.columns import Bodies, Motors
from systems.motor.go_on import go_on
from systems.motor.rate import play_at_rate
from systems.motor.track import Track, track
from systems.motor.warp import change, fade, wait

PARALLEL_FROM: Final = 500
"""Fishes from which two threads are worth their launch."""

CHUNKS: Final = 64

_AHEAD: Final = 8
"""Rows ahead of the one played whose entries are asked for."""


@inlined
def _step(i: int, fish: Bodies, motor: Motors, track: Track, literal: bool) -> None:
    motor.last_shape_row[i] = motor.shape_row[i]
    motor.last_warp_weight[i] = motor.warp_weight[i]
    motor.held[i] += 1
    change(i, fish, motor, track)
    if literal and motor.warp_length[i] > 0:
        wait(i, fish, motor)
        return
    weight = fade(i, motor)
    if motor.pace[i] != 1.0 or motor.throttle[i] != 1.0:
        play_at_rate(i, fish, motor, track, weight)
        return
    segment = motor.segment[i]
    frame = motor.frame[i]
    entry = track.start[segment] + frame
    t, m, glide, size = (
        track.translation[entry],
        track.rotation[entry],
        motor.glide[i],
        fish.length[i],
    )
    go_on(
        i, size * (t[0] + weight * glide[0]), size * (t[1] + weight * glide[1]),
        size * (t[2] + weight * glide[2]), (m[0, 0], m[1, 0], m[2, 0]),
        (m[0, 1], m[1, 1], m[2, 1]), fish, motor,
    )  # fmt: skip
    motor.shape_row[i] = entry
    frame += 1
    motor.frame[i] = 0 if frame == track.length[segment] and track.loops[segment] else frame


@inlined
def _ask_for(i: int, motor: Motors, track: Track) -> None:
    """Ask for the entry that row i is about to play."""
    entry = track.start[motor.segment[i]] + motor.frame[i]
    prefetch(track.translation, entry)
    prefetch(track.rotation, entry)
    prefetch(track.turn, entry)


@row
def advance(first: int, last: int, fish: Bodies, motor: Motors, track: Track) -> None:
    """Play one entry for the fishes of rows first to last - 1."""
    for i in range(first, last):
        _ask_for(min(i + _AHEAD, last - 1), motor, track)
        _step(i, fish, motor, track, False)


@row
def advance_literally(first: int, last: int, fish: Bodies, motor: Motors, track: Track) -> None:
    """Play one entry for the fishes of rows first to last - 1, gliding as appendix A is printed."""
    for i in range(first, last):
        _step(i, fish, motor, track, True)


@row
def _advance(first: int, last: int, fish: Bodies, motor: Motors, track: Track) -> None:
    if track.literal:
        advance_literally(first, last, fish, motor, track)
    else:
        advance(first, last, fish, motor, track)


@row
def _hold_inside(first: int, last: int, fish: Bodies, terrain: Terrain) -> None:
    for i in range(first, last):
        confine(terrain, fish.position, i, berth(fish.length[i]))


@row
def move_rows(
    first: int, last: int, fish: Bodies, motor: Motors, track: Track, terrain: Terrain
) -> None:
    """Move the fishes of rows first to last - 1."""
    _advance(first, last, fish, motor, track)
    _hold_inside(first, last, fish, terrain)


@loop
def move_parallel(count: int, fish: Bodies, motor: Motors, track: Track, terrain: Terrain) -> None:
    """Move `count` fishes on all threads; to the same bits as `move_rows`."""
    for chunk in numba.prange(CHUNKS):
        first, last = chunk * count // CHUNKS, (chunk + 1) * count // CHUNKS
        move_rows(first, last, fish, motor, track, terrain)


class Move:
    """Reads steer, throttle, wanted segment, species, length, library and terrain; writes the rest of the
    motor table and the fishes' position and rotation, now and a tick ago."""

    def __init__(
        self,
        population: Population,
        library: RepertoireLibrary,
        terrain: Terrain,
        clock: Clock,
        gliding: Literal["decay", "paper"] = "decay",
    ) -> None:
        self.population = population
        self.terrain = terrain
        self.clock = clock
        self.bodies = Columns(Bodies, population.fish)
        self.motors = Columns(Motors, population.motor)
        self.track = track(library, literal=gliding == "paper")
        self._serially, self._in_parallel = Launch(move_rows), Launch(move_parallel)

    def __call__(self) -> None:
        """Move every fish by one tick."""
        count = self.population.count
        given = (self.bodies(), self.motors(), self.track, self.terrain)
        if count < PARALLEL_FROM:
            self._serially(0, count, *given)
        else:
            self._in_parallel(count, *given)
