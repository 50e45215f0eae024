"""Passing by: fishes near plants stir them, as their species is a source or a hole to fibres (papers/002, section 1).

For drawing alone, and packed as `components.field.pack` does the level's own singularities: what a passing fish does to
tentacles is exaggerated so that one sees it, and would fling plankton about. Of thousands of fishes the few hundred
nearest to plants are taken, the same whatever order their rows stand in.
"""

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float32s, Float64s, Int32s
from components.field import pack
from components.fish import Population
from components.kernels import row
from components.singularity import SingularityTable
from components.species import Species
from components.sphere_grid import SphereGrid, list_spheres, sphere_grid, square_at

MOST: Final = 256
"""Fishes that stir plants at the same time."""

_SOFTENING: Final = 0.05
"""[m], half a small fish: nothing flickers as one swims through tentacles."""


class Stirrers(NamedTuple):
    """What each species is to fibres. S species."""

    kind: Int32s
    "`SingularityKind`, (S,)"
    intensity: Float64s
    "Phi [m^3/s], (S,)"
    most: Float64s
    "Phi_max [m/s], (S,)"
    reach: Float64s
    "R [m], 0 for who stirs nothing, (S,)"


def stirrers_of(species: Sequence[Species]) -> Stirrers:
    """Return what the species are to fibres, in their order."""
    stirs = [kind.stirs for kind in species]
    return Stirrers(
        np.array([one.kind for one in stirs], np.int32),
        np.array([one.speed * one.core * one.core for one in stirs], np.float64),
        np.array([one.speed for one in stirs], np.float64),
        np.array([one.reach for one in stirs], np.float64),
    )


@row
def nearness(
    grid: SphereGrid,
    spheres: Float64s,
    count: int,
    kinds: Int32s,
    reach: Float64s,
    position: Float64s,
    out: Float64s,
) -> None:
    """Write how near each of `count` fishes is to a plant, (count,): squared distance from the nearest plant's middle
    over the square of that at which it begins to stir it; 1 and more for who stirs none."""
    for i in range(count):
        out[i], far = 1.0, reach[kinds[i]]
        if far <= 0.0:
            continue
        x, y, z = position[i, 0], position[i, 1], position[i, 2]
        square = square_at(grid, x, y)
        for at in range(grid.first[square], grid.first[square + 1]):
            k = grid.listed[at]
            dx, dy, dz = x - spheres[k, 0], y - spheres[k, 1], z - spheres[k, 2]
            room = spheres[k, 3] + far
            out[i] = min(out[i], (dx * dx + dy * dy + dz * dz) / (room * room))


class PassBy:
    """Reads the fishes; `spheres`, (n, 4), are middle and radius [m] of the plants, in a sea of radius `extent` [m]."""

    def __init__(
        self,
        population: Population,
        species: Sequence[Species],
        spheres: Float64s,
        extent: float,
    ) -> None:
        self.population, self.stirrers = population, stirrers_of(species)
        self._spheres = np.ascontiguousarray(spheres, np.float64)
        farthest = self._spheres[:, 3] + self.stirrers.reach.max(initial=0.0)
        self._grid = list_spheres(sphere_grid(extent), self._spheres[:, :3], farthest)
        self._near = np.zeros(16)
        self._table = SingularityTable(capacity=MOST)
        # Once, so that every column holds what it is without a carrier and without waves.
        self._table.append(MOST)

    def __call__(self, alpha: float = 1.0) -> Float32s:
        """Return the fishes that stir plants, as fibres read singularities, (m, 16) with m <= `MOST`.

        Fishes stand `alpha` of the way from the last tick to this.
        """
        fish, count, stirrers = self.population.fish, self.population.count, self.stirrers
        if count > len(self._near):
            self._near = np.zeros(2 * count)
        near = self._near[:count]
        nearness(
            *(self._grid, self._spheres, count, fish.species, stirrers.reach, fish.position, near)
        )
        rows = np.flatnonzero(near < 1.0)
        rows = rows[np.lexsort((fish.id[rows], near[rows]))[:MOST]]
        table, kinds, last = self._table, fish.species[rows], fish.last_position[rows]
        table.count = len(rows)
        table.position[: len(rows)] = last + alpha * (fish.position[rows] - last)
        table.softening[: len(rows)] = _SOFTENING
        for name in Stirrers._fields:
            getattr(table, name)[: len(rows)] = getattr(stirrers, name)[kinds]
        return pack(table, 0.0)
