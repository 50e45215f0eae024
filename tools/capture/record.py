"""Runs the biomechanical fish through a stroke and writes down its nodes and body axes (papers/000, 4.1)."""

from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s
from components.kernels import serial
from systems.motor.biomechanics import Workspace, advance, workspace
from systems.motor.body_frame import body_frame
from systems.motor.contract import Stroke
from systems.motor.muscle_model import BodyModel

REACH: Final = 2.0
"""[BL] farther than any node of a sound body lies from its origin, along an axis."""


@dataclass(frozen=True)
class Recording:
    """What a run showed at F frames of 1/60 s, world axes: x ahead at the start, z up."""

    nodes: Float64s
    "[BL], (F, 23, 3)"
    origin: Float64s
    "[BL] o, (F, 3)"
    rotation: Float64s
    "R, (F, 3, 3)"


class BlewUpError(ValueError):
    """A simulation ran away: `frame` is the first at which a node was nowhere near its body."""

    def __init__(self, frame: int) -> None:
        self.frame = frame
        super().__init__(f"the simulation blows up at frame {frame}")


class State(NamedTuple):
    """A fish between two frames."""

    position: Float64s
    "[BL] of the nodes, world axes, (23, 3)"
    velocity: Float64s
    "[BL/s], (23, 3)"

    def copy(self) -> "State":
        """Return a state that may be run on without changing this one."""
        return State(self.position.copy(), self.velocity.copy())


def at_rest(model: BodyModel) -> State:
    """Return the straight body that does not move."""
    return State(model.start.copy(), np.zeros_like(model.start))


@serial
def _run(
    model: BodyModel,
    stroke: Stroke,
    begin: int,
    state: State,
    work: Workspace,
    nodes: Float64s,
    origin: Float64s,
    rotation: Float64s,
) -> int:
    """Write the frames; return how many are sound: those before a node is farther than `REACH` from the body."""
    for frame in range(len(nodes)):
        advance(model, stroke, begin + frame, state.position, state.velocity, work)
        nodes[frame] = state.position
        body_frame(nodes[frame], origin[frame], rotation[frame])
        for node in range(nodes.shape[1]):
            for axis in range(3):
                if not abs(nodes[frame, node, axis] - origin[frame, axis]) <= REACH:
                    return frame
                if not abs(rotation[frame, axis, 0]) <= 1.5:
                    return frame
    return len(nodes)


def record(
    model: BodyModel, stroke: Stroke, frames: int, state: State | None = None, begin: int = 0
) -> Recording:
    """Return `frames` frames of `stroke` from frame `begin` on; frame k follows SUBSTEPS (k + 1) substeps.

    It starts from `state`, which is left as it is after the last frame; without one, from rest. Raise BlewUpError
    where a node is not a number or leaves its body.
    """
    nodes = np.zeros((frames, *model.start.shape))
    made = Recording(nodes, np.zeros((frames, 3)), np.zeros((frames, 3, 3)))
    state = at_rest(model) if state is None else state
    work = workspace(model)
    sound = _run(model, stroke, begin, state, work, made.nodes, made.origin, made.rotation)
    if sound < frames:
        raise BlewUpError(begin + sound)
    return made
