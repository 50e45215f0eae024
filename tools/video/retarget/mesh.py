"""A target from a mesh: principal axes, silhouette from above, landmarks (papers/003, sections 3.2 and 5)."""

from dataclasses import dataclass
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s, Int64s
from tools.video.images import Grey
from tools.video.retarget.binding import bound_fin, to_local
from tools.video.retarget.landmarks import landmarks
from tools.video.retarget.target import ModelError, Target, Texture
from tools.video.retarget.triangulation import open_edges

_PIXELS: Final = 900.0
"""[px] of the longer side of the silhouette."""
_RIM: Final = 8
_SAME: Final = 1e-6
"""Of the mesh's extent: vertices nearer than this are one."""
_ALONG: Final = 0.9
"""Cosine from which the file's upward axis lies along the body and cannot be its back."""


@dataclass(frozen=True)
class Mesh:
    """What a file or a species gives."""

    vertices: Float64s
    "right-handed axes of its own, (V, 3)"
    triangles: Int64s
    "(F, 3)"
    uv: Float64s
    "[px] in the texture, (V, 2)"
    texture: Texture
    up: Float64s
    "where its file says that up is, unit vector, (3,)"


def mesh_target(
    mesh: Mesh, name: str, ahead: Float64s | None = None, may_be_open: bool = False
) -> Target:
    """Return the mesh as a target; `ahead` (3,) is where its head points, else the heavier half is the head's.

    Raise ModelError where it is empty, flat or, unless that is allowed, has holes.
    """
    _check(mesh, may_be_open)
    turned = _lying(mesh, ahead)
    extent = float(np.ptp(turned[:, :2], axis=0).max())
    scale = extent / _PIXELS
    corner = np.array([turned[:, 0].min(), turned[:, 1].max()])
    seen = (turned[:, :2] - corner) * (1.0, -1.0) / scale + _RIM
    marks = landmarks(
        _silhouette(seen, mesh.triangles), None if ahead is None else np.array([0.0, -1.0])
    )
    height = turned[:, 2:] - turned[:, 2].mean()
    places = np.concatenate((to_local(seen, marks, scale), height), axis=1)
    fins = tuple(
        None if mark is None else bound_fin(mark, marks, scale, places, mesh.triangles)
        for mark in marks.fins
    )
    return Target(
        name=name,
        vertices=places,
        triangles=mesh.triangles,
        uv=mesh.uv,
        texture=mesh.texture,
        controls=to_local(marks.controls, marks, scale),
        fins=(fins[0], fins[1]),
        solid=True,
    )


def _lying(mesh: Mesh, ahead: Float64s | None) -> Float64s:
    """Return the vertices with x to the right, y along the body and z up, (V, 3)."""
    centred = mesh.vertices - mesh.vertices.mean(axis=0)
    _, vectors = np.linalg.eigh(centred.T @ centred)
    length = vectors[:, 2] if ahead is None else ahead / np.sqrt(ahead @ ahead)
    up = mesh.up if abs(float(mesh.up @ length)) < _ALONG else vectors[:, 0]
    up = up - (up @ length) * length
    up = up / np.sqrt(up @ up)
    return np.asarray(centred @ np.stack((np.cross(length, up), length, up), axis=1))


def _silhouette(places: Float64s, triangles: Int64s) -> Grey:
    """Return the mask of triangles [px], holes filled, the largest part alone."""
    width, height = (np.ceil(places.max(axis=0)) + _RIM).astype(int)
    mask = np.zeros((int(height), int(width)), np.uint8)
    for corners in np.round(places[triangles] * 16.0).astype(np.int32):
        cv2.fillConvexPoly(mask, corners, 255, shift=4)
    mask = np.asarray(cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8)), np.uint8)
    found, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    filled = np.zeros_like(mask)
    cv2.drawContours(filled, [max(found, key=cv2.contourArea)], 0, 255, cv2.FILLED)
    return filled


def _check(mesh: Mesh, may_be_open: bool) -> None:
    if len(mesh.triangles) == 0:
        raise ModelError("the mesh has no triangles")
    extent = np.ptp(mesh.vertices, axis=0)
    if not np.isfinite(mesh.vertices).all():
        raise ModelError("the mesh has places that are no numbers")
    if np.sort(extent)[1] <= _SAME * extent.max():
        raise ModelError("the mesh is a line or a point, not a body")
    if may_be_open:
        return
    edges = open_edges(welded(mesh.vertices, mesh.triangles))
    if len(edges):
        a, b = (", ".join(f"{v:.4g}" for v in mesh.vertices[i]) for i in edges[0])
        raise ModelError(
            f"the mesh has holes: {len(edges)} open edges, one from ({a}) to ({b}); a closed one is expected"
        )


def welded(vertices: Float64s, triangles: Int64s) -> Int64s:
    """Return the triangles with vertices at the same place made one (the first of them); those that collapse go."""
    cell = np.round(
        (vertices - vertices.min(axis=0)) / (_SAME * float(np.ptp(vertices, axis=0).max()))
    ).astype(np.int64)
    _, first, same = np.unique(cell, axis=0, return_index=True, return_inverse=True)
    joined = first[same.reshape(-1)][triangles]
    distinct = (
        (joined[:, 0] != joined[:, 1])
        & (joined[:, 1] != joined[:, 2])
        & (joined[:, 2] != joined[:, 0])
    )
    return np.asarray(joined[distinct], np.int64)
