"""The fibres' kernel in numba: the twin of fibres.cl, operation for operation (papers/002, section 4; FINDINGS 9).

Force and moment go from tip to root (eqs. 9-13), target directions from root to tip (eq. 10), and every segment's
direction eases towards its target; lengths are exact because only directions are state. float32 throughout, with the
same operations and sums in the same order as there, so that both give the same bits.
"""

from collections.abc import Callable
from math import sqrt
from typing import Final, cast

import numba
import numpy as np

from components.arrays import Float32s, Int32s
from components.fibre import CARRIED, GROUNDED, LANES, PUSH, SKIN, Rocks, Strands
from components.kernels import inlined, loop, row
from systems.sea.gather import Lists

# What a kernel reads as float32 is a float to those who check types.
F: Final = cast(Callable[[float], float], np.float32)
_0, _1, _2, _3 = F(0.0), F(1.0), F(2.0), F(3.0)
_HALF, _WHIRLING, _DIRECTED = F(0.5), F(1.5), F(2.5)
_LEAST_PUSH = F(1e-30)
_LEAST_STIFFNESS = F(1e-12)
_FASTEST, _STRONGEST, _SHARPEST = F(1e4), F(1e12), F(1e9)
_ANTIPODE = F(1e-3)
_LOST = F(1e-6)
_TURN = F(6.2831855)
_SIN3, _SIN5, _SIN7 = F(-1.0 / 6.0), F(1.0 / 120.0), F(-1.0 / 5040.0)
_SIN9, _SIN11 = F(1.0 / 362880.0), F(-1.0 / 39916800.0)
_INVERSE_SKIN, _PUSH, _GAIN = F(1.0 / SKIN), F(PUSH), F(PUSH / SKIN)
_PROJECTIONS: Final = 3


@inlined
def _wave(turns: float) -> float:
    """Return the sine of an angle in turns."""
    s: float = turns - np.floor(turns + _HALF)
    size = abs(s)
    size = min(size, _HALF - size) * _TURN
    q = size * size
    p = _SIN11 * q + _SIN9
    p = p * q + _SIN7
    p = p * q + _SIN5
    p = p * q + _SIN3
    value = size + size * q * p
    return value if s >= _0 else -value


@row
def flow_at(
    packed: Float32s, member: Int32s, begin: int, end: int, x: float, y: float, z: float
) -> tuple[float, float, float, float]:
    """Return the flow [m/s] and the holes' gain [1/s] at a point [m]: eqs. 2-5 over a list of singularities."""
    u, v, w, gain = _0, _0, _0, _0
    for at in range(begin, end):
        k = member[at]
        qx, qy, qz = x - packed[k, 0], y - packed[k, 1], z - packed[k, 2]
        d2 = qx * qx + qy * qy + qz * qz
        inside = _2 - d2 * packed[k, 14]
        if not inside > _0:
            continue
        inside = min(inside, _1)
        push = packed[k, 8] * (inside * inside * (_3 - _2 * inside))
        kind = packed[k, 7]
        if kind < _WHIRLING:
            push = push / ((packed[k, 9] + d2) * sqrt(d2 + packed[k, 10]) + _LEAST_PUSH)
            u, v, w = u + push * qx, v + push * qy, w + push * qz
            gain = gain + max(-push, _0)
            continue
        ax, ay, az = packed[k, 4], packed[k, 5], packed[k, 6]
        if kind < _DIRECTED:
            cx, cy, cz = qy * az - qz * ay, qz * ax - qx * az, qx * ay - qy * ax
            c2 = cx * cx + cy * cy + cz * cz
            push = push / ((packed[k, 9] + d2) * sqrt(c2 + packed[k, 10]) + _LEAST_PUSH)
            u, v, w = u + push * cx, v + push * cy, w + push * cz
        else:
            turns = packed[k, 12] * (x * ax + y * ay + z * az) + packed[k, 13]
            push = push * (_1 + packed[k, 11] * _wave(turns))
            u, v, w = u + push * ax, v + push * ay, w + push * az
    return u, v, w, gain


