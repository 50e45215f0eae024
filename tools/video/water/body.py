"""The body that a silhouette from above shows: stations, half-widths; what it cannot show is assumed (FINDINGS 4).

A camera above sees how wide a fish is and how long, never how deep. Depth, tail and fins are those of a streamlined
fish, such as trouts and sardines; whoever knows better writes it into the species' file.
"""

from itertools import product
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.body import Body, Fin
from tools.video.water.film import STATIONS, Film

DEPTH: Final = 1.65
"""Height over width where the body is thickest, assumed ..."""

_SIDE: Final = (
    (0.0, 0.1, 0.2, 0.32, 0.45, 0.62, 0.8, 0.86),
    (0.3, 0.62, 0.84, 0.97, 1.0, 0.78, 0.38, 0.33),
)
"""... and height along the body over that: deepest behind the middle of the trunk, as streamlined fishes are."""

TAIL_SPAN: Final = 0.115
"""[BL] assumed of the half span of the caudal fin."""

LEAST: Final = 0.012
"""[BL] of half-width: a thinner ring would hardly have mass."""

MOST: Final = 0.2
"""[BL] of half-width."""

_PLACES: Final = (
    (0.09, 0.11, 0.13, 0.15),
    (0.22, 0.25, 0.28, 0.31, 0.34),
    (0.42, 0.46, 0.5, 0.54),
    (0.6, 0.64, 0.68),
    (0.77, 0.8, 0.83),
)
_END: Final = 0.86
"""Up to where a body's width is compared: behind it, there is only the caudal fin."""


def widths(film: Film) -> Float64s:
    """Return the half-width at 41 stations from nose to tail [BL]: the median of the good frames, (41,)."""
    good = film.half_width[film.good]
    found: Float64s = np.median(good, axis=0) / film.length
    return found


def body_of(film: Film) -> Body:
    """Return the body of a filmed fish: stations where straight lines between them come nearest to its outline."""
    wide = widths(film)
    along = np.linspace(0.0, 1.0, STATIONS)
    seen = along <= _END

    def apart(stations: tuple[float, ...]) -> float:
        at = np.interp(stations, along, wide)
        drawn = np.interp(along, (0.0, *stations, 1.0), (0.0, *at, 0.0))
        return float(((drawn - wide)[seen] ** 2).sum())

    best = min(product(*_PLACES), key=apart)
    half = [min(max(float(np.interp(s, along, wide)), LEAST), MOST) for s in best]
    width = tuple(round(w, 4) for w in half)
    deep = DEPTH * max(width)
    height = tuple(round(min(deep * float(np.interp(s, *_SIDE)), 0.35), 4) for s in best)
    return Body(
        station=best,
        half_width=width,  # type: ignore[arg-type]
        half_height=height,  # type: ignore[arg-type]
        tail_span=TAIL_SPAN,
        tail_fork=0.06,
        dorsal=Fin(0.42, 0.55, 0.07, 0.04),
        anal=Fin(0.64, 0.74, 0.045, 0.03),
        pectoral_at=0.24,
        pectoral_length=0.11,
        pectoral_height=-0.5,
    )
