"""What each species senses and prefers, as kernels read it: one number a species and column.

It repeats in columns what `Species` says, and what the library knows of speeds. It never changes during a dive.
"""

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s
from components.clock import TICKS_PER_SECOND
from components.repertoire import RepertoireLibrary
from components.species import Species

MOUTH: Final = 0.35
"""[BL] from the nose at which a grazer's wide open mouth sucks in what it eats."""
SNAP: Final = 0.2
"""[BL] from the nose at which a hunter snaps: farther, and no dodge saved its prey."""


FISH_GRAMS: Final = 10_000.0
"""[g] of a fish of one metre; its mass grows with the cube of its length."""
SWALLOWED: Final = 0.34
"""Length of the largest fish that one swallows, over its own."""


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
    eats: Int8s
    "1 where the species of the row eats that of the column, (S, S)"
    hunts: Int8s
    "1 where it eats some species of the level, (S,)"
    hunted: Int8s
    "1 where some species of the level eats it, (S,)"
    grazes: Int8s
    "1 where it eats food in the water, (S,)"
    meal: Float64s
    "[g] of an average meal, (S,)"
    appetite: Float64s
    "a: meals that fill it, (S,)"
    digestion: Float64s
    "[ticks] until a full stomach is empty, 1 / p0, (S,)"
    breeding: Float64s
    "[ticks] from mating until libido is full, 1 / p1, (S,)"
    wariness: Float64s
    "[m] D0, for a predator of one metre, (S,)"
    curiosity: Float64s
    "chance that a pacifist comes to look, (S,)"
    bright: Int8s
    "1 likes light, -1 the dark, 0 does not mind, (S,)"
    warm: Int8s
    "1 likes warmth, -1 the cold, 0 does not mind, (S,)"
    mouth: Float64s
    "[BL] farthest from the nose at which a wide open mouth sucks in, (S,)"
    at_home: Int8s
    "1 where it shelters in anemones, which do not sting it, (S,)"
    nose: Float64s
    "[BL] from the body's origin forward to the nose, (S,)"


def _girth(species: Species) -> float:
    body = species.body
    return max(*body.half_width, *body.half_height, body.tail_span)


def _eats(species: Sequence[Species]) -> Int8s:
    names = [kind.name for kind in species]
    return np.array([[name in kind.temper.diet for name in names] for kind in species], np.int8)


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
        eats=_eats(species),
        hunts=np.max(_eats(species), axis=1, initial=0),
        hunted=np.max(_eats(species), axis=0, initial=0),
        grazes=np.array([kind.temper.grazes for kind in species], np.int8),
        meal=np.array([kind.temper.meal for kind in species], np.float64),
        appetite=np.array([kind.temper.appetite for kind in species], np.float64),
        digestion=TICKS_PER_SECOND * np.array([kind.temper.digestion for kind in species]),
        breeding=TICKS_PER_SECOND * np.array([kind.temper.breeding for kind in species]),
        wariness=np.array([kind.temper.wariness for kind in species], np.float64),
        curiosity=np.array([kind.temper.curiosity for kind in species], np.float64),
        bright=np.array([kind.temper.bright for kind in species], np.int8),
        warm=np.array([kind.temper.warm for kind in species], np.int8),
        mouth=np.array([SNAP if kind.temper.diet else MOUTH for kind in species], np.float64),
        at_home=np.array([kind.temper.at_home for kind in species], np.int8),
        nose=np.array([kind.body.station[1] for kind in species], np.float64),
    )