@inlined
def _rock_at(
    table: Float32s, k: int, x: float, y: float, z: float
) -> tuple[float, float, float, float]:
    """Return the distance [m] to a rock, negative inside, and the way out: `components.ground.rock_clearance`."""
    dx, dy, dz = x - table[k, 0], y - table[k, 1], z - table[k, 2]
    cosine, sine = table[k, 8], table[k, 9]
    u = (cosine * dx + sine * dy) * table[k, 4]
    v = (cosine * dy - sine * dx) * table[k, 5]
    w = dz * table[k, 6]
    k0 = sqrt(u * u + v * v + w * w)
    u, v, w = u * table[k, 4], v * table[k, 5], w * table[k, 6]
    k1 = sqrt(u * u + v * v + w * w)
    if not k1 > _LOST:
        return -table[k, 3], _0, _0, _1
    return (
        k0 * (k0 - _1) / k1,
        (cosine * u - sine * v) / k1,
        (sine * u + cosine * v) / k1,
        w / k1,
    )


@row
def _outside(
    strands: Strands, rocks: Rocks, bundle: int, lane: int, x: float, y: float, z: float
) -> tuple[float, float, float]:
    """Return a point [m] moved out of the rocks and the ground that hold it, one after the other."""
    clump, plane = strands.bundle[bundle, 2], strands.plane
    for near in range(rocks.first[clump], rocks.first[clump + 1]):
        away, nx, ny, nz = _rock_at(rocks.table, rocks.member[near], x, y, z)
        away = min(away, _0)
        x, y, z = x - away * nx, y - away * ny, z - away * nz
    nx, ny, nz = plane[bundle, 0, lane], plane[bundle, 1, lane], plane[bundle, 2, lane]
    away = min(nx * x + ny * y + nz * z - plane[bundle, 3, lane], _0)
    return x - away * nx, y - away * ny, z - away * nz


@row
def _turn_root(strands: Strands, bundle: int, lane: int) -> None:
    """Set the root of a carried fibre as its carrier's node has moved and turned: the least turn between directions."""
    node = strands.carrier[bundle, lane]
    above, beside = node // LANES, node % LANES
    perch, rest, root = strands.perch, strands.rest_root, strands.root
    ex, ey, ez = perch[bundle, 3, lane], perch[bundle, 4, lane], perch[bundle, 5, lane]
    dx = strands.direction[above, 0, beside]
    dy = strands.direction[above, 1, beside]
    dz = strands.direction[above, 2, beside]
    c = ex * dx + ey * dy + ez * dz
    wx, wy, wz = ey * dz - ez * dy, ez * dx - ex * dz, ex * dy - ey * dx
    share = _1 / max(_1 + c, _ANTIPODE)
    first = strands.bundle[bundle, 0]
    for part in range(3):
        if part == 0:
            x, y, z = perch[bundle, 0, lane], perch[bundle, 1, lane], perch[bundle, 2, lane]
        else:
            a = 3 * part - 3
            x, y, z = rest[bundle, a, lane], rest[bundle, a + 1, lane], rest[bundle, a + 2, lane]
        along = (wx * x + wy * y + wz * z) * share
        px = c * x + (wy * z - wz * y) + wx * along
        py = c * y + (wz * x - wx * z) + wy * along
        pz = c * z + (wx * y - wy * x) + wz * along
        if part == 0:
            strands.position[first, 0, lane] = strands.position[above, 0, beside] + px
            strands.position[first, 1, lane] = strands.position[above, 1, beside] + py
            strands.position[first, 2, lane] = strands.position[above, 2, beside] + pz
        else:
            a = 3 * part - 3
            root[bundle, a, lane], root[bundle, a + 1, lane], root[bundle, a + 2, lane] = px, py, pz
        if part == 1:
            strands.direction[first, 0, lane] = px
            strands.direction[first, 1, lane] = py
            strands.direction[first, 2, lane] = pz


