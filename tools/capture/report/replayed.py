"""A segment played back in the world: where the fish is and how it is bent (papers/000, eqs. 10-12 as corrected)."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.segment import Segment

_LEVEL: Final = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""R of a level fish whose nose points along x: columns anterior, dorsal (z of the world), right (-y)."""


@dataclass(frozen=True)
class Replayed:
    """F entries played, from the origin along +x; world axes, z up."""

    nodes: Float64s
    "[BL] after each entry, (F, 23, 3)"
    origin: Float64s
    "[BL] o, before the first entry and after each, (F + 1, 3)"
    rotation: Float64s
    "R, before the first entry and after each, (F + 1, 3, 3)"

    def heading(self) -> Float64s:
        """Return the level angle [degrees] of the anterior axis, left positive, without jumps, (F + 1,)."""
        ahead = self.rotation[:, :, 0]
        angles: Float64s = np.degrees(np.unwrap(np.arctan2(ahead[:, 1], ahead[:, 0])))
        return angles

    def pitch(self) -> Float64s:
        """Return the angle [degrees] of the anterior axis above the level, (F + 1,)."""
        angles: Float64s = np.degrees(np.arcsin(np.clip(self.rotation[:, 2, 0], -1.0, 1.0)))
        return angles


def replay(segment: Segment, cycles: int = 1) -> Replayed:
    """Play a segment so many times; a cycle is turned so that its mean course is +x, seen from above."""
    turned = _LEVEL
    if segment.loops:
        x, y = _played(segment, 1, _LEVEL).origin[-1, :2]
        size = float(np.hypot(x, y)) or 1.0
        c, s = x / size, -y / size
        turned = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ _LEVEL
    return _played(segment, cycles, turned)


def _played(segment: Segment, cycles: int, start: Float64s) -> Replayed:
    origins, rotations, nodes = [np.zeros(3)], [start], []
    for _ in range(cycles):
        for m, t, d in zip(segment.rotation, segment.translation, segment.shape, strict=True):
            origins.append(origins[-1] + rotations[-1] @ t)
            rotations.append(rotations[-1] @ m)
            nodes.append(origins[-1] + d.astype(np.float64) @ rotations[-1].T)
    return Replayed(np.array(nodes), np.array(origins), np.array(rotations))
