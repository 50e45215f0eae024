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

from components.arrays import Float64s
from components.clock import Clock
from components.fish import Population
from components.kernels import Launch, inlined, loop, row
from components.repertoire import RepertoireLibrary
from components.rotation import set_axes, turned
from components.table import Columns
from components.terrain import Terrain, berth, confine
from systems.motor.balance import righting, roll
from systems.motor.columns import Bodies, Motors
from systems.motor.rate import play_at_rate
from systems.motor.track import Track, track
from systems.motor.warp import change, fade, wait

PARALLEL_FROM: Final = 500
"""Fishes from which two threads are worth their launch."""

CHUNKS: Final = 64


@inlined
def _play(i: int, t: Float64s, m: Float64s, weight: float, fish: Bodies, motor: Motors) -> None:
    """Play an entry: o <- o + R (length (t + weight glide)), eq. 11, then R <- steer R M, eq. 10, less
    the part of the mean roll that balance takes out now.

    All loads stand before the stores: what was just stored would be waited for.
    """
    r, o = fish.rotation[i], fish.position[i]
    r00, r01, r02 = r[0, 0], r[0, 1], r[0, 2]
    r10, r11, r12 = r[1, 0], r[1, 1], r[1, 2]
    r20, r21, r22 = r[2, 0], r[2, 1], r[2, 2]
    x, y, z = o[0], o[1], o[2]
    size = fish.length[i]
    u = size * (t[0] + weight * motor.glide[i, 0])
    v = size * (t[1] + weight * motor.glide[i, 1])
    w = size * (t[2] + weight * motor.glide[i, 2])
    m00, m10, m20, m01, m11, m21 = m[0, 0], m[1, 0], m[2, 0], m[0, 1], m[1, 1], m[2, 1]
    p, q, s = motor.steer[i, 0], motor.steer[i, 1], motor.steer[i, 2]
    last, was = fish.last_rotation[i], fish.last_position[i]
    last[0, 0], last[0, 1], last[0, 2] = r00, r01, r02
    last[1, 0], last[1, 1], last[1, 2] = r10, r11, r12
    last[2, 0], last[2, 1], last[2, 2] = r20, r21, r22
    was[0], was[1], was[2] = x, y, z
    o[0] = x + (r00 * u + r01 * v + r02 * w)
    o[1] = y + (r10 * u + r11 * v + r12 * w)
    o[2] = z + (r20 * u + r21 * v + r22 * w)
    ax = r00 * m00 + r01 * m10 + r02 * m20
    ay = r10 * m00 + r11 * m10 + r12 * m20
    az = r20 * m00 + r21 * m10 + r22 * m20
    bx = r00 * m01 + r01 * m11 + r02 * m21
    by = r10 * m01 + r11 * m11 + r12 * m21
    bz = r20 * m01 + r21 * m11 + r22 * m21
    cx, cy, cz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    c = righting(i, motor, roll(az, bz, cz))
    bx, by, bz = bx - c * cx, by - c * cy, bz - c * cz
    ax, ay, az = turned(ax, ay, az, p, q, s)
    bx, by, bz = turned(bx, by, bz, p, q, s)
    set_axes(r, ax, ay, az, bx, by, bz)


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
    _play(i, track.translation[entry], track.rotation[entry], weight, fish, motor)
    motor.shape_row[i] = entry
    frame += 1
    motor.frame[i] = 0 if frame == track.length[segment] and track.loops[segment] else frame


@row
def advance(first: int, last: int, fish: Bodies, motor: Motors, track: Track) -> None:
    """Play one entry for the fishes of rows first to last - 1."""
    for i in range(first, last):
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
def move_serial(count: int, fish: Bodies, motor: Motors, track: Track, terrain: Terrain) -> None:
    """Move `count` fishes on this thread."""
    _advance(0, count, fish, motor, track)
    _hold_inside(0, count, fish, terrain)


@loop
def move_parallel(count: int, fish: Bodies, motor: Motors, track: Track, terrain: Terrain) -> None:
    """Move `count` fishes on all threads; to the same bits as `move_serial`."""
    for chunk in numba.prange(CHUNKS):
        first, last = chunk * count // CHUNKS, (chunk + 1) * count // CHUNKS
        _advance(first, last, fish, motor, track)
        _hold_inside(first, last, fish, terrain)


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
        self._bodies = Columns(Bodies, population.fish)
        self._motors = Columns(Motors, population.motor)
        self.track = track(library, literal=gliding == "paper")
        self._serially, self._in_parallel = Launch(move_serial), Launch(move_parallel)

    def __call__(self) -> None:
        """Move every fish by one tick."""
        count = self.population.count
        kernel = self._serially if count < PARALLEL_FROM else self._in_parallel
        kernel(count, self._bodies(), self._motors(), self.track, self.terrain)
