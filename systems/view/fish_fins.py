"""Fins: caudal from the tail's nodes, dorsal and anal on back and belly, paired fins that scull (papers/000, 7.2).

Median fins are linear outwards and cubic along the body: 2 x 12 control points. Paired fins are blades on a hinge: the
place of a vertex is weight + cos(angle) along_u + sin(angle) along_v, so d/d(angle) is the blade's normal.
"""

from dataclasses import dataclass
from typing import Final, TypeAlias

import numpy as np

from components.arrays import Float64s
from components.body import Body, Fin
from systems.view.bspline import basis
from systems.view.fish_lattice import Lattice
from systems.view.fish_surface import HELD, MEMBRANE, PECTORAL, PELVIC, Patch, grid, into_box

CAUDAL_BOX: Final = (0.006, 0.506, 0.494, 0.994)
DORSAL_BOX: Final = (0.506, 0.506, 0.994, 0.66)
ANAL_BOX: Final = (0.506, 0.67, 0.994, 0.824)
PECTORAL_BOX: Final = (0.506, 0.834, 0.744, 0.994)
PELVIC_BOX: Final = (0.756, 0.834, 0.994, 0.994)
"""Where the fins lie in a skin's layer; x runs from root or front to tip or rear, y from upper or outer to lower."""
CONTROL: Final = 12
"""Control points along a median fin (papers/000, 7.2)."""
Blade: TypeAlias = tuple[float, float, float, float]
"""A paired fin: x [BL] and h of its root, length [BL], droop [rad]."""
_SUNK: Final = 0.9
_DEEPEST_FORK: Final = 0.72
_NO_FIN: Final = Fin(0.5, 0.501, 0.0, 0.0)


@dataclass(frozen=True)
class Detail:
    """How many vertices the fins have."""

    caudal: tuple[int, int]
    "from root to edge and across"
    median: int
    "along dorsal and anal fins"
    paired: tuple[int, int]
    "from root to tip and across; 0 draws none"


CLOSE: Final = Detail((8, 13), 23, (5, 4))
FAR: Final = Detail((4, 7), 12, (3, 2))
CARD: Final = Detail((2, 3), 4, (0, 0))


def fins_of(lattice: Lattice, detail: Detail) -> list[Patch]:
    """Return all fins of one species: caudal, dorsal, anal, then pairs of pectoral and pelvic fins."""
    body = lattice.body
    fins = [
        caudal(lattice, *detail.caudal),
        median(lattice, body.dorsal, 1.0, detail.median, DORSAL_BOX),
        median(lattice, body.anal, -1.0, detail.median, ANAL_BOX),
    ]
    if detail.paired[0]:
        kinds = (HELD, HELD) if body.pectoral_held else (PECTORAL, PELVIC)
        for side in (1.0, -1.0):
            for kind, blade, box in zip(
                kinds, _blades(body), (PECTORAL_BOX, PELVIC_BOX), strict=True
            ):
                fins.append(paired(lattice, kind, blade, side, detail.paired, box))
    return fins


def _blades(body: Body) -> tuple[Blade, Blade]:
    """Return where pectoral and pelvic fins are rooted, their lengths and droops; held out they hang from the side."""
    at, length = body.pectoral_at, body.pectoral_length
    behind = min(at + 0.08, 0.45) if body.pelvic_at is None else body.pelvic_at
    short = 0.65 * length if body.pelvic_length is None else body.pelvic_length
    droops = (1.45, 1.45) if body.pectoral_held else (0.5, 1.1)
    return (at, body.pectoral_height, length, droops[0]), (behind, -0.9, short, droops[1])


def caudal(lattice: Lattice, outward: int, across: int) -> Patch:
    """Return the caudal fin: lobes that fan out from the body's end, forked or rounded by `Body.tail_fork`."""
    body, outline = lattice.body, lattice.outline
    root = outline.end - 0.03
    root_half = 0.95 * float(outline.half_height(np.array([root]))[0])
    r, q = np.linspace(0, 1, outward)[:, None], np.linspace(-1, 1, across)[None, :]
    fork = min(body.tail_fork, _DEEPEST_FORK * (1.0 - root))
    inward = 1.0 - q * q
    drawn_in = inward ** (1.4 - 0.9 * body.tail_slender) if fork > 0.0 else inward**0.7 - 1.0
    lobe = np.where(q > 0.0, body.tail_upper, body.tail_lower)
    short = 1.0 - (1.0 - body.tail_lower) * np.clip(-q, 0.0, 1.0)
    x = root + (1.0 - fork * drawn_in - root) * short * r
    spread = r**1.15 * (1.0 - 0.12 * r * (1.0 - np.abs(q)))
    y = q * (root_half + (lobe * body.tail_span - root_half) * spread)
    points = np.stack((-x, y, np.zeros_like(x)), axis=-1)
    place = np.stack(np.broadcast_arrays(r, 0.5 - 0.5 * q), axis=-1)
    return _membrane(lattice, points, place, CAUDAL_BOX)


