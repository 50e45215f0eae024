"""Draws our counterpart of papers/003, fig. 1, the flow chart: `python -m reefgame.flow_chart docs/pictures`.

Four panels of three pictures: a fish of ours is filmed and followed (a), a drawing becomes a model (b), the model swims
as the fish does (c), and one frame is edited by hand (d).
"""

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s, Int64s
from reefgame.retarget_figures import (
    CELL,
    cell,
    clipped,
    figure_5,
    filmed,
    fine_tuned,
    write_picture,
)
from tools.video.background import Plate
from tools.video.follow import Choices, look
from tools.video.images import Colour, Grey
from tools.video.mask import RIM, Segmenter
from tools.video.motion import Motion
from tools.video.reading import Clip
from tools.video.retarget.choose import shipped, target_from
from tools.video.retarget.film import draw, view_of, water
from tools.video.retarget.intermediate import IntermediateMotion, intermediate
from tools.video.retarget.picture import read_picture
from tools.video.retarget.retarget import Retargeting
from tools.video.retarget.skeleton import NAMES
from tools.video.retarget.target import Target
from tools.video.retouch.session import Session

NAME: Final = "flow_chart.png"
_FRAME: Final = 45
"""Frame of the clip that a and c show."""
_PLACED: Final = (0, 115)
"""Frames that the last picture of c shows together."""
_GAP: Final = 34
"""[px] between pictures, which an arrow crosses."""
_TITLE: Final = 46
"""[px] above a panel's pictures."""
_BELOW: Final = 34
"""[px] under them, for their words."""
_APART: Final = 64
"""[px] between panels."""
_NEARER: Final = 3.0
"""Times as large the mesh is shown: its triangles are small."""
_SCALE: Final = 0.72
"""Of the picture that is written, over the one that is drawn."""
_INK: Final = (24, 40, 48)
_BOX: Final = (244, 247, 248)
_RIM_INK: Final = (150, 170, 178)
_RED: Final = (226, 60, 44)
_BLUE: Final = (60, 150, 240)
_FONT: Final = cv2.FONT_HERSHEY_SIMPLEX
_FINE: Final = 2


@dataclass(frozen=True)
class Panel:
    """A part of the chart: a title, and three pictures of CELL with a word under each."""

    title: str
    pictures: tuple[Colour, Colour, Colour]
    words: tuple[str, str, str]


def captured(folder: Path, motion: Motion, levels: Colour) -> Panel:
    """Return panel a: a frame of the clip, the fish in it, its features."""
    fish, marked = (levels[:, k * CELL[0] : (k + 1) * CELL[0]] for k in (0, 1))
    mask = clipped(_mask(folder / "swim.mkv", _FRAME), intermediate(motion), _FRAME)
    return Panel(
        "(a) Motion captured from the clip",
        (fish, mask, marked),
        ("frame", "foreground", "features"),
    )


def _mask(path: Path, number: int) -> Grey:
    """Return the fish of one frame, 255 on 0."""
    scene = look(Clip(path), Choices(), lambda _: None)
    segmenter = Segmenter(scene.plate, scene.gate, Plate())
    segmenter.wary = scene.wary
    grey = next(f.grey for f in scene.clip.frames() if f.number == number)
    sighting = None if grey is None else segmenter.find(grey)
    if grey is None or sighting is None:
        raise ValueError(f"no fish is seen in frame {number}")
    whole = np.zeros_like(grey)
    left, top, right, bottom = sighting.box
    whole[top:bottom, left:right] = sighting.mask[RIM:-RIM, RIM:-RIM]
    return whole


def constructed(play: Retargeting, drawing: Path) -> Panel:
    """Return panel b: the drawing, its outline and control points, the mesh."""
    target = play.target
    places = _in_cell(play, target.vertices[:, :2])
    edges = _edges(target.triangles)
    lines, counts = np.unique(edges, axis=0, return_counts=True)
    outlined = _sketch(places, lines[counts == 1])
    middle = _in_cell(play, target.controls[:1])
    meshed = _sketch((places - middle) * _NEARER + 0.5 * np.array(CELL), lines)
    _dots(outlined, _in_cell(play, target.controls), _RED)
    for fin in target.fins:
        if fin is not None:
            _dots(outlined, _in_cell(play, np.stack((fin.tip, fin.top, fin.bottom))), _BLUE)
    return Panel(
        "(b) Model made of a drawing",
        (_on_white(drawing, places), outlined, meshed),
        ("drawing", "control points", "mesh, nearer"),
    )


