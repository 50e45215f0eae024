"""Where the rings of drawn fibres are: nodes smoothed into as many rings as a fibre is worth, each with a frame that is
carried along the fibre without twist (papers/002, 3: generalized cylinders; FINDINGS 9).

For the view only: what is written here goes to the GPU and nowhere else.
"""

from math import sqrt
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float32s, Float64s, Int32s
from components.garden import Garden
from components.kernels import row

RING: Final = 12
"""Numbers of a ring: place [m], radius [m]; unit side, way from the root [m]; unit direction, slope of the radius."""
_LEAST: Final = 1e-12


class Fibres(NamedTuple):
    """The fibres of a garden as the kernel reads them."""

    position: Float32s
    "[m] nodes, (rows, 3, 8)"
    radius: Float32s
    "[m] at the nodes, (rows, 8)"
    first_row: Int32s
    "row of each fibre's root, (fibres,)"
    lane: Int32s
    "place of each fibre in its rows, (fibres,)"
    nodes: Int32s
    "of each fibre, (fibres,)"
    side: Float32s
    "unit vector across each fibre's root at rest, from which its frame starts, (fibres, 3)"


def fibres_of(garden: Garden) -> Fibres:
    """Return the fibres of a garden that stands at rest: blades are as wide as level as they can be."""
    first, lane = garden.first_row, garden.lane
    above = np.minimum(garden.nodes - 1, 1)
    along = (
        garden.position[first + above, :, lane].astype(np.float64) - garden.position[first, :, lane]
    )
    number = np.arange(garden.fibres)
    # Upright ones have no level side of their own: each gets another, the same at every start.
    turn = 2.399963 * number
    wanted = np.stack((-along[:, 1], along[:, 0], np.zeros(len(number))), axis=1)
    size = np.linalg.norm(along, axis=1, keepdims=True)
    wanted += 0.35 * size * np.stack((np.cos(turn), np.sin(turn), 0.0 * turn), axis=1)
    side = _across(wanted, along / np.maximum(size, _LEAST))
    return Fibres(garden.position, garden.radius, first, lane, garden.nodes, side)


def _across(wanted: Float64s, along: Float64s) -> Float32s:
    """Return the part of `wanted` across the unit `along`, as unit vectors, (n, 3)."""
    side = wanted - (wanted * along).sum(axis=1, keepdims=True) * along
    size = np.linalg.norm(side, axis=1, keepdims=True)
    other = np.cross(along, np.where(np.abs(along[:, :1]) < 0.6, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
    side = np.where(size > 1e-6, side, other)
    size = np.linalg.norm(side, axis=1, keepdims=True)
    return np.asarray(side / np.maximum(size, _LEAST), np.float32)


@row
def _spline(position: Float32s, first: int, lane: int, nodes: int, at: float, out: Float64s) -> int:
    """Write the point [m] and derivative at node number `at` of a fibre, by Catmull and Rom; return the node below."""
    i = min(int(at), nodes - 2)
    u = at - i
    for c in range(3):
        b, d = float(position[first + i, c, lane]), float(position[first + i + 1, c, lane])
        a = float(position[first + i - 1, c, lane]) if i > 0 else 2.0 * b - d
        e = float(position[first + i + 2, c, lane]) if i + 2 < nodes else 2.0 * d - b
        p, q, r = 0.5 * (d - a), a - 2.5 * b + 2.0 * d - 0.5 * e, 1.5 * (b - d) + 0.5 * (e - a)
        out[c] = b + u * (p + u * (q + u * r))
        out[3 + c] = p + u * (2.0 * q + u * 3.0 * r)
    return i


@row
def _carry(frame: Float64s) -> None:
    """Turn the side, frame[9:12], as little as brings the old direction, [6:9], to the new one, [3:6]; make it unit."""
    size = sqrt(frame[3] * frame[3] + frame[4] * frame[4] + frame[5] * frame[5] + _LEAST)
    whole, down = 1.0, 0.0
    for c in range(3):
        frame[3 + c] /= size
        whole += frame[3 + c] * frame[6 + c]
        down += frame[3 + c] * frame[9 + c]
    down /= max(whole, 1e-3)
    for c in range(3):
        frame[9 + c] -= down * (frame[3 + c] + frame[6 + c])
    # Rounding, and sharp corners, must not add up.
    along, square = 0.0, _LEAST
    for c in range(3):
        along += frame[9 + c] * frame[3 + c]
    for c in range(3):
        frame[9 + c] -= along * frame[3 + c]
        square += frame[9 + c] * frame[9 + c]
        frame[6 + c] = frame[3 + c]
    for c in range(3):
        frame[9 + c] /= sqrt(square)


@row
def write_strip(fibres: Fibres, fibre: int, rings: int, frame: Float64s, out: Float32s) -> None:
    """Write the rings of a fibre of two nodes or more, root first, to out, (rings, RING); `frame` is scratch, (12,)."""
    first, lane, nodes = fibres.first_row[fibre], fibres.lane[fibre], fibres.nodes[fibre]
    way = 0.0
    for k in range(rings):
        at = k * (nodes - 1.0) / (rings - 1.0)
        i = _spline(fibres.position, first, lane, nodes, at, frame)
        if k == 0:
            for c in range(3):
                frame[6 + c] = frame[3 + c]
                frame[9 + c] = fibres.side[fibre, c]
            size = sqrt(frame[6] * frame[6] + frame[7] * frame[7] + frame[8] * frame[8] + _LEAST)
            for c in range(3):
                frame[6 + c] /= size
        _carry(frame)
        low, high = float(fibres.radius[first + i, lane]), float(fibres.radius[first + i + 1, lane])
        radius = low + (at - i) * (high - low)
        ring = out[k]
        if k > 0:
            square = 0.0
            for c in range(3):
                step = frame[c] - float(out[k - 1, c])
                square += step * step
            step = sqrt(square)
            way += step
            ring[11] = (radius - float(out[k - 1, 3])) / max(step, 1e-6)
        for c in range(3):
            ring[c], ring[4 + c], ring[8 + c] = frame[c], frame[9 + c], frame[3 + c]
        ring[3], ring[7] = radius, way
    out[0, 11] = out[1, 11]


@row
def write_strips(
    fibres: Fibres, chosen: Int32s, rings: Int32s, starts: Int32s, frame: Float64s, out: Float32s
) -> None:
    """Write the rings of the chosen fibres, (m,): each `rings` of them from row `starts` of out, (all, RING), on."""
    for m in range(len(chosen)):
        begin = starts[m]
        write_strip(fibres, chosen[m], rings[m], frame, out[begin : begin + rings[m]])
