"""One fish's tick in live physics: muscles, water, fine steering, hull and ground (papers/000, 3.1 and 9.1).

`Move` has played the fish's replay for this tick already, from where physics left it; its segment and frame tell the
muscles what to do, so that the stroke stays in phase with the repertoire and the hand-back finds it there.
"""

from math import sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float32s, Float64s, Int8s, Int32s, Int64s
from components.body import NODES
from components.kernels import row
from components.live import MUSCLES, LiveTable
from components.motor import RATES
from components.rotation import turned
from components.submarine import HULL_RADIUS
from components.terrain import Terrain, berth, confine
from systems.motor.biomechanics import (
    BAND_SIZE,
    SUBSTEP_SECONDS,
    SUBSTEPS,
    UNKNOWNS,
    Workspace,
    assemble,
    move_nodes,
    solve,
)
from systems.motor.body_frame import body_frame
from systems.motor.columns import Bodies, Motors
from systems.motor.contract import Stroke, contract
from systems.motor.muscle_model import SEGMENTS, SPRINGS, BodyModel
from systems.motor.pectorals import Pectorals, press
from systems.motor.strokes import Strokes
from systems.motor.track import Track

FARTHEST: Final = 0.3
"""[BL] of a node from where replay shows it, thrice that as a change of segment begins: beyond, physics has failed or
the body has folded, and replay goes on."""

FARTHEST_AT_FIRST: Final = 0.015
"""... and in its first tick, else it goes on replaying."""

HULL_KEEP: Final = 0.25
"""Half a fish's width, over its length: what its nodes' middles keep from the hull."""


class Slots(NamedTuple):
    """The columns of `LiveTable`."""

    id: Int64s
    stage: Int8s
    entry: Int32s
    side: Int8s
    shape: Float32s
    nodes: Float64s
    velocity: Float64s
    travel: Float64s
    rest: Float64s
    offset: Float64s


class Scratch(NamedTuple):
    """What a fish's physics needs and nobody remembers, once a piece of the work, P in all: it stays in the cache."""

    rest: Float64s
    "(P, 91)"
    axes: Float64s
    "(P, 6, 3)"
    band: Float64s
    "(P, BAND_SIZE)"
    right: Float64s
    "(P, 69)"
    origin: Float64s
    "(P, 2, 3)"
    rotation: Float64s
    "(P, 3, 3)"


class Hull(NamedTuple):
    """The submarine's hull, which fishes cannot enter."""

    position: Float64s
    "[m], (3,)"
    velocity: Float64s
    "[m/s], (3,)"


def slots(table: LiveTable) -> Slots:
    """Return the columns of `table`."""
    return Slots(*(getattr(table, name)[: table.count] for name in Slots._fields))


def scratch(count: int) -> Scratch:
    """Return scratch for `count` pieces."""
    return Scratch(
        np.zeros((count, SPRINGS)),
        np.zeros((count, SEGMENTS, 3)),
        np.zeros((count, BAND_SIZE)),
        np.zeros((count, UNKNOWNS)),
        np.zeros((count, 2, 3)),
        np.zeros((count, 3, 3)),
    )


@row
def scratch_of(work: Scratch, piece: int) -> Scratch:
    """Return the scratch of one piece: the same arrays without their first axis."""
    return Scratch(
        work.rest[piece],
        work.axes[piece],
        work.band[piece],
        work.right[piece],
        work.origin[piece],
        work.rotation[piece],
    )


@row
def model_of(strokes: Strokes, species: int, segment: int) -> BodyModel:
    """Return a species' body in the water in which `segment` was captured."""
    return BodyModel(
        strokes.mass[species],
        strokes.length[species],
        strokes.stiffness[species],
        strokes.damping[species],
        strokes.start[species],
        strokes.water[segment],
    )


