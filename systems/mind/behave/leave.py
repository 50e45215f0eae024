"""Leaving: where light or warmth do not suit, go up or down to where they do (papers/004's habits).

Both fall with depth. Where the water ends in that direction, a fish goes along the slope of the ground.
"""

from typing import Final

from components.arrays import Float64s
from components.ground import Terrain, ground_height
from components.kernels import row
from systems.mind.crowd import Crowd

_SLOPE: Final = 0.6
_PROBE: Final = 2.0
_ROOM: Final = 1.0


@row
def leave(
    terrain: Terrain, crowd: Crowd, me: int, rise: float, low: float, high: float, out: Float64s
) -> tuple[int, float, float]:
    """Write the wanted direction, (3,); return gear, urgency, throttle.

    `rise`: how much it wants to be higher, 1, or deeper, -1; `low` and `high` [m] are the lowest and highest z
    that it can go to here.
    """
    x, y, z = crowd.x[me], crowd.y[me], crowd.z[me]
    room = min(max((high - z if rise > 0.0 else z - low) / _ROOM, 0.0), 1.0)
    up = 1.0 if rise > 0.0 else -1.0
    out[0], out[1], out[2] = crowd.hx[me], crowd.hy[me], up * _SLOPE * room
    if room < 1.0:
        height, extent, cell = terrain.height, terrain.extent, terrain.cell
        here = ground_height(height, extent, cell, x, y)
        out[0] += (1.0 - room) * up * (ground_height(height, extent, cell, x + _PROBE, y) - here)
        out[1] += (1.0 - room) * up * (ground_height(height, extent, cell, x, y + _PROBE) - here)
    much = min(max(rise * up, 0.0), 1.0)
    return 1, 0.15 + 0.15 * much, 1.0
