"""Pieces of a report's page: figures with captions, tables with marks."""

from collections.abc import Iterable, Sequence
from html import escape

from tools.capture.report.tables import Cell, Row


def figure(pictures: Iterable[str], caption: str) -> str:
    """Return pictures with their caption."""
    return f"<figure>{''.join(pictures)}<figcaption>{caption}</figcaption></figure>"


def table(corner: str, columns: Sequence[str], rows: Sequence[Row]) -> str:
    """Return a table of ours against living fishes."""
    head = "".join(f"<th>{escape(name)}</th>" for name in columns)
    lines = [
        f"<tr><th scope='row'>{escape(row.name)}</th>{''.join(map(cell_html, row.cells))}"
        f"<td class='living'>{escape(row.living)}</td></tr>"
        for row in rows
    ]
    body = "\n".join(lines)
    return (
        f"<table><thead><tr><th>{escape(corner)}</th>{head}<th class='living'>living fishes</th></tr></thead>"
        f"<tbody>{body}</tbody></table>"
    )


def cell_html(cell: Cell) -> str:
    """Return a figure of a table with its mark."""
    if cell.fits is None:
        return f"<td>{escape(cell.text)}</td>"
    kind, mark = ("in", "in") if cell.fits else ("out", "out")
    return f"<td class='{kind}'>{escape(cell.text)} <b>{mark}</b></td>"
