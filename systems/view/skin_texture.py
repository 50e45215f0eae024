"""Paints a species' skin: one 512 x 512 layer, body above, fins below (FINDINGS 8, look).

Everything is drawn in places of the body (s, h) and, where shapes must stay round, in the plane seen from the side,
in units of s. The body's fourth channel is relief (scales, gill cover, mouth) that the shader lights; the fins' is
opacity. The same skin gives the same picture on every run.
"""

from dataclasses import dataclass
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s
from components.body import Body
from components.skin import Colour, Eye, Gradient, Patch, Scales, Skin, Spots, Stripes
from systems.view.fish_fins import ANAL_BOX, CAUDAL_BOX, DORSAL_BOX, PECTORAL_BOX, PELVIC_BOX
from systems.view.fish_outline import Outline, outline_of
from systems.view.fish_surface import BODY_BOX

SIZE: Final = 512
"""Texels along each side of a layer."""
_HALF: Final = SIZE // 2
Texels: TypeAlias = NDArray[np.uint8]
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


def paint_skin(skin: Skin, body: Body) -> Texels:
    """Return the layer of `skin` on `body`, (512, 512, 4) uint8, the back's row first."""
    outline = outline_of(body)
    canvas = _canvas(outline)
    _head(canvas, skin, outline)
    scaled = any(isinstance(layer, Scales) for layer in skin.layers)
    for layer in skin.layers:
        _paint(canvas, layer, skin, outline)
    if scaled:
        _lateral_line(canvas, skin)
    _tail_root(canvas, skin)
    _gill_cover(canvas, skin)
    _mouth(canvas, outline)
    _eye(canvas, skin.eye, outline)
    picture = np.zeros((SIZE, SIZE, 4))
    picture[:_HALF, :, :3] = canvas.colour
    picture[:_HALF, :, 3] = canvas.relief
    _fins(picture, skin, canvas)
    return (np.clip(picture, 0.0, 1.0) * 255.0 + 0.5).astype(np.uint8)


def smooth_noise(width: int, height: int, cells: tuple[int, int], seed: int) -> Float64s:
    """Return value noise from -1 to 1 with `cells` (across, down) lattice cells, (height, width)."""
    lattice = np.random.default_rng(seed).uniform(-1.0, 1.0, (cells[1] + 2, cells[0] + 2))
    x, y = np.linspace(0, cells[0], width), np.linspace(0, cells[1], height)
    i, j = x.astype(int), y.astype(int)
    fx, fy = _ease(x - i), _ease(y - j)[:, None]
    low, high = lattice[j], lattice[j + 1]
    top = low[:, i] + (low[:, i + 1] - low[:, i]) * fx
    bottom = high[:, i] + (high[:, i + 1] - high[:, i]) * fx
    noise: Float64s = top + (bottom - top) * fy
    return noise


def _ease(t: Float64s) -> Float64s:
    eased: Float64s = t * t * (3.0 - 2.0 * t)
    return eased


def _inside(distance: Float64s, softness: float) -> Float64s:
    """Return 1 where `distance` is negative, 0 beyond, eased over `softness`."""
    return _ease(np.clip(0.5 - distance / max(softness, 1e-6), 0.0, 1.0))


def _unboxed(box: Box) -> tuple[slice, slice, Float64s, Float64s]:
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


def _canvas(outline: Outline) -> Canvas:
    left, top, right, bottom = BODY_BOX
    s = np.clip(((np.arange(SIZE) + 0.5) / SIZE - left) / (right - left), 0.0, 1.0)[None, :]
    around = np.clip(((np.arange(_HALF) + 0.5) / SIZE - top) / (bottom - top), 0.0, 1.0)[:, None]
    h = np.cos(np.pi * around)
    half = outline.half_height(s * outline.end) / outline.end
    side = outline.middle(s * outline.end) / outline.end + h * half
    fine = (
        smooth_noise(SIZE, _HALF, (48, 24), 7) * 0.4 + smooth_noise(SIZE, _HALF, (14, 7), 8) * 0.6
    )
    shape = (_HALF, SIZE)
    return Canvas(
        np.broadcast_to(s, shape),
        np.broadcast_to(h, shape),
        side,
        np.broadcast_to(half, shape),
        fine,
        np.full((*shape, 3), 0.6),
        np.full(shape, 0.5),
    )


