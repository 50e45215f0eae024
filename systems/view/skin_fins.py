"""Paints the fins' half of a layer: rays, membranes, rims, marks; the fourth channel is opacity.

A fin whose body gives it a profile is a whole strip that its opacity cuts into shape.
"""

from typing import Final

import numpy as np

from components.arrays import Float64s
from components.body import Body, Fin
from components.skin import FinLines, FinName, Skin
from systems.view.fish_fins import ANAL_BOX, CAUDAL_BOX, DORSAL_BOX, PECTORAL_BOX, PELVIC_BOX
from systems.view.fish_outline import outline_of
from systems.view.fish_surface import BODY_BOX
from systems.view.skin_canvas import HALF, SIZE, Box, Canvas, inside_of, unboxed

_TIP: Final = 0.66
"""Where a coloured tip begins, 0 root to 1 edge."""


def paint_fins(picture: Float64s, skin: Skin, canvas: Canvas, body: Body) -> None:
    """Paint the lower half of `picture`, (512, 512, 4); fins take on the body's colours where they are rooted."""
    flesh = np.median(canvas.colour[90:150, -14:], axis=(0, 1))
    picture[HALF:, :, :3] = skin.fin
    _caudal(picture, skin, flesh)
    medians: tuple[tuple[FinName, Box, Fin | None], ...] = (
        ("dorsal", DORSAL_BOX, body.dorsal),
        ("anal", ANAL_BOX, body.anal),
    )
    for name, box, fin in medians:
        row = 6 if name == "dorsal" else -16
        beside = np.median(canvas.colour[row, 200:420], axis=0) + np.zeros((1, 3))
        if fin is not None:
            beside = beside + (_beside(canvas, body, fin, box, row) - beside) * skin.fin_follow
        _median(picture, skin, name, box, fin, beside)
    waves: tuple[tuple[FinName, Box, float], ...] = (
        ("pectoral", PECTORAL_BOX, 6.0),
        ("pelvic", PELVIC_BOX, 5.0),
    )
    for name, box, wave in waves:
        _blade(picture, skin, name, box, wave, body.pectoral_held)


def _rays(skin: Skin, phase: Float64s) -> Float64s:
    """Return 1 on a fin ray and less on the membrane between, one ray a unit of `phase`."""
    between = 1.0 - (0.5 + 0.5 * np.cos(2.0 * np.pi * phase)) ** 2
    return 1.0 - skin.fin_rays * between


def _marked(
    skin: Skin, name: FinName, colour: Float64s, along: Float64s, out: Float64s, limit: Float64s
) -> Float64s:
    """Lay the skin's marks on a fin over `colour`, (rows, columns, 3); return how much they cover.

    Patches lie at distances `out` from the root; lines follow the fin's edge, which is `limit` away.
    """
    covered = np.zeros(colour.shape[:2])
    for mark in skin.fin_marks:
        if mark.fin != name:
            continue
        if isinstance(mark, FinLines):
            lines = [
                np.abs(out / np.maximum(limit, 0.05) - at) - 0.5 * mark.width for at in mark.at
            ]
            cover = inside_of(np.minimum.reduce(lines), mark.softness)
        else:
            (x, y), (long, high) = mark.at, mark.size
            cover = inside_of(np.hypot((along - x) / long, (out - y) / high) - 1.0, mark.softness)
        colour += (np.array(mark.colour) - colour) * cover[..., None]
        covered = np.maximum(covered, cover)
    return covered


def _tipped(skin: Skin, colour: Float64s, out: Float64s) -> Float64s:
    """Lay the tips' colour over `colour` where `out` nears 1; return how much it covers."""
    if skin.fin_tip is None:
        return np.zeros(colour.shape[:2])
    cover = np.broadcast_to(inside_of(_TIP - out, 0.12), colour.shape[:2])
    colour += (np.array(skin.fin_tip) - colour) * cover[..., None]
    return cover


def _caudal(picture: Float64s, skin: Skin, flesh: Float64s) -> None:
    rows, columns, r, down = unboxed(CAUDAL_BOX)
    q = 1.0 - 2.0 * down
    fork = np.clip((r - 0.45) / 0.1, 0.0, 1.0)
    rays = _rays(skin, 8.5 * q) * (1.0 - fork) + _rays(skin, 17.0 * q + 0.25) * fork
    joints = 0.9 + 0.1 * np.cos(2 * np.pi * r * 26.0)
    colour = np.array(skin.tail) * (0.8 + 0.3 * rays * joints - 0.12 * r)[..., None]
    along, out = np.broadcast_to(down, rays.shape), np.broadcast_to(r, rays.shape)
    covered = _marked(skin, "tail", colour, along, out, np.ones_like(r))
    covered = np.maximum(covered, _tipped(skin, colour, out * np.clip(1.7 * np.abs(q) - 0.4, 0, 1)))
    if skin.tail_edge is not None:
        rim = inside_of(0.78 - np.abs(q) + 0.12 * r, 0.12) * inside_of(0.06 - r, 0.1)
        colour += (np.array(skin.tail_edge) - colour) * rim[..., None]
    base = inside_of(r - 0.13 - 0.06 * np.cos(9.0 * q), 0.16)
    colour += (flesh - colour) * np.broadcast_to(base, rays.shape)[..., None]
    notches = 0.012 * (1.0 - rays)
    opaque = skin.fin_opacity + (1.0 - skin.fin_opacity) * np.maximum(
        np.maximum(rays, base), covered
    )
    opaque = opaque * (1.0 - 0.25 * r**3)
    corner = np.hypot(np.clip(np.abs(q) - 0.86, 0, 1) / 0.14, np.clip(r - 0.9, 0, 1) / 0.1)
    edge = inside_of(r - 0.985 + notches, 0.02) * inside_of(corner - 0.95, 0.2)
    picture[rows, columns, :3] = colour
    picture[rows, columns, 3] = opaque * edge


