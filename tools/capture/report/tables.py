"""Tables of ours against living fishes: the same cells for the page and for the documentation."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from components.segment import Pattern
from tools.capture.report import ranges
from tools.capture.report.measures import SwimMeasures, TurnMeasures
from tools.capture.report.ranges import Range, short


@dataclass(frozen=True)
class Cell:
    """A figure and whether it lies where living fishes have theirs; None where nothing is known to hold it against."""

    text: str
    fits: bool | None = None


@dataclass(frozen=True)
class Row:
    """A line of a table: what, what living fishes do, our figures."""

    name: str
    living: str
    cells: tuple[Cell, ...]


def fixed(value: float, digits: int) -> str:
    """Return a number with so many digits after the point and no zero before it."""
    text = f"{value:.{digits}f}"
    return text.replace("0.", ".", 1) if text.startswith(("0.", "-0.")) else text


def held(value: float | None, digits: int, against: Range | None, unit: str = "") -> Cell:
    """Return a figure held against a range."""
    if value is None:
        return Cell("not noted")
    text = fixed(value, digits) + unit if digits >= 0 else short(value)
    return Cell(text, None if against is None else against.holds(value))


def swim_rows(length: float, gears: Sequence[SwimMeasures]) -> list[Row]:
    """Return the table of swims, slow, medium and fast in this order; cruise is held against medium alone."""
    return [
        _speeds(length, gears),
        Row("of an adult, m/s", "", tuple(Cell(fixed(g.speed * length, 2)) for g in gears)),
        Row("frequency, Hz", "", tuple(Cell(fixed(g.frequency, 2)) for g in gears)),
        _row("stride, BL a beat", ranges.STRIDE, ((g.stride, 2) for g in gears)),
        _row("Strouhal number", ranges.STROUHAL, ((g.strouhal, 2) for g in gears)),
        _row("sweep of the tail, BL", ranges.SWEEP, ((g.sweep, 3) for g in gears)),
        _row("head's sweep over the tail's", ranges.HEAD, ((g.head, 2) for g in gears)),
        _row("wavelength, BL", ranges.WAVELENGTH, ((g.wavelength, 2) for g in gears)),
        Row(
            "wave runs",
            "backwards",
            tuple(Cell("backwards" if g.backward else "forwards", g.backward) for g in gears),
        ),
        _row("sharpest joint, degrees", ranges.JOINT, ((g.joint, 0) for g in gears)),
        _row("change of shape over a cycle, BL", ranges.CLOSURE, ((g.closure, -1) for g in gears)),
        _row("drift in 1,000 beats, degrees", ranges.DRIFT, ((g.drift, 3) for g in gears)),
    ]


def _speeds(length: float, gears: Sequence[SwimMeasures]) -> Row:
    """Return the row of speeds: medium against cruise, fast against what can be kept up for 20 s."""
    cells = [Cell(fixed(g.speed, 2)) for g in gears]
    known = ranges.cruise(length)
    said = "no figure for its size"
    if known is not None:
        against, scale = known
        cells[1] = Cell(cells[1].text, against.holds(gears[1].speed * scale))
        said = f"medium {against.text()} ({against.source})"
    cells[2] = Cell(cells[2].text, ranges.SUSTAINED.holds(gears[2].speed))
    return Row("speed, BL/s", f"{said}; fast at most 4 (for 20 s)", tuple(cells))


def _row(name: str, against: Range, values: Iterable[tuple[float | None, int]]) -> Row:
    cells = tuple(held(value, digits, against) for value, digits in values)
    return Row(name, f"{against.text()} ({against.source})", cells)


def turn_rows(length: float, turns: Sequence[tuple[Pattern, TurnMeasures]]) -> list[Row]:
    """Return the table of turns and the fast start, a column for each in the order given."""
    made = [m for _, m in turns]
    angles = [(_turn_range(pattern, length), m) for pattern, m in turns]
    return [
        Row(
            "net turn, degrees",
            ", ".join(against.text() for against, _ in angles),
            tuple(held(m.net, 0, against) for against, m in angles),
        ),
        Row(
            "takes, s",
            f"sharp {ranges.SHARP_TIME.text()}",
            tuple(
                held(m.seconds, 2, ranges.SHARP_TIME if p == Pattern.TURN_SHARP_LEFT else None)
                for p, m in turns
            ),
        ),
        _row("sharpest joint, degrees", ranges.JOINT, ((m.joint, 0) for m in made)),
        Row("fastest turning, degrees/s", "", tuple(Cell(fixed(m.fastest, 0)) for m in made)),
        Row("leaves with, BL/s", "", tuple(Cell(fixed(m.speed, 2)) for m in made)),
        _first_stroke("first stroke takes, ms", ranges.STAGE_ONE_TIME, turns, 0),
        _first_stroke("first stroke turns the head, degrees", ranges.STAGE_ONE_ANGLE, turns, 1),
    ]


def _turn_range(pattern: Pattern, length: float) -> Range:
    return ranges.START_NET if pattern == Pattern.FAST_START_LEFT else ranges.turn(pattern, length)


def _first_stroke(
    name: str, against: Range, turns: Sequence[tuple[Pattern, TurnMeasures]], part: int
) -> Row:
    cells = tuple(
        held((1000.0, 1.0)[part] * m.first_stroke[part], 0, against)
        if pattern == Pattern.FAST_START_LEFT
        else Cell("")
        for pattern, m in turns
    )
    return Row(name, f"{against.text()} ({against.source})", cells)
