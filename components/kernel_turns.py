"""Threads take turns: who is done with a piece of a loop takes the next, so that nobody waits for the slower.

numba gives each thread its share of a `prange` beforehand. Shares cost differently, and a processor that others use
too is slow for a while. Where each thread takes pieces from one count until none is left, both even out; of its other
shares of the `prange` nothing is left to do:

    turns = first_turn()
    for _ in numba.prange(pieces):
        piece = next_turn(turns)
        while piece < pieces:
            ...
            piece = next_turn(turns)

Which thread takes a piece must not matter to its result.
"""

from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.extending import intrinsic

_COUNT = ir.IntType(64)


@intrinsic  # type: ignore[untyped-decorator]
def first_turn(_: Any) -> Any:
    """Return the address of a count of pieces taken, 0, that lives as long as the kernel runs."""

    def write(_: Any, builder: Any, *__: Any) -> Any:
        place = cgutils.alloca_once(builder, _COUNT)
        builder.store(ir.Constant(_COUNT, 0), place)
        return builder.ptrtoint(place, _COUNT)

    return types.int64(), write


@intrinsic  # type: ignore[untyped-decorator]
def next_turn(_: Any, turns: Any) -> Any:  # noqa: ARG001 (typed by numba)
    """Take a turn: return the number of the piece, from 0, that is the caller's."""

    def write(_: Any, builder: Any, __: Any, args: Any) -> Any:
        place = builder.inttoptr(args[0], _COUNT.as_pointer())
        return builder.atomic_rmw("add", place, ir.Constant(_COUNT, 1), "monotonic")

    return types.int64(types.int64), write
