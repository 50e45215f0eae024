"""What each fish's motor system plays and is asked to play (papers/000 sections 5 and 6.1).

The rows stand in step with `FishTable`'s (components/fish.py). Shape rows index
`RepertoireLibrary.shape`. The shape shown at the end of a tick is shape[shape_row] + warp_weight *
(shape[warp_from] - shape[warp_to]), in body lengths; the view blends it with the one of the tick
before, whose row and weight stand beside.
"""

import numpy as np

from components.arrays import Float64s, Int8s, Int32s
from components.table import Table, column


class MotorTable(Table):
    """The motor state of each fish, one row each."""

    heading: Float64s = column(np.float64, 3)
    "demand: unit direction to swim in, world axes, (capacity, 3)"
    gear: Int8s = column(np.int8, fill=1)
    "demand: 0 slow, 1 medium, 2 fast, (capacity,)"
    urgency: Float64s = column(np.float64)
    "demand: 0 for leisure to 1 for danger; lets steering turn faster, (capacity,)"
    throttle: Float64s = column(np.float64, fill=1.0)
    "demand: speed over the swim's own, 1 as captured, 0 to brake and stand, below 0 to back, (capacity,)"
    pace: Float64s = column(np.float64, fill=1.0)
    "the speed over the segment's own that is played now, (capacity,)"
    steer: Float64s = column(np.float64, 3)
    "rotation vector [rad] of this tick's fine steering, world axes, (capacity, 3)"
    segment: Int32s = column(np.int32)
    "the library's segment being played, (capacity,)"
    wanted: Int32s = column(np.int32)
    "the library's segment that control asks for; taken when no warp is under way, (capacity,)"
    frame: Int32s = column(np.int32)
    "the segment's entry to be played next, from 0, (capacity,)"
    held: Int32s = column(np.int32)
    "[ticks] since the segment changed, (capacity,)"
    shape_row: Int32s = column(np.int32)
    "the library's entry whose shape is shown now, (capacity,)"
    last_shape_row: Int32s = column(np.int32)
    "the entry shown a tick ago, (capacity,)"
    warp_from: Int32s = column(np.int32)
    "the entry that the warp leaves, as shown when it began, (capacity,)"
    warp_to: Int32s = column(np.int32)
    "the new segment's entry before the first one played, or a turn's first, (capacity,)"
    warp_length: Int32s = column(np.int32)
    "[ticks] that the warp takes, 0 for none, (capacity,)"
    warp_age: Int32s = column(np.int32)
    "[ticks] of the warp played, (capacity,)"
    warp_weight: Float64s = column(np.float64)
    "weight of the decaying offset now, 0 to 1, (capacity,)"
    last_warp_weight: Float64s = column(np.float64)
    "weight of the offset a tick ago, 0 to 1, (capacity,)"
    mean_roll: Float64s = column(np.float64)
    "running mean [rad] of the roll, which balance takes out (papers/000, appendix B), (capacity,)"
    glide: Float64s = column(np.float64, 3)
    "velocity left over from the segment before [BL/tick], body axes; fades with the warp, (capacity, 3)"
