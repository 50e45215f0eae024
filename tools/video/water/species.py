"""A filmed fish made into a species: body, muscles, repertoire, and what is to be said about them."""

from dataclasses import dataclass
from typing import Final

from components.body import Body, Swim
from components.repertoire import Pattern, Repertoire, Segment
from tools.capture.capture import Progress, capture
from tools.video.water.beats import bouts
from tools.video.water.body import body_of
from tools.video.water.cycle import Cycle
from tools.video.water.film import Film, FilmError
from tools.video.water.gaits import Cut, Gaits, gaits_of
from tools.video.water.joining import joined
from tools.video.water.muscles import muscles_for

_TURNS: Final = {Pattern.TURN_LEFT, Pattern.TURN_SHARP_LEFT}


@dataclass(frozen=True)
class FilmedSpecies:
    """What a film gave."""

    body: Body
    swim: Swim
    "muscles that swim about as the film shows"
    repertoire: Repertoire
    cruise: Cycle
    said: tuple[str, ...]
    "what came from where, and what was assumed, a line each"


def species_of(film: Film, source: str, progress: Progress) -> FilmedSpecies:
    """Return the species of a film; `source` names the clip in its notes.

    Raise FilmError, one line, where the film shows no steady swimming, or its body cannot be made to swim.
    """
    progress(0.0, "beats of the tail")
    body = body_of(film)
    gaits = gaits_of(film, bouts(film), body)
    cuts, cruise = gaits.cuts, gaits.cruise
    progress(0.1, "muscles for this body")
    muscles = muscles_for(body, cruise)
    if muscles is None:
        raise FilmError("no muscles were found that make a body of this shape swim")
    try:
        captured = capture(
            muscles.body, muscles.swim, lambda done, what: progress(0.3 + 0.7 * done, what)
        )
    except (ValueError, ArithmeticError) as error:
        raise FilmError(f"a body of this shape does not swim: {error}") from None
    segments = [cut.segment for cut in cuts]
    notes = _notes(cuts, source)
    made = joined(segments, notes, captured, muscles.body, muscles.swim)
    return FilmedSpecies(muscles.body, muscles.swim, made, cruise, tuple(_said(gaits, made)))


def _notes(cuts: list[Cut], source: str) -> dict[str, str]:
    notes: dict[str, str] = {}
    warnings: list[str] = []
    for cut in cuts:
        name = cut.segment.pattern.name.lower()
        notes[name] = cut.figures
        notes[f"{name}_from"] = f"{source}, frames {cut.first} to {cut.stop - 1}"
        warnings += [f"{name}: {fault}" for fault in cut.faults]
    return notes | {"warnings": "; ".join(warnings)}


def _said(gaits: Gaits, made: Repertoire) -> list[str]:
    cuts, cruise = gaits.cuts, gaits.cruise
    filmed = {cut.segment.pattern for cut in cuts}
    others = [_words(s) for s in made.segments if s.pattern not in filmed]
    lines = [f"from the clip: {_words(cut.segment)}, {cut.figures}" for cut in cuts]
    if others:
        lines.append(
            f"from muscles of the same body, for the clip could not give them: {', '.join(others)}"
        )
    lines += [f"frame {at}: a turn is not taken: {why}" for at, why in _refused(gaits)]
    if cruise.assumed:
        told = "for it held station or a current carried it"
        lines.append(
            f"assumed: {cruise.speed:.2f} BL/s, {told}; its tail sweeps .3 of what it swims in a beat"
        )
    if cruise.assumed and filmed & _TURNS:
        lines.append("assumed: a current that stays the same while the fish turns in it")
    lines.append(
        "assumed: how deep the body is, its fins and its tail's span, which a view from above does not show"
    )
    return lines


def _refused(gaits: Gaits) -> list[tuple[int, str]]:
    """Return the first turn that was not taken, and why, where none was taken at all."""
    if {cut.segment.pattern for cut in gaits.cuts} & _TURNS:
        return []
    return sorted(gaits.refused.items())[:1]


def _words(segment: Segment) -> str:
    return Pattern(segment.pattern).name.lower().replace("_", " ")
