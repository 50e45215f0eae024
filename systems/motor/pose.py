"""Pose: the 23 nodes of fishes, as the GPU rebuilds them from an instance record (papers/000, eq. 12).

The reference of the view in tests, of the benches, and of the capture that a replay is held
against. Between two ticks, at the fraction alpha: positions are interpolated, so are the x and y
axes, then made a rotation again (components/rotation.py, `between`); the shape is

    (1 - alpha) d[last_row] + alpha d[row] + w (d[warp_from] - d[warp_to]),
    w = (1 - alpha) last_warp_weight + alpha warp_weight.

Fishes that play at another rate than 1 show shapes between two entries; alpha runs from the last such
place to the one now (components/motor.py, `shown_between`).
"""

import numpy as np

from components.arrays import Float32s, Float64s, Int32s, Int64s
from components.body import NODES
from components.fish import Population
from components.kernels import inlined, row
from components.motor import shown_between
from components.repertoire import RepertoireLibrary
from components.rotation import between
from systems.motor.columns import Bodies, Motors, bodies, motors
from systems.motor.track import PLANE, Track, planes


@inlined
def place_nodes(d: Float32s, r: Float64s, o: Float64s, size: float, nodes: Float32s) -> None:
    """nodes <- o + R (size d), eq. 12, in float32; d and nodes by planes, (72,)."""
    a, b, c = np.float32(size * r[0, 0]), np.float32(size * r[0, 1]), np.float32(size * r[0, 2])
    e, f, g = np.float32(size * r[1, 0]), np.float32(size * r[1, 1]), np.float32(size * r[1, 2])
    p, q, s = np.float32(size * r[2, 0]), np.float32(size * r[2, 1]), np.float32(size * r[2, 2])
    x, y, z = np.float32(o[0]), np.float32(o[1]), np.float32(o[2])
    for n in range(PLANE):
        u, v, w = d[n], d[n + PLANE], d[n + 2 * PLANE]
        nodes[n] = x + (a * u + b * v + c * w)
        nodes[n + PLANE] = y + (e * u + f * v + g * w)
        nodes[n + 2 * PLANE] = z + (p * u + q * v + s * w)


@inlined
def place_warped(
    d: Float32s,
    leave: Float32s,
    enter: Float32s,
    weight: float,
    r: Float64s,
    o: Float64s,
    size: float,
    nodes: Float32s,
) -> None:
    """nodes <- o + R (size (d + weight (leave - enter))), as `place_nodes`, in one pass."""
    a, b, c = np.float32(size * r[0, 0]), np.float32(size * r[0, 1]), np.float32(size * r[0, 2])
    e, f, g = np.float32(size * r[1, 0]), np.float32(size * r[1, 1]), np.float32(size * r[1, 2])
    p, q, s = np.float32(size * r[2, 0]), np.float32(size * r[2, 1]), np.float32(size * r[2, 2])
    x, y, z, k = np.float32(o[0]), np.float32(o[1]), np.float32(o[2]), np.float32(weight)
    for n in range(PLANE):
        m, h = n + PLANE, n + 2 * PLANE
        u = d[n] + k * (leave[n] - enter[n])
        v = d[m] + k * (leave[m] - enter[m])
        w = d[h] + k * (leave[h] - enter[h])
        nodes[n] = x + (a * u + b * v + c * w)
        nodes[m] = y + (e * u + f * v + g * w)
        nodes[h] = z + (p * u + q * v + s * w)


@inlined
def mix_shapes(a: Float32s, b: Float32s, part: float, out: Float32s) -> None:
    """out <- (1 - part) a + part b, by planes, (72,)."""
    w = np.float32(part)
    v = np.float32(1.0) - w
    for n in range(3 * PLANE):
        out[n] = v * a[n] + w * b[n]


@inlined
def offset_shape(out: Float32s, weight: float, leave: Float32s, enter: Float32s) -> None:
    """out <- out + weight (leave - enter), the offset of a warp, by planes, (72,)."""
    w = np.float32(weight)
    for n in range(3 * PLANE):
        out[n] += w * (leave[n] - enter[n])


@row
def pose_rows(
    rows: Int64s,
    fish: Bodies,
    motor: Motors,
    shape: Float32s,
    after: Int32s,
    alpha: float,
    body: bool,
    o: Float64s,
    r: Float64s,
    nodes: Float32s,
) -> None:
    """Fill nodes (rows, 72) from shapes (E, 72) as `pose` tells; o (3,) and r (3, 3) are scratch."""
    for at in range(len(rows)):
        i, out = rows[at], nodes[at]
        last, part = motor.last_shape_row[i], motor.part[i]
        a, b, share = shown_between(
            last, motor.last_part[i], motor.shape_row[i], part, alpha, after
        )
        mix_shapes(shape[a], shape[b], share, out)
        weight = (1.0 - alpha) * motor.last_warp_weight[i] + alpha * motor.warp_weight[i]
        leave, enter, part = motor.warp_from[i], motor.warp_to[i], motor.warp_part[i]
        offset_shape(out, weight * (1.0 - part), shape[leave], shape[enter])
        if part > 0.0:
            offset_shape(out, weight * part, shape[after[leave]], shape[enter])
        if not body:
            between(fish.last_rotation[i], fish.rotation[i], alpha, r)
            for k in range(3):
                a = fish.last_position[i, k]
                o[k] = a + alpha * (fish.position[i, k] - a)
            place_nodes(out, r, o, fish.length[i], out)


