"""Attention: what minds hold while they think, in scratch that is forgotten with the tick.

Minds think in batches, a step of all of them before the next step of any: a step's code stays near the processor for
the whole batch, where one mind's whole thought would not fit (FINDINGS 5).
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from systems.mind.grid import PIECES
from systems.mind.sparse import MOST_LISTED

NEIGHBOURS: Final = 8
"""The nearest of a kind that a fish attends to (FINDINGS 5)."""

MOST_AROUND: Final = 2048
"""Fishes around a cell that are looked at; of more every second, third, ... so that no crowd hangs the game."""

BATCH: Final = 64
"""Minds that take a step together."""

NO_DANGER: Final = 1e9
"""A distance, or a time, without end."""


class Attention(NamedTuple):
    """What a piece of the loop holds of the one mind that it is with; (PIECES, ...) each."""

    runs: Int64s
    "begin and end of the runs of fishes around the cell, (PIECES, 24)"
    around_x: Float64s
    "[m] of the fishes around the cell, (PIECES, MOST_AROUND)"
    around_y: Float64s
    "[m], (PIECES, MOST_AROUND)"
    around_z: Float64s
    "[m], (PIECES, MOST_AROUND)"
    around: Int32s
    "their places in the crowd, (PIECES, MOST_AROUND)"
    kinds: Int32s
    "their species, (PIECES, MOST_AROUND)"
    seen: Int8s
    "1 for who of them is seen, (PIECES, MOST_AROUND)"
    square: Float64s
    "squared distances [m^2] to them; later to the hunters that eat it, (PIECES, MOST_AROUND + 1)"
    company: Int32s
    "which of them are of its kind and seen; later the places of hunters that eat it, (PIECES, MOST_AROUND + 1)"
    others: Int32s
    "which of them are seen and may cross its way; later the places of large hunters, (PIECES, MOST_AROUND + 1)"
    coarse_runs: Int32s
    "begin and end of the runs of hunters, food or mates around a point, (PIECES, 32)"
    hunters_around: Int32s
    "hunters around several minds, by their row in the hunters' grid, (PIECES, MOST_LISTED)"
    sought: Int64s
    "places in the crowd of the nearest that it seeks, (PIECES, NEIGHBOURS)"
    sought_distance: Float64s
    "squared distances [m^2] to them, (PIECES, NEIGHBOURS)"
    roaming: Float64s
    "cohort, place x and y [m] and height of where the last school seen travels, (PIECES, 8)"
    shelter: Float64s
    "offset [m] to a hiding-place, (PIECES, 8)"
    out: Float64s
    "wanted direction, (PIECES, 8)"


class Thoughts(NamedTuple):
    """What each mind of a piece's batch has come to by now, one row each; (PIECES x BATCH, ...)."""

    me: Int32s
    "place in the crowd"
    previous: Int8s
    "the intention before this thought"
    target: Int32s
    "place in the crowd of its meal or mate, -1 for none"
    looks: Int8s
    "1 for who looks round for hunters, food and mates in this thought"
    found: Int32s
    "nearest of its kind listed"
    near: Int64s
    "their places in the crowd, (rows, NEIGHBOURS)"
    distance: Float64s
    "squared distances [m^2] to them, (rows, NEIGHBOURS)"
    other: Int32s
    "place of who collides first, -1 for none"
    when: Float64s
    "[s] until then"
    number: Float64s
    "fishes of its shoal, 0 for none"
    shoal: Float64s
    "offset [m] and mean heading of one's kind farther off, (rows, 8)"
    seen: Int32s
    "predators listed"
    hunters: Int64s
    "their places in the crowd, (rows, NEIGHBOURS)"
    hunter_distance: Float64s
    "squared distances [m^2] to them, (rows, NEIGHBOURS)"
    predator: Int32s
    "place of the most dangerous, -1 for none"
    fear: Float64s
    "of all"
    worst: Float64s
    "fear of the most dangerous predator alone"
    danger: Float64s
    "the most dangerous predator as `heed` tells of it, (rows, 8)"
    obstacle: Float64s
    "distance of the nearest obstacle over the distance that alarms"
    normal: Float64s
    "unit way out of it, (rows, 8)"
    away: Float64s
    "offset [m] from the submarine, (rows, 8)"
    meets: Float64s
    "[s] until the submarine is too near"
    scare: Float64s
    "fear of the submarine"
    urgent: Int8s
    "1 for who is in danger"
    plain: Float64s
    "hunger that nothing near tempts, as `appetite` has it"
    meal: Int64s
    "focus that food or prey deserves, -1 for none"
    mate: Int32s
    "place of the partner, -1 for none"
    rise: Float64s
    "where light and warmth lie: 1 up, -1 down"


def make_attention() -> Attention:
    """Return scratch for every piece; rows are padded so that threads share no cache line."""

    def reals(width: int) -> Float64s:
        return np.zeros((PIECES, width))

    def places(width: int) -> Int32s:
        return np.zeros((PIECES, width), np.int32)

    return Attention(
        runs=np.zeros((PIECES, 24), np.int64),
        around_x=reals(MOST_AROUND),
        around_y=reals(MOST_AROUND),
        around_z=reals(MOST_AROUND),
        around=places(MOST_AROUND),
        kinds=places(MOST_AROUND),
        seen=np.zeros((PIECES, MOST_AROUND), np.int8),
        square=reals(MOST_AROUND + 1),
        company=places(MOST_AROUND + 1),
        others=places(MOST_AROUND + 1),
        coarse_runs=places(32),
        hunters_around=places(MOST_LISTED),
        sought=np.zeros((PIECES, NEIGHBOURS), np.int64),
        sought_distance=reals(NEIGHBOURS),
        roaming=reals(8),
        shelter=reals(8),
        out=reals(8),
    )


def make_thoughts() -> Thoughts:
    """Return room for a batch of every piece."""
    rows = PIECES * BATCH
    wide = {"near", "distance", "shoal", "hunters", "hunter_distance", "danger", "normal", "away"}
    types = {Int8s: np.int8, Int32s: np.int32, Int64s: np.int64, Float64s: np.float64}
    return Thoughts(
        **{
            name: np.zeros((rows, NEIGHBOURS) if name in wide else rows, types[kind])
            for name, kind in Thoughts.__annotations__.items()
        }
    )