@row
def _load(
    strands: Strands, rocks: Rocks, packed: Float32s, lists: Lists, bundle: int, lane: int
) -> float:
    """Put the net force on each node (eqs. 9-13) where its position stood; return the holes' gain G of the fibre."""
    first, nodes = strands.bundle[bundle, 0], strands.bundle[bundle, 1]
    clump = strands.bundle[bundle, 2]
    begin, end = lists.first[clump], lists.first[clump + 1]
    position, direction = strands.position, strands.direction
    carry_x, carry_y, carry_z = _0, _0, _0
    m0, m1, gain = _0, _0, _0
    below = _0
    for at in range(first + 1, first + nodes):
        below = below + strands.length[at, lane]
    for at in range(first + nodes - 1, first, -1):
        x, y, z = position[at, 0, lane], position[at, 1, lane], position[at, 2, lane]
        u, v, w, holes = flow_at(packed, lists.member, begin, end, x, y, z)
        for near in range(rocks.first[clump], rocks.first[clump + 1]):
            away, nx, ny, nz = _rock_at(rocks.table, rocks.member[near], x, y, z)
            push = min(_1 - away * _INVERSE_SKIN, _2)
            if push > _0:
                push = push * _PUSH
                u, v, w, holes = u + push * nx, v + push * ny, w + push * nz, holes + _GAIN
        holes = min(holes, _SHARPEST)
        u = min(max(u, -_FASTEST), _FASTEST)
        v = min(max(v, -_FASTEST), _FASTEST)
        w = min(max(w, -_FASTEST), _FASTEST)
        area, length = strands.area[at, lane], strands.length[at, lane]
        fx = min(max(area * u + carry_x, -_STRONGEST), _STRONGEST)
        fy = min(max(area * v + carry_y, -_STRONGEST), _STRONGEST)
        fz = min(max(area * w + carry_z, -_STRONGEST), _STRONGEST)
        position[at, 0, lane], position[at, 1, lane], position[at, 2, lane] = fx, fy, fz
        m0 = m0 + area * holes
        m1 = m1 + area * holes * below
        below = below - length
        arm = max(m1 - below * m0, _0)
        gain = gain + arm / (strands.stiffness[at, lane] + _LEAST_STIFFNESS)
        dx, dy, dz = direction[at, 0, lane], direction[at, 1, lane], direction[at, 2, lane]
        lengthwise = fx * dx + fy * dy + fz * dz
        lx, ly, lz = lengthwise * dx, lengthwise * dy, lengthwise * dz
        tx, ty, tz = fx - lx, fy - ly, fz - lz
        if at > first + 1:
            bx, by, bz = (
                direction[at - 1, 0, lane],
                direction[at - 1, 1, lane],
                direction[at - 1, 2, lane],
            )
            c = bx * dx + by * dy + bz * dz
            s = bx * tx + by * ty + bz * tz
            gx, gy, gz = tx * c - dx * s, ty * c - dy * s, tz * c - dz * s
            size = sqrt(tx * tx + ty * ty + tz * tz) * (length / strands.length[at - 1, lane])
            q = _1 / sqrt(gx * gx + gy * gy + gz * gz + _LEAST_PUSH)
            gx, gy, gz = gx * q, gy * q, gz * q
            carry_x, carry_y, carry_z = lx + size * gx, ly + size * gy, lz + size * gz
    return gain