def _paint(
    canvas: Canvas,
    layer: Gradient | Stripes | Spots | Patch | Scales,
    skin: Skin,
    outline: Outline,
) -> None:
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
            canvas.lay(layer.edge, _inside(distance - layer.edge_width, layer.softness))
        canvas.lay(layer.colour, _inside(distance, layer.softness))


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
        away = _distance(canvas, outline, place, height) - radius
        canvas.lay(layer.colour, 0.9 * _inside(away + 0.2 * radius * canvas.noise, 0.8 * radius))


def _distance(canvas: Canvas, outline: Outline, s: float, h: float) -> Float64s:
    """Return the distance from (s, h) in the picture from the side, in units of s."""
    away: Float64s = np.hypot(canvas.s - s, canvas.side - _height(outline, s, h))
    return away


def _height(outline: Outline, s: float, h: float) -> float:
    x = np.array([s * outline.end])
    return float((outline.middle(x) + h * outline.half_height(x))[0]) / outline.end


def _patch(canvas: Canvas, layer: Patch, outline: Outline) -> None:
    s, h = layer.at
    tall = layer.size[1] * float(outline.half_height(np.array([s * outline.end]))[0]) / outline.end
    turn = np.radians(layer.tilt_deg)
    dx, dy = canvas.s - s, canvas.side - _height(outline, s, h)
    along = (dx * np.cos(turn) + dy * np.sin(turn)) / layer.size[0]
    across = (dy * np.cos(turn) - dx * np.sin(turn)) / tall
    radius = np.hypot(along, across) + 0.04 * canvas.noise
    cover = _inside(radius - 1.0, layer.softness)
    if layer.hollow > 0.0:
        cover = cover * (1.0 - _inside(radius - layer.hollow, layer.softness))
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
        inside = _ease(np.clip((0.58 - radius) / 0.14, 0.0, 1.0))
        best = np.maximum(best, inside * (0.55 + 0.9 * du))
        rim = np.maximum(rim, inside)
    fade = np.clip((canvas.s - skin.gill_at + 0.06 * canvas.h**2 - 0.005) / 0.03, 0.0, 1.0)
    fade = fade * np.clip(1.3 - np.abs(canvas.h) ** 6, 0.0, 1.0)
    canvas.shade(1.0 + layer.strength * fade * (0.8 * (best - 0.45) + 0.35 * (rim - 1.0)))
    canvas.relief += 0.5 * layer.strength * fade * (best - 0.5)


def _lateral_line(canvas: Canvas, skin: Skin) -> None:
    at = 0.28 - 0.28 * canvas.s + 0.02 * np.sin(9.0 * canvas.s)
    dots = 0.65 + 0.35 * np.cos(canvas.s * 420.0)
    reach = _ease(np.clip((canvas.s - skin.gill_at) / 0.05, 0.0, 1.0))
    line = np.exp(-(((canvas.h - at) * canvas.half / 0.0035) ** 2)) * dots * reach
    canvas.shade(1.0 - 0.22 * line)


def _tail_root(canvas: Canvas, skin: Skin) -> None:
    """Let the body's end run into the caudal fin's colour with an uneven border of scales."""
    border = 0.962 - 0.02 * np.cos(5.0 * canvas.h) + 0.012 * canvas.noise
    canvas.lay(skin.tail, 0.92 * _inside(border - canvas.s, 0.05))


def _head(canvas: Canvas, skin: Skin, outline: Outline) -> None:
    """Give the head a smooth swelling cheek in the relief."""
    cheek = _distance(canvas, outline, 0.7 * skin.gill_at, -0.2) / (0.45 * skin.gill_at)
    canvas.relief += 0.06 * np.exp(-(cheek**2))


