"""The garden of a level as a scene shows it: grown when the scene opens, bent before each picture, then drawn.

No simulation knows of it: what swims meets static shapes, never a bent fibre (papers/002; DESIGN 3).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from components.arrays import AnyArray, Float32s, Float64s
from components.flora import Growth, Look
from components.garden import Garden
from components.terrain import Terrain
from systems.sea.bend import Bender
from systems.view.cull import View
from systems.view.draw_fibres import DrawFibres
from systems.view.fibre_levels import Tufts, plants_seen, tufts_seen
from systems.view.shade import ground_under

if TYPE_CHECKING:
    from reefgame.world import World

SETTLING_STEPS: Final = 24
"""Steps before the first picture, so that it shows fibres as the flow has laid them: three seconds."""
SETTLING_STEP: Final = 0.125
"""[s]"""
_ON_SAND: Final = 0.12
"""[m] from the sand within which a plant's root stands in it."""
_SHADE: Final = {
    "foot": (1.12, 0.78),
    "blade": (1.1, 0.34),
    "frond": (1.1, 0.34),
    "branch": (1.5, 0.5),
    "tentacle": (1.1, 0.5),
}
"""How wide a shade a plant casts around it, in radii of its foot, and how dark, by the kind of its first part."""
LONGEST_STEP: Final = 0.1
"""[s] of bending between two pictures, however long the second took to come."""


def growth_of(world: "World") -> Growth:
    """Return the fibres of all plants of a world, at rest."""
    # A level without plants pays nothing, not even the import.
    from tools.grow.plants import grow

    return grow(world.plants, world.floras, world.terrain)


def clumps_seen(garden: Garden, tufts: Tufts, view: View) -> AnyArray:
    """Return which clumps are to be bent for a view, (clumps,): all of each plant that is seen at all."""
    whole = plants_seen(tufts, tufts_seen(tufts, view))
    seen = np.zeros(len(garden.clump_sphere), np.bool_)
    seen[garden.clump[whole & (garden.clump >= 0)]] = True
    return seen


def feet_of(garden: Garden, looks: Sequence[Look], terrain: Terrain) -> Float64s:
    """Return place [m], radius [m] and darkness on the sand of each plant's foot, (plants on sand, 4)."""
    _, first = np.unique(garden.plant, return_index=True)
    feet = []
    for tuft in first:
        fibres = slice(garden.first_fibre[tuft], garden.first_fibre[tuft + 1])
        rows, lanes = garden.first_row[fibres], garden.lane[fibres]
        roots = garden.position[rows, :, lanes].astype(np.float64)
        middle = roots.mean(axis=0)
        spread = np.linalg.norm(roots - middle, axis=1).max() + garden.radius[rows, lanes].max()
        if abs(middle[2] - ground_under(terrain, middle[None])[0]) < _ON_SAND:
            wide, dark = _SHADE[looks[garden.look[tuft]].kind]
            feet.append((*middle[:2], max(wide * spread, 0.05), dark))
    return np.array(feet).reshape(-1, 4)


class Bed:
    """A garden that sways. `sun` is the unit vector towards the sun, `most` the triangles that a picture may take."""

    def __init__(
        self,
        growth: Growth,
        terrain: Terrain,
        sun: tuple[float, float, float],
        bender: Bender,
        most: int,
        defines: Sequence[str] = (),
    ) -> None:
        rocks = (terrain.rock_centre, terrain.rock_radii, terrain.rock_axes)
        self.garden = Garden(growth.tufts, rocks)
        self.bender = bender
        self._looks, self._terrain = growth.looks, terrain
        self._most = most
        self._draw = DrawFibres(self.garden, growth.looks, growth.discs, terrain, sun, defines)
        self._seconds: float | None = None

    def feet(self) -> Float64s:
        """Return where plants stand on the sand, and how they darken it, as `DrawContact` wants it."""
        return feet_of(self.garden, self._looks, self._terrain)

    def draw(self, view: View, flow: Float32s, seconds: float) -> None:
        """Draw what is seen in `view`, bent by `flow` (`components.field.pack`) since the last picture's `seconds`."""
        self._bend(view, flow, seconds)
        self._draw.draw(view, self._most)

    def _bend(self, view: View, flow: Float32s, seconds: float) -> None:
        if self._seconds is None:
            for _ in range(SETTLING_STEPS):
                self.bender.step(self.garden, flow, SETTLING_STEP)
        else:
            passed = min(seconds - self._seconds, LONGEST_STEP)
            if passed > 0.0:
                seen = clumps_seen(self.garden, self._draw.tufts, view)
                self.bender.step(self.garden, flow, passed, seen)
        self._seconds = seconds

    def delete(self) -> None:
        """Free what the GPU holds."""
        self._draw.delete()
