"""Puts a mesh and the landmarks of its silhouette together into a target (papers/003, section 3.2)."""

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from components.arrays import Float64s, Int64s
from tools.video.retarget.fin import Fin
from tools.video.retarget.landmarks import FinMark, Landmarks

_NEAR: Final = 2.5
"""[px] outside a fin's outline at which a vertex still belongs to it."""


def axes_of(marks: Landmarks) -> Float64s:
    """Return the local axes in the picture, rows right and ahead, unit vectors with y down, (2, 2)."""
    ahead = marks.controls[4] - marks.controls[-1]
    ahead = ahead / np.sqrt(ahead @ ahead)
    return np.array([[-ahead[1], ahead[0]], ahead])


def to_local(points: Float64s, marks: Landmarks, scale: float = 1.0) -> Float64s:
    """Return places of the picture [px], (n, 2), in the local frame, a pixel being `scale` units."""
    return np.asarray((points - marks.controls[0]) @ axes_of(marks).T * scale)


def bound_fin(
    mark: FinMark, marks: Landmarks, scale: float, vertices: Float64s, triangles: Int64s
) -> Fin | None:
    """Return the fin with the mesh's vertices that lie in it, None where there are none; all is local."""
    edge = to_local(mark.outline, marks, scale)
    unit = np.ptp(edge, axis=0).max() / 1000.0
    polygon = (edge / unit).astype(np.float32)
    near = np.flatnonzero(
        _within(vertices[:, :2], edge.min(axis=0) - _NEAR * scale, edge.max(axis=0) + _NEAR * scale)
    )
    depth = [
        cv2.pointPolygonTest(polygon, (float(x), float(y)), True)
        for x, y in vertices[near, :2] / unit
    ]
    # A mesh has its own border within a pixel or two of the outline that it was drawn into.
    inside = near[np.array(depth) > -_NEAR * scale / unit]
    if not len(inside):
        return None
    tip, top, bottom = to_local(np.stack((mark.tip, mark.top, mark.bottom)), marks, scale)
    distance = _from_root(vertices, triangles, inside, (top, bottom))
    return Fin(tip, top, bottom, inside, distance)


def _within(points: Float64s, low: Float64s, high: Float64s) -> NDArray[np.bool_]:
    return np.asarray(((points >= low) & (points <= high)).all(axis=1))


def _from_root(
    vertices: Float64s, triangles: Int64s, inside: Int64s, root: tuple[Float64s, Float64s]
) -> Float64s:
    """Return how far the fin's vertices are from its root along the surface, (n,).

    Paths start at the vertices that border the body, at their distance from the root. What no path reaches, as in a fin
    that is a part of its own, is taken as the crow flies.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import dijkstra

    straight = _to_segment(vertices[inside, :2], *root)
    place = np.full(len(vertices), -1)
    place[inside] = np.arange(len(inside))
    edges = np.concatenate((triangles[:, :2], triangles[:, 1:], triangles[:, ::2]))
    one, other = place[edges[:, 0]], place[edges[:, 1]]
    starts = np.unique(
        np.concatenate((one[(one >= 0) & (other < 0)], other[(other >= 0) & (one < 0)]))
    )
    both = (one >= 0) & (other >= 0)
    length = np.sqrt(((vertices[edges[both, 0]] - vertices[edges[both, 1]]) ** 2).sum(axis=1))
    # One more node stands for the root itself.
    n = len(inside)
    first = np.concatenate((one[both], np.full(len(starts), n)))
    second = np.concatenate((other[both], starts))
    cost = np.concatenate((length, straight[starts])) + 1e-12
    lower, upper = np.minimum(first, second), np.maximum(first, second)
    _, kept = np.unique(lower * (n + 1) + upper, return_index=True)
    graph = coo_array((cost[kept], (lower[kept], upper[kept])), shape=(n + 1, n + 1)).tocsr()
    far = dijkstra(graph, directed=False, indices=n)[:n]
    return np.where(np.isfinite(far), far, straight)


def _to_segment(points: Float64s, a: Float64s, b: Float64s) -> Float64s:
    along = b - a
    share = np.clip((points - a) @ along / max(float(along @ along), 1e-300), 0.0, 1.0)
    return np.asarray(np.sqrt(((points - a - share[:, None] * along) ** 2).sum(axis=1)))
