"""Threads take turns: who is done with a piece of a loop takes the next, so that nobody waits for the slower.

numba gives each thread its share of a `prange` beforehand. Shares cost differently, and a processor that others use
too is slow for a while. Where each thread takes pieces until none is left, both even out; of its other shares of the
`prange` nothing is left to do:

    turns = first_turn()
    for share in numba.prange(pieces):
        piece = next_turn(turns, share, pieces)
        while piece < pieces:
            ...
            piece = next_turn(turns, share, pieces)

Threads with the first shares take pieces from the front, those with the last from the back: so each has the same pieces
tick by tick, and their lines stay in its own caches. Which thread takes a piece must not matter to its result.
"""

from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.extending import intrinsic

from components.kernels import inlined

_COUNT = ir.IntType(64)


@intrinsic  # type: ignore[untyped-decorator]
def first_turn(_: Any) -> Any:
    """Return the address of counts of pieces taken, 0: in all, from the front, from the back.

    They live as long as the kernel runs.
    """

    def write(_: Any, builder: Any, *__: Any) -> Any:
        counts = ir.ArrayType(_COUNT, 3)
        place = cgutils.alloca_once(builder, counts)
        builder.store(ir.Constant(counts, [0, 0, 0]), place)
        return builder.ptrtoint(place, _COUNT)

    return types.int64(), write


@intrinsic  # type: ignore[untyped-decorator]
def _raise(_: Any, turns: Any, which: Any) -> Any:  # noqa: ARG001 (typed by numba)
    """Raise the count `which` by one; return what it was."""

    def write(_: Any, builder: Any, __: Any, args: Any) -> Any:
        at = builder.add(args[0], builder.mul(args[1], ir.Constant(_COUNT, 8)))
        place = builder.inttoptr(at, _COUNT.as_pointer())
        return builder.atomic_rmw("add", place, ir.Constant(_COUNT, 1), "monotonic")

    return types.int64(types.int64, types.int64), write


@inlined
def next_turn(turns: int, share: int, pieces: int) -> int:
    """Take a turn: return the number of the piece, from 0, that is the caller's; `pieces` where none is left.

    `share`: the one of the `prange` with which its thread came, 0 to pieces - 1.
    """
    if _raise(turns, 0) >= pieces:
        return pieces
    return int(_raise(turns, 1) if 2 * share < pieces else pieces - 1 - _raise(turns, 2))
