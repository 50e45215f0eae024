"""Paints what every fish has: cheek, gill cover, mouth, eye, lateral line and the root of the tail."""

import numpy as np

from components.skin import Eye, Skin
from systems.view.fish_outline import Outline
from systems.view.skin_canvas import Canvas, distance_to, ease, height_of, inside_of


def lateral_line(canvas: Canvas, skin: Skin) -> None:
    """Draw the dotted line of sense organs along the flank."""
    at = 0.28 - 0.28 * canvas.s + 0.02 * np.sin(9.0 * canvas.s)
    dots = 0.65 + 0.35 * np.cos(canvas.s * 420.0)
    reach = ease(np.clip((canvas.s - skin.gill_at) / 0.05, 0.0, 1.0))
    line = np.exp(-(((canvas.h - at) * canvas.half / 0.0035) ** 2)) * dots * reach
    canvas.shade(1.0 - 0.22 * line)


def tail_root(canvas: Canvas, skin: Skin) -> None:
    """Let the body's end run into the caudal fin's colour with an uneven border of scales."""
    border = 0.962 - 0.02 * np.cos(5.0 * canvas.h) + 0.012 * canvas.noise
    canvas.lay(skin.tail, 0.92 * inside_of(border - canvas.s, 0.05))


def cheek(canvas: Canvas, skin: Skin, outline: Outline) -> None:
    """Give the head a smooth swelling cheek in the relief."""
    swelling = distance_to(canvas, outline, 0.7 * skin.gill_at, -0.2) / (0.45 * skin.gill_at)
    canvas.relief += 0.06 * np.exp(-(swelling**2))


def gill_cover(canvas: Canvas, skin: Skin) -> None:
    """Draw the gill cover's edge, its shadow and the fold of the cheek."""
    limit = np.clip((0.62 - np.abs(canvas.h + 0.12)) / 0.14, 0.0, 1.0)
    curve = skin.gill_at - 0.075 * (canvas.h + 0.1) ** 2
    behind = canvas.s - curve
    line = np.exp(-((behind / 0.0045) ** 2)) * ease(limit)
    lip = np.exp(-(((behind + 0.012) / 0.009) ** 2)) * ease(limit)
    shadow = np.exp(-np.clip(behind, 0.0, 1.0) / 0.022) * (behind > 0.0) * ease(limit)
    canvas.shade(1.0 - skin.gill_strength * (0.75 * line + 0.28 * shadow))
    canvas.shade(1.0 + 0.22 * skin.gill_strength * lip)
    canvas.relief += skin.gill_strength * (0.35 * lip - 0.4 * line)
    cheek = skin.gill_at * 0.72 - 0.06 * (canvas.h + 0.2) ** 2
    fold = np.exp(-(((canvas.s - cheek) / 0.004) ** 2)) * ease(limit)
    canvas.shade(1.0 - 0.3 * skin.gill_strength * fold)


def gill_slits(canvas: Canvas, skin: Skin) -> None:
    """Draw a shark's gill slits: the last at `gill_at`, the others ahead of it."""
    limit = ease(np.clip((0.42 - np.abs(canvas.h + 0.08)) / 0.12, 0.0, 1.0))
    for slit in range(skin.gill_slits):
        at = skin.gill_at - 0.0125 * slit
        behind = canvas.s - at + 0.02 * (canvas.h + 0.1) ** 2 + 0.006 * canvas.h
        line = np.exp(-((behind / 0.0018) ** 2)) * limit
        lip = np.exp(-(((behind + 0.004) / 0.003) ** 2)) * limit
        canvas.shade(1.0 - skin.gill_strength * (0.8 * line - 0.12 * lip))
        canvas.relief += skin.gill_strength * (0.08 * lip - 0.12 * line)


def mouth(canvas: Canvas, skin: Skin, outline: Outline) -> None:
    """Draw the slit of the mouth and its lips."""
    if skin.mouth is None:
        tip = float(outline.middle(np.zeros(1))[0]) / outline.end
        start, long = 0.0, 0.34 * outline.first / outline.end
        level = tip - 0.12 * canvas.s
    else:
        (start, front), (long, corner) = skin.mouth.front, skin.mouth.corner
        rise = height_of(outline, long, corner) - height_of(outline, start, front)
        level = height_of(outline, start, front) + rise * (canvas.s - start) / max(
            long - start, 1e-3
        )
    along = np.clip((long - canvas.s) / max(0.35 * (long - start), 1e-3), 0.0, 1.0)
    along = along * np.clip((canvas.s - start) / 0.004 + 1.0, 0.0, 1.0)
    above = canvas.side - level
    line = np.exp(-((above / 0.0032) ** 2)) * along
    lips = np.exp(-((above / 0.010) ** 2)) * along
    canvas.shade(1.0 + 0.12 * lips)
    canvas.shade(1.0 - 0.75 * line)
    canvas.relief += 0.12 * lips - 0.15 * line


def eyeball(canvas: Canvas, eye: Eye, outline: Outline) -> None:
    """Draw iris, pupil and glint, and raise the eyeball."""
    away = distance_to(canvas, outline, *eye.at) / eye.radius
    height = (canvas.side - height_of(outline, *eye.at)) / eye.radius
    ahead = (canvas.s - eye.at[0]) / eye.radius
    canvas.shade(1.0 - 0.45 * np.exp(-(((away - 1.05) / 0.22) ** 2)))
    iris = np.array(eye.iris)
    inside = inside_of(away - 1.0, 0.16)
    ring = np.clip((away - eye.pupil) / (1.0 - eye.pupil), 0.0, 1.0)
    tone = (0.72 + 0.5 * np.exp(-(((ring - 0.25) / 0.3) ** 2)) - 0.35 * ring**3)[..., None]
    tone = tone * (1.0 - 0.22 * np.clip(height, -1.0, 1.0))[..., None]
    canvas.lay(np.clip(iris * tone, 0.0, 1.0), inside)
    canvas.lay((0.012, 0.014, 0.02), inside_of(away - eye.pupil, 0.12))
    glint = np.hypot(ahead + 0.26, height - 0.3) / 0.19
    canvas.lay((0.97, 0.99, 1.0), 0.95 * inside_of(glint - 1.0, 0.6))
    canvas.relief = np.where(
        away < 1.15, 0.5 + 0.45 * np.clip(1.15 - away, 0.0, 1.0), canvas.relief
    )