def _edges(triangles: Int64s) -> Int64s:
    """Return the ends of all triangles' edges, the lesser first, (3 F, 2)."""
    sides = np.concatenate([triangles[:, pair] for pair in ((0, 1), (1, 2), (2, 0))])
    return np.sort(sides, axis=1)


def _in_cell(play: Retargeting, points: Float64s) -> Float64s:
    """Return places of the model's rest pose (n, 2) in a picture as `cell` draws it [px]."""
    scale = 0.72 * CELL[1] / play.motion.length
    away = points * play.scale * (1.0, -1.0) - (0.0, 0.08 * play.motion.length)
    return away * scale + 0.5 * np.array(CELL)


def _sketch(places: Float64s, lines: Int64s) -> Colour:
    picture = np.full((_FINE * CELL[1], _FINE * CELL[0], 3), 255, np.uint8)
    fixed = np.round(places * _FINE * 16.0).astype(np.int32)
    for start, end in lines.tolist():
        cv2.line(picture, fixed[start].tolist(), fixed[end].tolist(), _INK, 1, cv2.LINE_AA, shift=4)
    return np.asarray(cv2.resize(picture, CELL, interpolation=cv2.INTER_AREA), np.uint8)


def _dots(picture: Colour, places: Float64s, colour: tuple[int, int, int]) -> None:
    for x, y in np.round(places * 16.0).astype(int).tolist():
        cv2.circle(picture, (x, y), 40, colour, -1, cv2.LINE_AA, shift=4)


def _on_white(drawing: Path, places: Float64s) -> Colour:
    """Return the drawing as large as its mesh is, on white."""
    texture = read_picture(drawing).astype(np.float64)
    flat = texture[..., :3] + (255.0 - texture[..., :3]) * (1.0 - texture[..., 3:] / 255.0)
    rows, columns = np.nonzero(texture[..., 3] > 127)
    low, high = places.min(axis=0), places.max(axis=0)
    scale = float((high[1] - low[1]) / np.ptp(rows))
    shift = low - scale * np.array([columns.min(), rows.min()])
    matrix = np.array([[scale, 0.0, shift[0]], [0.0, scale, shift[1]]])
    fine = cv2.warpAffine(
        flat.astype(np.uint8),
        matrix * _FINE,
        (_FINE * CELL[0], _FINE * CELL[1]),
        borderMode=cv2.BORDER_CONSTANT,
        borderValue=(255, 255, 255),
    )
    return np.asarray(cv2.resize(fine, CELL, interpolation=cv2.INTER_AREA), np.uint8)


def retargeted(play: Retargeting, levels: Colour) -> Panel:
    """Return panel c: the body's motion, the fins', the way through the water."""
    body, fins = (levels[:, k * CELL[0] : (k + 1) * CELL[0]] for k in (2, 3))
    return Panel(
        "(c) Retargeted",
        (body, fins, _on_its_way(play)),
        ("body motion", "fin motion", "global motion"),
    )


def _on_its_way(play: Retargeting) -> Colour:
    size = (_FINE * CELL[0], _FINE * CELL[1])
    view, picture = view_of(play.motion, *size), np.ascontiguousarray(water(*size))
    course = np.round(view.to_picture(play.motion.centre)).astype(np.int32)
    cv2.polylines(picture, [course], False, (255, 255, 255), 3, cv2.LINE_AA)
    for frame in _PLACED:
        draw(picture, play, play.angles(frame), play.placement(frame), view)
    return np.asarray(cv2.resize(picture, CELL, interpolation=cv2.INTER_AREA), np.uint8)


def tuned(motion: IntermediateMotion, target: Target) -> Panel:
    """Return panel d: a frame as it was, edited, and the fin's angle over time before and after."""
    session, frame, _ = fine_tuned(motion, target)
    play = Retargeting(target, motion)
    before, after = (
        cell(play, play.target_angles(values[frame]))
        for values in (session.original, session.angles)
    )
    return Panel(
        "(d) Edited by hand",
        (before, after, _curves(session, frame)),
        (f"frame {frame}", "edited", "its neighbours follow"),
    )


