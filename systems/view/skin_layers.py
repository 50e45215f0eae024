"""Paints the layers that a modder lists: gradients, stripes, spots, patches, scales (components/skin.py)."""

import numpy as np

from components.skin import Gradient, Layer, Patch, Scales, Skin, Spots, Stripes
from systems.view.fish_outline import Outline
from systems.view.skin_canvas import Canvas, distance_to, ease, height_of, inside_of


def paint_layer(canvas: Canvas, layer: Layer, skin: Skin, outline: Outline) -> None:
    """Paint one layer over what the canvas holds."""
    match layer:
        case Gradient():
            _gradient(canvas, layer)
        case Stripes():
            _stripes(canvas, layer)
        case Spots():
            _spots(canvas, layer, outline)
        case Patch():
            _patch(canvas, layer, outline)
        case Scales():
            _scales(canvas, layer, skin)


def _gradient(canvas: Canvas, layer: Gradient) -> None:
    low, high = (0.0, 1.0) if layer.along else (-1.0, 1.0)
    at = np.array(layer.at) if layer.at else np.linspace(low, high, len(layer.colours))
    place = (canvas.s if layer.along else canvas.h) + 0.035 * canvas.noise
    colours = np.array(layer.colours)
    channels = [np.interp(place, at, colours[:, c]) for c in range(3)]
    canvas.colour = np.stack(channels, axis=-1)


def _stripes(canvas: Canvas, layer: Stripes) -> None:
    if layer.along:
        across, bulge, place = canvas.h, 4.0 * canvas.s * (1.0 - canvas.s), canvas.s
    else:
        across, bulge, place = canvas.s, 1.0 - canvas.h**2, canvas.h
    low, high = layer.reach
    ends = np.maximum(low - place, place - high) * (1.0 if layer.along else 0.3)
    if layer.reach == (-1.0, 1.0):
        ends = np.full_like(ends, -1.0)
    for at in layer.at:
        offset = np.abs(across - at - layer.bow * bulge + layer.wobble * 0.05 * canvas.noise)
        distance = np.maximum(offset - 0.5 * layer.width, ends)
        if layer.edge is not None:
            canvas.lay(layer.edge, inside_of(distance - layer.edge_width, layer.softness))
        canvas.lay(layer.colour, inside_of(distance, layer.softness))


def _spots(canvas: Canvas, layer: Spots, outline: Outline) -> None:
    rng = np.random.default_rng(layer.seed)
    jitter = rng.uniform(-1.0, 1.0, (layer.count, 3))
    low, high = layer.reach
    if layer.in_row:
        s = low + (high - low) * (np.arange(layer.count) + 0.5 + 0.12 * jitter[:, 0]) / layer.count
    else:
        s = low + (high - low) * (0.5 + 0.5 * jitter[:, 0])
    h = np.mean(layer.height) + 0.5 * (layer.height[1] - layer.height[0]) * jitter[:, 1]
    size = layer.size * (1.0 + 0.3 * jitter[:, 2])
    for place, height, radius in zip(s, h, size, strict=True):
        away = distance_to(canvas, outline, place, height) - radius
        canvas.lay(layer.colour, 0.9 * inside_of(away + 0.2 * radius * canvas.noise, 0.8 * radius))


def _patch(canvas: Canvas, layer: Patch, outline: Outline) -> None:
    s, h = layer.at
    tall = layer.size[1] * float(outline.half_height(np.array([s * outline.end]))[0]) / outline.end
    turn = np.radians(layer.tilt_deg)
    dx, dy = canvas.s - s, canvas.side - height_of(outline, s, h)
    along = (dx * np.cos(turn) + dy * np.sin(turn)) / layer.size[0]
    across = (dy * np.cos(turn) - dx * np.sin(turn)) / tall
    radius = np.hypot(along, across) + 0.04 * canvas.noise
    cover = inside_of(radius - 1.0, layer.softness)
    if layer.hollow > 0.0:
        cover = cover * (1.0 - inside_of(radius - layer.hollow, layer.softness))
    canvas.lay(layer.colour, cover)


def _scales(canvas: Canvas, layer: Scales, skin: Skin) -> None:
    """Draw overlapping round scales in rows: a dark rim behind each, a light middle."""
    row = canvas.side / (0.62 * layer.size)
    best = np.zeros_like(row)
    rim = np.zeros_like(row)
    for step in (0, 1):
        index = np.floor(row) + step
        shift = 0.5 * (index % 2)
        u = canvas.s / layer.size + shift
        du = u - np.floor(u) - 0.5
        dv = (row - index) * 0.62
        radius = np.hypot(du * 1.05, dv)
        inside = ease(np.clip((0.58 - radius) / 0.14, 0.0, 1.0))
        best = np.maximum(best, inside * (0.55 + 0.9 * du))
        rim = np.maximum(rim, inside)
    fade = np.clip((canvas.s - skin.gill_at + 0.06 * canvas.h**2 - 0.005) / 0.03, 0.0, 1.0)
    fade = fade * np.clip(1.3 - np.abs(canvas.h) ** 6, 0.0, 1.0)
    canvas.shade(1.0 + layer.strength * fade * (0.8 * (best - 0.45) + 0.35 * (rim - 1.0)))
    canvas.relief += 0.5 * layer.strength * fade * (best - 0.5)
