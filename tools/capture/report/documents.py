"""What docs/motion.md shows of the shipped repertoires: its tables in Markdown, its pictures."""

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Final

from components.segment import Pattern, Segment
from tools.capture.report import figures, plots, ranges
from tools.capture.report.measures import (
    SWIMS,
    TURNS,
    SwimMeasures,
    TurnMeasures,
    measure_swim,
    measure_turn,
)
from tools.capture.report.ranges import Range
from tools.capture.report.silhouette import silhouette_of
from tools.capture.report.subject import Subject
from tools.capture.report.svg import Drawing
from tools.capture.report.tables import Cell, fixed, held

_Gears = tuple[SwimMeasures, ...]
_WHOLE: Final = 1040.0
_STRIP: Final = 660.0


def pictures(subjects: Sequence[Subject]) -> dict[str, str]:
    """Return the page's pictures, SVG, by the names of their files; `subjects` holds sardine and parrotfish."""
    named = {subject.name: subject for subject in subjects}
    sardine, parrotfish = named["sardine"], named["parrotfish"]
    drawings = {
        "motion_nine.svg": (_nine(subjects), "nine species swimming, from above"),
        "motion_swim.svg": (_moments(sardine, Pattern.SWIM_MEDIUM, 8), "a sardine's beat"),
        "motion_wave.svg": (_wave(sardine), "a sardine's envelope and wave"),
        "motion_sharp_turn.svg": (
            _turn(parrotfish, Pattern.TURN_SHARP_LEFT, False),
            "a parrotfish turning sharply",
        ),
        "motion_fast_start.svg": (
            _turn(sardine, Pattern.FAST_START_LEFT, True),
            "a sardine's fast start",
        ),
    }
    return {name: drawing.svg(label) for name, (drawing, label) in drawings.items()}


def tables(subjects: Sequence[Subject]) -> dict[str, str]:
    """Return the page's tables, Markdown, by the names of their marks."""
    swims = {s.title: _gears(s) for s in subjects}
    turns = {s.title: _turns(s) for s in subjects}
    return {
        "swims": _swims(subjects, swims),
        "turns": _turn_table(subjects, turns),
        "living": _living(subjects, swims, turns),
    }


def rewritten(text: str, made: Mapping[str, str]) -> str:
    """Return a page with every table between `<!-- NAME -->` and `<!-- end -->` made anew."""
    for name, table in made.items():
        pattern = rf"(<!-- {name} -->\n).*?(<!-- end -->)"
        text, found = re.subn(pattern, rf"\g<1>\n{table}\n\n\g<2>", text, flags=re.DOTALL)
        if found != 1:
            raise ValueError(f"the page has {found} places for the table {name}")
    return text


def _gears(subject: Subject) -> _Gears:
    drawn = silhouette_of(subject.body)
    found = (measure_swim(subject, drawn, pattern) for pattern in SWIMS)
    return tuple(m for m in found if m is not None)


def _turns(subject: Subject) -> dict[Pattern, TurnMeasures]:
    found = {p: measure_turn(subject, p) for p in (*TURNS, Pattern.FAST_START_LEFT)}
    return {p: m for p, m in found.items() if m is not None}


def _segment(subject: Subject, pattern: Pattern) -> Segment:
    return next(s for s in subject.repertoire.segments if s.pattern == pattern)


def _sheet(width: float, height: float) -> Drawing:
    """Return a white sheet: pages may lie on a dark ground."""
    sheet = Drawing(width, height)
    sheet.box(0, 0, width, height, "fill='#fff'")
    return sheet


def _nine(subjects: Sequence[Subject]) -> Drawing:
    strips = [
        figures.beats(silhouette_of(s.body), _segment(s, Pattern.SWIM_MEDIUM)) for s in subjects
    ]
    sheet = _sheet(_WHOLE, sum(strip.height + 18.0 for strip in strips))
    y = 0.0
    for subject, strip in zip(subjects, strips, strict=True):
        sheet.text(2, y + 12, subject.title, "font-weight='600'")
        sheet.place(strip, 0, y + 16)
        y += strip.height + 18.0
    return sheet


def _moments(subject: Subject, pattern: Pattern, count: int) -> Drawing:
    drawn = silhouette_of(subject.body)
    panels = figures.moments(drawn, _segment(subject, pattern), count, 4)
    sheet = _sheet(panels.width, panels.height)
    sheet.place(panels, 0, 0)
    return sheet


def _wave(subject: Subject) -> Drawing:
    drawn = silhouette_of(subject.body)
    envelope = plots.envelope(_gears(subject))
    sheet = _sheet(_WHOLE, envelope.height)
    sheet.place(envelope, 0, 0)
    waves = plots.midlines(drawn, _segment(subject, Pattern.SWIM_MEDIUM))
    sheet.place(waves, _WHOLE - waves.width, 0)
    return sheet


def _turn(subject: Subject, pattern: Pattern, started: bool) -> Drawing:
    segment = _segment(subject, pattern)
    way = figures.way(silhouette_of(subject.body), segment, 6, 560.0)
    curve = plots.heading([("", "#1f6f9f", segment)], started)
    sheet = _sheet(_WHOLE, max(way.height, curve.height))
    sheet.place(way, 0, 0)
    sheet.place(curve, _WHOLE - curve.width, 0)
    return sheet


def _marked(cell: Cell) -> str:
    return f"**{cell.text}**" if cell.fits is False else cell.text


