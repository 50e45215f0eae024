"""What each fish's motor system plays and is asked to play (papers/000 sections 5 and 6.1).

The rows stand in step with `FishTable`'s (components/fish.py). Shape rows index
`RepertoireLibrary.shape`; d(row, part) lies the share `part` of the way from the shape of `row` to the
one that follows it. The shape shown at the end of a tick is d(shape_row, part) + warp_weight *
(d(warp_from, warp_part) - d(warp_to, 0)), in body lengths; the view blends it with the one of the tick
before, whose row, part and weight stand beside. Parts are 0 in fishes at pace 1.
"""

from typing import Final

import numpy as np

from components.arrays import Float64s, Int8s, Int32s
from components.kernels import inlined
from components.table import Table, column

RATES: Final = (0.66, 1.5)
"""Slowest and fastest that a swim is played, entries a tick. The beat's frequency and the speed change alike, so stride
and Strouhal number stay as captured. In our nine species frequencies of neighbouring gears differ by 1.56 to 1.69: a
rate between .66 and 1.5 never beats a gear more slowly than the one below was captured, or faster than the one above.
Speeds differ by 1.36 to 2.2, and 1.5 / .66 is 2.27: from .66 of the slow swim to 1.5 of the fast no speed is left out.
At the top a sardine beats 10 times a second, which muscle of its size can (Wardle 1975), at less than Bainbridge's
V = L (3f - 4) / 4."""

PACES: Final = (-0.2, RATES[1])
"""Slowest and fastest that a swim is played over its own speed. Below the lowest rate strides shrink; backwards a fish
goes no faster than fins row."""

KEPT: Final = (0.75, 1.4)
"""Throttles between which a fish keeps its gear, so that a demand that wavers changes none."""


@inlined
def gear_for_speed(
    wanted: float, gear: int, slow: float, medium: float, fast: float
) -> tuple[int, float]:
    """Return the gear and the throttle that swim at `wanted` [BL/s], from 0 up, for the speeds of three gears [BL/s].

    The present gear is kept while its throttle would lie in `KEPT`; else the gear whose own speed is nearest in
    proportion is taken, or the one below where that would have to play more slowly than `RATES` allow.
    """
    own = slow if gear == 0 else (medium if gear == 1 else fast)
    if wanted < KEPT[0] * own or wanted > KEPT[1] * own:
        square = wanted * wanted
        low, high = RATES[0] * medium, RATES[0] * fast
        gear = 1 if square < medium * fast or wanted < high else 2
        gear = 0 if square < slow * medium or wanted < low else gear
        own = slow if gear == 0 else (medium if gear == 1 else fast)
    return gear, wanted / own


@inlined
def shown_between(
    last: int, last_part: float, now: int, part: float, alpha: float, after: Int32s
) -> tuple[int, int, float]:
    """Return the two shape rows, and the share of the second, shown the fraction `alpha` of a tick after its start.

    The tick led from `last_part` behind the row `last` to `part` behind `now`. `after` (E,) holds the row that follows
    each (`RepertoireLibrary.after`). At rate 1 these are the rows themselves; else neighbours that `alpha` chooses.
    """
    if last_part == 0.0 and part == 0.0:
        return last, now, alpha
    steps, row = 0, last
    while row != now and steps < 3:
        row = after[row]
        steps += 1
    if row != now:
        return last, now, alpha
    share = last_part + alpha * (steps + part - last_part)
    row = last
    while share >= 1.0:
        row = after[row]
        share -= 1.0
    return row, after[row], share


class MotorTable(Table):
    """The motor state of each fish, one row each."""

    heading: Float64s = column(np.float64, 3)
    "demand: unit direction to swim in, world axes, (capacity, 3)"
    gear: Int8s = column(np.int8, fill=1)
    "demand: 0 slow, 1 medium, 2 fast, (capacity,)"
    urgency: Float64s = column(np.float64)
    "demand: 0 for leisure to 1 for danger; lets steering turn faster, (capacity,)"
    throttle: Float64s = column(np.float64, fill=1.0)
    """demand: speed over the gear's own, 1 as captured; from .66 to 1.5 the swim plays at that rate (`RATES`), below
    with shrinking strides: 0 to brake and stand, down to -.2 to back. Other than 1, the gear is played that is asked
    for, at leisure too; turns are played as captured. `gear_for_speed` finds both for a speed, (capacity,)"""
    pace: Float64s = column(np.float64, fill=1.0)
    "the speed over the segment's own that is played now, (capacity,)"
    mood: Int8s = column(np.int8)
    "the gear preferred at leisure to the one asked for: -1, 0 or 1 beside it, (capacity,)"
    mood_until: Int32s = column(np.int32)
    "[tick] at which another mood is drawn, (capacity,)"
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
    part: Float64s = column(np.float64)
    "how far towards the entry after `shape_row`, 0 to below 1, the shape shown is, (capacity,)"
    last_part: Float64s = column(np.float64)
    "how far it was after `last_shape_row` a tick ago, (capacity,)"
    warp_from: Int32s = column(np.int32)
    "the entry that the warp leaves, as shown when it began, (capacity,)"
    warp_part: Float64s = column(np.float64)
    "how far towards the entry after it, 0 to below 1, (capacity,)"
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
