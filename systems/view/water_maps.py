"""Tileable maps that shaders read: caustics, noise, surface waves, sand, stone, coral, marks (FINDINGS 8, Look).

Computed once from a fixed seed: noise looked up costs software GL a tenth of noise computed.
"""

from ctypes import byref, c_uint
from itertools import product
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.arrays import AnyArray, Float64s, Int64s
from systems.view.context import ensure_context
from systems.view.keep import kept, named
from systems.view.program import SAMPLER_UNITS

SIDE: Final = 256
"""Texels along a side of each map."""
CELLS: Final = 9
"""Caustic cells along a side of the tile."""


def spectral_noise(
    rng: np.random.Generator, slope: float, low: float, high: float, side: int = SIDE
) -> Float64s:
    """Return tileable noise of mean 0 and deviation 1, (side, side), by shaping white noise.

    Amplitude falls as frequency ** -slope between `low` and `high` cycles a tile.
    """
    spectrum = np.fft.fft2(rng.standard_normal((side, side)))
    size = _frequency(side)
    shape = np.where((size >= low) & (size <= high), np.maximum(size, 1.0) ** -slope, 0.0)
    noise = np.fft.ifft2(spectrum * shape).real
    return np.asarray(noise / noise.std())


def voronoi_gap(rng: np.random.Generator, cells: int, warp: float, side: int = SIDE) -> Float64s:
    """Return F2 - F1 of a tileable jittered Voronoi pattern [cells], (side, side).

    Smooth noise of deviation `warp` [cells] displaces the lookup, which bends the borders.
    """
    grid = (np.arange(side) + 0.5) * cells / side
    x = grid[:, None] + warp * spectral_noise(rng, 2.0, 1, 12, side)
    y = grid[None, :] + warp * spectral_noise(rng, 2.0, 1, 12, side)
    points = rng.uniform(0.05, 0.95, (cells, cells, 2))
    ix, iy = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    nearest = second = np.full((side, side), np.inf)
    for i, j in product(range(-2, 3), repeat=2):
        away = _squared(points, x, y, ix + i, iy + j, cells)
        second = np.minimum(second, np.maximum(nearest, away))
        nearest = np.minimum(nearest, away)
    return np.asarray(np.sqrt(second) - np.sqrt(nearest))


def _squared(
    points: Float64s, x: Float64s, y: Float64s, i: Int64s, j: Int64s, cells: int
) -> Float64s:
    point = points[i % cells, j % cells]
    return np.asarray((i + point[..., 0] - x) ** 2 + (j + point[..., 1] - y) ** 2)


def water_map() -> Float64s:
    """Return caustic net, shafts of light, soft noise, fine noise; (SIDE, SIDE, 4) of 0..1."""
    rng = np.random.default_rng(1999)
    gap = voronoi_gap(rng, CELLS, 0.22)
    net = np.exp(-gap * 6.0)
    shafts = _unit(spectral_noise(rng, 0.9, 3, 34), 0.55, 2.7)
    soft = _unit(spectral_noise(rng, 1.5, 1, 40), -2.2, 2.2)
    fine = _unit(spectral_noise(rng, 0.6, 6, 128), -2.4, 2.4)
    return np.stack((net, shafts, soft, fine), axis=-1)


def surface_map() -> Float64s:
    """Return the surface's slopes along x and y (.5: level), height, clouds, (SIDE, SIDE, 4)."""
    rng = np.random.default_rng(1994)
    height = spectral_noise(rng, 1.9, 2, 90)
    height = height + 0.7 * np.exp(-voronoi_gap(rng, 7, 0.3) * 3.0)
    slope_x = np.roll(height, -1, 0) - np.roll(height, 1, 0)
    slope_y = np.roll(height, -1, 1) - np.roll(height, 1, 1)
    spread = 3.0 * np.sqrt((slope_x**2 + slope_y**2).mean() / 2)
    clouds = _unit(spectral_noise(rng, 1.7, 1, 60), -2.0, 2.0)
    shape = (_unit(slope_x, -spread, spread), _unit(slope_y, -spread, spread))
    return np.stack((*shape, _unit(height, -2.5, 3.0), clouds), axis=-1)


