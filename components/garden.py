"""The garden: all fibres of a level, laid out for those that bend and draw them (papers/002, section 5).

Bounding spheres hold what fibres can never leave, whatever the flow, since segments never stretch: a list of
singularities by sphere is therefore lossless.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Final

import numpy as np

from components.arrays import AnyArray, Float32s, Float64s, Int32s
from components.fibre import DENSITY, GROUNDED, LANES, SKIN, Followers, Rocks, Strands, Tuft
from components.garden_plan import Plan, plan_bundles
from components.rocks import pack_rocks

_NEAREST: Final = 3
_LINE: Final = 64
_STIFFEST: Final = 1e12


class Garden:
    """All fibres of a level. `position` is what is drawn; see the layout in components/fibre.py."""

    tuft_sphere: Float64s
    "[m] centre and radius of what each tuft can never leave, its thickness included, (tufts, 4)"
    clump_sphere: Float64s
    "[m] the same of each clump's nodes, (clumps, 4)"
    clump: Int32s
    "clump of each tuft, -1 for followers and tufts without fibres, (tufts,)"
    first_fibre: Int32s
    "index of each tuft's first fibre, (tufts + 1,)"
    first_row: Int32s
    "row of each fibre's root, (fibres,)"
    lane: Int32s
    "place of each fibre in its rows, (fibres,)"
    nodes: Int32s
    "of each fibre, (fibres,)"
    plant: Int32s
    "of each tuft, (tufts,)"
    look: Int32s
    "of each tuft, (tufts,)"
    position: Float32s
    "[m] nodes, world axes, (rows, 3, 8): the rows that bend, then those of followers"
    radius: Float32s
    "[m] at the nodes, (rows, 8)"
    strands: Strands
    "what bending kernels read and write"
    followers: Followers
    "what is interpolated"
    rocks: Rocks
    "what no node enters"
    depths: tuple[int, ...]
    "where each depth of carrying begins in `strands.bundle`, and the end"

    def __init__(
        self,
        tufts: Sequence[Tuft],
        rocks: tuple[Float64s, Float64s, Float64s] | None = None,
        density: float = DENSITY,
    ) -> None:
        """Lay out the tufts at rest among rocks: centres, semi-axes and yaws as `components.rocks.pack_rocks` has them.

        Raise ValueError where a tuft leans on one that does not come before it.
        """
        plan = plan_bundles(tufts)
        self.plant = np.array([tuft.plant for tuft in tufts], np.int32)
        self.look = np.array([tuft.look for tuft in tufts], np.int32)
        self.first_fibre, self.clump = plan.first_fibre, plan.clump
        self.nodes = np.repeat([tuft.nodes for tuft in tufts], np.diff(plan.first_fibre))
        self.nodes = self.nodes.astype(np.int32)
        self.first_row, self.lane = plan.bundle[plan.of_fibre // LANES, 0], plan.of_fibre % LANES
        self.position = _aligned(plan.rows, 3, LANES)
        self.radius = _aligned(plan.rows, LANES)
        self.depths = plan.depths
        self._write_shapes(tufts, plan, density)
        self.tuft_sphere = _spheres(tufts)
        self.clump_sphere = _around(self.tuft_sphere, plan.clump)
        self.rocks = _list_rocks(self.clump_sphere, *(rocks or pack_rocks([])))

    @property
    def fibres(self) -> int:
        """Number of fibres, followers included."""
        return len(self.first_row)

    def fibre(self, tuft: int, fibre: int) -> int:
        """Return the index of a tuft's fibre among all."""
        return int(self.first_fibre[tuft]) + fibre

    def points(self, fibre: int) -> Float32s:
        """Return the nodes of a fibre [m] as they are now, root first, (nodes, 3)."""
        first = self.first_row[fibre]
        return self.position[first : first + self.nodes[fibre], :, self.lane[fibre]]

    def _write_shapes(self, tufts: Sequence[Tuft], plan: Plan, density: float) -> None:
        rows, bundles = plan.bent_rows, plan.depths[-1]
        self.strands = Strands(
            bundle=plan.bundle[:bundles].copy(),
            rest=_aligned(rows, 3, LANES),
            length=_aligned(rows, LANES),
            area=_aligned(rows, LANES),
            stiffness=_aligned(rows, LANES),
            rest_root=_aligned(bundles, 6, LANES),
            root=_aligned(bundles, 6, LANES),
            perch=_aligned(bundles, 6, LANES),
            carrier=np.zeros((bundles, LANES), np.int32),
            plane=_aligned(bundles, 4, LANES),
            direction=_aligned(rows, 3, LANES),
            position=self.position[:rows],
        )
        groups = len(plan.bundle) - bundles
        self.followers = Followers(
            bundle=plan.bundle[bundles:, :2].copy(),
            guide=np.zeros((groups, _NEAREST, LANES), np.int32),
            weight=_aligned(groups, _NEAREST, LANES),
            root=_aligned(groups, 3, LANES),
            length=_aligned(plan.rows - rows, LANES),
        )
        for index, tuft in enumerate(tufts):
            here = _Where(self, plan, index, tuft.nodes)
            here.put(self.position, tuft.points)
            here.put(self.radius, np.broadcast_to(tuft.radii, tuft.points.shape[:2]))
            if tuft.guides is None:
                _write_strands(self.strands, tuft, here, density)
                if tuft.carriers is not None:
                    _write_perch(self, tufts, tuft, here)
            else:
                _write_followers(self, tufts, tuft, here)
        for planes, bundle, filled in self._planes(plan):
            for plane in planes:
                _fill_lanes(plane, filled, bundle)
        self.strands.root[:] = self.strands.rest_root

    def _planes(self, plan: Plan) -> "list[tuple[list[AnyArray], Int32s, Int32s]]":
        """Return the planes, first row and rows of each bundle in them, and its filled lanes."""
        bent, strands, followers = self.depths[-1], self.strands, self.followers
        rows = plan.bundle[:, :2]
        own = np.stack([np.arange(len(rows)), np.ones(len(rows))], axis=1).astype(np.int32)
        below = rows[bent:] - np.array([plan.bent_rows, 0], np.int32)
        by_row = [strands.rest, strands.length, strands.area, strands.stiffness, strands.direction]
        by_bundle = [strands.rest_root, strands.perch, strands.carrier, strands.plane]
        blended = [followers.guide, followers.weight, followers.root]
        return [
            ([self.position, self.radius], rows, plan.filled),
            ([*by_row], rows[:bent], plan.filled[:bent]),
            ([*by_bundle], own[:bent], plan.filled[:bent]),
            ([*blended], own[: len(rows) - bent], plan.filled[bent:]),
            ([followers.length], below, plan.filled[bent:]),
        ]


