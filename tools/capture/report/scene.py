"""Draws fishes in a plane: seen from above or from the side, to scale, with their axes and paths."""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import Float64s
from tools.capture.report.silhouette import Silhouette
from tools.capture.report.svg import Drawing, blend

TIMES: Final = ("#23407f", "#1f6f9f", "#1b9a96", "#3fb573", "#9bc53d")
"""Colours from the first moment to the last."""
MIDLINE: Final = "#ffd75e"
ANTERIOR: Final = "#17324d"
LATERAL: Final = "#8fb4c6"
PATH: Final = "#d1495b"
_INK: Final = "#10273a"


@dataclass(frozen=True)
class View:
    """A window onto a plane of the world: x to the right and `up` upwards."""

    left: float
    top: float
    "[BL] of the window's corner"
    scale: float
    "[px] for 1 BL"
    up: int = 1
    "axis of the world that points up on the sheet: 1 from above, 2 from the side"

    def __call__(self, places: Float64s) -> Float64s:
        """Return places (..., 3) [BL] on the sheet, (..., 2) [px]."""
        x = (places[..., 0] - self.left) * self.scale
        y = (self.top - places[..., self.up]) * self.scale
        return np.stack((x, y), axis=-1)


def window(places: Float64s, width: float, margin: float, up: int = 1) -> tuple[View, float]:
    """Return the view `width` px wide that holds places (..., 3) and a margin [BL], and its height [px]."""
    x, y = places[..., 0], places[..., up]
    scale = width / (float(np.ptp(x)) + 2.0 * margin)
    view = View(float(x.min()) - margin, float(y.max()) + margin, scale, up)
    return view, scale * (float(np.ptp(y)) + 2.0 * margin)


def fish_above(
    sheet: Drawing,
    view: View,
    drawn: Silhouette,
    nodes: Float64s,
    share: float,
    opacity: float = 1.0,
) -> None:
    """Draw a fish from above, of nodes (23, 3), in the colour of a share of the time."""
    colour, edge = blend(share, TIMES), blend(share, [_dark(c) for c in TIMES])
    line = f"stroke='{edge}' stroke-linejoin='round' stroke-linecap='round'"
    sheet.add(f"<g opacity='{opacity:g}'>")
    for fin in drawn.fins_above:
        sheet.polygon(
            view(fin @ nodes), f"fill='{colour}' fill-opacity='.35' {line} stroke-width='.5'"
        )
    thick = max(1.6, 0.022 * view.scale)
    sheet.curve(view(drawn.tail_above @ nodes), f"{line} stroke-width='{thick:.1f}'")
    sheet.polygon(view(drawn.above @ nodes), f"fill='{colour}' {line} stroke-width='.9'")
    for rib in drawn.ribs_above:
        sheet.curve(view(rib @ nodes), "stroke='#fff' stroke-opacity='.28' stroke-width='.6'")
    sheet.curve(view(drawn.middle @ nodes), f"stroke='{MIDLINE}' stroke-width='1.4'")
    sheet.add("</g>")


def fish_beside(
    sheet: Drawing, view: View, drawn: Silhouette, nodes: Float64s, share: float
) -> None:
    """Draw a fish from its right side, of nodes (23, 3)."""
    colour, edge = blend(share, TIMES), blend(share, [_dark(c) for c in TIMES])
    line = f"stroke='{edge}' stroke-linejoin='round'"
    for fin in (drawn.tail_beside, *drawn.fins_beside):
        sheet.polygon(
            view(fin @ nodes), f"fill='{colour}' fill-opacity='.55' {line} stroke-width='.7'"
        )
    sheet.polygon(view(drawn.beside @ nodes), f"fill='{colour}' {line} stroke-width='.9'")
    for rib in drawn.ribs_beside:
        sheet.curve(view(rib @ nodes), "stroke='#fff' stroke-opacity='.28' stroke-width='.6'")
    sheet.curve(view(drawn.middle @ nodes), f"stroke='{MIDLINE}' stroke-width='1.2'")


def axes(sheet: Drawing, view: View, origin: Float64s, rotation: Float64s, long: float) -> None:
    """Draw the anterior (dark) and lateral (light) axis of a body at o (3,), R (3, 3), `long` [BL]."""
    at = view(origin).tolist()
    for axis, colour in ((2, LATERAL), (0, ANTERIOR)):
        tip = view(origin + long * rotation[:, axis]).tolist()
        sheet.arrow(at, tip, colour, 4.0)


def path(sheet: Drawing, view: View, places: Float64s, colour: str, style: str = "") -> None:
    """Draw a way through places (n, 3)."""
    sheet.curve(view(places), f"stroke='{colour}' stroke-width='1.2' {style}")


def ruler(sheet: Drawing, view: View, x: float, y: float, long: float, words: str) -> None:
    """Draw a length [BL] at a place [px], with its name after it."""
    end = x + long * view.scale
    style = f"stroke='{_INK}' stroke-width='1.2'"
    sheet.line(x, y, end, y, style)
    for at in (x, end):
        sheet.line(at, y - 3, at, y + 3, style)
    sheet.text(end + 6, y + 4, words)


def _dark(colour: str) -> str:
    return blend(0.55, (colour, _INK))
