"""Which singularities reach which clump of fibres: bounding spheres, and an octree over many (papers/002, 5.1).

Lists name singularities in rising order and leave out none that reaches, so sums are the same to the bit with and
without them. The octree is implicit: singularities in Morton order, eight to a leaf, eight boxes to the box above.
"""

from typing import Final, NamedTuple

import numpy as np

from components.arrays import Float32s, Float64s, Int32s, Int64s
from components.field import REACH_AT
from components.kernels import row, serial

MANY: Final = 256
"""Singularities from which on the octree is faster."""

_BRANCH: Final = 8
_BITS: Final = 10


class Lists(NamedTuple):
    """Singularities by clump. C clumps."""

    first: Int32s
    "where the list of each clump begins, (C + 1,)"
    member: Int32s
    "rows in what `components.field.pack` returned; there may be room behind the last list"


class Octree(NamedTuple):
    """Boxes around singularities in Morton order, eight by eight. N with bounds, T boxes on all levels."""

    box: Float64s
    "lowest and highest corner [m] of what those below can reach, leaves first, (T, 6)"
    level: Int64s
    "where the boxes of each level begin, and the end"
    order: Int64s
    "rows of the singularities in Morton order, (N,)"
    everywhere: Int64s
    "rows of those without bounds"


@row
def _reaches(sphere: Float64s, clump: int, packed: Float32s, k: int) -> bool:
    """Return whether a singularity may be felt in a clump, with room for float32's rounding."""
    dx, dy = packed[k, 0] - sphere[clump, 0], packed[k, 1] - sphere[clump, 1]
    dz = packed[k, 2] - sphere[clump, 2]
    room = (sphere[clump, 3] + packed[k, REACH_AT]) * 1.0001 + 1e-3
    room += 1e-6 * (abs(sphere[clump, 0]) + abs(sphere[clump, 1]) + abs(sphere[clump, 2]))
    return bool(dx * dx + dy * dy + dz * dz <= room * room)


@row
def _scan(
    sphere: Float64s, clump: int, packed: Float32s, rows: Int64s, member: Int32s, count: int
) -> int:
    """Append those of `rows` that may be felt in a clump, as far as there is room; return how many there are now."""
    for k in rows:
        if packed[k, 8] != 0.0 and _reaches(sphere, clump, packed, k):
            if count < len(member):
                member[count] = k
            count += 1
    return count


@row
def _list_all(
    sphere: Float64s, packed: Float32s, rows: Int64s, first: Int32s, member: Int32s
) -> int:
    """Write the lists as far as `member` has room; return how much they need."""
    count = 0
    for clump in range(len(sphere)):
        count = _scan(sphere, clump, packed, rows, member, count)
        first[clump + 1] = count
    return count


@row
def _apart(sphere: Float64s, clump: int, box: Float64s) -> bool:
    """Return whether no singularity in a box (6,) can reach a clump."""
    away = 0.0
    for axis in range(3):
        short = max(box[axis] - sphere[clump, axis], sphere[clump, axis] - box[axis + 3])
        if short > 0.0:
            away += short * short
    room = sphere[clump, 3] * 1.0001 + 2e-3
    for axis in range(3):
        room += 1e-6 * abs(sphere[clump, axis])
    return bool(away > room * room)


@serial
def _list_by_octree(
    sphere: Float64s,
    packed: Float32s,
    tree: Octree,
    first: Int32s,
    member: Int32s,
) -> int:
    """Do as `_list_all` does."""
    top = len(tree.level) - 2
    stack = np.zeros((_BRANCH * len(tree.level) + 1, 2), np.int64)
    count = 0
    for clump in range(len(sphere)):
        count = _scan(sphere, clump, packed, tree.everywhere, member, count)
        stack[0, 0], stack[0, 1], depth = top, 0, min(top + 1, 1)
        while depth > 0:
            depth -= 1
            height, node = stack[depth]
            if _apart(sphere, clump, tree.box[tree.level[height] + node]):
                continue
            begin, end = node * _BRANCH, (node + 1) * _BRANCH
            if height == 0:
                count = _scan(sphere, clump, packed, tree.order[begin:end], member, count)
                continue
            for child in range(begin, min(end, tree.level[height] - tree.level[height - 1])):
                stack[depth, 0], stack[depth, 1] = height - 1, child
                depth += 1
        if count <= len(member):
            member[first[clump] : count].sort()
        first[clump + 1] = count
    return count


def _spread(cells: Int64s) -> Int64s:
    """Return 10-bit numbers with two zero bits between each two of theirs."""
    out = np.zeros_like(cells)
    for bit in range(_BITS):
        out |= ((cells >> bit) & 1) << (3 * bit)
    return out


def _octree(packed: Float32s) -> Octree:
    bounded = np.isfinite(packed[:, REACH_AT])
    rows = np.flatnonzero(bounded)
    centre, reach = packed[rows, :3].astype(float), 1.0001 * packed[rows, REACH_AT, None]
    low = centre.min(0, initial=np.inf)
    size = max(float((centre - low).max(initial=0.0)), 1e-9)
    cells = ((centre - low) / size * ((1 << _BITS) - 1)).astype(np.int64)
    code = _spread(cells[:, 0]) | _spread(cells[:, 1]) << 1 | _spread(cells[:, 2]) << 2
    rank = np.argsort(code, kind="stable")
    boxes = [np.concatenate([centre - reach, centre + reach], axis=1)[rank]]
    while len(boxes[-1]) > 1 or len(boxes) == len(rows[:1]):
        begins = np.arange(0, len(boxes[-1]), _BRANCH)
        low, high = boxes[-1][:, :3], boxes[-1][:, 3:]
        box = [np.minimum.reduceat(low, begins), np.maximum.reduceat(high, begins)]
        boxes.append(np.concatenate(box, axis=1))
    level = np.cumsum([0, *(len(box) for box in boxes[1:])])
    return Octree(
        np.concatenate([*boxes[1:], np.zeros((0, 6))]), level, rows[rank], np.flatnonzero(~bounded)
    )


def gather(
    sphere: Float64s, packed: Float32s, spare: Lists | None = None, culled: bool = True
) -> Lists:
    """Return the singularities that may be felt in each sphere [m], (C, 4); all of them where not `culled`.

    The members' array of `spare`, earlier lists, is used again where it is large enough.
    """
    clumps, rows = len(sphere), np.arange(len(packed))
    first = (np.arange(clumps + 1) * len(packed)).astype(np.int32)
    if not culled:
        return Lists(first, np.tile(rows.astype(np.int32), clumps))
    member = spare.member if spare is not None else np.zeros(64 * clumps + 1, np.int32)
    tree = _octree(packed) if len(packed) > MANY else None
    while True:
        if tree is None:
            needed = _list_all(sphere, packed, rows, first, member)
        else:
            needed = _list_by_octree(sphere, packed, tree, first, member)
        if needed <= len(member):
            return Lists(first, member)
        member = np.zeros(needed + needed // 4, np.int32)
