"""Synthetic motion capture: a species' repertoire from its body and swim (papers/000, section 4; FINDINGS 1, 1b).

Three beats, slow, medium and fast; a gradual and a sharp turn to the left out of medium cruise, at whose end the fish
cruises again in the beat's phase; and a fast start from rest. Turns to the right are mirrored as repertoires are
packed. Everything that reaches the file is + - * / sqrt, so a capture writes the same bytes on every machine.
"""

import hashlib
from collections.abc import Callable, Iterator
from dataclasses import astuple
from math import floor
from pathlib import Path
from typing import Final

import numpy as np

import components.trigonometry
import systems.motor.biomechanics
import systems.motor.body_frame
import systems.motor.contract
import systems.motor.controllers
import systems.motor.muscle_model
import systems.motor.pectorals
import tools.capture.bend
import tools.capture.cut
import tools.capture.escape
import tools.capture.phase
import tools.capture.record
import tools.capture.rotation
import tools.capture.turns
from components.body import Body, Swim
from components.clock import TICKS_PER_SECOND
from components.repertoire import Pattern, Repertoire, Segment
from systems.motor import controllers
from systems.motor.biomechanics import SUBSTEPS
from systems.motor.contract import TWO_PI, Stroke
from systems.motor.muscle_model import BodyModel, body_model
from tools.capture.cut import beat_start, cut
from tools.capture.escape import fast_start
from tools.capture.faults import check, suspect
from tools.capture.measure import measure_swim
from tools.capture.phase import Gear, begun, phase_notes
from tools.capture.record import BlewUpError, Recording, record
from tools.capture.turns import Found, gradual_turn, sharp_turn

Progress = Callable[[float, str], None]
"""Told how far the work is, 0 to 1, and what is being done."""

GEARS: Final[dict[Pattern, Gear]] = {
    Pattern.SWIM_SLOW: (0.75, 0.6),
    Pattern.SWIM_MEDIUM: (1.0, 1.0),
    Pattern.SWIM_FAST: (1.0, 1.6),
}
"""Amplitude and frequency of each gear, over the cruise's."""

SETTLE_FRAMES: Final = 16 * TICKS_PER_SECOND
"""How long a beat runs before it is cut."""

_PHASE_RUNS: Final = 3
_SOURCES: Final = (
    components.trigonometry,
    systems.motor.biomechanics,
    systems.motor.body_frame,
    systems.motor.contract,
    systems.motor.controllers,
    systems.motor.muscle_model,
    systems.motor.pectorals,
    tools.capture.bend,
    tools.capture.cut,
    tools.capture.escape,
    tools.capture.phase,
    tools.capture.record,
    tools.capture.rotation,
    tools.capture.turns,
)


def capture(body: Body, swim: Swim, progress: Progress | None = None) -> Repertoire:
    """Return the repertoire of a species. Raise ValueError, one line, where the body does not swim at all.

    The provenance holds the fingerprint, each segment's figures and muscle phase (tools/capture/phase.py), and under
    "warnings" what is unlike a living fish.
    """
    check(body, swim)
    try:
        return _repertoire(body, swim, progress)
    except BlewUpError as error:
        raise ValueError(f"{error}: {suspect(body, swim, error.frame + 1)}") from None


def _repertoire(body: Body, swim: Swim, progress: Progress | None) -> Repertoire:
    segments: list[Segment] = []
    notes: dict[str, str] = {}
    warnings: list[str] = []
    stages = len(GEARS) + 3
    for stage, (found, gear) in enumerate(_segments(body, swim)):
        name = found.segment.pattern.name.lower()
        segments.append(found.segment)
        notes[name] = found.figures
        notes |= phase_notes(name, found.stroke, gear)
        warnings += [f"{name}: {fault}" for fault in found.faults]
        if progress is not None:
            progress((stage + 1) / stages, name.replace("_", " "))
    notes["fingerprint"] = fingerprint(body, swim)
    notes["warnings"] = "; ".join(warnings)
    return Repertoire(tuple(segments), notes)


def fingerprint(body: Body, swim: Swim) -> str:
    """Return 32 hex digits that change with what shapes motion: the model's numbers, the swim, the kernels' sources.

    Fins and pectorals of `body` leave it as it is.
    """
    digest = hashlib.blake2b(digest_size=16)
    for numbers in body_model(body, swim):
        digest.update(numbers.astype("<f8").tobytes())
    digest.update(np.array(astuple(swim), "<f8").tobytes())
    for source in (__file__, *(str(module.__file__) for module in _SOURCES)):
        digest.update(Path(source).read_bytes().replace(b"\r\n", b"\n"))
    return digest.hexdigest()


def _segments(body: Body, swim: Swim) -> Iterator[tuple[Found, Gear]]:
    """Yield each segment, and the gear that it is swum in or goes over into."""
    model = body_model(body, swim)
    ready: dict[Pattern, tuple[Stroke, int, Segment]] = {}
    for pattern, gear in GEARS.items():
        stroke, first, recording = _in_phase(model, controllers.swim(swim, *gear))
        segment = cut(recording, pattern, first, stroke.period // SUBSTEPS, True)
        ready[pattern] = stroke, first, segment
        figures = measure_swim(recording, segment, first)
        yield Found(segment, figures.text(), figures.faults(), begun(stroke, first + 1)), gear
    (cruise, first, _), gear = ready[Pattern.SWIM_MEDIUM], GEARS[Pattern.SWIM_MEDIUM]
    yield gradual_turn(model, cruise, first), gear
    yield sharp_turn(model, cruise, first), gear
    (fast, _, beat), gear = ready[Pattern.SWIM_FAST], GEARS[Pattern.SWIM_FAST]
    yield fast_start(body_model(body, swim, "firm"), fast, beat), gear


def _in_phase(model: BodyModel, stroke: Stroke) -> tuple[Stroke, int, Recording]:
    """Return the stroke shifted so that a frame falls where the yaw crosses the course, that frame, and the run."""
    period = stroke.period // SUBSTEPS
    frames = SETTLE_FRAMES + 2 * period + 3
    for _ in range(_PHASE_RUNS):
        recording = record(model, stroke, frames)
        crossing = beat_start(recording, period)
        first = floor(crossing + 0.5)
        stroke = stroke._replace(offset=stroke.offset + (crossing - first) * TWO_PI / period)
    recording = record(model, stroke, frames)
    return stroke, floor(beat_start(recording, period) + 0.5), recording