def relief_map() -> Float64s:
    """Return the sand's slopes along x and y (.5: level), pebbles, mottling, (SIDE, SIDE, 4)."""
    rng = np.random.default_rng(2009)
    ripples = _ripples(rng)
    slope_x = np.roll(ripples, -1, 0) - np.roll(ripples, 1, 0)
    slope_y = np.roll(ripples, -1, 1) - np.roll(ripples, 1, 1)
    spread = 3.0 * max(slope_x.std(), slope_y.std())
    pebbles = _pebbles(rng)
    mottled = _unit(spectral_noise(rng, 1.1, 2, 100), -2.2, 2.2)
    shape = (_unit(slope_x, -spread, spread), _unit(slope_y, -spread, spread))
    return np.stack((*shape, pebbles, mottled), axis=-1)


def stone_map() -> Float64s:
    """Return stone's slopes along x and y (.5: level), height, patches of growth, (SIDE, SIDE, 4)."""
    rng = np.random.default_rng(1669)
    rough = spectral_noise(rng, 1.0, 3, 110)
    creased = -np.abs(spectral_noise(rng, 1.5, 2, 24))
    cracks = np.exp(-voronoi_gap(rng, 5, 0.75) * 16.0)
    pits = np.exp(-((spectral_noise(rng, 0.7, 12, 44) - 1.9) ** 2) * 4.0)
    height = 0.55 * rough + 1.1 * creased - 0.9 * cracks - 0.9 * pits
    height = (height - height.mean()) / height.std()
    slope_x = np.roll(height, -1, 0) - np.roll(height, 1, 0)
    slope_y = np.roll(height, -1, 1) - np.roll(height, 1, 1)
    spread = 3.0 * np.sqrt((slope_x**2 + slope_y**2).mean() / 2)
    growth = _unit(spectral_noise(rng, 1.35, 1, 90), -2.2, 2.2)
    shape = (_unit(slope_x, -spread, spread), _unit(slope_y, -spread, spread))
    return np.stack((*shape, _unit(height, -2.8, 2.2), growth), axis=-1)


def mark_map() -> Float64s:
    """Return marks on living skin, 4 along x by 4 along y: spots, bands, stripes, mottling, (SIDE, SIDE, 4) of 0..1."""
    rng = np.random.default_rng(2002)
    wobble = 0.025 * spectral_noise(rng, 1.6, 1, 12)
    along, across = np.meshgrid(*(2 * [4.0 * np.arange(SIDE) / SIDE]), indexing="ij")
    rank = np.floor(along)
    cell_x, cell_y = along - rank - 0.5, (across + 0.5 * (rank % 2)) % 1.0 - 0.5
    spots = np.clip((0.34 + wobble - np.hypot(cell_x, cell_y)) / 0.10 + 0.5, 0.0, 1.0)
    bands, stripes = (
        np.clip((np.abs((ramp + wobble) % 1.0 - 0.5) - 0.29) / 0.08 + 0.5, 0.0, 1.0)
        for ramp in (along, across)
    )
    mottled = _unit(spectral_noise(rng, 1.5, 3, 60), -0.25, 0.65)
    return np.stack((spots, bands, stripes, mottled), axis=-1)


def coral_map() -> Float64s:
    """Return a brain coral's slopes along x and y (.5: level), ridges, polyps, (SIDE, SIDE, 4) of 0..1."""
    rng = np.random.default_rng(1778)
    # Noise of nearly one wave length: where it is above 0 are ridges that wander and fork.
    wandering = spectral_noise(rng, 0.0, 9.5, 12.5)
    ridges = 0.5 + 0.5 * np.tanh(1.6 * wandering + 0.35)
    height = ridges + 0.05 * spectral_noise(rng, 0.6, 30, 110)
    slope_x = np.roll(height, -1, 0) - np.roll(height, 1, 0)
    slope_y = np.roll(height, -1, 1) - np.roll(height, 1, 1)
    spread = 2.5 * np.sqrt((slope_x**2 + slope_y**2).mean() / 2)
    polyps = np.clip(1.5 * voronoi_gap(rng, 30, 0.05), 0.0, 1.0)
    shape = (_unit(slope_x, -spread, spread), _unit(slope_y, -spread, spread))
    return np.stack((*shape, np.clip(ridges, 0.0, 1.0), polyps), axis=-1)