def _lines(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    cells = [list(head), ["---"] * len(head), *map(list, rows)]
    return "\n".join(f"| {' | '.join(line)} |".replace("|  |", "| |") for line in cells)


def _swims(subjects: Sequence[Subject], swims: Mapping[str, _Gears]) -> str:
    rows = []
    for subject in subjects:
        gears = swims[subject.title]
        medium = gears[1]
        rows.append(
            [
                subject.title,
                _speeds(subject.length, gears),
                ", ".join(fixed(g.frequency, 2) for g in gears),
                ", ".join(_marked(held(g.sweep, 3, ranges.SWEEP)) for g in gears),
                ", ".join(_marked(held(g.strouhal, 3, ranges.STROUHAL)) for g in gears),
                _marked(held(medium.head, 2, ranges.HEAD)),
                _marked(held(medium.stride, 2, ranges.STRIDE)),
                _marked(held(medium.wavelength, 2, ranges.WAVELENGTH)),
            ]
        )
    head = ["", "speed, BL/s", "frequency, Hz", "tail sweep, BL", "Strouhal"]
    return _lines([*head, "head over tail", "stride, BL", "wavelength, BL"], rows)


def _speeds(length: float, gears: _Gears) -> str:
    known = ranges.cruise(length)
    cruise = Cell(fixed(gears[1].speed, 2))
    if known is not None:
        cruise = Cell(cruise.text, known[0].holds(gears[1].speed * known[1]))
    fast = held(gears[2].speed, 2, ranges.SUSTAINED)
    return ", ".join((fixed(gears[0].speed, 2), _marked(cruise), _marked(fast)))


def _turn_table(
    subjects: Sequence[Subject], turns: Mapping[str, Mapping[Pattern, TurnMeasures]]
) -> str:
    rows = []
    for subject in subjects:
        made = turns[subject.title]
        cells = [subject.title]
        for pattern in TURNS:
            against = ranges.turn(pattern, subject.length)
            cells += _turned(made.get(pattern), against, pattern == Pattern.TURN_SHARP_LEFT)
        start = made.get(Pattern.FAST_START_LEFT)
        cells += _turned(start, ranges.START_NET, True)[::2] if start else ["none", ""]
        rows.append([*cells, *_first_stroke(start)])
    head = ["", "gradual", "within, s", "sharp", "within, s", "joint", "fast start at 1 s", "joint"]
    return _lines([*head, "its first stroke"], rows)


def _turned(made: TurnMeasures | None, against: Range, joint: bool) -> list[str]:
    if made is None:
        return ["none", "", ""][: 2 + joint]
    cells = [_marked(held(made.net, 0, against)), fixed(made.seconds, 2)]
    return [*cells, _marked(held(made.joint, 0, ranges.JOINT))] if joint else cells


def _first_stroke(made: TurnMeasures | None) -> list[str]:
    if made is None:
        return [""]
    seconds, angle = made.first_stroke
    time = held(1000.0 * seconds, 0, ranges.STAGE_ONE_TIME, " ms")
    return [f"{_marked(held(angle, 0, ranges.STAGE_ONE_ANGLE))} in {_marked(time)}"]


def _living(
    subjects: Sequence[Subject],
    swims: Mapping[str, _Gears],
    turns: Mapping[str, Mapping[Pattern, TurnMeasures]],
) -> str:
    """Return what living fishes do, what the species span, and who falls outside."""

    def of_medium(value: Callable[[SwimMeasures], float]) -> dict[str, float]:
        return {title: value(gears[1]) for title, gears in swims.items()}

    starts = {
        t: m[Pattern.FAST_START_LEFT] for t, m in turns.items() if Pattern.FAST_START_LEFT in m
    }
    small = [s.title for s in subjects if s.length <= ranges.SMALL_LENGTH]
    sharks = {s.title: s.length for s in subjects if s.length >= ranges.SHARK_LENGTH}
    speed = of_medium(lambda m: m.speed)
    rows = [
        _span("cruise of small fishes, BL/s", ranges.cruise(0.1), {t: speed[t] for t in small}, 2),
        _span("cruise of reef sharks, m/s", ranges.cruise(1.5), _scaled(speed, sharks), 2),
        _span("Strouhal number", ranges.STROUHAL, of_medium(lambda m: m.strouhal), 2),
        _span("sweep of the tail, BL", ranges.SWEEP, of_medium(lambda m: m.sweep), 3),
        _span("head's sweep over the tail's", ranges.HEAD, of_medium(lambda m: m.head), 2),
        _span("stride, BL a beat", ranges.STRIDE, of_medium(lambda m: m.stride), 2),
        _span("wavelength, BL", ranges.WAVELENGTH, of_medium(lambda m: m.wavelength), 2),
        _span(
            "C-start: first stroke, ms",
            ranges.STAGE_ONE_TIME,
            {t: 1000.0 * m.first_stroke[0] for t, m in starts.items()},
            0,
        ),
        _span(
            "C-start: first stroke, degrees",
            ranges.STAGE_ONE_ANGLE,
            {t: m.first_stroke[1] for t, m in starts.items()},
            0,
        ),
    ]
    return _lines(["", "living fishes", "ours, medium swim", "outside"], rows)


def _scaled(values: Mapping[str, float], lengths: Mapping[str, float]) -> dict[str, float]:
    return {title: values[title] * length for title, length in lengths.items()}


def _span(
    name: str,
    against: Range | tuple[Range, float] | None,
    values: Mapping[str, float],
    digits: int,
) -> list[str]:
    known = against[0] if isinstance(against, tuple) else against
    if known is None or not values:
        return [name, "", "", ""]
    low, high = fixed(min(values.values()), digits), fixed(max(values.values()), digits)
    out = [title.lower() for title, value in values.items() if not known.holds(value)]
    told = "all" if len(out) == len(values) else ", ".join(out)
    return [
        name,
        f"{known.text()} ({known.source})",
        low if low == high else f"{low} to {high}",
        told or "none",
    ]
