"""Strokes: what the muscles did while each segment of the library was captured, so that live physics goes on in phase
(papers/000, 3.2 and 9.1).

Capture notes in a repertoire the phase, gear, scale and loops of each segment (`NAME_phase` ... in its provenance).
Entry k of a segment is frame k of its stroke. A segment without notes has no stroke: its fishes replay.
"""

import json
from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any, Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s, Int64s
from components.repertoire import Pattern, RepertoireLibrary
from components.segment import MIRROR_IMAGES
from components.species import Species
from systems.motor.contract import FAST_START, TWO_PI, Stroke
from systems.motor.controllers import balance, swim
from systems.motor.muscle_model import LAWS, BodyModel, body_model

LEFT_OF: Final = {right: left for left, right in MIRROR_IMAGES}
"""The captured segment that each mirrored one stands on."""

RAMPED: Final = 120
"""[substeps] after which a swim has its full contractions."""

MOST_KNOTS: Final = 64
"""Of a fast start's loops."""


_NUMBERS: Final = ("middle", "rear", "lag", "offset", "turn", "flight")
_SUBSTEPS: Final = ("period", "swim_at")
_BODY: Final = ("mass", "length", "stiffness", "damping", "start")


class Strokes(NamedTuple):
    """Strokes of S segments and bodies of the species, as the kernels of live physics read them."""

    known: Int8s
    "1 where the segment has a stroke, (S,)"
    middle: Float64s
    "as in `Stroke`, and so are the next, (S,)"
    rear: Float64s
    lag: Float64s
    period: Int64s
    offset: Float64s
    turn: Float64s
    flight: Float64s
    swim_at: Int64s
    loops: Float64s
    "(S, 3, knots)"
    water: Float64s
    "law of the water in which the segment was captured, (S, 3)"
    mass: Float64s
    "as in `BodyModel`, and so are the next, (species, 23)"
    length: Float64s
    "(species, 91)"
    stiffness: Float64s
    damping: Float64s
    start: Float64s
    "(species, 23, 3)"


def strokes(species: Sequence[Species], library: RepertoireLibrary) -> Strokes:
    """Return the strokes of the library's segments, of species in the order of its rows."""
    count = len(library.start)
    found: dict[int, Stroke] = {}
    for one, kind in enumerate(species):
        for pattern in Pattern:
            stroke = stroke_of(kind, pattern) if library.segment[one, pattern] >= 0 else None
            if stroke is not None:
                found[int(library.segment[one, pattern])] = stroke
    models = [body_model(kind.body, kind.swim) for kind in species]
    return _packed(count, found, models)


def stroke_of(species: Species, pattern: Pattern) -> Stroke | None:
    """Return the stroke by which a segment was captured, None where the repertoire does not tell."""
    notes = species.repertoire.provenance
    left = LEFT_OF.get(pattern, pattern)
    name = left.name.lower()
    phase, gear = _numbers(notes, f"{name}_phase"), _numbers(notes, f"{name}_gear")
    if len(phase) != 1 or len(gear) != 2 or min(gear) <= 0.0:
        return None
    stroke = balance(swim(species.swim, *gear))
    ramped = -stroke.period * -(-RAMPED // stroke.period)
    stroke = stroke._replace(offset=phase[0], swim_at=ramped)
    if left in (Pattern.TURN_LEFT, Pattern.TURN_SHARP_LEFT):
        scale = _numbers(notes, f"{name}_scale")
        return _mirrored(stroke._replace(turn=scale[0]), pattern) if len(scale) == 1 else None
    if left is Pattern.FAST_START_LEFT:
        loops, begin = _loops(notes), _numbers(notes, f"{name}_swim_at")
        if loops is None or len(begin) != 1:
            return None
        stroke = stroke._replace(flight=1.0, loops=loops, swim_at=int(begin[0]))
    return _mirrored(stroke, pattern)


def _mirrored(stroke: Stroke, pattern: Pattern) -> Stroke:
    """Return the stroke, mirrored where `pattern` is the mirror image of a captured one."""
    if pattern not in LEFT_OF:
        return stroke
    half = stroke.offset + 0.5 * TWO_PI
    return stroke._replace(offset=half, turn=-stroke.turn, flight=-stroke.flight)


def _numbers(notes: Mapping[str, str], key: str) -> list[float]:
    """Return the finite numbers of a note, none where it is missing or holds anything else."""
    try:
        numbers = [float(word) for word in notes.get(key, "").split()]
    except ValueError:
        return []
    return numbers if all(isfinite(n) for n in numbers) else []


def _loops(notes: Mapping[str, str]) -> Float64s | None:
    """Return the contractions of a fast start, (3, knots), None where the note is missing or no such table."""
    try:
        loops = np.array(json.loads(notes.get("fast_start_left_loops", "0")), np.float64)
    except (ValueError, TypeError):
        return None
    fits = loops.ndim == 2 and loops.shape[0] == 3 and 2 <= loops.shape[1] <= MOST_KNOTS
    return loops if fits and bool(np.abs(loops).max() <= 1.0) else None


def _packed(count: int, found: Mapping[int, Stroke], models: Sequence[BodyModel]) -> Strokes:
    knots = max((s.loops.shape[1] for s in found.values()), default=FAST_START.shape[1])
    columns: dict[str, Any] = {name: np.zeros(count) for name in _NUMBERS}
    columns |= {name: np.ones(count, np.int64) for name in _SUBSTEPS}
    known, loops = np.zeros(count, np.int8), np.zeros((count, 3, knots))
    water = np.tile(LAWS["streamlined"], (count, 1))
    for segment, stroke in found.items():
        known[segment] = 1
        for name, column in columns.items():
            column[segment] = getattr(stroke, name)
        if stroke.flight != 0.0:
            loops[segment, :, : stroke.loops.shape[1]] = stroke.loops
            water[segment] = LAWS["firm"]
    for name in _BODY:
        columns[name] = np.stack([getattr(model, name) for model in models])
    return Strokes(known=known, loops=loops, water=water, **columns)
