"""One species in a report: its figures, its plots, its tables."""

from collections.abc import Iterable
from html import escape
from typing import Final

from components.body import rest_nodes
from components.segment import Pattern, Segment
from tools.capture.report import figures, plots
from tools.capture.report.markup import figure, table
from tools.capture.report.measures import (
    SWIMS,
    TURNS,
    SwimMeasures,
    TurnMeasures,
    measure_swim,
    measure_turn,
)
from tools.capture.report.silhouette import Silhouette, silhouette_of
from tools.capture.report.subject import Subject
from tools.capture.report.tables import Cell, swim_rows, turn_rows

TITLES: Final = {
    Pattern.SWIM_SLOW: "Slow swim",
    Pattern.SWIM_MEDIUM: "Medium swim",
    Pattern.SWIM_FAST: "Fast swim",
    Pattern.TURN_LEFT: "Gradual turn",
    Pattern.TURN_SHARP_LEFT: "Sharp turn",
    Pattern.FAST_START_LEFT: "Fast start from rest",
}
_LINE: Final = "#1f6f9f"
_SWIM_PANELS: Final = (8, 4)
_TURN_PANELS: Final = (12, 4)
_GRADUAL_PANELS: Final = (9, 3)
_BY_WAY: Final = 560.0


class Section:
    """One species with everything measured."""

    def __init__(self, subject: Subject) -> None:
        self.subject = subject
        self.drawn: Silhouette = silhouette_of(subject.body)
        swims = [(p, measure_swim(subject, self.drawn, p)) for p in SWIMS]
        self.swims: list[tuple[Pattern, SwimMeasures]] = [(p, m) for p, m in swims if m is not None]
        turns = [(p, measure_turn(subject, p)) for p in (*TURNS, Pattern.FAST_START_LEFT)]
        self.turns: list[tuple[Pattern, TurnMeasures]] = [(p, m) for p, m in turns if m is not None]
        gears = [m for _, m in self.swims]
        self.swim_rows = swim_rows(subject.length, gears)
        self.turn_rows = turn_rows(subject.length, self.turns)

    def cells(self) -> list[Cell]:
        """Return every figure of the species' tables that is held against a range."""
        rows = (*self.swim_rows, *self.turn_rows)
        return [cell for row in rows for cell in row.cells if cell.fits is not None]

    def html(self) -> str:
        """Return the species' part of the page."""
        subject = self.subject
        warnings = "".join(f"<li>{escape(w)}</li>" for w in subject.warnings())
        told = (
            f"<ul class='warnings'>{warnings}</ul>"
            if warnings
            else "<p>The capture warned of nothing.</p>"
        )
        names = [TITLES[p].removesuffix(" swim") for p, _ in self.swims]
        turns = [TITLES[p].removesuffix(" from rest") for p, _ in self.turns]
        return "\n".join(
            [
                f"<section id='{escape(subject.name, quote=True)}'>",
                self._head(),
                "<h3>Swimming</h3>",
                table("", names, self.swim_rows),
                self._swim_plots(),
                *(self._swim(p) for p, _ in self.swims),
                "<h3>Turning</h3>",
                table("", turns, self.turn_rows),
                *(self._turn(p) for p, _ in self.turns),
                f"<h3>Warnings</h3>{told}",
                "</section>",
            ]
        )

    def _head(self) -> str:
        subject = self.subject
        picture = figures.portrait(self.drawn, rest_nodes(subject.body))
        entries = sum(len(s.translation) for s in subject.repertoire.segments)
        size = f"{100.0 * subject.length:g} cm"
        fit = [cell.fits for cell in self.cells()]
        return (
            f"<header class='species'><div><h2>{escape(subject.title)}</h2>"
            f"<p>{size}, {len(subject.repertoire.segments)} segments, {entries} entries of 1/60 s. "
            f"{fit.count(True)} of {len(fit)} figures lie where living fishes have theirs.</p>"
            "<p class='caption'>White dots: the 23 nodes of the muscle model in the skin that follows them.</p></div>"
            f"{picture.svg(f'{subject.title} from the side')}</header>"
        )

    def _swim_plots(self) -> str:
        medium = self.subject.segment(Pattern.SWIM_MEDIUM)
        if medium is None:
            return ""
        made = [m for _, m in self.swims]
        return figure(
            [
                plots.envelope(made).svg("half amplitude along the body, against a living fish's"),
                plots.midlines(self.drawn, medium).svg(
                    "centre lines of a beat, one below the other"
                ),
                plots.overlaid(self.drawn, medium).svg("centre lines of a beat over each other"),
            ],
            "Left: half of what each point of the body sweeps; dashed, the envelope .02 - .0825 s + .1625 s² of "
            "carangiform swimmers. Right: centre lines of a beat and a quarter, seen from above; the dots, where they "
            "cross the course, wander rearwards with the wave. Below: the same lines over each other; colours run "
            "once through the beat.",
        )

    def _swim(self, pattern: Pattern) -> str:
        segment = self._segment(pattern)
        return f"<h4>{TITLES[pattern]}</h4>" + figure(
            [
                figures.beats(self.drawn, segment).svg(f"{TITLES[pattern]} along its path"),
                figures.moments(self.drawn, segment, *_SWIM_PANELS).svg(
                    f"{TITLES[pattern]}, a beat"
                ),
                *self._beside(pattern),
            ],
            "Above: what tail (green) and nose (dotted) write into the water. Below: a beat from above; red, the way "
            "of the centre; dark arrows the anterior, light ones the lateral axis so far, as in Fig. 3 of papers/000.",
        )

    def _turn(self, pattern: Pattern) -> str:
        segment = self._segment(pattern)
        started = pattern == Pattern.FAST_START_LEFT
        curve = [(TITLES[pattern], _LINE, segment)]
        panels = _GRADUAL_PANELS if pattern == Pattern.TURN_LEFT else _TURN_PANELS
        title = TITLES[pattern]
        return f"<h4>{title}</h4>" + figure(
            [
                "<div class='pair'>"
                + figures.way(self.drawn, segment, 6, _BY_WAY).svg(f"{title} along its path")
                + "<div>"
                + plots.heading(curve, started).svg(f"{title}: heading against time")
                + plots.pace(curve).svg(f"{title}: speed against time")
                + "</div></div>",
                figures.moments(self.drawn, segment, *panels).svg(f"{title}, moments"),
                *self._beside(pattern),
            ],
            "Six moments over each other from first (blue) to last (green), the way of the centre (red) and of the "
            "nose (dotted); the head's own heading, which swings with the beat and so ends a little off the net turn; "
            "single moments, as in Fig. 4 of papers/000. Turns to the right are its mirror image.",
        )

    def _beside(self, pattern: Pattern) -> Iterable[str]:
        """Return the view from the side where the fish pitches."""
        swims = [m.pitch for p, m in self.swims if p == pattern]
        turns = [m.pitch for p, m in self.turns if p == pattern]
        if max(swims + turns) < figures.PITCH_SHOWN:
            return []
        drawn = figures.beside(self.drawn, self._segment(pattern))
        return [drawn.svg(f"{TITLES[pattern]} from the side")]

    def _segment(self, pattern: Pattern) -> Segment:
        return next(s for s in self.subject.repertoire.segments if s.pattern == pattern)