def _beside(canvas: Canvas, body: Body, fin: Fin, box: Box, row: int) -> Float64s:
    """Return the colours of the body's `row` beside each column of a median fin's box, (columns, 3)."""
    _, _, v, _ = unboxed(box)
    x = (fin.start + (fin.end - fin.start) * v[0]) / outline_of(body).end
    column = (BODY_BOX[0] + np.clip(x, 0.0, 1.0) * (BODY_BOX[2] - BODY_BOX[0])) * SIZE
    colours: Float64s = canvas.colour[row, column.astype(int).clip(0, SIZE - 1)]
    return colours


def _limit(fin: Fin | None, v: Float64s) -> Float64s:
    """Return how far out a fin reaches, 0 to 1, along it."""
    if fin is None or not fin.profile:
        return np.ones_like(v)
    fine = np.interp(v, np.linspace(0.0, 1.0, len(fin.profile)), fin.profile)
    kernel = np.hanning(11) / np.hanning(11).sum()
    padded = np.pad(fine[0], 5, mode="edge")
    return np.convolve(padded, kernel, mode="valid")[None, :]


def _median(
    picture: Float64s, skin: Skin, name: FinName, box: Box, fin: Fin | None, beside: Float64s
) -> None:
    rows, columns, v, down = unboxed(box)
    out = 1.0 - down
    limit = _limit(fin, v)
    own = (skin.dorsal if name == "dorsal" else skin.anal) or skin.fin
    ground = np.array(own) + (beside - np.array(own)) * skin.fin_follow
    rays = _rays(skin, 22.0 * (v - 0.05 * out)) * np.ones_like(out)
    spines = inside_of(v - 0.5, 0.1)
    colour = ground[None, :, :] * (0.82 + 0.28 * rays - 0.1 * out)[..., None]
    along = np.broadcast_to(v, rays.shape)
    covered = _marked(skin, name, colour, along, out * np.ones_like(v), limit)
    covered = np.maximum(covered, _tipped(skin, colour, out * np.ones_like(v)))
    if skin.fin_edge is not None:
        rim = np.broadcast_to(inside_of(limit - skin.fin_edge_width - out, 0.1), rays.shape)
        colour += (np.array(skin.fin_edge) - colour) * rim[..., None]
    base = np.broadcast_to(inside_of(out - 0.1, 0.25), rays.shape)
    colour += (beside[None] - colour) * (0.8 * base)[..., None]
    solid = np.maximum(np.maximum(0.8 * rays, base), covered)
    opaque = skin.fin_opacity + (1.0 - skin.fin_opacity) * solid
    notch = (
        (0.03 + 0.09 * spines * (name == "dorsal")) * (1.0 - rays) * np.minimum(1.0, 2.0 * limit)
    )
    ends = inside_of(0.004 - v, 0.02) * inside_of(v - 0.99, 0.02)
    picture[rows, columns, :3] = colour
    picture[rows, columns, 3] = opaque * inside_of(out - 0.975 * limit + notch, 0.04) * ends


def _blade(picture: Float64s, skin: Skin, name: FinName, box: Box, wave: float, held: bool) -> None:
    rows, columns, r, down = unboxed(box)
    q = 1.0 - 2.0 * down
    rays = _rays(skin, wave * q + 0.5)
    own = skin.pectoral or skin.fin
    if name == "pelvic":
        own = skin.pelvic or own
    colour = np.array(own) * (0.8 + 0.35 * rays - 0.1 * r)[..., None]
    along, out = (np.broadcast_to(place, colour.shape[:2]) for place in (down, r))
    covered = _marked(skin, name, colour, along, out, np.ones_like(r))
    covered = np.maximum(covered, _tipped(skin, colour, out))
    reach = 0.98 - 0.28 * np.abs(q) ** 2.6 - 0.02 * (1.0 - rays)
    ground = 0.8 * skin.fin_opacity
    opaque = (ground + (1.0 - ground) * np.maximum(rays, covered)) * (1.0 - 0.2 * r * (not held))
    picture[rows, columns, :3] = colour
    picture[rows, columns, 3] = opaque * inside_of(r - reach, 0.05)
