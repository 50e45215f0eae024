"""A target from one of the game's species: its close surface and fins, in its skin (papers/003, section 5)."""

from dataclasses import replace
from typing import Final

import numpy as np

from components.arrays import Int64s
from components.body import Body, rest_nodes
from components.skin import Skin
from systems.view.fish_fins import CLOSE, fins_of
from systems.view.fish_lattice import ROWS, lattice_of
from systems.view.fish_levels import both_sides
from systems.view.fish_surface import HELD, PECTORAL, PELVIC, Patch
from systems.view.skin_texture import skin_texels
from tools.video.retarget.fin import Fin
from tools.video.retarget.mesh import Mesh, mesh_target
from tools.video.retarget.target import Target

_SPREAD: Final = {PECTORAL: 1.15, PELVIC: 0.35, HELD: 1.2}
"""[rad] that paired fins stand out from the body."""
_SIDES: Final = 256
"""Rows of the skin that show the body; there the fourth channel is relief, not opacity."""


def species_target(name: str, body: Body, skin: Skin) -> Target:
    """Return a species as a target, in body lengths."""
    lattice = lattice_of(body)
    spans = ROWS - 3
    sides = both_sides(lattice, np.linspace(0, 1, 2 * spans + 1), np.linspace(0, 1, 13))
    patches = [*sides, *fins_of(lattice, CLOSE)]
    texture = skin_texels(skin, body).copy()
    texture[:_SIDES, :, 3] = 255
    rest = rest_nodes(body)
    first = np.cumsum([0, *(len(patch.weight) for patch in patches)])
    mesh = Mesh(
        vertices=np.concatenate([_weights(patch) @ rest for patch in patches]),
        triangles=np.concatenate(
            [p.triangles + n for p, n in zip(patches, first[:-1], strict=True)]
        ),
        uv=np.concatenate([patch.texture for patch in patches]) * np.array(texture.shape[1::-1])
        - 0.5,
        texture=texture,
        up=np.array([0.0, 1.0, 0.0]),
    )
    # Fins are sheets: holes are as they should be.
    target = mesh_target(mesh, name, ahead=np.array([1.0, 0.0, 0.0]), may_be_open=True)
    left, right = (_blade(target, patches, first, side) for side in (1, 0))
    return replace(target, fins=(left, right))


def _blade(target: Target, patches: list[Patch], first: Int64s, nth: int) -> Fin:
    """Return the nth pectoral fin: `fins_of` gives the right side's before the left's, pectoral before pelvic."""
    at = [i for i, patch in enumerate(patches) if patch.kind in (PECTORAL, HELD)]
    held = patches[at[0]].kind == HELD
    number = at[nth * (2 if held else 1)]
    rows = np.arange(first[number], first[number + 1])
    places = target.vertices[rows, :2]
    root = places[: CLOSE.paired[1]]
    order = np.argsort(-root[:, 1])
    top, bottom = root[order[0]], root[order[-1]]
    distance = np.sqrt(((places - 0.5 * (top + bottom)) ** 2).sum(axis=1))
    return Fin(places[int(np.argmax(distance))], top, bottom, rows, distance)


def _weights(patch: Patch) -> "np.ndarray[tuple[int, ...], np.dtype[np.float64]]":
    """Return the nodes' weights in the patch's places, paired fins spread."""
    if patch.kind not in _SPREAD:
        return patch.weight
    angle = _SPREAD[patch.kind]
    return np.asarray(patch.weight + np.cos(angle) * patch.along_u + np.sin(angle) * patch.along_v)
