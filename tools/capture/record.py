"""Runs the biomechanical fish through a stroke and writes down its nodes and body axes (papers/000, 4.1)."""

from dataclasses import dataclass

import numpy as np

from components.arrays import Float64s
from components.kernels import serial
from systems.motor.biomechanics import Workspace, advance, workspace
from systems.motor.body_frame import body_frame
from systems.motor.contract import Stroke
from systems.motor.muscle_model import BodyModel


@dataclass(frozen=True)
class Recording:
    """What a run showed at F frames of 1/60 s, world axes: x ahead at the start, z up."""

    nodes: Float64s
    "[BL], (F, 23, 3)"
    origin: Float64s
    "[BL] o, (F, 3)"
    rotation: Float64s
    "R, (F, 3, 3)"


@serial
def _run(
    model: BodyModel,
    stroke: Stroke,
    position: Float64s,
    work: Workspace,
    nodes: Float64s,
    origin: Float64s,
    rotation: Float64s,
) -> None:
    velocity = np.zeros_like(position)
    for frame in range(len(nodes)):
        advance(model, stroke, frame, position, velocity, work)
        nodes[frame] = position
        body_frame(nodes[frame], origin[frame], rotation[frame])


def record(model: BodyModel, stroke: Stroke, frames: int) -> Recording:
    """Return the first `frames` frames of `stroke`, begun at rest; frame k follows SUBSTEPS (k + 1) substeps."""
    position = model.start.copy()
    made = Recording(
        np.zeros((frames, *position.shape)), np.zeros((frames, 3)), np.zeros((frames, 3, 3))
    )
    work = workspace(model)
    _run(model, stroke, position, work, made.nodes, made.origin, made.rotation)
    return made
