"""A fish's vertices and triangles at three levels of detail, packed for the GPU (papers/000, 7.3; FINDINGS 8).

Close, the body is tessellated; far, it is the grid of the control points' places on the surface itself (their Greville
points), so that nothing jumps between levels; farther still, a card of a few triangles.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import AnyArray, Float32s, Float64s, Int64s
from components.body import NODES, Body
from systems.view.bspline import greville
from systems.view.fish_fins import CARD, CLOSE, FAR, fins_of
from systems.view.fish_lattice import ROWS, Lattice, lattice_of
from systems.view.fish_surface import AROUND, BODY, Patch, body_side
from systems.view.keep import kept, named

WINDOW: Final = 12
"""Consecutive nodes that a vertex may follow."""
COUNT_STEP: Final = 32
"""A vertex' first texel holds its first node plus this times the count of its nodes."""


@dataclass(frozen=True)
class Level:
    """One level of detail: all its vertices, the body's triangles and the fins'."""

    table: Float32s
    "texels (weight, d/du, d/dv, extra); extra is first node and count, texture x, y, kind, 0 ..., (n, 12, 4)"
    body: NDArray[np.uint32]
    "(t, 3)"
    fins: NDArray[np.uint32]
    "(t, 3)"


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


def levels_for(body: Body) -> list[Level]:
    """Return `levels_of(body)`, kept from the last time where it can be."""

    def arrays() -> list[AnyArray]:
        return [part for level in levels_of(body) for part in (level.table, level.body, level.fins)]

    parts = kept(named(__file__, body), arrays)
    return [
        Level(table.astype(np.float32), sides.astype(np.uint32), fins.astype(np.uint32))
        for table, sides, fins in zip(*(parts[start::3] for start in range(3)), strict=True)
    ]


def levels_of(body: Body) -> tuple[Level, Level, Level]:
    """Return a species' levels of detail: close, far and card. Topology is the same for every species."""
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