class _Where:
    """Where the fibres of one tuft stand in the planes."""

    def __init__(self, garden: Garden, plan: Plan, tuft: int, nodes: int) -> None:
        span = slice(plan.first_fibre[tuft], plan.first_fibre[tuft + 1])
        self.slot = plan.of_fibre[span] // LANES
        "bundle of each fibre, (F,)"
        self.lane = garden.lane[span]
        self.rows = garden.first_row[span, None] + np.arange(nodes)
        "row of each node, (F, N)"
        self.bent_rows, self.bundles = plan.bent_rows, plan.depths[-1]

    def put(self, plane: AnyArray, values: AnyArray, first_row: int = 0) -> None:
        """Write values of each node, (F, N) or (F, N, k), into a plane of rows, from node 0 on."""
        rows, lane = self.rows - first_row, self.lane[:, None]
        if plane.ndim == 2:
            plane[rows, lane] = values
        else:
            plane[rows, :, lane] = values

    def put_slot(self, plane: AnyArray, values: AnyArray, first: int = 0) -> None:
        """Write values of each fibre, (F, k), into a plane of bundles."""
        part = slice(first, first + values.shape[1])
        plane[self.slot[:, None], np.arange(part.start, part.stop), self.lane[:, None]] = values


def _aligned(*shape: int) -> Float32s:
    """Return zeros that begin at a cache line, as a device that shares our memory wants them."""
    size = 4 * int(np.prod(shape))
    raw = np.zeros(size + _LINE, np.uint8)
    start = -raw.ctypes.data % _LINE
    return raw[start : start + size].view(np.float32).reshape(shape)


def _unit(vectors: Float64s) -> Float64s:
    units: Float64s = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return units


