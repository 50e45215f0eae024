"""A filmed fish made into a species: body, muscles, repertoire, and what is to be said about them."""

from dataclasses import dataclass

from components.body import Body, Swim
from components.repertoire import Pattern, Repertoire, Segment
from tools.capture.capture import Progress, capture
from tools.video.water.beats import bouts
from tools.video.water.body import body_of
from tools.video.water.cycle import Cycle
from tools.video.water.film import Film, FilmError
from tools.video.water.gaits import Cut, gaits_of
from tools.video.water.joining import joined
from tools.video.water.muscles import muscles_for


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
    cuts, cruise = gaits_of(film, bouts(film), body)
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
    return FilmedSpecies(muscles.body, muscles.swim, made, cruise, tuple(_said(cuts, made, cruise)))


def _notes(cuts: list[Cut], source: str) -> dict[str, str]:
    notes: dict[str, str] = {}
    warnings: list[str] = []
    for cut in cuts:
        name = cut.segment.pattern.name.lower()
        notes[name] = cut.figures
        notes[f"{name}_from"] = f"{source}, frames {cut.first} to {cut.stop - 1}"
        warnings += [f"{name}: {fault}" for fault in cut.faults]
    return notes | {"warnings": "; ".join(warnings)}


def _said(cuts: list[Cut], made: Repertoire, cruise: Cycle) -> list[str]:
    filmed = {cut.segment.pattern for cut in cuts}
    others = [s.pattern for s in made.segments if s.pattern not in filmed]
    lines = [f"from the clip: {_words(cut.segment)}, {cut.figures}" for cut in cuts]
    if others:
        lines.append(
            f"from muscles of the same body: {', '.join(p.name.lower().replace('_', ' ') for p in others)}"
        )
    if cruise.assumed:
        lines.append(
            f"assumed: {cruise.speed:.2f} BL/s, for it held station; its tail sweeps .3 of what it swims in a beat"
        )
    lines.append(
        "assumed: how deep the body is, its fins and its tail's span, which a view from above does not show"
    )
    return lines


def _words(segment: Segment) -> str:
    return Pattern(segment.pattern).name.lower().replace("_", " ")
