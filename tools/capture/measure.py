"""What a captured motion amounts to, held against real fishes (FINDINGS 3): speed, sweep, Strouhal, wave, turn."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND
from components.repertoire import Segment, heading_change, mean_speed
from components.trigonometry import DEGREE
from tools.capture.bend import JOINT_LIMIT, largest_joint
from tools.capture.cut import course, shape_gap
from tools.capture.record import Recording

CLOSURE_LIMIT: Final = 1e-5
"""[BL] the most that the shape may change over a cycle."""

STROUHAL_RANGE: Final = (0.2, 0.45)
SWEEP_RANGE: Final = (0.1, 0.24)
"""[BL], of the tail from side to side."""

TURN_RANGE_DEG: Final = (10.0, 40.0)


@dataclass(frozen=True)
class SwimFigures:
    """A beat in numbers."""

    speed: float
    "[BL/s]"
    frequency: float
    "[Hz]"
    sweep: float
    "of the tail from side to side [BL]"
    head_sweep: float
    "of the nose [BL]"
    strouhal: float
    closure: float
    "largest change of shape over the cycle [BL]"
    backward: bool
    "whether the wave of bending runs from head to tail"
    joint: float = 0.0
    "largest angle between two parts of the centre line [rad]"

    def text(self) -> str:
        """Return the figures as one line for the provenance."""
        return (
            f"speed {self.speed:.3f} BL/s, {self.frequency:.2f} Hz, sweep {self.sweep:.3f} BL, "
            f"head {self.head_sweep:.3f} BL, Strouhal {self.strouhal:.3f}, closure {self.closure:.0e} BL"
        )

    def faults(self) -> list[str]:
        """Return what is unlike a living fish, one short phrase each."""
        found = []
        if not self.closure <= CLOSURE_LIMIT:
            found.append(f"does not close ({self.closure:.0e} BL)")
        if not STROUHAL_RANGE[0] <= self.strouhal <= STROUHAL_RANGE[1]:
            found.append(f"Strouhal {self.strouhal:.2f} outside {STROUHAL_RANGE}")
        if not SWEEP_RANGE[0] <= self.sweep <= SWEEP_RANGE[1]:
            found.append(f"sweep {self.sweep:.2f} BL outside {SWEEP_RANGE}")
        if not self.backward:
            found.append("the wave runs forwards")
        if not self.joint <= JOINT_LIMIT:
            found.append(f"bends a joint by {self.joint / DEGREE:.0f} degrees")
        return found


def measure_swim(recording: Recording, segment: Segment, first: int) -> SwimFigures:
    """Return the figures of the beat that starts at frame `first`."""
    period = len(segment.translation)
    x, y = course(recording, first, period)
    beat = recording.nodes[first : first + period]
    aside = x * beat[:, :, 1] - y * beat[:, :, 0]
    tail = 0.5 * (aside[:, 21] + aside[:, 22])
    speed, frequency = mean_speed(segment), TICKS_PER_SECOND / period
    sweep = float(tail.max() - tail.min())
    head = float(aside[:, 0].max() - aside[:, 0].min())
    return SwimFigures(
        speed,
        frequency,
        sweep,
        head,
        frequency * sweep / speed if speed > 0 else float("inf"),
        shape_gap(recording, first, first + period),
        _lag(aside) < period / 2,
        largest_joint(beat),
    )


def _lag(aside: Float64s) -> int:
    """Return how many frames the bend at R4 follows the bend at R3, of nodes' places aside (N, 23)."""
    bends = []
    for ring in (3, 4):
        centres = [
            aside[:, first] + aside[:, first + 1] + aside[:, first + 2] + aside[:, first + 3]
            for first in (4 * ring - 7, 4 * ring - 3, 4 * ring + 1)
        ]
        bends.append(int(np.argmax(centres[1] - 0.5 * (centres[0] + centres[2]))))
    return (bends[1] - bends[0]) % len(aside)


def turn_text(segment: Segment, gap: float) -> str:
    """Return a turn's figures as one line for the provenance; `gap` is its end's distance from the cruise [BL]."""
    seconds = len(segment.translation) / TICKS_PER_SECOND
    degrees = heading_change(segment) / DEGREE
    return f"turn {degrees:.1f} degrees in {seconds:.2f} s, speed {mean_speed(segment):.3f} BL/s, end {gap:.4f} BL"


def turn_faults(segment: Segment, gap: float, limit: float) -> list[str]:
    """Return what is wrong with a gradual turn to the left."""
    found = []
    degrees = heading_change(segment) / DEGREE
    if not TURN_RANGE_DEG[0] <= degrees <= TURN_RANGE_DEG[1]:
        found.append(f"turns {degrees:.0f} degrees, outside {TURN_RANGE_DEG}")
    if not gap <= limit:
        found.append(f"ends {gap:.3f} BL from the cruising shape")
    return found
