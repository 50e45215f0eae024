"""The shape of a species' body, as a modder draws it: five stations and a tail (FINDINGS 1, 1b).

All lengths are in body lengths (BL) from the nose backwards. Node 0 is the nose; rings of four
nodes, 1-4 ... 17-20, in ring order top-left, top-right, bottom-right, bottom-left (left is -z); 21
and 22 are the upper and lower tips of the caudal fin.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s

NODES: Final = 23
RINGS: Final = 5
NODE_HEIGHT: Final = 0.75
"""Height of a ring's nodes over the half-height of the skin at that station."""


@dataclass(frozen=True)
class Fin:
    """A median fin: from and to along the body, how far it stands out, how far its tip leans back, all in BL."""

    start: float
    end: float
    height: float
    lean: float = 0.04
    profile: tuple[float, ...] = ()
    "height at even steps from front to rear, over `height`; () is a fin that rises soon and falls off slowly"


@dataclass(frozen=True)
class Body:
    """Stations of the body at five rings, and its fins. Lengths in BL, from the nose backwards."""

    station: tuple[float, float, float, float, float]
    half_width: tuple[float, float, float, float, float]
    half_height: tuple[float, float, float, float, float]
    tail_span: float
    "half the span of the caudal fin"
    tail_fork: float = 0.06
    "depth of the caudal fin's fork"
    dorsal: Fin | None = None
    anal: Fin | None = None
    pectoral_at: float = 0.28
    pectoral_length: float = 0.12
    pectoral_height: float = -0.2
    "where the pectoral fin is rooted: -1 belly to 1 back"
    stiffness: float = 1.0
    "scale of all springs and dampers"
    snout: float = 0.6
    "view only: how pointed, 0.5 a parabola, 1 a cone"
    tail_upper: float = 1.0
    "view only: height of the caudal fin's upper lobe over `tail_span`"
    tail_lower: float = 1.0
    "view only: height and length of the lower lobe, over those of an even fin"
    tail_slender: float = 0.0
    "view only: 0 broad lobes, 1 slender ones"
    pectoral_held: bool = False
    "view only: held out like wings, as sharks do, not sculling"
    pelvic_at: float | None = None
    "view only: where the pelvic fins are rooted; behind the pectoral ones where None"
    pelvic_length: float | None = None
    "view only: 0.65 of the pectoral ones' where None"


@dataclass(frozen=True)
class Swim:
    """What the swim controller plays at cruise: contractions, lag and frequency (FINDINGS 1b)."""

    contraction_middle: float
    contraction_rear: float
    lag_deg: float
    frequency_hz: float


def rest_nodes(body: Body) -> Float64s:
    """Return the nodes of the straight body in BL, (23, 3), body axes, nose at the origin, x forward."""
    nodes = np.zeros((NODES, 3))
    sides = np.array([[1, -1], [1, 1], [-1, 1], [-1, -1]], dtype=np.float64)
    for ring in range(RINGS):
        first = 1 + 4 * ring
        nodes[first : first + 4, 0] = -body.station[ring]
        nodes[first : first + 4, 1] = sides[:, 0] * (NODE_HEIGHT * body.half_height[ring])
        nodes[first : first + 4, 2] = sides[:, 1] * body.half_width[ring]
    nodes[21] = (-1.0, body.tail_span, 0.0)
    nodes[22] = (-1.0, -body.tail_span, 0.0)
    return nodes
