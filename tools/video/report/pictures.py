"""The pictures of docs/video.md, counterparts of Figs. 2 to 4 of papers/003, from a swim of our own that is filmed."""

from dataclasses import replace
from pathlib import Path
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s
from tools.video.background import Plate
from tools.video.contour import evenly, smooth_contour
from tools.video.features import Features, features_of
from tools.video.fins import Finless, without_fins
from tools.video.follow import Choices, Scene, look
from tools.video.images import Colour, Grey
from tools.video.mask import Segmenter, Sighting
from tools.video.midline import Axis, medial_axis, paired, whole_axis
from tools.video.motion import LOWER, UPPER
from tools.video.orientation import shape_of
from tools.video.pectorals import pectorals_of
from tools.video.reading import Clip
from tools.video.report.overlay import AXIS, CONTOUR, FIN, TIPS, Picture

_MARGIN: Final = 26
_DARK: Final = (30, 50, 60)


def pictures(path: Path, number: int) -> dict[str, Colour]:
    """Return the page's pictures by their names, from frame `number` of a clip."""
    scene = look(Clip(path), Choices(), lambda _: None)
    grey = next(f.grey for f in scene.clip.frames() if f.number == number)
    if grey is None:
        raise ValueError(f"frame {number} is damaged")
    segmenter = Segmenter(scene.plate, scene.gate, Plate())
    segmenter.wary = scene.wary
    sighting = segmenter.find(grey)
    if sighting is None:
        raise ValueError(f"no fish is seen in frame {number}")
    return {
        "video_segmentation.png": _segmentation(scene, grey, segmenter, sighting),
        "video_features.png": _features(grey, sighting),
        "video_axis.png": _axis(grey, sighting),
        "video_junctions.png": _junctions(grey, sighting),
    }


def _segmentation(scene: Scene, grey: Grey, segmenter: Segmenter, sighting: Sighting) -> Colour:
    difference, _ = segmenter.differing(grey, (0, 0, grey.shape[1], grey.shape[0]))
    mask = np.zeros_like(grey)
    x, y = sighting.corner
    height, width = sighting.mask.shape
    inner = sighting.mask[2:-2, 2:-2]
    mask[y + 2 : y + height - 2, x + 2 : x + width - 2] = inner
    shown = zip(
        "abcd",
        (grey, scene.plate, np.minimum(difference.astype(np.int32) * 2, 255), mask),
        ("frame", "clean plate", "difference", "the fish"),
        strict=True,
    )
    tiles = []
    for letter, image, words in shown:
        tile = Picture(_rgb(np.asarray(image, np.uint8)))
        tile.words(f"{letter}: {words}", _DARK, size=1.0)
        tiles.append(
            np.asarray(cv2.resize(tile.image, None, fx=0.5, fy=0.5, interpolation=3), np.uint8)
        )
    return np.asarray(_sheet([tiles[:2], tiles[2:]]), np.uint8)


def _features(grey: Grey, sighting: Sighting) -> Colour:
    found = features_of(sighting, None)
    if found.centre is None or found.ends is None or found.spine is None or found.fins is None:
        raise ValueError("the frame's fish shows no axis")
    picture, corner = _cut(grey, sighting, 3)
    picture.features(_moved(found, corner))
    axis = whole_axis(found.ends[0], found.spine, found.ends[1]) - corner
    picture.line(axis, AXIS, 2)
    nearest = int(((axis + corner - found.centre) ** 2).sum(axis=1).argmin())
    centre = axis[nearest]
    upper = evenly(axis[nearest::-1], UPPER + 2)[1:-1]
    lower = evenly(axis[nearest:], LOWER + 2)[1:-1]
    picture.dots(np.concatenate((upper, lower)), (250, 200, 40), 4)
    picture.dots(centre[None], (255, 255, 255), 6)
    fins = found.fins - corner
    names = ("l_fin", "r_fin", "jun_tl", "jun_tr", "jun_bl", "jun_br")
    labels = {name: place for name, place in zip(names, fins, strict=True) if place[0] == place[0]}
    labels |= {"head": axis[0], "tail": axis[-1], "center": centre}
    for name, place in labels.items():
        away = (4.0, -4.0) if not name.endswith(("l", "l_fin", "center")) else (-16.0, 12.0)
        picture.words(name, _DARK, (place[0] + away[0], place[1] + away[1]), 0.6)
    return picture.image


