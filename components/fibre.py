"""Fibres: tentacles, feet, blades and stems as chains of segments that bend and never stretch (papers/002, section 4).

A `Tuft` is what content gives: fibres of one node count that grow together. `Strands` and `Followers` are the layout
that bending kernels and drawing read, which components/garden.py makes of tufts. Nothing here is simulation state:
fibres are drawn only.

Layout. Fibres lie in bundles of eight, side by side (one SIMD register); a row is one node of the eight fibres of a
bundle, and a bundle's rows follow each other from root to tip. Node i of fibre f stands in row `first_row[f] + i`, lane
`lane[f]`: its position is `position[row, :, lane]`. Lanes that no fibre fills repeat one that does.
"""

from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float32s, Float64s, Int32s

LANES: Final = 8
"""Fibres in a bundle."""

DENSITY: Final = 0.02
"""rho of papers/002 eq. 9: a coupling in scene units, no density (FINDINGS 9)."""

CARRIED: Final = 1
"""Flag of a bundle whose fibres are carried."""

GROUNDED: Final = 2
"""Flag of a bundle with ground below any of its fibres."""

SKIN: Final = 0.05
"""[m] from a rock within which it pushes fibres away."""

PUSH: Final = 2.0
"""[m/s] of flow that counts as that push at a rock's surface."""

_FARTHEST: Final = 1e5


class Carriers(NamedTuple):
    """Which fibres carry those of a tuft: the roots move and turn with a node of theirs."""

    tuft: int
    "index of an earlier tuft"
    fibre: Int32s
    "in that tuft, (F,)"
    node: Int32s
    "of that fibre, 0 is its root, (F,)"


@dataclass(frozen=True)
class Tuft:
    """Fibres of one node count that grow together at rest. F fibres of N nodes."""

    points: Float64s
    "[m] nodes at rest, root first, world axes, (F, N, 3)"
    radii: Float64s
    "[m] at the nodes, (F, N) or (N,)"
    modulus: float = 1.0
    "K of papers/002 eq. 11, k = r^n K"
    exponent: float = 2.0
    "n of papers/002 eq. 11"
    plant: int = 0
    "which plant of the level this is part of"
    look: int = 0
    "what the drawing knows it by"
    carriers: Carriers | None = None
    "what carries the roots; None where they stand fast"
    guides: int | None = None
    "index of an earlier tuft from whose fibres these are interpolated; None where they bend by themselves"
    ground: tuple[float, float, float, float] | None = None
    "plane n.p = c that no node passes: unit n, c [m]"

    def __post_init__(self) -> None:
        """Raise ValueError where these are no fibres."""
        if self.points.ndim != 3 or self.points.shape[2] != 3 or self.points.shape[1] < 1:
            raise ValueError("a tuft's points have the shape (fibres, nodes >= 1, 3)")
        if self.radii.shape not in (self.points.shape[:2], self.points.shape[1:2]):
            raise ValueError("a tuft's radii have one number a node")
        if not (np.abs(self.points) <= _FARTHEST).all():
            raise ValueError(f"a fibre's points lie within {_FARTHEST:g} m of the origin")
        if not ((self.radii >= 0.0) & (self.radii <= _FARTHEST)).all():
            raise ValueError("a fibre's radii are numbers >= 0")
        if not (np.linalg.norm(np.diff(self.points, axis=1), axis=2) > 1e-6).all():
            raise ValueError("a fibre's nodes stand apart: a segment has no length")
        if not (0.0 <= self.modulus < np.inf and abs(self.exponent) <= 20.0):
            raise ValueError("a fibre's stiffness needs K >= 0 and n from -20 to 20")

    @property
    def fibres(self) -> int:
        """Number of fibres."""
        return len(self.points)

    @property
    def nodes(self) -> int:
        """Nodes of each fibre, its root included."""
        return int(self.points.shape[1])


class Strands(NamedTuple):
    """What bending kernels read and write. R rows of fibres that bend, B bundles."""

    bundle: Int32s
    "first row, nodes, clump (bundles in one bounding sphere), flags, (B, 4); by depth of carrying"
    rest: Float32s
    "rest direction of each node's segment, in the frame (t, n, t x n) of the segment before, (R, 3, 8)"
    length: Float32s
    "[m] L of the segment that ends in each node, 0 at roots, (R, 8)"
    area: Float32s
    "A = rho L r / 2 of papers/002 eq. 9, (R, 8)"
    stiffness: Float32s
    "k L of papers/002 eq. 10, (R, 8)"
    rest_root: Float32s
    "t and n of the frame that each fibre's first segment starts from, at rest, (B, 6, 8)"
    root: Float32s
    "the same as the carrier has turned it, (B, 6, 8)"
    perch: Float32s
    "of carried fibres: root [m] from the carrier's node, and the carrier's direction there, at rest, (B, 6, 8)"
    carrier: Int32s
    "of carried fibres: 8 row + lane of the carrier's node, (B, 8)"
    plane: Float32s
    "n and c [m] of the ground below each fibre; n = 0 where there is none, (B, 4, 8)"
    direction: Float32s
    "state: unit vector of the segment that ends in each node, at roots as rest, (R, 3, 8)"
    position: Float32s
    "state: nodes [m], world axes, (R, 3, 8)"


class Followers(NamedTuple):
    """Interpolated fibres (papers/002, section 5.4). G bundles; their rows lie after those that bend."""

    bundle: Int32s
    "first row, nodes, (G, 2)"
    guide: Int32s
    "8 first row + lane of the three nearest guides, nearest first, (G, 3, 8)"
    weight: Float32s
    "of the guides, sum 1, (G, 3, 8)"
    root: Float32s
    "[m] root from the guides' mean root, (G, 3, 8)"
    length: Float32s
    "[m] of the segment that ends in each node, (rows of followers, 8)"


class Rocks(NamedTuple):
    """Ellipsoids that no node enters. M rocks, C clumps."""

    table: Float32s
    "centre [m], smallest semi-axis [m] | 1 / semi-axes [1/m], 0 | cosine and sine of the yaw, 0, 0, (M, 12)"
    first: Int32s
    "where the list of each clump begins, (C + 1,)"
    member: Int32s
    "rocks in reach, clump by clump"
