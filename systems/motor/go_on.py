"""Going on: a fish moves by what it plays in a tick (papers/000 section 5.1, eqs. 10 and 11; appendix B)."""

from components.kernels import inlined
from components.rotation import Vector, set_axes, turned
from systems.motor.balance import righting, roll
from systems.motor.columns import Bodies, Motors


@inlined
def go_on(
    i: int, u: float, v: float, w: float, ahead: Vector, above: Vector, fish: Bodies, motor: Motors
) -> None:
    """Move by (u, v, w) [m] in the body's axes, o <- o + R (u, v, w), eq. 11, and turn, R <- steer R M, eq. 10, where
    `ahead` and `above` are the first columns of M, less the part of the mean roll that balance takes out now.

    All loads stand before the stores: what was just stored would be waited for.
    """
    r, o = fish.rotation[i], fish.position[i]
    r00, r01, r02 = r[0, 0], r[0, 1], r[0, 2]
    r10, r11, r12 = r[1, 0], r[1, 1], r[1, 2]
    r20, r21, r22 = r[2, 0], r[2, 1], r[2, 2]
    x, y, z = o[0], o[1], o[2]
    p, q, s = motor.steer[i, 0], motor.steer[i, 1], motor.steer[i, 2]
    last, was = fish.last_rotation[i], fish.last_position[i]
    last[0, 0], last[0, 1], last[0, 2] = r00, r01, r02
    last[1, 0], last[1, 1], last[1, 2] = r10, r11, r12
    last[2, 0], last[2, 1], last[2, 2] = r20, r21, r22
    was[0], was[1], was[2] = x, y, z
    o[0] = x + (r00 * u + r01 * v + r02 * w)
    o[1] = y + (r10 * u + r11 * v + r12 * w)
    o[2] = z + (r20 * u + r21 * v + r22 * w)
    ax = r00 * ahead[0] + r01 * ahead[1] + r02 * ahead[2]
    ay = r10 * ahead[0] + r11 * ahead[1] + r12 * ahead[2]
    az = r20 * ahead[0] + r21 * ahead[1] + r22 * ahead[2]
    bx = r00 * above[0] + r01 * above[1] + r02 * above[2]
    by = r10 * above[0] + r11 * above[1] + r12 * above[2]
    bz = r20 * above[0] + r21 * above[1] + r22 * above[2]
    cx, cy, cz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    c = righting(i, motor, roll(az, bz, cz))
    bx, by, bz = bx - c * cx, by - c * cy, bz - c * cz
    ax, ay, az = turned(ax, ay, az, p, q, s)
    bx, by, bz = turned(bx, by, bz, p, q, s)
    set_axes(r, ax, ay, az, bx, by, bz)
