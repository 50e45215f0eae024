"""What a turn amounts to: how far it turns the fish, how sharply it bends its joints, how near the beat it ends."""

from dataclasses import dataclass
from math import sqrt
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND
from components.kernels import row, serial
from components.segment import Segment, mean_speed
from components.trigonometry import DEGREE, arc
from systems.motor.muscle_model import SEGMENTS

TURN_GAP: Final = 0.01
"""[BL] how near the cruising shape a turn must end."""

JOINT_LIMIT: Final = 70.0 * DEGREE
"""[rad] that no joint of the centre line may bend: a fish that bends farther folds its fin inside out."""

SHARP_LEAST: Final = 40.0 * DEGREE
"""[rad] that a sharp turn turns at least."""

START_LEAST: Final = 60.0 * DEGREE
"""[rad] that a fast start turns at least."""


@dataclass(frozen=True)
class Bend:
    """A turn in numbers."""

    net: float
    "change of the mean heading [rad], left positive"
    joint: float
    "largest angle between two parts of the centre line [rad]"
    gap: float
    "distance of the last shape from the beat that follows [BL]"

    def text(self, segment: Segment) -> str:
        """Return the figures as one line for the provenance."""
        seconds = len(segment.translation) / TICKS_PER_SECOND
        return (
            f"turn {self.net / DEGREE:.1f} degrees in {seconds:.2f} s, joints {self.joint / DEGREE:.0f} degrees, "
            f"speed {mean_speed(segment):.3f} BL/s, end {self.gap:.4f} BL"
        )

    def faults(self, least: float, gap: float) -> list[str]:
        """Return what is wrong with a turn of at least `least` [rad] that should end `gap` [BL] from the beat."""
        found = []
        if not self.net >= least:
            found.append(f"turns {self.net / DEGREE:.0f} degrees, below {least / DEGREE:.0f}")
        if not self.joint <= JOINT_LIMIT:
            found.append(f"bends a joint by {self.joint / DEGREE:.0f} degrees")
        if not self.gap <= gap:
            found.append(f"ends {self.gap:.3f} BL from the swimming shape")
        return found


@row
def _middle(nodes: Float64s, place: int, axis: int) -> float:
    """Return a coordinate of the centre line: 0 the nose, 1-5 the rings, 6 the caudal fin's tips."""
    if place == 0:
        return float(nodes[0, axis])
    if place == SEGMENTS:
        return 0.5 * float(nodes[21, axis] + nodes[22, axis])
    first = 4 * place - 3
    return 0.25 * float(
        nodes[first, axis]
        + nodes[first + 1, axis]
        + nodes[first + 2, axis]
        + nodes[first + 3, axis]
    )


@serial
def _joints(nodes: Float64s) -> float:
    line, most = np.zeros((SEGMENTS, 2)), 0.0
    for frame in range(len(nodes)):
        for part in range(SEGMENTS):
            for axis in range(2):
                line[part, axis] = _middle(nodes[frame], part, axis) - _middle(
                    nodes[frame], part + 1, axis
                )
        for part in range(SEGMENTS - 1):
            x, y, u, v = line[part, 0], line[part, 1], line[part + 1, 0], line[part + 1, 1]
            most = max(most, abs(arc(x * u + y * v, x * v - y * u)))
    return most


def largest_joint(nodes: Float64s) -> float:
    """Return the largest level angle [rad] between neighbouring parts of the centre line, of nodes (F, 23, 3)."""
    return float(_joints(np.ascontiguousarray(nodes)))


def level_turn(before: Float64s, after: Float64s) -> float:
    """Return the level angle [rad] from one body's anterior axis to another's, left positive; both R (3, 3)."""
    x, y, u, v = before[0, 0], before[1, 0], after[0, 0], after[1, 0]
    return float(arc(x * u + y * v, x * v - y * u))


def speed_ahead(origin: Float64s, ahead: Float64s) -> float:
    """Return the speed [BL/s] over origins (F, 3) along the level part of `ahead` (3,)."""
    way = origin[-1] - origin[0]
    size = sqrt(ahead[0] * ahead[0] + ahead[1] * ahead[1])
    along = (way[0] * ahead[0] + way[1] * ahead[1]) / size
    return float(along) * TICKS_PER_SECOND / (len(origin) - 1)
