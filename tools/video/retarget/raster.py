"""Paints a textured mesh into a picture: triangles with depth and light, one thread, no GPU (papers/003, fig. 7)."""

from typing import Final

import numpy as np

from components.arrays import Float64s, Int64s
from components.kernels import row, serial
from tools.video.images import Colour
from tools.video.retarget.target import Texture

_FAR: Final = -1e30
_OPAQUE: Final = 0.5
"""Opacity from which a texel hides what lies behind it in depth."""


@row
def _texel(texture: Texture, u: float, v: float, channel: int) -> float:
    """Return the texture's value at a place [px] between its four texels."""
    x = min(max(u, 0.0), texture.shape[1] - 1.001)
    y = min(max(v, 0.0), texture.shape[0] - 1.001)
    left, top = int(x), int(y)
    a, b = x - left, y - top
    upper = texture[top, left, channel] * (1.0 - a) + texture[top, left + 1, channel] * a
    lower = texture[top + 1, left, channel] * (1.0 - a) + texture[top + 1, left + 1, channel] * a
    return float(upper * (1.0 - b) + lower * b)


@row
def _lay(
    picture: Colour, texture: Texture, x: int, y: int, u: float, v: float, light: float
) -> float:
    """Lay a texel over a pixel; return its opacity."""
    opacity = _texel(texture, u, v, 3) / 255.0
    for channel in range(3):
        shown = min(255.0, _texel(texture, u, v, channel) * light)
        under = picture[y, x, channel]
        picture[y, x, channel] = int(shown * opacity + under * (1.0 - opacity) + 0.5)
    return opacity


@serial
def _paint(
    picture: Colour,
    places: Float64s,
    depth: Float64s,
    triangles: Int64s,
    uv: Float64s,
    light: Float64s,
    texture: Texture,
) -> None:
    """Paint triangles over a picture (h, w, 3); `places` [px] are pixels' middles, larger `depth` is nearer."""
    height, width = picture.shape[0], picture.shape[1]
    nearest = np.full((height, width), _FAR)
    for t in range(len(triangles)):
        i, j, k = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        ax, ay, bx, by, cx, cy = (
            places[i, 0], places[i, 1], places[j, 0], places[j, 1], places[k, 0], places[k, 1],
        )  # fmt: skip
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if not abs(area) > 1e-12:
            continue
        left = max(0, int(np.floor(min(ax, bx, cx))))
        right = min(width - 1, int(np.floor(max(ax, bx, cx))) + 1)
        top = max(0, int(np.floor(min(ay, by, cy))))
        bottom = min(height - 1, int(np.floor(max(ay, by, cy))) + 1)
        for y in range(top, bottom + 1):
            for x in range(left, right + 1):
                p = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area
                q = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area
                r = 1.0 - p - q
                if p < 0.0 or q < 0.0 or r < 0.0:
                    continue
                z = p * depth[i] + q * depth[j] + r * depth[k]
                if z <= nearest[y, x]:
                    continue
                u = p * uv[i, 0] + q * uv[j, 0] + r * uv[k, 0]
                v = p * uv[i, 1] + q * uv[j, 1] + r * uv[k, 1]
                lit = p * light[i] + q * light[j] + r * light[k]
                if _lay(picture, texture, x, y, u, v, lit) > _OPAQUE:
                    nearest[y, x] = z


def paint(
    picture: Colour,
    places: Float64s,
    depth: Float64s,
    triangles: Int64s,
    uv: Float64s,
    light: Float64s,
    texture: Texture,
) -> None:
    """Paint a mesh over a picture (h, w, 3), in place.

    `places` are its vertices in the picture [px], (V, 2), larger `depth` (V,) is nearer, `uv` places in the texture
    [px], `light` what its colours are multiplied by, (V,). Triangles are painted in order where their depths are equal.
    """
    _paint(picture, places, depth, triangles, uv, light, texture)
