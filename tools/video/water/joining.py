"""Filmed segments among those that muscles swim with the same body: one repertoire (papers/000, 4; FINDINGS 4).

A repertoire that holds filmed segments says so in its provenance, under "filmed": their names. They do not go stale as
kernels change. Where the species' file was changed since, they are fitted to the body as it is now, and all else is
captured anew (reefgame/content/repertoires.py).
"""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import astuple, replace
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.body import NODE_HEIGHT, RINGS, Body, Swim, rest_nodes
from components.repertoire import Pattern, Repertoire, Segment, mean_speed

FILMED: Final = "filmed"
"""Note of the names of filmed segments, with a space between two."""

FILMED_WITH: Final = "filmed_with"
"""Note of the print of body and swim that all segments of the file serve."""

FILMED_AT: Final = "filmed_at"
"""Note of the five stations of the body that filmed segments were made for [BL]."""

FILMED_PACE: Final = "filmed_pace"
"""Note of what the strides of all other segments were scaled by."""

_CORNERS: Final = ((1, -1), (1, 1), (-1, 1), (-1, -1))
"""Up and right of a ring's nodes, in ring order."""


def is_filmed(repertoire: Repertoire) -> bool:
    """Return whether a repertoire holds filmed segments."""
    return bool(repertoire.provenance.get(FILMED))


def fits(repertoire: Repertoire, body: Body, swim: Swim) -> bool:
    """Return whether a filmed repertoire serves body and swim as it is."""
    return repertoire.provenance.get(FILMED_WITH) == print_of(body, swim)


def print_of(body: Body, swim: Swim) -> str:
    """Return 32 hex digits that change with body, stiffness and swim, but with no kernel."""
    digest = hashlib.blake2b(rest_nodes(body).astype("<f8").tobytes(), digest_size=16)
    digest.update(np.array([body.stiffness, *astuple(swim)], "<f8").tobytes())
    return digest.hexdigest()


def joined(
    filmed: Sequence[Segment], notes: dict[str, str], captured: Repertoire, body: Body, swim: Swim
) -> Repertoire:
    """Return a captured repertoire with filmed segments in place of its own.

    `notes` tell of these; under "warnings" what is unlike a living fish, each with the segment's name before it.
    Muscles rarely come to the filmed speed exactly: their strides are scaled by what they miss at cruise, so that
    gears keep their order.
    """
    ours = {segment.pattern: segment for segment in filmed}
    theirs = {segment.pattern: segment for segment in captured.segments}
    pace = 1.0
    if Pattern.SWIM_MEDIUM in ours:
        pace = mean_speed(ours[Pattern.SWIM_MEDIUM]) / mean_speed(theirs[Pattern.SWIM_MEDIUM])
    whole = {
        p: replace(s, translation=pace * s.translation, control=None) for p, s in theirs.items()
    }
    whole |= ours
    names = {pattern.name.lower() for pattern in ours}
    told = {k: v for k, v in captured.provenance.items() if not _about(k, names)}
    told |= notes | {
        "warnings": "; ".join(_warnings(captured, names, False) + _warnings_in(notes)),
        FILMED: " ".join(sorted(names)),
        FILMED_WITH: print_of(body, swim),
        FILMED_AT: " ".join(repr(at) for at in body.station),
        FILMED_PACE: repr(pace),
    }
    return Repertoire(tuple(whole[p] for p in sorted(whole)), told)


def _warnings_in(notes: Mapping[str, str]) -> list[str]:
    return [warning for warning in notes.get("warnings", "").split("; ") if warning]


def _warnings(repertoire: Repertoire, names: set[str], wanted: bool) -> list[str]:
    """Return the warnings about segments that are, or are not, among `names`."""
    every = _warnings_in(repertoire.provenance)
    return [one for one in every if (one.partition(":")[0] in names) is wanted]


def _about(key: str, names: set[str]) -> bool:
    """Return whether a note of a captured repertoire is about one of some segments, or no longer true."""
    return key == "fingerprint" or any(key == name or key.startswith(f"{name}_") for name in names)


def rejoined(old: Repertoire, captured: Repertoire, body: Body, swim: Swim) -> Repertoire:
    """Return the filmed segments of `old`, fitted to a body that was changed since, among captured ones.

    Raise ValueError where the notes of `old` are damaged.
    """
    names = set(old.provenance[FILMED].split())
    stations = [float(at) for at in old.provenance.get(FILMED_AT, "").split()]
    if len(stations) != RINGS:
        raise ValueError(f"the note {FILMED_AT} holds no {RINGS} stations")
    filmed = [refitted(s, stations, body) for s in old.segments if s.pattern.name.lower() in names]
    notes = {key: text for key, text in old.provenance.items() if _about(key, names)}
    notes["warnings"] = "; ".join(_warnings(old, names, True))
    return joined(filmed, notes, captured, body, swim)


def refitted(segment: Segment, stations: Sequence[float], body: Body) -> Segment:
    """Return a filmed segment, its rings at `stations`, with another body's rings and tail along the same axis.

    Body axes stay those in which the segment was cut.
    """
    shape = segment.shape.astype(np.float64)
    rings = shape[:, 1:21].reshape(len(shape), RINGS, 4, 3)
    tail = shape[:, 21:].mean(axis=1, keepdims=True)
    middles = np.concatenate((shape[:, :1], rings.mean(axis=2), tail), axis=1)
    sides = rings[:, :, (1, 2)].mean(axis=2) - rings[:, :, (0, 3)].mean(axis=2)
    made = shape.copy()
    for ring, at in enumerate(body.station):
        middle = _between(middles, (0.0, *stations, 1.0), at)
        side = _between(sides, stations, at)
        right = body.half_width[ring] * side / np.sqrt((side**2).sum(axis=1))[:, None]
        up = np.array([0.0, NODE_HEIGHT * body.half_height[ring], 0.0])
        for node, (high, out) in enumerate(_CORNERS, start=1 + 4 * ring):
            made[:, node] = middle + high * up + out * right
    made[:, 21, 1], made[:, 22, 1] = body.tail_span, -body.tail_span
    return replace(segment, shape=made.astype(np.float32), control=None)


def _between(values: Float64s, places: Sequence[float], at: float) -> Float64s:
    """Return values (n, places, 3) at a place between two of `places`, the first's or last's beyond them, (n, 3)."""
    after = min(max(int(np.searchsorted(places, at)), 1), len(places) - 1)
    part = (at - places[after - 1]) / (places[after] - places[after - 1])
    part = min(max(part, 0.0), 1.0)
    found: Float64s = (1.0 - part) * values[:, after - 1] + part * values[:, after]
    return found