def _carry_normal(t: Float64s, normal: Float64s, after: Float64s) -> Float64s:
    """Return the normals (F, 3) of directions t (F, 3), turned as little as brings t to `after`."""
    whole = np.maximum(1.0 + (t * after).sum(1), 1e-3)
    moved: Float64s = normal - ((normal * after).sum(1) / whole)[:, None] * (t + after)
    return moved


def _rest_frames(points: Float64s) -> tuple[Float64s, Float64s, Float64s]:
    """Return each fibre's first direction and a normal, (F, 3) each, and its rest directions, (F, N, 3).

    Those are in the frame (t, n, t x n) of the segment below, so that a bent fibre keeps its own curl.
    """
    count, nodes = points.shape[:2]
    directions = np.zeros((count, max(nodes - 1, 1), 3))
    directions[..., 2] = 1.0
    if nodes > 1:
        directions = _unit(np.diff(points, axis=1))
    t = directions[:, 0]
    least = np.eye(3)[np.abs(t).argmin(axis=1)]
    normal = start = _unit(np.cross(t, least))
    local = np.zeros(points.shape)
    local[:, :2, 0] = 1.0
    for node in range(2, nodes):
        after = directions[:, node - 1]
        for part, axis in enumerate((t, normal, np.cross(t, normal))):
            local[:, node, part] = (after * axis).sum(1)
        normal, t = _carry_normal(t, normal, after), after
    return directions[:, 0], start, local


def _write_strands(strands: Strands, tuft: Tuft, here: _Where, density: float) -> None:
    radii = np.broadcast_to(tuft.radii, tuft.points.shape[:2])
    length = np.zeros(radii.shape)
    length[:, 1:] = np.linalg.norm(np.diff(tuft.points, axis=1), axis=2)
    with np.errstate(divide="ignore", over="ignore"):
        stiff = np.minimum(radii**tuft.exponent * tuft.modulus, _STIFFEST)
    first, normal, local = _rest_frames(tuft.points)
    directions = np.broadcast_to(first[:, None], tuft.points.shape).copy()
    if tuft.nodes > 1:
        directions[:, 1:] = _unit(np.diff(tuft.points, axis=1))
    here.put(strands.rest, local)
    here.put(strands.length, length)
    here.put(strands.area, 0.5 * density * length * radii)
    here.put(strands.stiffness, np.nan_to_num(stiff) * length)
    here.put(strands.direction, directions)
    here.put_slot(strands.rest_root, np.concatenate([first, normal], axis=1))
    if tuft.ground is not None:
        here.put_slot(strands.plane, np.broadcast_to(tuft.ground, (tuft.fibres, 4)))
        strands.bundle[here.slot, 3] |= GROUNDED


def _write_perch(garden: Garden, tufts: Sequence[Tuft], tuft: Tuft, here: _Where) -> None:
    """Write where the roots stand on their carriers, which are laid out already."""
    if tuft.carriers is None:
        return
    above, fibre, node = tuft.carriers
    carrier = garden.first_fibre[above] + np.asarray(fibre)
    row, lane = garden.first_row[carrier] + np.asarray(node), garden.lane[carrier]
    offset = tuft.points[:, 0] - tufts[above].points[fibre, node]
    facing = garden.strands.direction[row, :, lane]
    here.put_slot(garden.strands.perch, np.concatenate([offset, facing], axis=1))
    garden.strands.carrier[here.slot, here.lane] = LANES * row + lane


def _write_followers(garden: Garden, tufts: Sequence[Tuft], tuft: Tuft, here: _Where) -> None:
    """Write the three nearest guides of each fibre, weights 1 / (d^2 + (.4 L)^2) (FINDINGS 9)."""
    if tuft.guides is None or not tuft.fibres:
        return
    guides, followers = tufts[tuft.guides], garden.followers
    roots, own = guides.points[:, 0], tuft.points[:, 0]
    away2 = ((own[:, None] - roots[None]) ** 2).sum(2)
    nearest = np.argsort(away2, axis=1, kind="stable")[:, :_NEAREST]
    length = np.linalg.norm(np.diff(guides.points, axis=1), axis=2)
    near2 = (0.4 * length.mean()) ** 2 if guides.nodes > 1 else 1.0
    weight = 1.0 / (np.take_along_axis(away2, nearest, axis=1) + near2)
    weight /= weight.sum(1, keepdims=True)
    blank = _NEAREST - nearest.shape[1]
    nearest, weight = np.pad(nearest, ((0, 0), (0, blank))), np.pad(weight, ((0, 0), (0, blank)))
    fibre = garden.first_fibre[tuft.guides] + nearest
    place = LANES * garden.first_row[fibre] + garden.lane[fibre]
    slot, lane = here.slot - here.bundles, here.lane
    followers.guide[slot[:, None], np.arange(_NEAREST), lane[:, None]] = place
    followers.weight[slot[:, None], np.arange(_NEAREST), lane[:, None]] = weight
    followers.root[slot, :, lane] = own - (weight[..., None] * roots[nearest]).sum(1)
    segments = np.zeros(tuft.points.shape[:2])
    segments[:, 1:] = np.linalg.norm(np.diff(tuft.points, axis=1), axis=2)
    here.put(followers.length, segments, here.bent_rows)