@row
def stroke_of_row(strokes: Strokes, segment: int) -> Stroke:
    """Return the stroke of a segment, the pectoral fins righting."""
    return Stroke(
        strokes.middle[segment],
        strokes.rear[segment],
        strokes.lag[segment],
        strokes.period[segment],
        strokes.offset[segment],
        strokes.turn[segment],
        0,
        strokes.flight[segment],
        strokes.loops[segment],
        Pectorals(1.0, 0.0, 0.0, 0.0, 0.0, 1),
        strokes.swim_at[segment],
    )


@row
def rate_of(i: int, motor: Motors) -> float:
    """Return how many entries of a swim the fish of row `i` plays in a tick."""
    return max(RATES[0], min(RATES[1], float(motor.pace[i])))


@row
def swim_on(
    s: int, i: int, slots: Slots, fish: Bodies, motor: Motors, track: Track, strokes: Strokes,
    work: Scratch,
) -> None:  # fmt: skip
    """Advance the nodes of slot `s` by four substeps of the stroke of its fish's segment, at the rate of its replay.

    After a change of segment the muscles go over from the old stroke to the new one as replay's shapes do.
    """
    segment = motor.segment[i]
    rate = rate_of(i, motor) if track.loops[segment] == 1 else 1.0
    place = SUBSTEPS * (slots.entry[s] - track.start[segment] + 1 + motor.part[i] - rate)
    model = model_of(strokes, fish.species[i], segment)
    stroke = stroke_of_row(strokes, segment)
    space = Workspace(work.rest, work.axes, work.band, work.right)
    for spring in range(SPRINGS):
        space.rest[spring] = model.length[spring]
    if motor.held[i] == 0:
        contract(stroke, model.length, place, SUBSTEP_SECONDS, space.rest)
        for m in range(MUSCLES):
            slots.offset[s, m] = slots.rest[s, m] - space.rest[m]
    weight = motor.warp_weight[i]
    nodes, velocity = slots.nodes[s], slots.velocity[s]
    for step in range(SUBSTEPS):
        contract(stroke, model.length, place + step * rate, SUBSTEP_SECONDS, space.rest)
        for m in range(MUSCLES):
            space.rest[m] += weight * slots.offset[s, m]
        assemble(model, nodes, velocity, space)
        fins, drag, mass = stroke.fins, model.water[0], model.mass
        press(fins, drag, mass, nodes, velocity, step, SUBSTEP_SECONDS, space.right)
        solve(space.band, space.right)
        move_nodes(nodes, velocity, space.right)
    for m in range(MUSCLES):
        slots.rest[s, m] = space.rest[m]


@row
def turn_all(vectors: Float64s, u: float, v: float, w: float) -> None:
    """Turn vectors (23, 3) by the rotation vector (u, v, w) [rad]."""
    for n in range(NODES):
        x, y, z = turned(vectors[n, 0], vectors[n, 1], vectors[n, 2], u, v, w)
        vectors[n, 0], vectors[n, 1], vectors[n, 2] = x, y, z


@row
def halt(velocity: Float64s, x: float, y: float, z: float, least: float) -> None:
    """Let velocities (23, 3) have a mean of at least `least` along the unit vector (x, y, z): no more into a wall."""
    mean = 0.0
    for n in range(NODES):
        mean += x * velocity[n, 0] + y * velocity[n, 1] + z * velocity[n, 2]
    lack = least - mean / NODES
    if lack > 0.0:
        for n in range(NODES):
            velocity[n, 0] += lack * x
            velocity[n, 1] += lack * y
            velocity[n, 2] += lack * z