@row
def _place_between(
    i: int, fish: Bodies, motor: Motors, after: Int32s, flat: Float32s, out: Float32s
) -> None:
    """Fill the nodes, (72,), of a fish between two entries, or whose warp left from there; see `reconstruct`."""
    row, leave, enter = motor.shape_row[i], motor.warp_from[i], motor.warp_to[i]
    weight, part = motor.warp_weight[i], motor.warp_part[i]
    mix_shapes(flat[row], flat[after[row]], motor.part[i], out)
    if weight != 0.0:
        offset_shape(out, weight * (1.0 - part), flat[leave], flat[enter])
        offset_shape(out, weight * part, flat[after[leave]], flat[enter])
    place_nodes(out, fish.rotation[i], fish.position[i], fish.length[i], out)


@row
def reconstruct(
    count: int, fish: Bodies, motor: Motors, shape: Float32s, after: Int32s, nodes: Float32s
) -> None:
    """Fill nodes (count, 3, 24) [m], world axes, at the end of a tick: eq. 12 and the warps.

    `shape` and `after` are the track's; taken out of it they cost a tenth less.
    """
    flat, laid = shape.reshape(len(shape), 3 * PLANE), nodes.reshape(len(nodes), 3 * PLANE)
    for i in range(count):
        out, r, o = laid[i], fish.rotation[i], fish.position[i]
        d = flat[motor.shape_row[i]]
        weight = motor.warp_weight[i]
        if motor.part[i] != 0.0 or (weight != 0.0 and motor.warp_part[i] != 0.0):
            _place_between(i, fish, motor, after, flat, out)
        elif weight != 0.0:
            leave, enter = flat[motor.warp_from[i]], flat[motor.warp_to[i]]
            place_warped(d, leave, enter, weight, r, o, fish.length[i], out)
        else:
            place_nodes(d, r, o, fish.length[i], out)


@row
def replay(
    first: int,
    length: int,
    frame: Int32s,
    size: Float64s,
    track: Track,
    rotation: Float64s,
    position: Float64s,
    nodes: Float32s,
) -> None:
    """Play the cycle of `length` entries from `first` for every fish by a tick: eqs. 10 to 12 and
    nothing else, for the bench. Shapes: (n,), (n,), (n, 3, 3), (n, 3), (n, 3, 24)."""
    flat = track.shape.reshape(len(track.shape), 3 * PLANE)
    laid = nodes.reshape(len(nodes), 3 * PLANE)
    for i in range(len(frame)):
        entry = first + frame[i]
        frame[i] = frame[i] + 1 if frame[i] + 1 < length else 0
        t, m, r, o = track.translation[entry], track.rotation[entry], rotation[i], position[i]
        a, u, v, w = size[i], size[i] * t[0], size[i] * t[1], size[i] * t[2]
        for j in range(3):
            x, y, z = r[j, 0], r[j, 1], r[j, 2]
            o[j] += x * u + y * v + z * w
            r[j, 0] = x * m[0, 0] + y * m[1, 0] + z * m[2, 0]
            r[j, 1] = x * m[0, 1] + y * m[1, 1] + z * m[2, 1]
            r[j, 2] = x * m[0, 2] + y * m[1, 2] + z * m[2, 2]
        place_nodes(flat[entry], r, o, a, laid[i])


def pose(
    population: Population,
    library: RepertoireLibrary,
    rows: Int64s | None = None,
    alpha: float = 1.0,
    body: bool = False,
) -> Float32s:
    """Return the nodes of `rows`, all by default, at the fraction `alpha` of the last tick.

    [m] in world axes, or [BL] in body axes where `body` is set; (rows, 23, 3), float32.
    """
    chosen = np.arange(population.count) if rows is None else np.asarray(rows, np.int64)
    nodes = np.empty((len(chosen), 3 * PLANE), np.float32)
    fish, motor = bodies(population.fish), motors(population.motor)
    shape = planes(library.shape).reshape(-1, 3 * PLANE)
    o, r = np.empty(3), np.empty((3, 3))
    pose_rows(chosen, fish, motor, shape, library.after, alpha, body, o, r, nodes)
    laid = nodes.reshape(-1, 3, PLANE)[:, :, :NODES]
    return np.ascontiguousarray(laid.transpose(0, 2, 1))
