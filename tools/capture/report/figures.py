"""Figures of segments, as Figs. 3 and 4 of papers/000: moments of a beat or a turn, and the way that the fish makes."""

from math import ceil, floor
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND
from components.segment import Segment
from tools.capture.report.replayed import Replayed, replay
from tools.capture.report.scene import (
    PATH,
    View,
    axes,
    fish_above,
    fish_beside,
    path,
    ruler,
    window,
)
from tools.capture.report.silhouette import Silhouette
from tools.capture.report.svg import Drawing

WIDTH: Final = 1040.0
"""[px] of a figure across the page."""
PITCH_SHOWN: Final = 3.0
"""[degrees] of pitch from which a segment is shown from the side too."""
_MARGIN: Final = 0.06
_CAPTION: Final = 20.0
_STRIP: Final = 4.6
_APART: Final = 1.14
_AXES: Final = 9
_PANEL: Final = "fill='#f4f9fb' stroke='#d5e4ea'"
_FAINT: Final = "stroke-dasharray='2 3' stroke-opacity='.55'"
_LETTERS: Final = "abcdefghijklmnopqrstuvwxyz"


def moments(drawn: Silhouette, segment: Segment, count: int, columns: int) -> Drawing:
    """Return `count` even moments of a segment in panels, each with the axes' way so far, from above."""
    run = replay(segment)
    chosen = _even(len(run.nodes), count)
    width = (WIDTH - 8.0 * (columns - 1)) / columns
    view, height = window(_reach(drawn, run.nodes), width, _MARGIN)
    rows = ceil(count / columns)
    sheet = Drawing(WIDTH, rows * (height + _CAPTION + 6.0))
    for place, frame in enumerate(chosen):
        panel = Drawing(width, height)
        panel.box(0, 0, width, height, f"{_PANEL} rx='4'")
        _moment(panel, view, drawn, run, frame, place / max(count - 1, 1))
        x, y = (place % columns) * (width + 8.0), (place // columns) * (height + _CAPTION + 6.0)
        sheet.place(panel, x, y)
        seconds = f"{(frame + 1) / TICKS_PER_SECOND:.2f} s"
        sheet.text(x + 2, y + height + 13, _LETTERS[place], "font-weight='bold'")
        sheet.text(x + 14, y + height + 13, seconds, "fill='#6d8794'")
    return sheet


def _moment(
    panel: Drawing, view: View, drawn: Silhouette, run: Replayed, frame: int, share: float
) -> None:
    path(panel, view, run.origin, PATH, _FAINT)
    fish_above(panel, view, drawn, run.nodes[frame], share)
    step = max(1, round(len(run.nodes) / _AXES))
    for k in range(0, frame + 2, step):
        axes(panel, view, run.origin[k], run.rotation[k], 0.12)
    path(panel, view, run.origin[: frame + 2], PATH)


def way(drawn: Silhouette, segment: Segment, fishes: int = 6, width: float = WIDTH) -> Drawing:
    """Return a turn as one exposure: the fish at even moments along its path, with the ways of centre and nose."""
    run = replay(segment)
    view, height = window(_reach(drawn, run.nodes), width, 0.1)
    view, height = _narrowed(view, height, 400.0)
    sheet = Drawing(width, height + 24.0)
    sheet.box(0, 0, width, height, f"{_PANEL} rx='4'")
    centre = (width - view.scale * float(np.ptp(_reach(drawn, run.nodes)[..., 0]) + 0.2)) / 2.0
    sheet.add(f"<g transform='translate({centre:.1f},0)'>")
    for place, frame in enumerate(_even(len(run.nodes), fishes, first=True)):
        fish_above(sheet, view, drawn, run.nodes[frame], place / (fishes - 1), 0.82)
    path(sheet, view, run.nodes[:, 0], "#17324d", _FAINT)
    path(sheet, view, run.origin, PATH)
    for frame in _even(len(run.nodes), fishes, first=True):
        axes(sheet, view, run.origin[frame + 1], run.rotation[frame + 1], 0.16)
    sheet.add("</g>")
    ruler(sheet, view, 4.0, height + 13.0, 0.5, "half a body length")
    return sheet


def beats(drawn: Silhouette, segment: Segment) -> Drawing:
    """Return a swim along its path: the fish at a few places, with what nose and tail write into the water."""
    once = replay(segment)
    stride = max(float(once.origin[-1, 0]), 0.05)
    every = ceil(_APART / stride * 4.0 - 1.0) / 4.0 + 0.25
    run = replay(segment, min(ceil(_STRIP / stride) + 1, 60))
    period = len(once.nodes)
    frames = [floor(k * every * period) for k in range(1 + floor(_STRIP / (every * stride)))]
    frames = [frame for frame in frames if frame < len(run.nodes)]
    held = run.nodes[: frames[-1] + 1]
    view, height = window(_reach(drawn, held), WIDTH, _MARGIN)
    sheet = Drawing(WIDTH, height + 4.0)
    sheet.box(0, 0, WIDTH, height, f"{_PANEL} rx='4'")
    tail = 0.5 * (held[:, 21] + held[:, 22])
    path(sheet, view, tail, "#1b9a96")
    for place, frame in enumerate(frames):
        fish_above(sheet, view, drawn, run.nodes[frame], place / max(len(frames) - 1, 1))
    path(sheet, view, held[:, 0], "#17324d", _FAINT)
    path(sheet, view, run.origin[: frames[-1] + 2], PATH)
    return sheet


def beside(drawn: Silhouette, segment: Segment, count: int = 4) -> Drawing:
    """Return even moments of a segment from the right side, one beside the other, to the scale of the others."""
    run = replay(segment)
    width = (WIDTH - 8.0 * (count - 1)) / count
    chosen = _even(len(run.nodes), count)
    turned = [_facing(run, frame) for frame in chosen]
    lines = np.concatenate((drawn.beside, drawn.tail_beside, *drawn.fins_beside))
    view, height = window(np.stack([lines @ nodes for nodes in turned]), width, _MARGIN, up=2)
    sheet = Drawing(WIDTH, height + _CAPTION)
    for place, (frame, nodes) in enumerate(zip(chosen, turned, strict=True)):
        panel = Drawing(width, height)
        panel.box(0, 0, width, height, f"{_PANEL} rx='4'")
        fish_beside(panel, view, drawn, nodes, place / max(count - 1, 1))
        sheet.place(panel, place * (width + 8.0), 0.0)
        pitch = run.pitch()[frame + 1]
        words = f"{(frame + 1) / TICKS_PER_SECOND:.2f} s, pitch {pitch:+.1f} degrees"
        sheet.text(place * (width + 8.0) + 2, height + 13, words, "fill='#6d8794'")
    return sheet


def portrait(drawn: Silhouette, rest: Float64s, width: float = 420.0, dots: bool = True) -> Drawing:
    """Return the straight body, nodes (23, 3) in body axes, from the side, with `dots` at the nodes that carry it."""
    nodes = np.stack((rest[:, 0], -rest[:, 2], rest[:, 1]), axis=-1)
    lines = np.concatenate((drawn.beside, drawn.tail_beside, *drawn.fins_beside))
    view, height = window(lines @ nodes, width, 0.03, up=2)
    sheet = Drawing(width, height)
    fish_beside(sheet, view, drawn, nodes, 0.3)
    for x, y in view(nodes).tolist() if dots else ():
        sheet.dot(x, y, 2.4, "fill='#fff' stroke='#10273a' stroke-width='.8'")
    return sheet


def _facing(run: Replayed, frame: int) -> Float64s:
    """Return a frame's nodes about its centre, turned level until the fish faces +x."""
    angle = np.radians(run.heading()[frame + 1])
    c, s = np.cos(angle), np.sin(angle)
    turned: Float64s = (run.nodes[frame] - run.origin[frame + 1]) @ np.array(
        [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
    )
    return turned


def _reach(drawn: Silhouette, nodes: Float64s) -> Float64s:
    """Return every point that figures from above draw, of nodes (F, 23, 3)."""
    lines = np.concatenate((drawn.above, drawn.tail_above, *drawn.fins_above))
    reach: Float64s = np.einsum("pn,fnc->fpc", lines, nodes)
    return reach


def _even(length: int, count: int, first: bool = False) -> list[int]:
    """Return `count` evenly spaced frames below `length`, the last among them, the first where asked for."""
    if first:
        return [round(k * (length - 1) / max(count - 1, 1)) for k in range(count)]
    return [max(0, round((k + 1) * length / count) - 1) for k in range(count)]


def _narrowed(view: View, height: float, most: float) -> tuple[View, float]:
    """Return the view at a smaller scale where it would be higher than `most`."""
    if height <= most:
        return view, height
    return View(view.left, view.top, view.scale * most / height, view.up), most