def _fill_lanes(plane: AnyArray, filled: Int32s, bundle: Int32s) -> None:
    """Repeat the last fibre of each bundle in the lanes that hold none; `bundle` is (first row, rows) in the plane."""
    for at in np.flatnonzero(filled < LANES):
        first, rows = bundle[at]
        here = plane[first : first + rows]
        here[..., filled[at] :] = here[..., filled[at] - 1 : filled[at]]


def _reaches(tufts: Sequence[Tuft], index: int) -> tuple[Float64s, Float64s]:
    """Return a point that never moves [m], (F, 3), and how far each node may get from it [m], (F, N)."""
    tuft = tufts[index]
    along = np.zeros(tuft.points.shape[:2])
    along[:, 1:] = np.cumsum(np.linalg.norm(np.diff(tuft.points, axis=1), axis=2), axis=1)
    roots = tuft.points[:, 0]
    if tuft.carriers is not None:
        above, fibre, node = tuft.carriers
        still, far = _reaches(tufts, above)
        offset = np.linalg.norm(roots - tufts[above].points[fibre, node], axis=1)
        return still[fibre], along + (far[fibre, node] + offset)[:, None]
    if tuft.guides is not None:
        still, far = _reaches(tufts, tuft.guides)
        moved = np.linalg.norm(tufts[tuft.guides].points[:, 0] - still, axis=1) + far[:, 0]
        return roots, along + moved.max(initial=0.0)
    return roots, along


def _spheres(tufts: Sequence[Tuft]) -> Float64s:
    """Return centre and radius [m] of what each tuft can never leave, thickness included, (tufts, 4)."""
    spheres = np.zeros((len(tufts), 4))
    for index, tuft in enumerate(tufts):
        if tuft.fibres:
            still, far = _reaches(tufts, index)
            centre = 0.5 * (still.min(0) + still.max(0))
            farthest = np.linalg.norm(still - centre, axis=1) + (far + tuft.radii).max(1)
            spheres[index] = *centre, farthest.max()
    return spheres


def _around(spheres: Float64s, clump: Int32s) -> Float64s:
    """Return the sphere around the tufts of each clump, (clumps, 4)."""
    around = np.zeros((int(clump.max(initial=-1)) + 1, 4))
    order = np.argsort(clump, kind="stable")
    ends = np.searchsorted(clump[order], np.arange(len(around) + 1))
    for index, (begin, end) in enumerate(pairwise(ends)):
        own = spheres[order[begin:end]]
        centre = own[:, :3].mean(0)
        around[index] = *centre, (np.linalg.norm(own[:, :3] - centre, axis=1) + own[:, 3]).max()
    return around


def _list_rocks(sphere: Float64s, centre: Float64s, radii: Float64s, axes: Float64s) -> Rocks:
    """Return the rocks as bending kernels read them, listed by clump."""
    table = _aligned(len(centre), 12)
    table[:, :3], table[:, 3] = centre, radii.min(1, initial=np.inf)
    table[:, 4:7], table[:, 8:10] = 1.0 / radii, axes
    reach = sphere[:, None, 3] + radii.max(1, initial=0.0) + 2.0 * SKIN
    near = np.linalg.norm(sphere[:, None, :3] - centre, axis=2) < reach
    first = np.zeros(len(sphere) + 1, np.int32)
    first[1:] = np.cumsum(near.sum(1))
    return Rocks(table, first, np.nonzero(near)[1].astype(np.int32))
