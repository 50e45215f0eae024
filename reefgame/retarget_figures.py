"""Draws our counterparts of papers/003, figs. 5 to 7, and table 2: `python -m reefgame.retarget_figures docs/pictures`.

The fish is one of our own species, filmed by tools/video/synthetic.py and followed like any clip.
"""

import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s
from components.segment import Pattern
from reefgame.console import say
from reefgame.content import load_species
from tools.video.follow import follow
from tools.video.images import Colour, Grey
from tools.video.motion import Motion, fin_tips, rebuilt_axis
from tools.video.retarget.choose import target_from
from tools.video.retarget.film import View, draw, water
from tools.video.retarget.intermediate import IntermediateMotion, intermediate
from tools.video.retarget.retarget import Placement, Retargeting
from tools.video.retarget.skeleton import BONES, NAMES
from tools.video.retarget.target import Target
from tools.video.retouch.edit import window_of
from tools.video.retouch.session import Session
from tools.video.synthetic import Setting, SyntheticClip
from tools.video.writing import LOSSLESS, write_film

SPECIES: Final = "parrotfish"
FRAMES: Final = 120
CELL: Final = (200, 250)
"""Width and height of one picture of a figure [px]."""
ROWS: Final = ("carp", "cartoon", "whale", "mermaid", "flower", "lobster")
SHOWN: Final = range(20, 65, 5)
"""Frames of fig. 7."""
EDITED: Final = (
    # what table 2 edits, and how much of the way from rest the edit keeps
    ("up_axis_angle_2", 0.80),
    ("up_axis_angle_3", 0.68),
    ("head_angle", 0.67),
    ("r_fin_angle", 0.21),
)
_INK: Final = (24, 40, 48)
_RED: Final = (226, 60, 44)
_FINE: Final = 2
_UP: Final = 0.5 * np.pi


def filmed(folder: Path) -> tuple[SyntheticClip, Motion]:
    """Return a clip of our own and the motion that `reefgame video` takes from it."""
    species = load_species(SPECIES)
    segments = species.repertoire.segments
    swim = next(s for s in segments if s.pattern == Pattern.SWIM_MEDIUM)
    clip = SyntheticClip(species.body, swim, Setting(travels=True, fins=1.4))
    path = folder / "swim.mkv"
    write_film(path, clip.frames(FRAMES), 60.0, LOSSLESS)
    return clip, follow(path).assembled.motion


def cell(play: Retargeting, angles: Float64s, zoom: float = 0.72) -> Colour:
    """Return a target at these angles (22,), its head up, as one picture of a figure."""
    width, height = (_FINE * side for side in CELL)
    picture = water(width, height)
    length = play.motion.length
    middle = np.array([0.0, 0.08 * length])
    view = View(width, height, middle, zoom * height / length)
    draw(picture, play, angles, Placement(np.zeros(2), _UP, play.scale), view)
    return np.asarray(cv2.resize(picture, CELL, interpolation=cv2.INTER_AREA), np.uint8)


def figure_7(motion: IntermediateMotion, clip: SyntheticClip) -> Colour:
    """Return the clip's frames above those of the six models, the rest pose first."""
    tops = [np.full((CELL[1], CELL[0], 3), 255, np.uint8)]
    tops += [clipped(clip.frame(frame), motion, frame) for frame in SHOWN]
    rows = [np.concatenate(tops, axis=1)]
    for name in ROWS:
        target = target_from(name)
        play = Retargeting(target, motion)
        poses = [target.rest_angles, *(play.angles(frame) for frame in SHOWN)]
        rows.append(np.concatenate([cell(play, pose) for pose in poses], axis=1))
    return np.concatenate(rows, axis=0)