def median(
    lattice: Lattice,
    fin: Fin | None,
    side: float,
    count: int,
    box: tuple[float, float, float, float],
) -> Patch:
    """Return a fin on the back (side 1) or the belly (-1); a species without one gets an empty sliver."""
    drawn = fin or _NO_FIN
    outline = lattice.outline
    q = np.linspace(0, 1, CONTROL)
    rear = min(drawn.end, outline.end)
    x = drawn.start + (rear - drawn.start) * q
    rise, lean = _swept(drawn, q)
    foot = outline.middle(x) + side * _SUNK * outline.half_height(x)
    tip = outline.middle(x) + side * (outline.half_height(x) + drawn.height * rise)
    control = np.stack(
        (np.stack((-x, -(x + lean))), np.stack((foot, tip)), np.zeros((2, CONTROL))), axis=-1
    )
    at = np.linspace(0, 1, count)
    points = np.einsum("kj,ujc->kuc", basis(at, CONTROL), control)
    place = np.stack(np.broadcast_arrays(at[:, None], np.array([[1.0, 0.0]])), axis=-1)
    return _membrane(lattice, points, place, box)


def _swept(fin: Fin, q: Float64s) -> tuple[Float64s, Float64s]:
    """Return rise and lean of a fin's outer edge; a fin with a profile is cut out of a whole strip by its opacity."""
    if fin.profile:
        return np.ones_like(q), np.full_like(q, fin.lean)
    rise = np.minimum(1.0, (q / 0.3) ** 0.75) * (1.0 - 0.55 * np.clip((q - 0.3) / 0.7, 0, 1) ** 1.3)
    return rise, fin.lean * (0.4 + 0.6 * q) * (fin.height > 0.0)


def paired(
    lattice: Lattice,
    kind: int,
    blade: Blade,
    side: float,
    counts: tuple[int, int],
    box: tuple[float, float, float, float],
) -> Patch:
    """Return a blade hinged at (x [BL], h), of a length [BL] and a droop [rad], on one side (1 right, -1 left)."""
    at, height, length, droop = blade
    outline = lattice.outline
    around = np.arccos(np.clip(height, -1.0, 1.0)) / np.pi
    root = outline.section(np.array(at), np.array(around)) * (1.0, 1.0, 0.98)
    r, q = np.linspace(0.04, 1, counts[0])[:, None], np.linspace(-1, 1, counts[1])[None, :]
    back = np.array([-np.cos(droop), -np.sin(droop), 0.0])
    hinge = np.array([-back[1], back[0], 0.0]) * -1.0
    half = length * ((0.25 - 0.19 * r) if kind == HELD else (0.07 + 0.31 * r**0.8))
    swept = r * (1.0 - 0.16 * q * (kind != HELD)) * length
    behind = 0.45 * length * r**1.3 if kind == HELD else 0.0
    base = root + (half * q + behind)[..., None] * hinge
    flat = np.broadcast_to(root, (base.size // 3, 3)) * (1.0, 1.0, side)
    steps = swept.reshape(-1, 1)
    weight = lattice.bind(base.reshape(-1, 3) * (1.0, 1.0, side))
    along = steps * lattice.bind_steps(flat, np.broadcast_to(back, flat.shape))
    out = steps * lattice.bind_steps(flat, np.broadcast_to(np.array([0.0, 0.0, side]), flat.shape))
    place = np.stack(np.broadcast_arrays(r, 0.5 - 0.5 * q), axis=-1).reshape(-1, 2)
    return Patch(weight, along, out, into_box(place, box), kind, grid(*counts))


def _membrane(
    lattice: Lattice,
    points: Float64s,
    place: Float64s,
    box: tuple[float, float, float, float],
) -> Patch:
    rows, columns = points.shape[:2]
    flat = points.reshape(-1, 3)
    upwards = np.broadcast_to(np.array([0.0, 1.0, 0.0]), flat.shape)
    backwards = np.broadcast_to(np.array([-1.0, 0.0, 0.0]), flat.shape)
    return Patch(
        lattice.bind(flat),
        lattice.bind_steps(flat, upwards),
        lattice.bind_steps(flat, backwards),
        into_box(place.reshape(-1, 2), box),
        MEMBRANE,
        grid(rows, columns),
    )
