"""Paints the fins' half of a layer: rays, membranes, rims; the fourth channel is opacity."""

import numpy as np

from components.arrays import Float64s
from components.skin import Skin
from systems.view.fish_fins import ANAL_BOX, CAUDAL_BOX, DORSAL_BOX, PECTORAL_BOX, PELVIC_BOX
from systems.view.skin_canvas import HALF, Box, Canvas, inside_of, unboxed


def paint_fins(picture: Float64s, skin: Skin, canvas: Canvas) -> None:
    """Paint the lower half of `picture`, (512, 512, 4); fins take on the body's colours where they are rooted."""
    flesh = np.median(canvas.colour[90:150, -14:], axis=(0, 1))
    back, belly = (np.median(canvas.colour[y, 200:420], axis=0) for y in (6, -16))
    picture[HALF:, :, :3] = skin.fin
    _caudal(picture, skin, flesh)
    _median(picture, skin, DORSAL_BOX, back, flip=False)
    _median(picture, skin, ANAL_BOX, belly, flip=True)
    for box, wave in ((PECTORAL_BOX, 6.0), (PELVIC_BOX, 5.0)):
        _blade(picture, skin, box, wave)


def _rays(phase: Float64s) -> Float64s:
    """Return 1 on a fin ray and 0 on the membrane between, one ray a unit of `phase`."""
    return (0.5 + 0.5 * np.cos(2.0 * np.pi * phase)) ** 2


def _caudal(picture: Float64s, skin: Skin, flesh: Float64s) -> None:
    rows, columns, r, down = unboxed(CAUDAL_BOX)
    q = 1.0 - 2.0 * down
    fork = np.clip((r - 0.45) / 0.1, 0.0, 1.0)
    rays = _rays(8.5 * q) * (1.0 - fork) + _rays(17.0 * q + 0.25) * fork
    joints = 0.9 + 0.1 * np.cos(2 * np.pi * r * 26.0)
    colour = np.array(skin.tail) * (0.8 + 0.3 * rays * joints - 0.12 * r)[..., None]
    if skin.tail_edge is not None:
        rim = inside_of(0.78 - np.abs(q) + 0.12 * r, 0.12) * inside_of(0.06 - r, 0.1)
        colour += (np.array(skin.tail_edge) - colour) * rim[..., None]
    base = inside_of(r - 0.13 - 0.06 * np.cos(9.0 * q), 0.16)
    colour += (flesh - colour) * np.broadcast_to(base, rays.shape)[..., None]
    notches = 0.012 * (1.0 - rays)
    opaque = skin.fin_opacity + (1.0 - skin.fin_opacity) * np.maximum(rays, base)
    opaque = opaque * (1.0 - 0.25 * r**3)
    corner = np.hypot(np.clip(np.abs(q) - 0.86, 0, 1) / 0.14, np.clip(r - 0.9, 0, 1) / 0.1)
    edge = inside_of(r - 0.985 + notches, 0.02) * inside_of(corner - 0.95, 0.2)
    picture[rows, columns, :3] = colour
    picture[rows, columns, 3] = opaque * edge


def _median(picture: Float64s, skin: Skin, box: Box, flesh: Float64s, flip: bool) -> None:
    rows, columns, v, down = unboxed(box)
    out = 1.0 - down
    rays = _rays(22.0 * (v - 0.05 * out)) * np.ones_like(out)
    spines = inside_of(v - 0.5, 0.1)
    colour = np.array(skin.fin) * (0.82 + 0.28 * rays - 0.1 * out)[..., None]
    if skin.fin_edge is not None:
        rim = np.broadcast_to(inside_of(0.8 - out, 0.1), rays.shape)
        colour += (np.array(skin.fin_edge) - colour) * rim[..., None]
    base = np.broadcast_to(inside_of(out - 0.1, 0.25), rays.shape)
    colour += (flesh - colour) * (0.8 * base)[..., None]
    opaque = skin.fin_opacity + (1.0 - skin.fin_opacity) * np.maximum(0.8 * rays, base)
    notch = (0.03 + 0.09 * spines * (not flip)) * (1.0 - rays)
    ends = inside_of(0.004 - v, 0.02) * inside_of(v - 0.99, 0.02)
    picture[rows, columns, :3] = colour
    picture[rows, columns, 3] = opaque * inside_of(out - 0.975 + notch, 0.04) * ends


def _blade(picture: Float64s, skin: Skin, box: Box, wave: float) -> None:
    rows, columns, r, down = unboxed(box)
    q = 1.0 - 2.0 * down
    rays = _rays(wave * q + 0.5)
    own = np.array(skin.pectoral if skin.pectoral is not None else skin.fin)
    colour = own * (0.8 + 0.35 * rays - 0.1 * r)[..., None]
    reach = 0.98 - 0.28 * np.abs(q) ** 2.6 - 0.02 * (1.0 - rays)
    opaque = (0.8 * skin.fin_opacity + (1.0 - 0.8 * skin.fin_opacity) * rays) * (1.0 - 0.2 * r)
    picture[rows, columns, :3] = colour
    picture[rows, columns, 3] = opaque * inside_of(r - reach, 0.05)
