"""The page of a report: one HTML file that holds its pictures, and nothing that changes from run to run."""

from collections.abc import Sequence
from html import escape

from components.body import rest_nodes
from components.segment import Pattern
from tools.capture.report import figures
from tools.capture.report.markup import cell_html
from tools.capture.report.section import Section
from tools.capture.report.style import STYLE
from tools.capture.report.subject import Subject
from tools.capture.report.tables import Cell


def page(subjects: Sequence[Subject]) -> str:
    """Return the report of all species as one HTML page."""
    sections = [Section(subject) for subject in subjects]
    names = ", ".join(s.subject.title for s in sections)
    return "\n".join(
        [
            "<!DOCTYPE html>",
            "<html lang='en'><head><meta charset='utf-8'>",
            "<meta name='viewport' content='width=device-width, initial-scale=1'>",
            f"<title>Captured motion: {escape(names)}</title>",
            f"<style>{STYLE}</style></head><body><main>",
            _opening(sections),
            *(section.html() for section in sections),
            "</main></body></html>\n",
        ]
    )


def _opening(sections: Sequence[Section]) -> str:
    """Return title, explanation, and the table of all species."""
    lines = [_overview(section) for section in sections]
    return (
        "<h1>Captured motion</h1><p class='lead'>Every movement here was swum by muscles in water, once, and cut into "
        "the segments that the game replays (Yu and Terzopoulos 1999). Each figure is held against living fishes: "
        "<span class='in'><b>in</b></span> where theirs lie, <span class='out'><b>out</b></span> where they do not. "
        "BL are body lengths.</p>"
        "<table class='all'><thead><tr><th></th><th></th><th>cruise, BL/s</th><th>frequency, Hz</th>"
        "<th>Strouhal</th><th>sweep, BL</th><th>head/tail</th><th>sharp turn, degrees</th><th>fast start, degrees</th>"
        f"<th>figures in</th></tr></thead><tbody>{''.join(lines)}</tbody></table>"
    )


def _overview(section: Section) -> str:
    subject = section.subject
    portrait = figures.portrait(section.drawn, rest_nodes(subject.body), 96.0, False)
    named = {row.name: row.cells for row in section.swim_rows}
    swims = [
        named[name][1]
        for name in (
            "speed, BL/s",
            "frequency, Hz",
            "Strouhal number",
            "sweep of the tail, BL",
            "head's sweep over the tail's",
        )
    ]
    nets = dict(zip((p for p, _ in section.turns), section.turn_rows[0].cells, strict=True))
    turns = [nets.get(p, Cell("none")) for p in (Pattern.TURN_SHARP_LEFT, Pattern.FAST_START_LEFT)]
    fit = [cell.fits for cell in section.cells()]
    name = escape(subject.name, quote=True)
    return (
        f"<tr><td>{portrait.svg(subject.title)}</td>"
        f"<th scope='row'><a href='#{name}'>{escape(subject.title)}</a></th>"
        f"{''.join(map(cell_html, (*swims, *turns)))}<td>{fit.count(True)} of {len(fit)}</td></tr>"
    )
