"""Fishes in live physics: the few near the pilot whose muscles are simulated, not replayed (papers/000, 9.1).

A slot holds one fish from the tick it is chosen until the offset left over from its hand-back has faded. It owns two
rows at the end of `RepertoireLibrary.shape`, its shapes now and a tick ago, so that whoever draws or poses a fish finds
its shape by row as ever. The library's rows are a copy; the state is here.
"""

from typing import Final

import numpy as np

from components.arrays import Float32s, Float64s, Int8s, Int32s, Int64s
from components.body import NODES
from components.table import Table, column

MOST_LIVE: Final = 50
"""Fishes in live physics at most."""

FREE: Final = 0
"""Stage of a slot that holds no fish."""

ENTERING: Final = 1
"""Stage of one chosen this tick; it replays for one more, from which its nodes' speeds are known."""

LIVE: Final = 2
"""Stage of one whose muscles are simulated."""

LEAVING: Final = 3
"""Stage of one that replays again; what it looked like last still fades."""

MUSCLES: Final = 12


class LiveTable(Table):
    """The slots, two for each fish that may be live: one to be in, one to leave."""

    id: Int64s = column(np.int64, fill=-1)
    "the fish, -1 for none, (capacity,)"
    stage: Int8s = column(np.int8)
    "FREE, ENTERING, LIVE or LEAVING, (capacity,)"
    entry: Int32s = column(np.int32)
    "the library's entry that the fish would show if it replayed, (capacity,)"
    side: Int8s = column(np.int8)
    "which of `shape` is now, 0 or 1, (capacity,)"
    shape: Float32s = column(np.float32, 2, NODES, 3)
    "nodes now and a tick ago [BL], body axes, (capacity, 2, 23, 3)"
    nodes: Float64s = column(np.float64, NODES, 3)
    "nodes [BL] from the fish's position, along world axes, (capacity, 23, 3)"
    velocity: Float64s = column(np.float64, NODES, 3)
    "of the nodes [BL/s], world axes, (capacity, 23, 3)"
    travel: Float64s = column(np.float64, 3)
    "way of the origin in the last tick over the pace [BL], body axes of the tick before, (capacity, 3)"
    rest: Float64s = column(np.float64, MUSCLES)
    "lengths [BL] that the muscles strove for last, (capacity, 12)"
    offset: Float64s = column(np.float64, MUSCLES)
    "what they had more than the new stroke at the last change of segment [BL]; fades with the warp, (capacity, 12)"
