"""Places drawn by chance: anywhere in a ball, named by (seed, stream, draw, id) (DESIGN 2)."""

from typing import Final

from components import chance
from components.arrays import Float64s
from components.kernels import row

_ATTEMPTS: Final = 64


@row
def place(
    seed: int,
    stream: int,
    draw: int,
    identity: int,
    around: Float64s,
    within: float,
    position: Float64s,
) -> None:
    """Draw a position [m] in the ball of radius `within` around `around`, both in world axes, into (3,).

    Another `draw` of the stream is another position.
    """
    for attempt in range(_ATTEMPTS):
        first = 3 * (draw * _ATTEMPTS + attempt)
        x = 2.0 * chance.uniform(seed, stream, first, identity) - 1.0
        y = 2.0 * chance.uniform(seed, stream, first + 1, identity) - 1.0
        z = 2.0 * chance.uniform(seed, stream, first + 2, identity) - 1.0
        if x * x + y * y + z * z <= 1.0:
            break
    position[0] = around[0] + within * x
    position[1] = around[1] + within * y
    position[2] = around[2] + within * z