def _curves(session: Session, frame: int) -> Colour:
    """Return the right fin's angle about the edited frame: blue as it was, red as it is."""
    column = NAMES.index("r_fin_angle")
    shown = np.arange(max(0, frame - 16), min(len(session.angles), frame + 17))
    both = [values[shown, column] for values in (session.original, session.angles)]
    low, high = min(v.min() for v in both), max(v.max() for v in both)
    picture = np.full((CELL[1], CELL[0], 3), 255, np.uint8)
    across = 20.0 + (shown - shown[0]) / np.ptp(shown) * (CELL[0] - 40.0)
    at = round(float(across[frame - shown[0]]))
    cv2.line(picture, (at, 20), (at, CELL[1] - 20), _RIM_INK, 1)
    for values, colour in zip(both, (_BLUE, _RED), strict=True):
        up = CELL[1] - 30.0 - (values - low) / (high - low) * (CELL[1] - 60.0)
        line = np.round(np.stack((across, up), axis=1) * 16.0).astype(np.int32)
        cv2.polylines(picture, [line], False, colour, 2, cv2.LINE_AA, shift=4)
    return picture


def chart(panels: Sequence[Panel]) -> Colour:
    """Return panels a to d, two and two, with arrows from a and b to c and from c to d."""
    width = 3 * CELL[0] + 4 * _GAP
    height = _TITLE + CELL[1] + _BELOW
    picture = np.full((2 * height + _APART, 2 * width + _APART, 3), 255, np.uint8)
    for number, panel in enumerate(panels):
        _place(picture, panel, (number % 2) * (width + _APART), number // 2 * (height + _APART))
    middle, between = width // 2, height + _APART // 2
    _arrow(picture, ((middle, height), (middle, height + _APART)))
    far = width + _APART + middle
    _arrow(
        picture,
        ((far, height), (far, between), (middle + 90, between), (middle + 90, height + _APART)),
    )
    level = height + _APART + _TITLE + CELL[1] // 2
    _arrow(picture, ((width, level), (width + _APART, level)))
    return picture


def _place(picture: Colour, panel: Panel, left: int, top: int) -> None:
    """Draw a panel with its corner there."""
    right, bottom = left + 3 * CELL[0] + 4 * _GAP, top + _TITLE + CELL[1] + _BELOW
    cv2.rectangle(picture, (left, top), (right - 1, bottom - 1), _BOX, -1)
    cv2.rectangle(picture, (left, top), (right - 1, bottom - 1), _RIM_INK, 2)
    cv2.putText(picture, panel.title, (left + _GAP, top + 32), _FONT, 0.85, _INK, 2, cv2.LINE_AA)
    for k, (shown, word) in enumerate(zip(panel.pictures, panel.words, strict=True)):
        x, y = left + _GAP + k * (CELL[0] + _GAP), top + _TITLE
        picture[y : y + CELL[1], x : x + CELL[0]] = shown
        cv2.rectangle(picture, (x, y), (x + CELL[0] - 1, y + CELL[1] - 1), _RIM_INK, 1)
        cv2.putText(picture, word, (x, bottom - 11), _FONT, 0.65, _INK, 1, cv2.LINE_AA)
        if k:
            level = y + CELL[1] // 2
            _arrow(picture, ((x - _GAP + 4, level), (x - 4, level)), 3)


def _arrow(picture: Colour, places: Sequence[tuple[int, int]], thick: int = 5) -> None:
    """Draw a line through places with a head at its end."""
    end, before = np.array(places[-1]), np.array(places[-2])
    ahead = (end - before) / np.hypot(*(end - before))
    aside = np.array([-ahead[1], ahead[0]])
    neck = end - 3.6 * thick * ahead
    corners = np.stack((end, neck + 2.2 * thick * aside, neck - 2.2 * thick * aside))
    line = np.array([*places[:-1], np.round(neck)], np.int32)
    cv2.polylines(picture, [line], False, _INK, thick, cv2.LINE_AA)
    cv2.fillPoly(picture, [np.round(corners).astype(np.int32)], _INK, cv2.LINE_AA)


def main(folder: Path) -> None:
    """Write the chart into a folder."""
    target = target_from("carp")
    with TemporaryDirectory() as kept:
        clip, motion = filmed(Path(kept))
        play = Retargeting(target, intermediate(motion))
        levels = figure_5(clip, motion, target, _FRAME)
        panels = (
            captured(Path(kept), motion, levels),
            constructed(play, shipped()["carp"]),
            retargeted(play, levels),
            tuned(play.motion, target),
        )
    write_picture(folder / NAME, chart(panels), _SCALE)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
