"""The body's own axes from its nodes (papers/000, 4.1, eqs. 1-4, with eq. 3 normalised as FINDINGS 1 says)."""

from math import sqrt

from components.arrays import Float64s
from components.kernels import row


@row
def body_frame(nodes: Float64s, origin: Float64s, rotation: Float64s) -> None:
    """Write o (3,) and R (3, 3), columns x anterior, y dorsal, z right, of `nodes` (23, 3)."""
    for axis in range(3):
        origin[axis] = 0.5 * (nodes[5, axis] + nodes[7, axis])
    x0, x1, x2 = nodes[0, 0] - origin[0], nodes[0, 1] - origin[1], nodes[0, 2] - origin[2]
    size = sqrt(x0 * x0 + x1 * x1 + x2 * x2)
    x0, x1, x2 = x0 / size, x1 / size, x2 / size
    w0, w1, w2 = nodes[5, 0] - nodes[6, 0], nodes[5, 1] - nodes[6, 1], nodes[5, 2] - nodes[6, 2]
    y0, y1, y2 = x1 * w2 - x2 * w1, x2 * w0 - x0 * w2, x0 * w1 - x1 * w0
    size = sqrt(y0 * y0 + y1 * y1 + y2 * y2)
    y0, y1, y2 = y0 / size, y1 / size, y2 / size
    rotation[0, 0], rotation[1, 0], rotation[2, 0] = x0, x1, x2
    rotation[0, 1], rotation[1, 1], rotation[2, 1] = y0, y1, y2
    rotation[0, 2], rotation[1, 2], rotation[2, 2] = (
        x1 * y2 - x2 * y1,
        x2 * y0 - x0 * y2,
        x0 * y1 - x1 * y0,
    )