def _axis(grey: Grey, sighting: Sighting) -> Colour:
    """Draw what Fig. 3 does: the plain axis, the smooth contour, the axis from it, its samples; then with fins off."""
    outline, ahead = sighting.outline.astype(np.float64), _ahead(sighting)
    finless = without_fins(
        sighting.mask, sighting.outline, shape_of(sighting.outline).centre, ahead
    )
    rows = []
    bare = Finless(sighting.mask, outline, (), finless.radius)
    for letters, body in (("abcd", bare), ("efgh", finless)):
        contour, harmonics = smooth_contour(body.outline, 0.5 * len(body.outline))
        found = medial_axis(body, contour, ahead)
        rough = paired(body.outline, ahead)
        rows.append(_four(grey, sighting, letters, body, rough, contour, found, harmonics))
    return np.asarray(_sheet(rows), np.uint8)


def _four(
    grey: Grey,
    sighting: Sighting,
    letters: str,
    body: Finless,
    rough: Float64s,
    contour: Float64s,
    found: Axis,
    harmonics: int,
) -> list[Colour]:
    axis = whole_axis(found.head, found.spine, found.tail)
    words = ("eq. 1, plain contour", f"{harmonics} harmonics", "axis", "samples")
    tiles = []
    for k, (letter, told) in enumerate(zip(letters, words, strict=True)):
        tile, corner = _cut(grey, sighting, 1)
        shift = np.array(sighting.corner) - corner
        tile.line((body.outline if k == 0 else contour) + shift, CONTOUR, 1, closed=True)
        if k != 1:
            line = rough if k == 0 else axis
            tile.line(line + shift, AXIS, 1)
        if k == 3:
            tile.dots(axis[::2] + shift, TIPS, 2.5)
        tile.words(f"{letter}: {told}", _DARK, size=0.55)
        tiles.append(tile.image)
    return tiles


def _junctions(grey: Grey, sighting: Sighting) -> Colour:
    ahead = _ahead(sighting)
    finless = without_fins(
        sighting.mask, sighting.outline, shape_of(sighting.outline).centre, ahead
    )
    contour, _ = smooth_contour(finless.outline, 0.5 * len(finless.outline))
    found = medial_axis(finless, contour, ahead)
    axis = whole_axis(found.head, found.spine, found.tail)
    fins = pectorals_of(finless, axis)
    picture, corner = _cut(grey, sighting, 5)
    shift = np.array(sighting.corner) - corner
    for fin in finless.fins:
        picture.line(fin + shift, FIN, 2, closed=True)
    picture.line(axis + shift, AXIS, 2)
    picture.dots(fins.tip + shift, TIPS, 6)
    picture.dots(fins.junction + shift, (250, 200, 40), 6)
    shown = ~np.isnan(fins.junction[:, 0])
    middle = (fins.junction[shown].mean(axis=0) + shift) * 5
    x, y = (int(v) for v in middle)
    height, width = picture.image.shape[:2]
    return picture.image[
        max(0, y - 300) : min(height, y + 300), max(0, x - 400) : min(width, x + 400)
    ]


def _moved(found: Features, corner: Float64s) -> Features:
    """Return features with places measured from `corner`."""
    contour = None if found.contour is None else found.contour.copy()
    if contour is not None:
        contour[0] -= complex(*corner)
    ends, fins = found.ends, found.fins
    return replace(
        found,
        contour=contour,
        ends=None if ends is None else ends - corner,
        fins=None if fins is None else fins - corner,
    )


def _ahead(sighting: Sighting) -> Float64s:
    shape = shape_of(sighting.outline)
    return shape.axis if shape.lean >= 0.0 else -shape.axis


def _cut(grey: Grey, sighting: Sighting, times: int) -> tuple[Picture, Float64s]:
    """Return a picture of the fish and its surroundings, and where its corner lies in the frame [px]."""
    left, top, right, bottom = sighting.box
    height, width = grey.shape
    x, y = max(0, left - _MARGIN), max(0, top - _MARGIN)
    part = grey[y : min(height, bottom + _MARGIN), x : min(width, right + _MARGIN)]
    return Picture(_rgb(part), times), np.array([x, y], np.float64)


def _rgb(grey: Grey) -> Colour:
    return np.ascontiguousarray(np.repeat(grey[..., None], 3, axis=2))


def _sheet(rows: list[list[Colour]]) -> Colour:
    """Return pictures side by side and row under row, a line apart."""
    gap = 6
    lines = []
    for row in rows:
        padded = [np.pad(tile, ((0, gap), (0, gap), (0, 0)), constant_values=255) for tile in row]
        lines.append(np.concatenate(padded, axis=1))
    return np.asarray(np.concatenate(lines)[:-gap, :-gap], np.uint8)
