"""What each species senses and prefers, as kernels read it: one number a species and column.

It repeats in columns what `Species` says, and what the library knows of speeds. It never changes during a dive.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s
from components.repertoire import RepertoireLibrary
from components.species import Species


class SenseTable(NamedTuple):
    """One entry a species, in the order of the level's species. S species."""

    role: Int8s
    "a `Role`, (S,)"
    schooling: Int8s
    "1 where it schools, (S,)"
    length: Float64s
    "[m] of an adult, (S,)"
    sight: Float64s
    "[m] how far it sees fishes of its own size, (S,)"
    spacing: Float64s
    "distance kept in a school [BL], (S,)"
    shallow: Float64s
    "[m] z of the shallowest water that it likes, negative, (S,)"
    deep: Float64s
    "[m] z of the deepest, (S,)"
    girth: Float64s
    "farthest that the body reaches from its axis [BL], (S,)"
    speed: Float64s
    "mean speed in slow, medium and fast gear [BL/s], (S, 3)"


def _girth(species: Species) -> float:
    body = species.body
    return max(*body.half_width, *body.half_height, body.tail_span)


def sense_table(species: Sequence[Species], library: RepertoireLibrary) -> SenseTable:
    """Return the columns of the species, in their order; the library is packed in the same order."""
    speed = np.zeros((len(species), 3))
    for kind in range(len(species)):
        for gear in range(3):
            segment = int(library.segment[kind, gear])
            speed[kind, gear] = library.speed[segment] if segment >= 0 else 0.0
    return SenseTable(
        role=np.array([kind.role for kind in species], np.int8),
        schooling=np.array([kind.schooling for kind in species], np.int8),
        length=np.array([kind.length for kind in species], np.float64),
        sight=np.array([kind.sight for kind in species], np.float64),
        spacing=np.array([kind.spacing for kind in species], np.float64),
        shallow=np.array([-kind.depth[0] for kind in species], np.float64),
        deep=np.array([-kind.depth[1] for kind in species], np.float64),
        girth=np.array([_girth(kind) for kind in species], np.float64),
        speed=speed,
    )
