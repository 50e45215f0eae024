"""What the muscles do at a segment's first entry, kept as text beside its figures (papers/000, 9.1).

Live physics takes a fish over from replay in the right phase of its stroke by these notes, and by them alone. For a
segment NAME, in lower case, whose entry k leads from frame k to frame k + 1:

    NAME_phase    [rad] offset of the stroke whose frame 0 is entry 0
    NAME_gear     amplitude and pace, over the cruise's
    NAME_scale    of the pulses of a turn, which begins at substep 0
    NAME_loops    JSON, (3, 13): the fast start's contractions, from substep 0; in water of the law "firm"
    NAME_swim_at  [substeps] when the swim ramps in after a fast start

Numbers are written so that reading them gives the same bits. Every swim here is past its ramp, but for a fast start's.
"""

import json

from systems.motor.biomechanics import SUBSTEPS
from systems.motor.contract import TWO_PI, Stroke

Gear = tuple[float, float]
"""Amplitude and frequency over the cruise's."""


def begun(stroke: Stroke, frame: int) -> Stroke:
    """Return `stroke` as counted from `frame` on: frame 0 of what is returned does what `frame` did."""
    ahead = SUBSTEPS * frame
    return stroke._replace(turn_at=stroke.turn_at - ahead, swim_at=stroke.swim_at - ahead)


def phase_notes(name: str, stroke: Stroke, gear: Gear) -> dict[str, str]:
    """Return the notes on the segment `name`, whose first entry begins `stroke`, a swim in `gear`."""
    swum = max(0, -stroke.swim_at) % stroke.period / stroke.period
    notes = {
        f"{name}_phase": repr((stroke.offset + TWO_PI * swum) % TWO_PI),
        f"{name}_gear": f"{gear[0]!r} {gear[1]!r}",
    }
    if stroke.turn != 0.0:
        notes[f"{name}_scale"] = repr(float(stroke.turn))
    if stroke.flight != 0.0:
        notes[f"{name}_loops"] = json.dumps((stroke.flight * stroke.loops).tolist())
        notes[f"{name}_swim_at"] = str(stroke.swim_at)
    return notes