@row
def bend_fibre(
    strands: Strands,
    rocks: Rocks,
    packed: Float32s,
    lists: Lists,
    bundle: int,
    lane: int,
    part: float,
) -> None:
    """Bend one fibre by the part of the way that a step takes."""
    if strands.bundle[bundle, 3] & CARRIED:
        _turn_root(strands, bundle, lane)
    gain = _load(strands, rocks, packed, lists, bundle, lane)
    part = min(part, _1 / (_1 + gain))
    first, nodes = strands.bundle[bundle, 0], strands.bundle[bundle, 1]
    clump = strands.bundle[bundle, 2]
    free = rocks.first[clump] == rocks.first[clump + 1]
    attempts = 0 if free and not strands.bundle[bundle, 3] & GROUNDED else _PROJECTIONS
    position, direction, root = strands.position, strands.direction, strands.root
    tx, ty, tz = root[bundle, 0, lane], root[bundle, 1, lane], root[bundle, 2, lane]
    nx, ny, nz = root[bundle, 3, lane], root[bundle, 4, lane], root[bundle, 5, lane]
    x, y, z = position[first, 0, lane], position[first, 1, lane], position[first, 2, lane]
    for at in range(first + 1, first + nodes):
        a, b, c = strands.rest[at, 0, lane], strands.rest[at, 1, lane], strands.rest[at, 2, lane]
        cx = a * tx + b * nx + c * (ty * nz - tz * ny)
        cy = a * ty + b * ny + c * (tz * nx - tx * nz)
        cz = a * tz + b * nz + c * (tx * ny - ty * nx)
        fx, fy, fz = position[at, 0, lane], position[at, 1, lane], position[at, 2, lane]
        along = fx * cx + fy * cy + fz * cz
        hold = strands.stiffness[at, lane] + _LEAST_STIFFNESS + max(along, _0)
        sx = (fx - along * cx) + hold * cx
        sy = (fy - along * cy) + hold * cy
        sz = (fz - along * cz) + hold * cz
        q = sx * sx + sy * sy + sz * sz
        if q > _LEAST_PUSH:
            size = _1 / sqrt(q)
            sx, sy, sz = sx * size, sy * size, sz * size
        else:
            sx, sy, sz = cx, cy, cz
        whole = max(_1 + (tx * sx + ty * sy + tz * sz), _ANTIPODE)
        share = (nx * sx + ny * sy + nz * sz) / whole
        nx, ny, nz = nx - share * (tx + sx), ny - share * (ty + sy), nz - share * (tz + sz)
        tx, ty, tz = sx, sy, sz
        dx, dy, dz = direction[at, 0, lane], direction[at, 1, lane], direction[at, 2, lane]
        dx, dy, dz = dx + part * (tx - dx), dy + part * (ty - dy), dz + part * (tz - dz)
        q = dx * dx + dy * dy + dz * dz
        if q > _LOST:
            size = _1 / sqrt(q)
            dx, dy, dz = dx * size, dy * size, dz * size
        else:
            dx, dy, dz = tx, ty, tz
        length = strands.length[at, lane]
        px, py, pz = x + length * dx, y + length * dy, z + length * dz
        for _ in range(attempts):
            qx, qy, qz = _outside(strands, rocks, bundle, lane, px, py, pz)
            if qx == px and qy == py and qz == pz:
                break
            qx, qy, qz = qx - x, qy - y, qz - z
            q = qx * qx + qy * qy + qz * qz
            if not q > _LEAST_PUSH:
                break
            size = _1 / sqrt(q)
            dx, dy, dz = qx * size, qy * size, qz * size
            px, py, pz = x + length * dx, y + length * dy, z + length * dz
        direction[at, 0, lane], direction[at, 1, lane], direction[at, 2, lane] = dx, dy, dz
        position[at, 0, lane], position[at, 1, lane], position[at, 2, lane] = px, py, pz
        x, y, z = px, py, pz


@row
def bend_bundles(
    strands: Strands,
    rocks: Rocks,
    packed: Float32s,
    lists: Lists,
    bundles: Int32s,
    part: float,
) -> None:
    """Bend all fibres of some bundles, one after the other."""
    for bundle in bundles:
        for lane in range(LANES):
            bend_fibre(strands, rocks, packed, lists, bundle, lane, part)


@loop
def bend_in_parallel(
    strands: Strands,
    rocks: Rocks,
    packed: Float32s,
    lists: Lists,
    bundles: Int32s,
    part: float,
) -> None:
    """Bend all fibres of some bundles, none of which carries another."""
    for at in numba.prange(len(bundles)):
        bend_bundles(strands, rocks, packed, lists, bundles[at : at + 1], part)