def _gill_cover(canvas: Canvas, skin: Skin) -> None:
    limit = np.clip((0.62 - np.abs(canvas.h + 0.12)) / 0.14, 0.0, 1.0)
    curve = skin.gill_at - 0.075 * (canvas.h + 0.1) ** 2
    behind = canvas.s - curve
    line = np.exp(-((behind / 0.0045) ** 2)) * _ease(limit)
    lip = np.exp(-(((behind + 0.012) / 0.009) ** 2)) * _ease(limit)
    shadow = np.exp(-np.clip(behind, 0.0, 1.0) / 0.022) * (behind > 0.0) * _ease(limit)
    canvas.shade(1.0 - skin.gill_strength * (0.75 * line + 0.28 * shadow))
    canvas.shade(1.0 + 0.22 * skin.gill_strength * lip)
    canvas.relief += skin.gill_strength * (0.35 * lip - 0.4 * line)
    cheek = skin.gill_at * 0.72 - 0.06 * (canvas.h + 0.2) ** 2
    fold = np.exp(-(((canvas.s - cheek) / 0.004) ** 2)) * _ease(limit)
    canvas.shade(1.0 - 0.3 * skin.gill_strength * fold)


def _mouth(canvas: Canvas, outline: Outline) -> None:
    tip = float(outline.middle(np.zeros(1))[0]) / outline.end
    long = 0.34 * outline.first / outline.end
    level = tip - 0.12 * canvas.s
    along = np.clip((long - canvas.s) / (0.35 * long), 0.0, 1.0)
    above = canvas.side - level
    line = np.exp(-((above / 0.0032) ** 2)) * along
    lips = np.exp(-((above / 0.010) ** 2)) * along
    canvas.shade(1.0 + 0.12 * lips)
    canvas.shade(1.0 - 0.75 * line)
    canvas.relief += 0.12 * lips - 0.15 * line


def _eye(canvas: Canvas, eye: Eye, outline: Outline) -> None:
    away = _distance(canvas, outline, *eye.at) / eye.radius
    height = (canvas.side - _height(outline, *eye.at)) / eye.radius
    ahead = (canvas.s - eye.at[0]) / eye.radius
    canvas.shade(1.0 - 0.45 * np.exp(-(((away - 1.05) / 0.22) ** 2)))
    iris = np.array(eye.iris)
    inside = _inside(away - 1.0, 0.16)
    ring = np.clip((away - eye.pupil) / (1.0 - eye.pupil), 0.0, 1.0)
    tone = (0.72 + 0.5 * np.exp(-(((ring - 0.25) / 0.3) ** 2)) - 0.35 * ring**3)[..., None]
    tone = tone * (1.0 - 0.22 * np.clip(height, -1.0, 1.0))[..., None]
    canvas.lay(np.clip(iris * tone, 0.0, 1.0), inside)
    canvas.lay((0.012, 0.014, 0.02), _inside(away - eye.pupil, 0.12))
    glint = np.hypot(ahead + 0.26, height - 0.3) / 0.19
    canvas.lay((0.97, 0.99, 1.0), 0.95 * _inside(glint - 1.0, 0.6))
    canvas.relief = np.where(
        away < 1.15, 0.5 + 0.45 * np.clip(1.15 - away, 0.0, 1.0), canvas.relief
    )


def _fins(picture: Float64s, skin: Skin, canvas: Canvas) -> None:
    flesh = np.median(canvas.colour[90:150, -14:], axis=(0, 1))
    back, belly = (np.median(canvas.colour[y, 200:420], axis=0) for y in (6, -16))
    picture[_HALF:, :, :3] = skin.fin
    _caudal(picture, skin, flesh)
    _median(picture, skin, DORSAL_BOX, back, flip=False)
    _median(picture, skin, ANAL_BOX, belly, flip=True)
    for box, wave in ((PECTORAL_BOX, 6.0), (PELVIC_BOX, 5.0)):
        _blade(picture, skin, box, wave)


