"""A swimmer of known motion: what the motor system plays in tests that need no captured fish."""

from collections.abc import Callable
from pathlib import Path
from typing import TypeAlias

import numpy as np
import pytest

from components.arrays import Float64s
from components.body import Body, rest_nodes
from components.fish import Population
from components.repertoire import Pattern, Repertoire, RepertoireLibrary, Segment, pack
from components.repertoire_file import load
from components.terrain import Terrain, build_terrain

School: TypeAlias = Callable[[int, RepertoireLibrary], Population]

BODY = Body(
    station=(0.11, 0.28, 0.47, 0.66, 0.82),
    half_width=(0.036, 0.050, 0.047, 0.032, 0.013),
    half_height=(0.060, 0.088, 0.085, 0.058, 0.026),
    tail_span=0.105,
)
FALSE_ROLL = 0.1
"[rad] that the body axes roll either way in a beat (FINDINGS 1)"


def _about(axis: int, angle: float) -> Float64s:
    c, s = np.cos(angle), np.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    m = np.eye(3)
    m[i, i], m[j, j], m[i, j], m[j, i] = c, c, -s, s
    return m


def _segment(
    pattern: Pattern, frames: int, speed: float, sweep: float, beats: float, turn: float
) -> Segment:
    """Record a travelling wave: `speed` BL/s, `beats` in `frames` frames, `turn` [rad] to the left."""
    phase = 2 * np.pi * beats * np.arange(frames + 1) / frames
    yaw = 0.05 * np.sin(phase) + turn * np.arange(frames + 1) / frames
    frame = [
        _about(1, a) @ _about(0, FALSE_ROLL * np.sin(p)) for a, p in zip(yaw, phase, strict=True)
    ]
    origin = np.zeros((frames + 1, 3))
    for k in range(frames):
        origin[k + 1] = origin[k] + _about(1, yaw[k])[:, 0] * (speed / 60)
    origin[:, 2] += 0.01 * np.sin(phase)
    rest = rest_nodes(BODY)
    along = -rest[:, 0]
    shape = np.repeat(rest[None], frames, axis=0)
    for k in range(frames):
        shape[k, :, 2] += 0.5 * sweep * along**2 * np.sin(phase[k + 1] - 2 * np.pi * along)
    return Segment(
        pattern,
        turn == 0.0,
        np.array([frame[k].T @ frame[k + 1] for k in range(frames)]),
        np.array([frame[k].T @ (origin[k + 1] - origin[k]) for k in range(frames)]),
        shape.astype(np.float32),
    )


def synthetic() -> Repertoire:
    """Return the synthetic swimmer's repertoire; right turns mirror the left one."""
    return Repertoire(
        (
            _segment(Pattern.SWIM_SLOW, 24, 0.9, 0.12, 1, 0.0),
            _segment(Pattern.SWIM_MEDIUM, 15, 2.0, 0.18, 1, 0.0),
            _segment(Pattern.SWIM_FAST, 10, 3.2, 0.2, 1, 0.0),
            _segment(Pattern.TURN_LEFT, 45, 1.6, 0.25, 0.75, 0.9),
        ),
        {},
    )


@pytest.fixture(scope="session")
def library() -> RepertoireLibrary:
    """The synthetic swimmer's library."""
    return pack([synthetic()])


def swimmers(count: int, library: RepertoireLibrary) -> Population:
    """Return `count` upright fishes of 1 m that head along +x at z = -5 m, their phases apart."""
    population = Population()
    rows = population.append(np.arange(100, 100 + count))
    fish, motor = population.fish, population.motor
    medium = int(library.segment[0, Pattern.SWIM_MEDIUM])
    fish.position[rows] = fish.last_position[rows] = (0.0, 0.0, -5.0)
    fish.rotation[rows] = fish.last_rotation[rows] = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]
    motor.segment[rows] = motor.wanted[rows] = medium
    motor.frame[rows] = np.arange(count) % library.length[medium]
    shown = library.start[medium] + (motor.frame[rows] - 1) % library.length[medium]
    motor.shape_row[rows] = motor.last_shape_row[rows] = shown
    motor.heading[rows] = (1.0, 0.0, 0.0)
    return population


@pytest.fixture(scope="session")
def school() -> School:
    """Make so many swimmers of a library."""
    return swimmers


@pytest.fixture(scope="session")
def captured(installed: Path) -> RepertoireLibrary:
    """The shipped repertoires of sardine and blue tang, in this order."""
    folder = installed / "assets" / "repertoires"
    return pack([load(folder / f"{name}.npz") for name in ("sardine", "blue_tang")])


@pytest.fixture(scope="session")
def sea() -> Terrain:
    """A wide sea, 60 m deep, without rocks."""
    return build_terrain(500.0, 60.0, 0.5, 20.0, 1)
