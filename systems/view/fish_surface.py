"""The skin of a fish as linear combinations of its nodes, at three levels of detail (papers/000, 7.2, 7.3; FINDINGS 8).

The body is two juxtaposed bicubic B-spline surfaces of 9 x 21 control points, one a side. Close, it is tessellated;
far, it is the grid of the control points' places on the surface itself (their Greville points), so that nothing jumps
between levels; farther still, a card of a few triangles. Bases are evaluated once, here; the GPU only sums nodes.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float32s, Float64s, Int64s
from components.body import NODES, Body, rest_nodes
from systems.view.bspline import basis, greville, slope
from systems.view.fish_lattice import ROWS, Lattice, lattice_of
from systems.view.fish_outline import Outline

AROUND: Final = 9
"""Control points around a side, from back to belly (papers/000, 7.2)."""
WINDOW: Final = 12
"""Consecutive nodes that a vertex may follow."""
COUNT_STEP: Final = 32
"""A vertex' first texel holds its first node plus this times the count of its nodes."""
BODY, MEMBRANE, PECTORAL, PELVIC = range(4)
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
    "one of BODY, MEMBRANE, PECTORAL, PELVIC"
    triangles: Int64s
    "anticlockwise seen from outside, (t, 3)"


@dataclass(frozen=True)
class Level:
    """One level of detail: all its vertices, the body's triangles and the fins'."""

    table: Float32s
    "texels (weight, d/du, d/dv, extra); extra is first node and count, texture x, y, kind, 0 ..., (n, 12, 4)"
    body: NDArray[np.uint32]
    "(t, 3)"
    fins: NDArray[np.uint32]
    "(t, 3)"


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


def pack(patches: list[Patch]) -> Float32s:
    """Return the vertices of all patches as texels, (n, 12, 4) float32."""
    weight = np.concatenate([p.weight for p in patches])
    rows = np.stack(
        (
            weight,
            np.concatenate([p.along_u for p in patches]),
            np.concatenate([p.along_v for p in patches]),
        ),
        axis=-1,
    )
    used = np.abs(rows).max(axis=-1) > 1e-9
    first = np.minimum(used.argmax(axis=1), NODES - WINDOW)
    beyond = NODES - 1 - used[:, ::-1].argmax(axis=1) - first
    if (beyond >= WINDOW).any():
        raise ValueError(f"a vertex follows {int(beyond.max()) + 1} nodes, at most {WINDOW}")
    table = np.zeros((len(weight), WINDOW, 4), np.float32)
    window = first[:, None] + np.arange(WINDOW)
    table[:, :, :3] = np.take_along_axis(rows, window[:, :, None], axis=1)
    table[:, 0, 3] = first + COUNT_STEP * (beyond + 1)
    table[:, 1:3, 3] = np.concatenate([p.texture for p in patches])
    table[:, 3, 3] = np.concatenate([np.full(len(p.weight), p.kind) for p in patches])
    return table


def level_of(patches: list[Patch], solid: bool = False) -> Level:
    """Return the patches as one level; where `solid` is set the fins are drawn with the body."""
    body: list[Int64s] = []
    fins: list[Int64s] = []
    start = 0
    for patch in patches:
        kind = body if solid or patch.kind == BODY else fins
        kind.append(patch.triangles + start)
        start += len(patch.weight)
    none = np.zeros((0, 3), np.uint32)
    return Level(
        pack(patches),
        np.concatenate(body).astype(np.uint32),
        np.concatenate(fins).astype(np.uint32) if fins else none,
    )


def both_sides(lattice: Lattice, along: Float64s, around: Float64s) -> list[Patch]:
    """Return the two juxtaposed surfaces of a body."""
    return [body_side(lattice, along, around, side) for side in (1, -1)]


def levels_of(body: Body) -> tuple[Level, Level, Level]:
    """Return a species' levels of detail: close, far and card. Topology is the same for every species."""
    from systems.view.fish_fins import CARD, CLOSE, FAR, fins_of

    lattice = lattice_of(body)
    spans = ROWS - 3
    close = both_sides(lattice, np.linspace(0, 1, 2 * spans + 1), np.linspace(0, 1, 13))
    far = both_sides(lattice, greville(ROWS), greville(AROUND))
    few = greville(ROWS)[[0, 3, 5, 9, 14, 20]]
    card = both_sides(lattice, few, np.array([0.0, 0.5, 1.0]))
    return (
        level_of([*close, *fins_of(lattice, CLOSE)]),
        level_of([*far, *fins_of(lattice, FAR)]),
        level_of([*card, *fins_of(lattice, CARD)], solid=True),
    )


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
