"""The canvas on which a skin's body half is painted, and the strokes that all painters share.

Everything is drawn in places of the body (s, h) and, where shapes must stay round, in the plane seen from the side, in
units of s.
"""

from dataclasses import dataclass
from typing import Final, TypeAlias

import numpy as np

from components.arrays import Float64s
from components.skin import Colour
from systems.view.fish_outline import Outline
from systems.view.fish_surface import BODY_BOX

SIZE: Final = 512
"""Texels along each side of a layer."""
HALF: Final = SIZE // 2
"""Rows of the body's half; the fins' half follows."""
Box: TypeAlias = tuple[float, float, float, float]


@dataclass
class Canvas:
    """The body's half being painted; arrays are (256, 512)."""

    s: Float64s
    "place along the body, 0 at the nose to 1"
    h: Float64s
    "height, -1 at the belly to 1 at the back"
    side: Float64s
    "height in the picture from the side, in units of s"
    half: Float64s
    "half-height of the body there, in units of s"
    noise: Float64s
    "smooth noise, -1 to 1"
    colour: Float64s
    "(256, 512, 3)"
    relief: Float64s
    "0 to 1, 0.5 is flat"

    def lay(self, colour: Colour | Float64s, cover: Float64s) -> None:
        """Lay `colour` over the canvas where `cover` is 1."""
        self.colour += (np.asarray(colour) - self.colour) * cover[..., None]

    def shade(self, factor: Float64s) -> None:
        """Multiply the colour."""
        self.colour *= factor[..., None]


def blank_canvas(outline: Outline) -> Canvas:
    """Return the unpainted canvas of a body."""
    left, top, right, bottom = BODY_BOX
    s = np.clip(((np.arange(SIZE) + 0.5) / SIZE - left) / (right - left), 0.0, 1.0)[None, :]
    around = np.clip(((np.arange(HALF) + 0.5) / SIZE - top) / (bottom - top), 0.0, 1.0)[:, None]
    h = np.cos(np.pi * around)
    half = outline.half_height(s * outline.end) / outline.end
    side = outline.middle(s * outline.end) / outline.end + h * half
    fine = smooth_noise(SIZE, HALF, (48, 24), 7) * 0.4 + smooth_noise(SIZE, HALF, (14, 7), 8) * 0.6
    shape = (HALF, SIZE)
    return Canvas(
        np.broadcast_to(s, shape),
        np.broadcast_to(h, shape),
        side,
        np.broadcast_to(half, shape),
        fine,
        np.full((*shape, 3), 0.6),
        np.full(shape, 0.5),
    )


def smooth_noise(width: int, height: int, cells: tuple[int, int], seed: int) -> Float64s:
    """Return value noise from -1 to 1 with `cells` (across, down) lattice cells, (height, width)."""
    lattice = np.random.default_rng(seed).uniform(-1.0, 1.0, (cells[1] + 2, cells[0] + 2))
    x, y = np.linspace(0, cells[0], width), np.linspace(0, cells[1], height)
    i, j = x.astype(int), y.astype(int)
    fx, fy = ease(x - i), ease(y - j)[:, None]
    low, high = lattice[j], lattice[j + 1]
    top = low[:, i] + (low[:, i + 1] - low[:, i]) * fx
    bottom = high[:, i] + (high[:, i + 1] - high[:, i]) * fx
    noise: Float64s = top + (bottom - top) * fy
    return noise


def ease(t: Float64s) -> Float64s:
    """Return a smooth step from 0 to 1 of t in [0, 1]."""
    eased: Float64s = t * t * (3.0 - 2.0 * t)
    return eased


def inside_of(distance: Float64s, softness: float) -> Float64s:
    """Return 1 where `distance` is negative, 0 beyond, eased over `softness`."""
    return ease(np.clip(0.5 - distance / max(softness, 1e-6), 0.0, 1.0))


def distance_to(canvas: Canvas, outline: Outline, s: float, h: float) -> Float64s:
    """Return the distance from (s, h) in the picture from the side, in units of s."""
    away: Float64s = np.hypot(canvas.s - s, canvas.side - height_of(outline, s, h))
    return away


def height_of(outline: Outline, s: float, h: float) -> float:
    """Return the height of (s, h) in the picture from the side, in units of s."""
    x = np.array([s * outline.end])
    return float((outline.middle(x) + h * outline.half_height(x))[0]) / outline.end


def unboxed(box: Box) -> tuple[slice, slice, Float64s, Float64s]:
    """Return the texels of a box with its gutter, and the places 0 to 1 of their columns and rows."""
    left, top, right, bottom = box
    edges = [np.floor(v * SIZE).astype(int) for v in (left, top, right, bottom)]
    columns = slice(max(edges[0] - 3, 0), min(edges[2] + 4, SIZE))
    rows = slice(max(edges[1] - 3, 0), min(edges[3] + 4, SIZE))
    x = (np.arange(columns.start, columns.stop) + 0.5) / SIZE
    y = (np.arange(rows.start, rows.stop) + 0.5) / SIZE
    across = np.clip((x - left) / (right - left), 0.0, 1.0)
    down = np.clip((y - top) / (bottom - top), 0.0, 1.0)
    return rows, columns, across[None, :], down[:, None]