def clipped(picture: Grey, motion: IntermediateMotion, frame: int) -> Colour:
    """Return a picture of the clip's size, as the fish lies at `frame`: in the middle, its head up."""
    turn = np.degrees(motion.direction[frame]) - 90.0
    scale = 0.72 * CELL[1] / motion.length
    x, y = (float(v) for v in motion.centre[frame])
    matrix = cv2.getRotationMatrix2D((x, y), -turn, scale)
    matrix[:, 2] += np.array([0.5 * CELL[0] - x, 0.46 * CELL[1] - y])
    grey = cv2.warpAffine(picture, matrix, CELL, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(cv2.cvtColor(grey, cv2.COLOR_GRAY2RGB), np.uint8)


def figure_5(clip: SyntheticClip, motion: Motion, target: Target, frame: int) -> Colour:
    """Return the tracked fish, its features, the model after the first level and after the second."""
    played = intermediate(motion)
    play = Retargeting(target, played)
    fish = clipped(clip.frame(frame), played, frame)
    marked = fish.copy()
    place = Placement(played.centre[frame], float(played.direction[frame]), 1.0)
    scale = 0.72 * CELL[1] / played.length
    points = np.concatenate(
        (rebuilt_axis(motion)[frame], fin_tips(motion)[frame], motion.junction[frame])
    )
    local = place.to_local(points) * (scale, -scale) + np.array([0.5 * CELL[0], 0.46 * CELL[1]])
    for number, (x, y) in enumerate(local):
        colour = _RED if number < BONES + 1 else (60, 150, 240)
        cv2.circle(marked, (round(float(x)), round(float(y))), 2, colour, -1, cv2.LINE_AA)
    angles = play.angles(frame)
    body = Retargeting(target, played, "none")
    return np.concatenate((fish, marked, cell(body, angles), cell(play, angles)), axis=1)


def fine_tuned(motion: IntermediateMotion, target: Target) -> tuple[Session, int, list[str]]:
    """Edit table 2's four angles where the right fin is bent most; return the session, the frame and the table."""
    play = Retargeting(target, motion)
    session = Session(motion.angles, play.motion_angles(target.rest_angles))
    away = np.abs(motion.angles - session.rest)
    fin = NAMES.index("r_fin_angle")
    frame = int(np.argmax(away[10:-10, fin])) + 10
    lines = ["| u | I | r | p | q | M_0 | M_r | M' |", "|---|---|---|---|---|---|---|---|"]
    for name, kept in EDITED:
        column = NAMES.index(name)
        rest, before = float(session.rest[column]), float(session.angles[frame, column])
        wanted = rest + kept * (before - rest)
        first, last = window_of(session.angles[:, column] - rest, frame)
        session.edit(frame, column, wanted)
        lines.append(
            f"| {name} | 1 | {frame} | {first} | {last} | {rest:.4f} | {before:.4f} | {wanted:.4f} |"
        )
    return session, frame, lines


def figure_6(motion: IntermediateMotion, target: Target) -> tuple[Colour, list[str]]:
    """Return eleven frames before and after one frame's edit, and table 2's lines."""
    session, frame, lines = fine_tuned(motion, target)
    play = Retargeting(target, motion)
    shown = range(frame - 4, frame + 7)
    rows = [_row(play, values, shown) for values in (session.original, session.angles)]
    left = 4 * CELL[0]
    cv2.rectangle(rows[1], (left + 1, 1), (left + CELL[0] - 2, CELL[1] - 2), _RED, 2)
    return np.concatenate(rows, axis=0), lines


def _row(play: Retargeting, values: Float64s, shown: Sequence[int]) -> Colour:
    pictures = [cell(play, play.target_angles(values[frame])) for frame in shown]
    for picture, frame in zip(pictures, shown, strict=True):
        cv2.putText(
            picture, str(frame), (8, 20), cv2.FONT_HERSHEY_SIMPLEX, 0.5, _INK, 1, cv2.LINE_AA
        )
    return np.concatenate(pictures, axis=1)


def main(folder: Path) -> None:
    """Write the three figures and print the table."""
    with TemporaryDirectory() as kept:
        clip, motion = filmed(Path(kept))
    played, carp = intermediate(motion), target_from("carp")
    tuned, lines = figure_6(played, carp)
    pictures = {
        "retarget_levels": figure_5(clip, motion, carp, 45),
        "retarget_tuned": tuned,
        "retarget_models": figure_7(played, clip),
    }
    for name, picture in pictures.items():
        write_picture(folder / f"{name}.png", picture, 1.0 if picture.shape[1] <= 1000 else 0.6)
    say("\n".join(lines))


def write_picture(path: Path, picture: Colour, scale: float) -> None:
    """Write a figure as PNG, made smaller by `scale`."""
    size = (round(scale * picture.shape[1]), round(scale * picture.shape[0]))
    smaller = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    bgr = cv2.cvtColor(smaller, cv2.COLOR_RGB2BGR)
    _, content = cv2.imencode(".png", bgr, [cv2.IMWRITE_PNG_COMPRESSION, 9])
    path.write_bytes(content.tobytes())


if __name__ == "__main__":
    main(Path(sys.argv[1]))
