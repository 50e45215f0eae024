"""Paints the layers that a modder lists (components/skin.py)."""

from typing import Final

import numpy as np

from components.arrays import Float64s
from components.skin import Band, Gradient, Hatch, Layer, Patch, Scales, Skin, Spots, Stripes
from systems.view.fish_outline import Outline
from systems.view.skin_canvas import Canvas, distance_to, ease, height_of, inside_of

_STEPS: Final = 6
"""Straight pieces from one point of a band to the next."""


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
        case Band():
            _band(canvas, layer, outline)
        case Hatch():
            _hatch(canvas, layer)
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
    across = (dy * np.cos(turn) - dx * np.sin(turn)) / max(tall, 1e-3)
    radius = np.hypot(along, across) + 0.04 * canvas.noise
    cover = inside_of(radius - 1.0, layer.softness)
    if layer.hollow > 0.0:
        cover = cover * (1.0 - inside_of(radius - layer.hollow, layer.softness))
    canvas.lay(layer.colour, cover)


def _band(canvas: Canvas, layer: Band, outline: Outline) -> None:
    """Draw a band along a smooth curve through its points (Catmull and Rom 1974), in the plane seen from the side."""
    knots = np.array([(s, height_of(outline, s, h)) for s, h in layer.points])
    at = np.linspace(0.0, len(knots) - 1.0, _STEPS * (len(knots) - 1) + 1)
    curve = _smooth(knots, at)
    width = np.interp(at / at[-1], np.linspace(0.0, 1.0, len(layer.width)), layer.width)
    reach = width.max() + layer.edge_width + layer.softness
    near = np.abs(canvas.s[0] - 0.5 * (curve[:, 0].min() + curve[:, 0].max()))
    columns = near < 0.5 * np.ptp(curve[:, 0]) + reach
    s, side = canvas.s[:, columns], canvas.side[:, columns]
    inside = np.full(s.shape, 1.0)
    for (x, y), (dx, dy), wide, change in zip(
        curve, np.diff(curve, axis=0), width, np.diff(width), strict=False
    ):
        t = np.clip(((s - x) * dx + (side - y) * dy) / max(dx * dx + dy * dy, 1e-12), 0.0, 1.0)
        away = np.hypot(s - x - t * dx, side - y - t * dy) - 0.5 * (wide + change * t)
        inside = np.minimum(inside, away)
    distance = np.full(canvas.s.shape, 1.0)
    distance[:, columns] = inside
    if layer.edge is not None:
        canvas.lay(layer.edge, inside_of(distance - layer.edge_width, layer.softness))
    canvas.lay(layer.colour, inside_of(distance, layer.softness))


def _smooth(knots: Float64s, at: Float64s) -> Float64s:
    """Return the points of a Catmull-Rom curve through `knots` (n, 2) at parameters from 0 to n - 1."""
    ends = np.concatenate((2 * knots[:1] - knots[1:2], knots, 2 * knots[-1:] - knots[-2:-1]))
    i = np.minimum(at.astype(int), len(knots) - 2)
    t = (at - i)[:, None]
    a, b, c, d = (ends[i + k] for k in range(4))
    curve: Float64s = b + 0.5 * t * (
        c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a))
    )
    return curve


def _hatch(canvas: Canvas, layer: Hatch) -> None:
    """Draw parallel lines; a wobble lets them wander, so that they look grown."""
    turn = np.radians(layer.tilt_deg)
    (left, right), (low, high) = layer.reach, layer.height
    middle = (canvas.s - left) / max(right - left, 1e-6)
    across = canvas.side * np.cos(turn) - canvas.s * np.sin(turn)
    across = across - 4.0 * layer.bow * middle * (1.0 - middle)
    phase = across / layer.spacing + 0.35 * layer.wobble * canvas.noise
    distance = layer.spacing * np.abs(phase - np.floor(phase) - 0.5) - 0.5 * layer.width
    within = np.minimum(canvas.s - left, right - canvas.s) / layer.fade
    inside = np.minimum(canvas.h - low, high - canvas.h) * canvas.half / layer.fade
    ends = ease(np.clip(np.minimum(within, inside) + 0.5, 0.0, 1.0))
    canvas.lay(layer.colour, inside_of(distance, layer.softness) * ends)


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
    if layer.rim is not None:
        canvas.lay(layer.rim, fade * ease(np.clip((0.62 - best) / 0.3, 0.0, 1.0)))
    canvas.shade(1.0 + layer.strength * fade * (0.8 * (best - 0.45) + 0.35 * (rim - 1.0)))
    canvas.relief += 0.5 * layer.strength * fade * (best - 0.5)
