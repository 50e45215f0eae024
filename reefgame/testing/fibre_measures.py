"""Measures of how plants bend, by name: each takes what was seen, a flora and a group of fishes or None (papers/002).

Where a measure speaks of the flow it means the first singularity of the scene's `flow`, and is NaN without one.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Final, TypeAlias

import numpy as np

from components.arrays import Float64s

if TYPE_CHECKING:
    from reefgame.testing.swaying import Sway

FibreMeasure: TypeAlias = Callable[["Sway", str, str | None], float]

_STIRRED: Final = 0.01
"""[m] by which a tip has moved that is not at rest."""
_NEAR: Final = 0.45
"""[m] from a fish that passes within which tips feel it."""
_FAR: Final = 1.5
"""[m] from all fishes beyond which nothing of a plant feels them: their reach, and half a plant."""


def to_flow_m(s: "Sway", of: str, _: str | None) -> float:
    """Return how far [m] tips lean towards the flow's centre in the end, their mean; below 0 away from it."""
    return float(_to_flow(s, of)[-1])


def swings_m(s: "Sway", of: str, _: str | None) -> float:
    """Return how far [m] tips swing towards the flow's centre and away from it, from least to most, their mean."""
    lean = _to_flow(s, of)
    return float(lean.max() - lean.min())


def _to_flow(s: "Sway", of: str) -> Float64s:
    """Return the mean lean of a flora's tips towards the flow's centre [m], (T,)."""
    fibres = s.of(of)
    if not len(s.axis):
        return np.full(1, np.nan)
    way = _unit(s.flow[:, 0, None] - s.rest[fibres])
    lean: Float64s = (s.moved[:, fibres] * way).sum(axis=2).mean(axis=1)
    return lean


def round_flow_m(s: "Sway", of: str, _: str | None) -> float:
    """Return how far [m] tips lean round the flow's axis in the end, the way that eq. 4 turns, their mean."""
    fibres = s.of(of)
    if not len(s.axis):
        return float("nan")
    way = _unit(np.cross(s.rest[fibres] - s.flow[-1, 0], s.axis[0]))
    return float((s.moved[-1, fibres] * way).sum(axis=1).mean())


def along_flow_m(s: "Sway", of: str, _: str | None) -> float:
    """Return how far [m] tips lean along the flow's axis in the end, their mean."""
    return float((s.moved[-1, s.of(of)] @ s.axis[0]).mean()) if len(s.axis) else float("nan")


def to_fish_m(s: "Sway", of: str, to: str | None) -> float:
    """Return how far [m] tips within .45 m of the group's fish lean towards it, their mean when most tips are so near.

    Below 0 they lean away from it; NaN where it never came so near.
    """
    fibres = s.of(of)
    way = _ways(s, of, to)
    far = np.linalg.norm(way, axis=2)
    near = far < _NEAR
    at = int(near.sum(axis=1).argmax())
    if not near[at].any():
        return float("nan")
    lean = (s.moved[at, fibres] * _unit(way[at])).sum(axis=1)
    return float(lean[near[at]].mean())


def stirred_share(s: "Sway", of: str, _: str | None) -> float:
    """Return the share of tips that were ever a centimetre or more from where they rest."""
    return float(_stirred(s, of).mean())


def stirred_near_share(s: "Sway", of: str, to: str | None) -> float:
    """Return that share among the tips that a fish of the group came within .45 m of; NaN where none did."""
    near = np.linalg.norm(_ways(s, of, to), axis=2).min(axis=0) < _NEAR
    return float(_stirred(s, of)[near].mean()) if near.any() else float("nan")


def moved_far_m(s: "Sway", of: str, to: str | None) -> float:
    """Return how far [m] any tip ever moved of the plants that none of the group came within 1.5 m of; NaN for none."""
    fibres = s.of(of)
    least = np.linalg.norm(_ways(s, of, to), axis=2).min(axis=0)
    plants, inverse = np.unique(s.plant[fibres], return_inverse=True)
    nearest = np.full(len(plants), np.inf)
    np.minimum.at(nearest, inverse, least)
    apart = nearest[inverse] > _FAR
    moved = np.linalg.norm(s.moved[:, fibres[apart]], axis=2)
    return float(moved.max()) if apart.any() else float("nan")


def follow_share(s: "Sway", of: str, _: str | None) -> float:
    """Return how far interpolated tips are from where they rest in the end, over that of their guides; the means."""
    fibres = s.of(of)
    moved, follows = np.linalg.norm(s.moved[-1, fibres], axis=1), s.follows[fibres]
    if not follows.any() or not moved[np.logical_not(follows)].any():
        return float("nan")
    return float(moved[follows].mean() / moved[np.logical_not(follows)].mean())


def stretch_m(s: "Sway", _: str, __: str | None) -> float:
    """Return by how much [m] any segment of any plant was ever longer or shorter than at rest."""
    return s.stretch


def _stirred(s: "Sway", of: str) -> Float64s:
    stirred: Float64s = np.linalg.norm(s.moved[:, s.of(of)], axis=2).max(axis=0) > _STIRRED
    return stirred


def _ways(s: "Sway", of: str, to: str | None) -> Float64s:
    """Return the ways [m] from where a flora's tips rest to the nearest fish of a group, (T, F, 3)."""
    if to is None:
        raise ValueError("this measure needs a group of fishes: say `to`")
    fishes, rest = s.fishes.position[:, s.fishes.of(to)], s.rest[s.of(of)]
    best = np.full((len(fishes), len(rest), 3), np.inf)
    for fish in np.swapaxes(fishes, 0, 1):
        way = fish[:, None] - rest
        nearer = (way**2).sum(axis=2) < (best**2).sum(axis=2)
        best[nearer] = way[nearer]
    return best


def _unit(ways: Float64s) -> Float64s:
    units: Float64s = ways / np.maximum(np.linalg.norm(ways, axis=-1, keepdims=True), 1e-9)
    return units


FIBRE_MEASURES: Final[dict[str, FibreMeasure]] = {
    measure.__name__: measure
    for measure in (
        along_flow_m, follow_share, moved_far_m, round_flow_m, stirred_near_share, stirred_share,
        stretch_m, swings_m, to_fish_m, to_flow_m,
    )
}  # fmt: skip
"""Every measure by its name, as scenes name it."""
