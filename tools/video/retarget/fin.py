"""Turns a target's fins as rigid bodies, joined to the body by a soft root (papers/003, section 5.2; FINDINGS 4).

The paper moves a fin's tip as one more control point, which strains fins and flips triangles from 40 degrees on. Here
the fin turns about the middle of its root; the turn fades in with the distance from the root along the surface.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s, Int64s
from tools.video.retarget.areas import signed_areas

BAND: Final = 0.08
"""[BL] from the root over which a fin's turn fades in."""
LARGEST_TURN: Final = 1.05
"""[rad] that a fin turns at most."""
_SHEAR: Final = 0.7
"""Turn times half the root over the band that leaves every triangle its side: below 1."""
_STEEPEST: Final = 1.5
"""Largest slope of smoothstep."""
_LONGEST_BAND: Final = 0.5
"""Of the fin's reach."""
_SQUEEZED: Final = 0.25
"""Of its area that the most squeezed triangle keeps at a fin's limit; a bending body takes some of it."""
_TRIALS: Final = 22


@dataclass(frozen=True)
class Fin:
    """One paired fin of a target, in the target's local frame and unit."""

    tip: Float64s
    "(2,)"
    top: Float64s
    "the junction nearer the head, (2,)"
    bottom: Float64s
    "the junction nearer the tail, (2,)"
    vertices: Int64s
    "those of the mesh that belong to it, (n,)"
    distance: Float64s
    "of each from the root along the surface, (n,)"


def smoothstep(t: Float64s) -> Float64s:
    """Return 3 t^2 - 2 t^3 for t held between 0 and 1."""
    t = np.clip(t, 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))


class RigidFin:
    """A fin that turns about the middle of its root."""

    def __init__(
        self, fin: Fin, rest: Float64s, body_length: float, triangles: Int64s | None = None
    ) -> None:
        """`rest` holds the mesh's vertices in the plane, (V, 2); no turn brings one of `triangles` near a flip."""
        self.vertices = fin.vertices
        root = fin.bottom - fin.top
        half = 0.5 * float(np.sqrt(root @ root))
        reach = float(fin.distance.max(initial=0.0))
        wanted = max(BAND * body_length, _STEEPEST * half * LARGEST_TURN / _SHEAR)
        self.band = max(min(wanted, _LONGEST_BAND * reach), 1e-9)
        self._share = smoothstep(fin.distance / self.band)
        self._root = complex(*root)
        middle = 0.5 * (fin.top + fin.bottom)
        self._arm = _complex(rest[fin.vertices] - middle)
        free = min(LARGEST_TURN, _SHEAR * self.band / (_STEEPEST * max(half, 1e-9)))
        self.limits = (-free, free)
        if triangles is not None:
            touched = triangles[np.isin(triangles, fin.vertices).any(axis=1)]
            back, forth = (
                self._unfolded(fin, rest, touched, sign * LARGEST_TURN) for sign in (-1.0, 1.0)
            )
            self.limits = (back, forth)

    def _unfolded(self, fin: Fin, rest: Float64s, triangles: Int64s, largest: float) -> float:
        """Return how far the fin can turn that way before a triangle has lost most of its area."""
        before, moved = signed_areas(rest, triangles), rest.copy()
        fine = 0.0
        self.limits = (-LARGEST_TURN, LARGEST_TURN)
        for turn in np.linspace(0.0, largest, _TRIALS)[1:]:
            moved[fin.vertices] = self(rest[fin.vertices], fin.top, fin.bottom, float(turn))
            if float((signed_areas(moved, triangles) / before).min(initial=1.0)) < _SQUEEZED:
                break
            fine = float(turn)
        return fine

    def __call__(self, body: Float64s, top: Float64s, bottom: Float64s, turn: float) -> Float64s:
        """Return the fin's vertices (n, 2): `body` is where the body put them, the junctions are carried.

        `turn` [rad] is from the rest pose in the local frame; what the body turns the root by is taken off, and what is
        left is held to `limits`.
        """
        middle = complex(*(0.5 * (top + bottom)))
        rolled = complex(*(bottom - top)) / self._root
        rolled /= max(abs(rolled), 1e-300)
        stiff = rolled * self._arm
        soft = _complex(body) - middle
        turn = min(max(turn - float(np.angle(rolled)), self.limits[0]), self.limits[1])
        angle = turn * self._share
        placed = (np.cos(angle) + 1j * np.sin(angle)) * (
            soft + self._share * (stiff - soft)
        ) + middle
        return np.stack((placed.real, placed.imag), axis=-1)


def _complex(points: Float64s) -> "np.ndarray[tuple[int, ...], np.dtype[np.complex128]]":
    return np.asarray(points[:, 0] + 1j * points[:, 1])
