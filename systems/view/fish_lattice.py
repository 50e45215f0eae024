"""How points around a fish follow its nodes: every point a fixed linear combination (papers/000, eq. 13; FINDINGS 8).

Control rows lie on the rings and between them. A row's centre, up and right are linear in the nodes of the two rings
beside it, so a cubic B-spline over four consecutive rows follows at most three rings: 12 consecutive nodes. The nose
has no section of its own and borrows the first ring's; behind the last ring the caudal fin's tips take over.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.body import NODE_HEIGHT, NODES, Body
from systems.view.bspline import basis, slope
from systems.view.fish_outline import Outline, outline_of

ROWS: Final = 21
"""Control points along the body (papers/000, 7.2)."""
_GAPS: Final = (5, 4, 3, 3, 3, 2)
_NOSE: Final = (0.0, 0.0, 0.1, 0.3, 0.62)
_FINE: Final = 2001
_POLE: Final = 0.012


@dataclass(frozen=True)
class Lattice:
    """The control rows of one species; made by `lattice_of`."""

    body: Body
    outline: Outline
    row: Float64s
    "x [BL] of each control row, from the nose backwards, (21,)"
    centre: Float64s
    "weights of the nodes in a row's centre, (21, 23)"
    up: Float64s
    "weights of the nodes in a step of 1 BL upwards, (21, 23)"
    right: Float64s
    "weights of the nodes in a step of 1 BL to the right, (21, 23)"
    reached: Float64s
    "x [BL] that the rows reach at evenly spaced parameters from 0 to 1, (2001,)"

    def bind(self, points: Float64s) -> Float64s:
        """Return the weights (n, 23) with which points (n, 3) of the straight body [BL] follow the nodes."""
        x, y, z = -points[:, 0], points[:, 1:2], points[:, 2:3]
        table = basis(self._parameter(x), ROWS)
        bound = table @ self.centre + y * (table @ self.up) + z * (table @ self.right)
        behind = x > self.outline.end
        if behind.any():
            centre, up, right = frames(self.body, x[behind])
            bound[behind] = centre + y[behind] * up + z[behind] * right
        return bound

    def bind_steps(self, points: Float64s, steps: Float64s) -> Float64s:
        """Return the weights (n, 23), summing to 0, of steps (n, 3) [BL] from `points` in the bent body's axes."""
        x, y, z = -points[:, 0], points[:, 1:2], points[:, 2:3]
        at = self._parameter(x)
        table, rate = basis(at, ROWS), slope(np.maximum(at, _POLE), ROWS)
        rate /= (rate @ self.row)[:, None]
        bound = steps[:, 1:2] * (table @ self.up) + steps[:, 2:3] * (table @ self.right)
        back = rate @ self.centre + y * (rate @ self.up) + z * (rate @ self.right)
        behind = x > self.outline.end
        if behind.any():
            _, up, right = frames(self.body, x[behind])
            bound[behind] = steps[behind, 1:2] * up + steps[behind, 2:3] * right
            ends = zip(
                frames(self.body, np.array([1.0])), frames(self.body, self.row[-1:]), strict=True
            )
            centre, up, right = ((a - b) / (1.0 - self.row[-1]) for a, b in ends)
            back[behind] = centre + y[behind] * up + z[behind] * right
        result: Float64s = bound - steps[:, :1] * back
        return result

    def _parameter(self, x: Float64s) -> Float64s:
        at: Float64s = np.interp(x, self.reached, np.linspace(0.0, 1.0, _FINE))
        return at


def lattice_of(body: Body) -> Lattice:
    """Return the control rows of `body`: five gaps from nose to first ring, then 4, 3, 3, 3 and 2."""
    outline = outline_of(body)
    edges = (0.0, *body.station, outline.end)
    rows = [edges[0] + share * edges[1] for share in _NOSE]
    for start, end, gaps in zip(edges[1:-1], edges[2:], _GAPS[1:], strict=True):
        rows += [start + (end - start) * k / gaps for k in range(gaps)]
    row = np.array([*rows, outline.end])
    reached = basis(np.linspace(0.0, 1.0, _FINE), ROWS) @ row
    return Lattice(body, outline, row, *frames(body, row), reached)


def frames(body: Body, x: Float64s) -> tuple[Float64s, Float64s, Float64s]:
    """Return the weights of centre, up and right at x [BL], each (n, 23), piecewise linear between the rings."""
    edges = np.array([0.0, *body.station, 1.0])
    centres, ups, rights = _anchors(body)
    i = np.clip(np.searchsorted(edges, x, side="right") - 1, 0, len(edges) - 2)
    t = ((x - edges[i]) / (edges[i + 1] - edges[i]))[:, None]
    return tuple((1 - t) * a[i] + t * a[i + 1] for a in (centres, ups, rights))


def _anchors(body: Body) -> tuple[Float64s, Float64s, Float64s]:
    """Return centre, up and right of nose, rings and tail as weights of the nodes, each (7, 23)."""
    centre, up, right = (np.zeros((7, NODES)) for _ in range(3))
    for ring in range(5):
        first = 1 + 4 * ring
        centre[ring + 1, first : first + 4] = 0.25
        half = 4.0 * NODE_HEIGHT * body.half_height[ring]
        up[ring + 1, first : first + 4] = np.array([1, 1, -1, -1]) / half
        right[ring + 1, first : first + 4] = np.array([-1, 1, 1, -1]) / (
            4.0 * body.half_width[ring]
        )
    centre[0, 0], up[0], right[0] = 1.0, up[1], right[1]
    centre[6, 21:23], right[6] = 0.5, right[5]
    up[6, 21:23] = np.array([0.5, -0.5]) / body.tail_span
    return centre, up, right
