"""The skin of a fish as linear combinations of its nodes (papers/000, 7.2; FINDINGS 8).

The body is two juxtaposed bicubic B-spline surfaces of 9 x 21 control points, one a side. Bases are evaluated once,
here; the GPU only sums nodes.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s, Int64s
from components.body import NODES, rest_nodes
from systems.view.bspline import basis, greville, slope
from systems.view.fish_lattice import ROWS, Lattice
from systems.view.fish_outline import Outline

AROUND: Final = 9
"""Control points around a side, from back to belly (papers/000, 7.2)."""
BODY, MEMBRANE, PECTORAL, PELVIC, HELD = range(5)
"""Kinds of vertices: what the shader does with a vertex' second and third row of weights."""
BODY_BOX: Final = (0.004, 0.004, 0.996, 0.484)
"""Where the body lies in a skin's layer: left, top, right, bottom, each 0 to 1; s runs right, back to belly down."""
_POLE: Final = 0.012
_FITS: Final = 6


@dataclass(frozen=True)
class Patch:
    """Vertices that share a grid of triangles. n vertices, t triangles."""

    weight: Float64s
    "of the nodes in the place, (n, 23)"
    along_u: Float64s
    "of the nodes in the derivative along u; in kinematic fins the part that follows the cosine, (n, 23)"
    along_v: Float64s
    "of the nodes in the derivative along v; in kinematic fins the part that follows the sine, (n, 23)"
    texture: Float64s
    "place in the skin's layer, 0 to 1, (n, 2)"
    kind: int
    "one of BODY, MEMBRANE, PECTORAL, PELVIC, HELD"
    triangles: Int64s
    "anticlockwise seen from outside, (t, 3)"


def grid(rows: int, columns: int, flip: bool = False) -> Int64s:
    """Return the triangles of a grid of vertices numbered row by row, (2 (rows-1)(columns-1), 3)."""
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)[None, :]).ravel()
    quads = [(0, 1, columns), (1, columns + 1, columns)]
    triangles = np.concatenate([corner[:, None] + np.array(q) for q in quads])
    return triangles[:, ::-1].copy() if flip else triangles


def control_points(outline: Outline, row: Float64s) -> Float64s:
    """Return the right side's control points (21, 9, 3) [BL], fitted so that the surface follows the outline."""
    along, around = greville(ROWS), greville(AROUND)
    nv, nu = basis(along, ROWS), basis(around, AROUND)
    target = outline.section((nv @ row)[:, None], around[None, :])[..., 1:]
    points = outline.section(row[:, None], around[None, :])
    for _ in range(_FITS):
        points[..., 1:] += target - np.einsum("mj,jic,ki->mkc", nv, points[..., 1:], nu)
        points[0, :, 1:] = (outline.middle(np.zeros(1))[0], 0.0)
        points[-1, :, 2] = 0.0
        points[:, (0, -1), 2] = 0.0
        points[:, 1, 1], points[:, -2, 1] = points[:, 0, 1], points[:, -1, 1]
    return points


def body_side(lattice: Lattice, along: Float64s, around: Float64s, side: int) -> Patch:
    """Return the surface of one side (1 right, -1 left) at the parameters given, rows along, columns around."""
    points = control_points(lattice.outline, lattice.row)
    v = np.clip(along, _POLE, 1.0)
    nu, du = basis(around, AROUND), slope(around, AROUND)
    weight = _surface(lattice, points, basis(along, ROWS), nu, side)
    along_u = _surface(lattice, points, basis(v, ROWS), du, side, constant=False)
    along_v = _surface(lattice, points, slope(v, ROWS), nu, side)
    rest = rest_nodes(lattice.body)
    s = (basis(along, ROWS) @ lattice.row) / lattice.outline.end
    texture = np.stack(np.broadcast_arrays(s[:, None], around[None, :]), -1).reshape(-1, 2)
    return Patch(
        weight,
        _unit(along_u, rest) * -side,
        _unit(along_v, rest),
        into_box(texture, BODY_BOX),
        BODY,
        grid(len(along), len(around), flip=side > 0),
    )


def into_box(places: Float64s, box: tuple[float, float, float, float]) -> Float64s:
    """Return places in the unit square, (n, 2), moved into a box (left, top, right, bottom) of the layer."""
    low, high = np.array(box[:2]), np.array(box[2:])
    moved: Float64s = low + places * (high - low)
    return moved


def _surface(
    lattice: Lattice,
    points: Float64s,
    nv: Float64s,
    nu: Float64s,
    side: int,
    constant: bool = True,
) -> Float64s:
    centre = np.repeat((nv @ lattice.centre)[:, None, :], len(nu), axis=1) * float(constant)
    up = np.einsum("mj,jk,jn->mkn", nv, points[..., 1] @ nu.T, lattice.up)
    right = np.einsum("mj,jk,jn->mkn", nv, points[..., 2] @ nu.T, lattice.right)
    summed: Float64s = (centre + up + side * right).reshape(-1, NODES)
    return summed


def _unit(steps: Float64s, rest: Float64s) -> Float64s:
    """Scale weights of a derivative so that it has length 1 in the straight body."""
    size = np.sqrt(((steps @ rest) ** 2).sum(axis=1))[:, None]
    scaled: Float64s = steps / np.maximum(size, 1e-9)
    return scaled
