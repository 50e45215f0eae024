"""A mesh of even triangles inside a contour: a constrained Delaunay triangulation (papers/003, section 5; FINDINGS 4).

Points stand along the contour at a step h and on a hexagonal grid inside it; Delaunay's triangles whose middle lies
inside remain, and no edge of the contour may be missing. Three passes of Laplacian smoothing even them out.
"""

from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s, Int64s
from tools.video.contour import evenly
from tools.video.retarget.areas import signed_areas
from tools.video.retarget.target import ModelError

_CLEAR: Final = 0.55
"""Steps that inner points keep from the contour."""
_PASSES: Final = 3
_FINER: Final = 5
"""Times that the step is divided where an edge of the contour is missing."""


def triangulated(contour: Float64s, step: float) -> tuple[Float64s, Int64s, int]:
    """Return points [px] (V, 2), triangles (F, 3) and how many of the first points make the contour, in order.

    `contour` (n, 2) is closed and does not cross itself. Raise ModelError where its edges cannot all be kept.
    """
    length = _around(contour)
    for finer in range(_FINER):
        border = evenly(contour, max(8, round(length / step * 1.5**finer)), closed=True)
        inner = _grid_inside(border, step)
        points = np.concatenate((border, inner))
        for _ in range(_PASSES):
            triangles = _inside(points, _delaunay(points), border)
            points = _evened(points, triangles, len(border))
        triangles = _inside(points, _delaunay(points), border)
        if _keeps_border(triangles, len(border)):
            return points, triangles, len(border)
    raise ModelError("the outline has parts too thin to be meshed")


def _around(contour: Float64s) -> float:
    step = np.roll(contour, -1, axis=0) - contour
    return float(np.sqrt((step**2).sum(axis=1)).sum())


def _grid_inside(border: Float64s, step: float) -> Float64s:
    """Return points of a hexagonal grid that lie clear of the border, (n, 2)."""
    low, high = border.min(axis=0), border.max(axis=0)
    rows = np.arange(low[1], high[1], step * np.sqrt(0.75))
    columns = np.arange(low[0], high[0], step)
    x, y = np.meshgrid(columns, rows)
    x[1::2] += 0.5 * step
    places = np.stack((x.ravel(), y.ravel()), axis=-1)
    polygon = border.astype(np.float32)
    depth = [cv2.pointPolygonTest(polygon, (float(px), float(py)), True) for px, py in places]
    return places[np.array(depth) > _CLEAR * step]


def _delaunay(points: Float64s) -> Int64s:
    from scipy.spatial import Delaunay

    corner = Delaunay(points).simplices.astype(np.int64)
    area = signed_areas(points, corner)
    corner[area < 0.0] = corner[area < 0.0][:, ::-1]
    return np.asarray(corner[np.abs(area) > 1e-9])


def _inside(points: Float64s, triangles: Int64s, border: Float64s) -> Int64s:
    """Return the triangles whose middle lies inside the border, (n, 3)."""
    polygon = border.astype(np.float32)
    middle = points[triangles].mean(axis=1)
    kept = [cv2.pointPolygonTest(polygon, (float(x), float(y)), False) > 0 for x, y in middle]
    return triangles[np.array(kept, np.bool_)]


def _evened(points: Float64s, triangles: Int64s, fixed: int) -> Float64s:
    """Return the points with each inner one at the mean of its neighbours; the first `fixed` stay."""
    edges = np.concatenate((triangles[:, :2], triangles[:, 1:], triangles[:, ::2]))
    both = np.concatenate((edges, edges[:, ::-1]))
    total = np.zeros_like(points)
    np.add.at(total, both[:, 0], points[both[:, 1]])
    count = np.bincount(both[:, 0], minlength=len(points)).astype(np.float64)
    mean = total / np.maximum(count, 1.0)[:, None]
    moved = np.where((count > 0.0)[:, None], mean, points)
    moved[:fixed] = points[:fixed]
    return moved


def _keeps_border(triangles: Int64s, count: int) -> bool:
    """Return whether the edges that bound the triangles are those of the contour, each once."""
    return {tuple(edge) for edge in open_edges(triangles).tolist()} == {
        (min(i, (i + 1) % count), max(i, (i + 1) % count)) for i in range(count)
    }


def open_edges(triangles: Int64s) -> Int64s:
    """Return the edges that belong to one triangle alone, the smaller vertex first, (n, 2)."""
    edges = np.sort(np.concatenate((triangles[:, :2], triangles[:, 1:], triangles[:, ::2])), axis=1)
    found, count = np.unique(edges, axis=0, return_counts=True)
    return np.asarray(found[count == 1])
