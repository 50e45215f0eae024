"""The paper's own way with the same equations: a dense 69 x 69 LU each substep (papers/000, 3.1), for benches."""

from typing import Final

import numpy as np

from components.arrays import Float64s, Int64s
from systems.motor.biomechanics import (
    SUBSTEPS,
    UNKNOWNS,
    Workspace,
    drive,
    move_nodes,
)
from systems.motor.contract import Stroke
from systems.motor.muscle_model import BodyModel

_ACROSS = np.subtract.outer(np.arange(UNKNOWNS), np.arange(UNKNOWNS))
_ENTRY: Final[tuple[Int64s, ...]] = np.nonzero((_ACROSS <= 0) & (_ACROSS > -24))
"""Row and column of each entry that the band holds."""


def dense_matrix(band: Float64s) -> Float64s:
    """Return the symmetric (69, 69) matrix that a flat band holds."""
    matrix = np.zeros((UNKNOWNS, UNKNOWNS))
    rows, columns = _ENTRY
    values = band[24 * rows + columns]
    matrix[rows, columns] = values
    matrix[columns, rows] = values
    return matrix


def _finish(position: Float64s, velocity: Float64s, work: Workspace) -> None:
    work.right[:] = np.linalg.solve(dense_matrix(work.band), work.right)
    move_nodes(position, velocity, work.right)


def dense_advance(
    model: BodyModel,
    stroke: Stroke,
    frame: int,
    position: Float64s,
    velocity: Float64s,
    work: Workspace,
) -> None:
    """Advance one frame as `systems.motor.biomechanics.advance` does."""
    for step in range(SUBSTEPS * frame, SUBSTEPS * (frame + 1)):
        drive(model, stroke, step, position, velocity, work)
        _finish(position, velocity, work)
