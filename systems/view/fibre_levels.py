"""How finely each tuft of fibres is drawn: by frustum, haze and size on the picture, within a number of triangles
(papers/000, 7.1 and 7.3 for fibres; papers/002, 5).

Nothing here needs OpenGL. The view alone reads it.
"""

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s, Int32s, Int64s
from systems.view.cull import HIDDEN, View

ROUND: Final = 0
"""Shape of what is a tube: tentacles, branches."""
FLAT: Final = 1
"""... a blade: seagrass, fronds."""
WIDE: Final = 2
"""... a column: feet."""
LEVELS: Final = 6
"""Levels of detail of each shape: the last is the coarsest."""

TRIANGLES: Final = 60_000
"""Most triangles of fibres on a picture."""

PIXELS: Final = (18.0, 9.0, 4.5, 2.2, 0.9)
"""[px] of thickness, of a blade's width, above which each level but the last is drawn."""
WIDE_PIXELS: Final = (120.0, 60.0, 24.0, 9.0, 3.0)
"""[px] of a column's thickness likewise."""
STEP_PIXELS: Final = (8.0, 8.0, 9.0, 12.0, 16.0, 24.0)
"""[px] between rings at each level: the fewer rings, the coarser."""

SIDES: Final = ((8, 6, 4, 3, 2, 2), (4, 4, 2, 2, 2, 2), (24, 16, 10, 7, 5, 3))
"""Corners around a ring, by shape and level; of tubes two, and of blades all, make a ribbon."""
CAPS: Final = ((2, 1, 1, 0, 0, 0), (0,) * LEVELS, (0,) * LEVELS)
"""Rings that round the tip, by shape and level; the last is a point."""
MOST_RINGS: Final = 33
"""Of one fibre."""
_LEAST_RINGS: Final = (4, 4, 4, 3, 3, 2)
_PARTS: Final = (1.0, 1.0, 1.0, 1.0, 0.6, 0.3)
"""Part of a tuft's fibres that are drawn at each level, wider for those that are not."""
_COARSEST: Final = 1e-4
"""Fineness below which even a plant that holds the eye is at its coarsest."""
_COARSER: Final = 0.85


class Tufts(NamedTuple):
    """What choosing reads of each tuft, n of them."""

    sphere: Float64s
    "centre and radius [m] of what the tuft never leaves, (n, 4)"
    shape: Int64s
    "ROUND, FLAT or WIDE, (n,)"
    thickness: Float64s
    "[m] diameter or width of a fibre, (n,)"
    length: Float64s
    "[m] of a fibre, (n,)"
    nodes: Int64s
    "of a fibre, (n,)"
    fibres: Int64s
    "(n,)"
    plant: Int64s
    "which plant it is part of, (n,)"


class Choice(NamedTuple):
    """What is drawn, and how."""

    tuft: Int64s
    "tufts that are drawn, (m,)"
    level: Int64s
    "of detail, (m,)"
    rings: Int64s
    "of each fibre, (m,)"
    fibres: Int64s
    "how many of its fibres are drawn: the first, (m,)"

    def triangles(self, tufts: Tufts) -> int:
        """Return how many triangles all this is."""
        each = triangles_of(tufts.shape[self.tuft], self.level, self.rings)
        return int((each * self.fibres).sum())


def triangles_of(shape: Int64s, level: Int64s, rings: Int64s) -> Int64s:
    """Return the triangles of one fibre of each shape at each level with so many rings."""
    sides = np.asarray(SIDES)[shape, level]
    caps = np.asarray(CAPS)[shape, level]
    closed = sides > 2
    closed &= shape != FLAT
    bands = np.where(closed, sides, sides - 1)
    # The last ring of a cap is a point: half the triangles.
    return np.asarray(2 * bands * (rings - 1 + caps) - np.where(caps > 0, bands, 0))


def tufts_seen(tufts: Tufts, view: View) -> NDArray[np.bool_]:
    """Return which tufts touch the frustum and are not hidden by water, (n,); some that miss it pass."""
    away = tufts.sphere[:, :3] - view.eye
    radius = tufts.sphere[:, 3]
    across, above, ahead = (away @ axis for axis in view.axes)
    depth = np.maximum(ahead, 0.0)
    seen = (ahead > -radius) & (np.linalg.norm(away, axis=1) < view.reach + radius)
    seen &= np.abs(across) <= depth * view.slope_x + radius * view.edge_x
    seen &= np.abs(above) <= depth * view.slope_y + radius * view.edge_y
    return np.asarray(seen)


def plants_seen(tufts: Tufts, seen: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return all tufts of the plants of which any is seen, (n,): what carries a tuft must bend with it."""
    whole = np.zeros(int(tufts.plant.max(initial=-1)) + 1, np.bool_)
    whole[tufts.plant[seen]] = True
    return np.asarray(whole[tufts.plant])


def choose_levels(tufts: Tufts, view: View, most: int = TRIANGLES) -> Choice:
    """Return what is drawn of the tufts: as fine as sizes on the picture ask for, coarser all round above `most`."""
    rows = np.flatnonzero(tufts_seen(tufts, view) & (tufts.nodes > 1) & (tufts.fibres > 0))
    far = np.linalg.norm(tufts.sphere[rows, :3] - view.eye, axis=1)
    far = np.maximum(far - 0.5 * tufts.sphere[rows, 3], 0.25)
    # What the water veils shows no corners.
    clear = 1.0 - 0.5 * np.minimum(far * HIDDEN / view.reach, 1.0)
    fineness = 1.0
    while True:
        choice = _choice(tufts, rows, fineness * clear * view.pixels / far)
        if choice.triangles(tufts) <= most or fineness < _COARSEST:
            return choice
        fineness *= _COARSER


def _choice(tufts: Tufts, rows: Int64s, pixels: Float64s) -> Choice:
    """Return the choice for the tufts `rows` where a metre is so many `pixels`."""
    shape = tufts.shape[rows]
    bounds = np.asarray((PIXELS, PIXELS, WIDE_PIXELS))[shape]
    level = (tufts.thickness[rows, None] * pixels[:, None] < bounds).sum(axis=1)
    wanted = tufts.length[rows] * pixels / np.asarray(STEP_PIXELS)[level] + 1.0
    least = np.asarray(_LEAST_RINGS)[level]
    # Between nodes a fibre is smooth: twice as many rings as nodes show all there is to see.
    most = np.clip(2 * tufts.nodes[rows] - 1, least, MOST_RINGS)
    rings = np.clip(np.ceil(wanted), least, most).astype(np.int64)
    parts = np.asarray(_PARTS)[level]
    fibres = np.ceil(parts * tufts.fibres[rows]).astype(np.int64)
    return Choice(rows, level, rings, fibres)


def widening(level: Int64s) -> Int32s | Float64s:
    """Return by how much fibres of each level are drawn wider for those that are left out."""
    return np.asarray(1.0 / np.asarray(_PARTS)[level])
