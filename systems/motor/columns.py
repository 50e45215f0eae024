"""The columns of the fish and motor tables as the motor system's kernels take them."""

from typing import NamedTuple

from components.arrays import Float64s, Int32s
from components.fish import FishTable
from components.motor import MotorTable


class Bodies(NamedTuple):
    """The columns of `FishTable` that move reads and writes."""

    species: Int32s
    length: Float64s
    position: Float64s
    rotation: Float64s
    last_position: Float64s
    last_rotation: Float64s


class Motors(NamedTuple):
    """The columns of `MotorTable` that move reads and writes."""

    steer: Float64s
    segment: Int32s
    wanted: Int32s
    throttle: Float64s
    pace: Float64s
    frame: Int32s
    held: Int32s
    shape_row: Int32s
    last_shape_row: Int32s
    part: Float64s
    last_part: Float64s
    warp_from: Int32s
    warp_part: Float64s
    warp_to: Int32s
    warp_length: Int32s
    warp_age: Int32s
    warp_weight: Float64s
    last_warp_weight: Float64s
    mean_roll: Float64s
    glide: Float64s


def bodies(fish: FishTable) -> Bodies:
    """Return the columns of `fish` that kernels move; stale when the table grows."""
    return Bodies(*(getattr(fish, name) for name in Bodies._fields))


def motors(motor: MotorTable) -> Motors:
    """Return the columns of `motor` that kernels move; stale when the table grows."""
    return Motors(*(getattr(motor, name) for name in Motors._fields))