@row
def out_of_hull(s: int, i: int, slots: Slots, fish: Bodies, hull: Hull) -> None:
    """Push a fish out of the submarine's hull, as a whole by its deepest node, and let it go no further inwards."""
    size, o, nodes = fish.length[i], fish.position[i], slots.nodes[s]
    reach = HULL_RADIUS + HULL_KEEP * size
    x, y, z = o[0] - hull.position[0], o[1] - hull.position[1], o[2] - hull.position[2]
    away = sqrt(x * x + y * y + z * z)
    if away > reach + 2.0 * size or away < 1e-6:
        return
    x, y, z = x / away, y / away, z / away
    deep = 0.0
    for n in range(NODES):
        u = o[0] + size * nodes[n, 0] - hull.position[0]
        v = o[1] + size * nodes[n, 1] - hull.position[1]
        w = o[2] + size * nodes[n, 2] - hull.position[2]
        deep = max(deep, reach - sqrt(u * u + v * v + w * w))
    if deep > 0.0:
        o[0], o[1], o[2] = o[0] + deep * x, o[1] + deep * y, o[2] + deep * z
        g = hull.velocity
        halt(slots.velocity[s], x, y, z, (x * g[0] + y * g[1] + z * g[2]) / size)


@row
def hold_inside(s: int, i: int, slots: Slots, fish: Bodies, terrain: Terrain) -> None:
    """Keep a fish in the world, as move does, and let it go no further into what it met."""
    o = fish.position[i]
    x, y, z = o[0], o[1], o[2]
    if confine(terrain, fish.position, i, berth(fish.length[i])):
        x, y, z = o[0] - x, o[1] - y, o[2] - z
        way = sqrt(x * x + y * y + z * z)
        if way > 1e-9:
            halt(slots.velocity[s], x / way, y / way, z / way, 0.0)


@row
def sound(s: int, slots: Slots, track: Track, part: float, farthest: float, work: Scratch) -> bool:
    """Write the nodes in body axes to the slot's other shape; return whether all are near those of replay, which stands
    `part` behind the slot's entry."""
    r, nodes, entry = work.rotation, slots.nodes[s], slots.entry[s]
    shape, after = track.shape[entry], track.shape[track.after[entry]]
    out = slots.shape[s, 1 - slots.side[s]]
    for n in range(NODES):
        square = 0.0
        for k in range(3):
            d = r[0, k] * nodes[n, 0] + r[1, k] * nodes[n, 1] + r[2, k] * nodes[n, 2]
            out[n, k] = np.float32(d)
            d -= shape[k, n] + part * (after[k, n] - shape[k, n])
            square += d * d
        if not square <= farthest * farthest:
            return False
    return True


@row
def step(
    s: int, i: int, slots: Slots, fish: Bodies, motor: Motors, track: Track, strokes: Strokes,
    terrain: Terrain, hull: Hull, work: Scratch, farthest: float,
) -> bool:  # fmt: skip
    """Simulate a tick of the fish in row `i`, held in slot `s`: its nodes, and where it is and looks.

    Return False, the fish where replay put it, if a node is farther than `farthest` [BL] from replay's or nowhere.
    """
    swim_on(s, i, slots, fish, motor, track, strokes, work)
    nodes, o, r = slots.nodes[s], work.origin[0], work.rotation
    body_frame(nodes, o, r)
    for n in range(NODES):
        for k in range(3):
            nodes[n, k] -= o[k]
    turn = motor.steer[i]
    turn_all(nodes, turn[0], turn[1], turn[2])
    turn_all(slots.velocity[s], turn[0], turn[1], turn[2])
    body_frame(nodes, work.origin[1], r)
    if not sound(s, slots, track, motor.part[i], farthest, work):
        return False
    slots.side[s] = 1 - slots.side[s]
    size, was = fish.length[i], fish.last_rotation[i]
    for k in range(3):
        way = was[0, k] * o[0] + was[1, k] * o[1] + was[2, k] * o[2]
        slots.travel[s, k] = way / motor.pace[i]
        fish.position[i, k] = fish.last_position[i, k] + size * o[k]
        for j in range(3):
            fish.rotation[i, j, k] = r[j, k]
    out_of_hull(s, i, slots, fish, hull)
    hold_inside(s, i, slots, fish, terrain)
    return True
