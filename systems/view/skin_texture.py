"""Paints a species' skin: one 512 x 512 layer, body above, fins below (FINDINGS 8, look).

The body's fourth channel is relief (scales, gill cover, mouth) that the shader lights; the fins' is opacity. The same
skin gives the same picture on every run.
"""

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from components.body import Body
from components.skin import Scales, Skin
from systems.view import skin_face as face
from systems.view.fish_outline import outline_of
from systems.view.keep import kept, named
from systems.view.skin_canvas import HALF, SIZE, blank_canvas
from systems.view.skin_fins import paint_fins
from systems.view.skin_layers import paint_layer

Texels: TypeAlias = NDArray[np.uint8]


def skin_texels(skin: Skin, body: Body) -> Texels:
    """Return what `paint_skin` paints, kept from the last time where it can be."""
    (texels,) = kept(named(__file__, skin, body), lambda: [paint_skin(skin, body)])
    return texels.astype(np.uint8, copy=False)


def paint_skin(skin: Skin, body: Body) -> Texels:
    """Return the layer of `skin` on `body`, (512, 512, 4) uint8, the back's row first."""
    outline = outline_of(body)
    canvas = blank_canvas(outline)
    face.cheek(canvas, skin, outline)
    scaled = any(isinstance(layer, Scales) for layer in skin.layers)
    for layer in skin.layers:
        paint_layer(canvas, layer, skin, outline)
    if scaled:
        face.lateral_line(canvas, skin)
    face.tail_root(canvas, skin)
    if skin.gill_slits:
        face.gill_slits(canvas, skin)
    else:
        face.gill_cover(canvas, skin)
    face.mouth(canvas, skin, outline)
    face.eyeball(canvas, skin.eye, outline)
    picture = np.zeros((SIZE, SIZE, 4))
    picture[:HALF, :, :3] = canvas.colour
    picture[:HALF, :, 3] = canvas.relief
    paint_fins(picture, skin, canvas, body)
    return (np.clip(picture, 0.0, 1.0) * 255.0 + 0.5).astype(np.uint8)
