"""Plants of a level grown: their fibres at rest where they stand, ready for `components.garden.Garden`.

The same plants grow the same fibres. A plant twice as large bends as its flora does: K falls as scale^(n - 1) rises.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from components.arrays import Float64s
from components.fibre import Carriers, Tuft
from components.flora import Anemone, Coral, Disc, Flora, Growth, Kelp, Look, Plant, Seagrass
from components.ground import Terrain, ground_height
from tools.grow import anemone, coral, kelp, seagrass
from tools.grow.shape import Part, unit

_SUNK = 0.05
"""[m] that roots stand in what they stand on, which may be round."""

_ON_SAND = 0.05
"""[m] from the ground within which a plant stands on it, not on rock."""


def nodes(flora: Flora) -> int:
    """Return how many nodes a plant of this species has."""
    match flora.form:
        case Anemone():
            return anemone.nodes(flora.form)
        case Seagrass():
            return seagrass.nodes(flora.form)
        case Kelp():
            return kelp.nodes(flora.form)
        case Coral():
            return coral.nodes(flora.form)


def grow(plants: Sequence[Plant], floras: Mapping[str, Flora], terrain: Terrain) -> Growth:
    """Return the fibres of all plants, the looks of their species and the discs of the anemones.

    `Tuft.plant` is the index in `plants`. Raise KeyError where a plant's species is none of `floras`.
    """
    looks: list[Look] = []
    first: dict[str, dict[str, int]] = {}
    for name in dict.fromkeys(plant.flora for plant in plants):
        parts = floras[name].looks
        first[name] = {part: len(looks) + at for at, part in enumerate(parts)}
        looks += parts.values()
    growth = Growth([], tuple(looks), ())
    discs: list[Disc] = []
    for index, plant in enumerate(plants):
        flora, looked = floras[plant.flora], first[plant.flora]
        if isinstance(flora.form, Anemone):
            discs.append(_disc(flora.form, plant, len(growth.tufts), looked["disc"]))
        growth.tufts.extend(_tufts(plant, index, flora, looked, terrain, len(growth.tufts)))
    return growth._replace(discs=tuple(discs))


def _disc(form: Anemone, plant: Plant, foot: int, look: int) -> Disc:
    return Disc(foot, 0, plant.scale * form.radius, plant.scale * form.mouth, look)


def _parts(plant: Plant, flora: Flora) -> list[Part]:
    chance = np.random.default_rng(plant.seed)
    match flora.form:
        case Anemone():
            return anemone.grow(flora.form, chance)
        case Seagrass():
            return seagrass.grow(flora.form, chance)
        case Kelp():
            return kelp.grow(flora.form, chance, -plant.position[2] / plant.scale)
        case Coral():
            return coral.grow(flora.form, chance)


def _tufts(
    plant: Plant, index: int, flora: Flora, looks: Mapping[str, int], terrain: Terrain, base: int
) -> list[Tuft]:
    axes, ground = _axes(plant, flora), _plane(plant, terrain)
    root = np.array(plant.position) - _SUNK * axes[2]
    tufts: list[Tuft] = []
    for part in _parts(plant, flora):
        carried, limb = part.carried, part.limb
        tufts.append(
            Tuft(
                points=root + plant.scale * (part.points @ axes),
                radii=plant.scale * part.radii,
                modulus=limb.modulus * plant.scale ** (1.0 - limb.exponent),
                exponent=limb.exponent,
                plant=index,
                look=looks[part.name],
                carriers=None if carried is None else Carriers(base + carried.part, *carried[1:]),
                guides=None if part.guides is None else base + part.guides,
                ground=ground,
            )
        )
    return tufts


def _axes(plant: Plant, flora: Flora) -> Float64s:
    """Return the plant's axes as rows, (3, 3): weeds grow to the light, corals half so, anemones as they stand."""
    up, light = np.array(plant.up), np.array([0.0, 0.0, 1.0])
    match flora.form:
        case Seagrass() | Kelp():
            up = light
        case Coral():
            up = unit(up + light)
        case Anemone():
            pass
    turn = np.radians(plant.yaw)
    ahead = np.array([np.cos(turn), np.sin(turn), 0.0])
    if abs(float(up @ ahead)) > 0.95:
        ahead = light
    ahead = unit(ahead - float(up @ ahead) * up)
    return np.stack([ahead, np.cross(up, ahead), up])


def _plane(plant: Plant, terrain: Terrain) -> tuple[float, float, float, float] | None:
    """Return the sand below a plant as a plane; None on rock, which keeps fibres out by itself."""
    x, y, z = plant.position
    if z > ground_height(terrain.height, terrain.extent, terrain.cell, x, y) + _ON_SAND:
        return None
    a, b, c = plant.up
    return a, b, c, a * x + b * y + c * z - _SUNK
