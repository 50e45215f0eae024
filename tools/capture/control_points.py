"""Records the control points of a species' skin beside its nodes (papers/000, 4.1, eq. 9; FINDINGS 8).

Control points are linear in the nodes, so in body axes s = W d. W is fitted with the view's own functions, whose last
bit may differ from machine to machine: a repertoire with control points is not held to the shipped ones' bytes.
"""

from dataclasses import replace

import numpy as np

from components.arrays import Float64s
from components.body import NODES, Body
from components.segment import CONTROL_POINTS, Repertoire
from systems.view.fish_lattice import lattice_of
from systems.view.fish_surface import control_points


def control_weights(body: Body) -> Float64s:
    """Return the weights of the nodes in each control point of a body's skin, (378, 23); rows sum to 1."""
    lattice = lattice_of(body)
    right = control_points(lattice.outline, lattice.row)
    centre, up, out = (w[:, None, :] for w in (lattice.centre, lattice.up, lattice.right))
    sides = [centre + right[..., 1:2] * up + side * right[..., 2:3] * out for side in (1.0, -1.0)]
    return np.stack(sides).reshape(CONTROL_POINTS, NODES)


def with_control_points(repertoire: Repertoire, body: Body) -> Repertoire:
    """Return the repertoire with the control points of every entry."""
    weights = control_weights(body)
    segments = tuple(
        replace(
            segment,
            control=np.einsum("pn,enc->epc", weights, segment.shape.astype(np.float64)).astype(
                np.float32
            ),
        )
        for segment in repertoire.segments
    )
    return replace(repertoire, segments=segments)


def memory(repertoire: Repertoire) -> tuple[int, int]:
    """Return the bytes of a repertoire's arrays without control points, and of its control points."""
    plain, control = 0, 0
    for segment in repertoire.segments:
        plain += segment.rotation.nbytes + segment.translation.nbytes + segment.shape.nbytes
        control += 0 if segment.control is None else segment.control.nbytes
    return plain, control
