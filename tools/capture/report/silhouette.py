"""The fish as figures draw it: lines on its B-spline skin, each a fixed linear combination of the nodes."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.body import Body, Fin
from systems.view.fish_fins import caudal
from systems.view.fish_lattice import Lattice, lattice_of

STATIONS: Final = 41
"""Points of the centre line from nose to tail."""
_ALONG: Final = 26
_RIBS: Final = 12
_AROUND: Final = 13


@dataclass(frozen=True)
class Silhouette:
    """Weights of the 23 nodes in the points of each line; a line's places are weights @ nodes."""

    above: Float64s
    "the body's edge from above, closed, (n, 23)"
    beside: Float64s
    "the body's edge from the side, closed, (n, 23)"
    ribs_above: Float64s
    "rows of control points from left to right, (r, 2, 23)"
    ribs_beside: Float64s
    "rows of control points from back to belly, (r, 2, 23)"
    middle: Float64s
    "the centre line at even steps from nose to tail, (41, 23)"
    tail_above: Float64s
    "the caudal fin's ridge, (n, 23)"
    tail_beside: Float64s
    "the caudal fin's edge, closed, (n, 23)"
    fins_above: tuple[Float64s, Float64s]
    "the pectoral fins, held, closed, each (n, 23)"
    fins_beside: tuple[Float64s, ...]
    "dorsal and anal fin, closed, each (n, 23)"


def silhouette_of(body: Body) -> Silhouette:
    """Return the lines of a body's figure."""
    lattice = lattice_of(body)
    outline = lattice.outline
    x = outline.end * np.linspace(0.0, 1.0, _ALONG) ** 1.5
    ribs = outline.end * np.linspace(0.06, 0.97, _RIBS)
    width, height, middle = outline.half_width, outline.half_height, outline.middle
    axis = np.linspace(0.0, 1.0, STATIONS)
    root = np.linspace(outline.end - 0.02, 1.0, 7)
    edge = caudal(lattice, 6, _AROUND).weight.reshape(6, _AROUND, -1)
    around = np.concatenate((edge[:, 0], edge[-1, 1:], edge[-2::-1, -1]))
    return Silhouette(
        above=_closed(lattice, x, middle(x), middle(x), -width(x), width(x)),
        beside=_closed(lattice, x, middle(x) + height(x), middle(x) - height(x)),
        ribs_above=_pairs(lattice, ribs, middle(ribs), middle(ribs), -width(ribs), width(ribs)),
        ribs_beside=_pairs(lattice, ribs, middle(ribs) + height(ribs), middle(ribs) - height(ribs)),
        middle=lattice.bind(_points(axis)),
        tail_above=lattice.bind(_points(root)),
        tail_beside=around,
        fins_above=(_leaf(lattice, -1.0), _leaf(lattice, 1.0)),
        fins_beside=tuple(
            _median(lattice, fin, side)
            for fin, side in ((body.dorsal, 1.0), (body.anal, -1.0))
            if fin is not None
        ),
    )


def _points(x: Float64s, y: Float64s | float = 0.0, z: Float64s | float = 0.0) -> Float64s:
    return np.stack(np.broadcast_arrays(-x, y, z), axis=-1)


def _closed(
    lattice: Lattice,
    x: Float64s,
    y: Float64s,
    other_y: Float64s,
    z: Float64s | float = 0.0,
    other_z: Float64s | float = 0.0,
) -> Float64s:
    """Return the line from the nose back along one side and forwards along the other."""
    there, back = _points(x, y, z), _points(x, other_y, other_z)[::-1]
    return lattice.bind(np.concatenate((there, back)))


def _pairs(
    lattice: Lattice,
    x: Float64s,
    y: Float64s,
    other_y: Float64s,
    z: Float64s | float = 0.0,
    other_z: Float64s | float = 0.0,
) -> Float64s:
    both = np.stack((_points(x, y, z), _points(x, other_y, other_z)), axis=1)
    return lattice.bind(both.reshape(-1, 3)).reshape(len(x), 2, -1)


def _leaf(lattice: Lattice, side: float) -> Float64s:
    """Return a pectoral fin, laid back and out, as a pointed leaf."""
    body, outline = lattice.body, lattice.outline
    q = np.linspace(0.0, np.pi, 9)
    long = body.pectoral_length
    along, across = 0.5 - 0.5 * np.cos(q), 0.16 * np.sin(q)
    back, out = (0.86, 0.51) if not body.pectoral_held else (0.55, 0.84)
    edges = []
    for sign in (1.0, -1.0):
        x = body.pectoral_at + long * (along * back - sign * across * out)
        foot = 0.9 * float(outline.half_width(np.array([body.pectoral_at]))[0])
        z = foot + long * (along * out + sign * across * back)
        edges.append(_points(x, body.pectoral_height * 0.1, side * z))
    return lattice.bind(np.concatenate((edges[0], edges[1][::-1])))


def _median(lattice: Lattice, fin: Fin, side: float) -> Float64s:
    outline = lattice.outline
    q = np.linspace(0.0, 1.0, 11)
    x = fin.start + (min(fin.end, outline.end) - fin.start) * q
    if fin.profile:
        rise = np.interp(q, np.linspace(0.0, 1.0, len(fin.profile)), fin.profile)
        lean = fin.lean * rise
    else:
        rise = np.minimum(1.0, (q / 0.3) ** 0.75) * (1.0 - 0.55 * np.clip((q - 0.3) / 0.7, 0, 1))
        lean = fin.lean * (0.4 + 0.6 * q)
    foot = outline.middle(x) + side * 0.9 * outline.half_height(x)
    tip = outline.middle(x) + side * (outline.half_height(x) + fin.height * rise)
    edge = np.concatenate((_points(x, foot), _points(x + lean, tip)[::-1]))
    return lattice.bind(edge)