def _rays(phase: Float64s) -> Float64s:
    """Return 1 on a fin ray and 0 on the membrane between, one ray a unit of `phase`."""
    return (0.5 + 0.5 * np.cos(2.0 * np.pi * phase)) ** 2


def _caudal(picture: Float64s, skin: Skin, flesh: Float64s) -> None:
    rows, columns, r, down = _unboxed(CAUDAL_BOX)
    q = 1.0 - 2.0 * down
    fork = np.clip((r - 0.45) / 0.1, 0.0, 1.0)
    rays = _rays(8.5 * q) * (1.0 - fork) + _rays(17.0 * q + 0.25) * fork
    joints = 0.9 + 0.1 * np.cos(2 * np.pi * r * 26.0)
    colour = np.array(skin.tail) * (0.8 + 0.3 * rays * joints - 0.12 * r)[..., None]
    if skin.tail_edge is not None:
        rim = _inside(0.78 - np.abs(q) + 0.12 * r, 0.12) * _inside(0.06 - r, 0.1)
        colour += (np.array(skin.tail_edge) - colour) * rim[..., None]
    base = _inside(r - 0.13 - 0.06 * np.cos(9.0 * q), 0.16)
    colour += (flesh - colour) * np.broadcast_to(base, rays.shape)[..., None]
    notches = 0.012 * (1.0 - rays)
    opaque = skin.fin_opacity + (1.0 - skin.fin_opacity) * np.maximum(rays, base)
    opaque = opaque * (1.0 - 0.25 * r**3)
    corner = np.hypot(np.clip(np.abs(q) - 0.86, 0, 1) / 0.14, np.clip(r - 0.9, 0, 1) / 0.1)
    edge = _inside(r - 0.985 + notches, 0.02) * _inside(corner - 0.95, 0.2)
    picture[rows, columns, :3] = colour
    picture[rows, columns, 3] = opaque * edge


def _median(picture: Float64s, skin: Skin, box: Box, flesh: Float64s, flip: bool) -> None:
    rows, columns, v, down = _unboxed(box)
    out = 1.0 - down
    rays = _rays(22.0 * (v - 0.05 * out)) * np.ones_like(out)
    spines = _inside(v - 0.5, 0.1)
    colour = np.array(skin.fin) * (0.82 + 0.28 * rays - 0.1 * out)[..., None]
    if skin.fin_edge is not None:
        rim = np.broadcast_to(_inside(0.8 - out, 0.1), rays.shape)
        colour += (np.array(skin.fin_edge) - colour) * rim[..., None]
    base = np.broadcast_to(_inside(out - 0.1, 0.25), rays.shape)
    colour += (flesh - colour) * (0.8 * base)[..., None]
    opaque = skin.fin_opacity + (1.0 - skin.fin_opacity) * np.maximum(0.8 * rays, base)
    notch = (0.03 + 0.09 * spines * (not flip)) * (1.0 - rays)
    ends = _inside(0.004 - v, 0.02) * _inside(v - 0.99, 0.02)
    picture[rows, columns, :3] = colour
    picture[rows, columns, 3] = opaque * _inside(out - 0.975 + notch, 0.04) * ends


def _blade(picture: Float64s, skin: Skin, box: Box, wave: float) -> None:
    rows, columns, r, down = _unboxed(box)
    q = 1.0 - 2.0 * down
    rays = _rays(wave * q + 0.5)
    own = np.array(skin.pectoral if skin.pectoral is not None else skin.fin)
    colour = own * (0.8 + 0.35 * rays - 0.1 * r)[..., None]
    reach = 0.98 - 0.28 * np.abs(q) ** 2.6 - 0.02 * (1.0 - rays)
    opaque = (0.8 * skin.fin_opacity + (1.0 - 0.8 * skin.fin_opacity) * rays) * (1.0 - 0.2 * r)
    picture[rows, columns, :3] = colour
    picture[rows, columns, 3] = opaque * _inside(r - reach, 0.05)