def _ripples(rng: np.random.Generator) -> Float64s:
    """Return the height of sand ripples: crests along y that wander and fork, (SIDE, SIDE)."""
    across = np.arange(SIDE)[:, None] * (2 * np.pi * 11 / SIDE)
    phase = across + 1.5 * spectral_noise(rng, 1.8, 1, 9)
    crests = 0.6 * np.sin(phase) + 0.25 * np.cos(2 * phase)
    amount = 0.65 + 0.35 * np.tanh(spectral_noise(rng, 1.5, 1, 6))
    return np.asarray(crests * amount + 0.16 * spectral_noise(rng, 0.9, 4, 120))


def _pebbles(rng: np.random.Generator) -> Float64s:
    """Return .5 for bare sand, darker and brighter in small round spots, (SIDE, SIDE)."""
    picture = np.full((SIDE, SIDE), 0.5)
    near = np.arange(-4, 6)
    for x, y, radius, tone in rng.uniform((0, 0, 0.8, 0), (SIDE, SIDE, 2.6, 1), (150, 4)):
        i, j = int(x) + near, int(y) + near
        away = np.hypot((i - x)[:, None], 1.3 * (j - y)[None, :])
        cover = np.clip(radius + 0.5 - away, 0, 1)
        patch = np.ix_(i % SIDE, j % SIDE)
        picture[patch] = picture[patch] * (1 - cover) + cover * (0.08 + 0.84 * tone)
    return picture


def _frequency(side: int) -> Float64s:
    cycles = np.fft.fftfreq(side, 1 / side)
    return np.asarray(np.hypot(cycles[:, None], cycles[None, :]))


def _unit(values: Float64s, low: float, high: float) -> Float64s:
    return np.clip((values - low) / (high - low), 0.0, 1.0)


_MAKERS: Final = {
    "water_map": water_map,
    "surface_map": surface_map,
    "relief_map": relief_map,
    "stone_map": stone_map,
    "mark_map": mark_map,
    "coral_map": coral_map,
}


def _texels(values: Float64s) -> NDArray[np.uint8]:
    """Return a map indexed [x, y], 0 to 1, as a texture's texels, whose rows run along y."""
    return np.ascontiguousarray(np.rint(values.swapaxes(0, 1) * 255).astype(np.uint8))


def upload(texels: AnyArray, smooth: bool = True) -> c_uint:
    """Return a new repeating, mipmapped RGBA8 texture of `texels`, (rows, columns, 4) uint8."""
    from pyglet import gl

    texture = c_uint()
    smaller = gl.GL_LINEAR_MIPMAP_LINEAR if smooth else gl.GL_LINEAR_MIPMAP_NEAREST
    gl.glGenTextures(1, byref(texture))
    gl.glBindTexture(gl.GL_TEXTURE_2D, texture)
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
    gl.glTexImage2D(
        *(gl.GL_TEXTURE_2D, 0, gl.GL_RGBA8, texels.shape[1], texels.shape[0], 0),
        *(gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, texels.ctypes.data),
    )
    for name, value in (
        (gl.GL_TEXTURE_WRAP_S, gl.GL_REPEAT),
        (gl.GL_TEXTURE_WRAP_T, gl.GL_REPEAT),
        (gl.GL_TEXTURE_MAG_FILTER, gl.GL_LINEAR),
        (gl.GL_TEXTURE_MIN_FILTER, smaller),
    ):
        gl.glTexParameteri(gl.GL_TEXTURE_2D, name, value)
    gl.glGenerateMipmap(gl.GL_TEXTURE_2D)
    return texture


class WaterMaps:
    """The maps as textures, for the units that `SAMPLER_UNITS` names.

    Not `smooth`, they step from size to size: a fifth of a frame on software GL.
    """

    def __init__(self, smooth: bool = True) -> None:
        ensure_context()
        maps = kept(named(__file__), lambda: [_texels(make()) for make in _MAKERS.values()])
        self._textures = {
            SAMPLER_UNITS[name]: upload(texels, smooth)
            for name, texels in zip(_MAKERS, maps, strict=True)
        }

    def bind(self) -> None:
        """Bind the maps, and leave unit 0 active."""
        from pyglet import gl

        for unit, texture in self._textures.items():
            gl.glActiveTexture(gl.GL_TEXTURE0 + unit)
            gl.glBindTexture(gl.GL_TEXTURE_2D, texture)
        gl.glActiveTexture(gl.GL_TEXTURE0)

    def delete(self) -> None:
        """Free the textures."""
        from pyglet import gl

        for texture in self._textures.values():
            gl.glDeleteTextures(1, byref(texture))
        self._textures = {}
