"""A target from a picture: outline by opacity or Canny's edges, landmarks, mesh (papers/003, sections 3.2 and 5)."""

from pathlib import Path
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s
from tools.video.images import Grey
from tools.video.retarget.binding import bound_fin, to_local
from tools.video.retarget.landmarks import landmarks
from tools.video.retarget.target import ModelError, Target, Texture
from tools.video.retarget.triangulation import triangulated

VERTICES: Final = 2450
"""Of a mesh, about: the paper's carp has 2,445."""
_LARGEST: Final = 1600
"""[px] of the longer side; larger pictures are made smaller."""
_SMALLEST: Final = 32
_CLEAR: Final = 0.01
"""Of the picture: so much must be see-through for its opacity to be the outline."""
_FILLED: Final = (0.01, 0.97)
"""Of the picture: a model covers so much of it."""
_GAP: Final = 2
"""[px] that edges are thickened by, to close small gaps."""
_RIM: Final = 4


def picture_target(path: Path, towards: Float64s | None = None, vertices: int = VERTICES) -> Target:
    """Return the model that a picture file shows; `towards` (2,) is where its head points, x right and y down.

    Raise ModelError, one line, where the file is no picture or shows no outline.
    """
    texture = read_picture(path)
    try:
        return target_of(texture, path.stem, towards, vertices)
    except ModelError as error:
        raise ModelError(f"{path}: {error}") from None


def target_of(
    texture: Texture, name: str, towards: Float64s | None = None, vertices: int = VERTICES
) -> Target:
    """Return the model in a picture (h, w, 4). Raise ModelError."""
    mask = silhouette(texture)
    marks = landmarks(mask, towards)
    area = float(cv2.contourArea(marks.outline.astype(np.float32)))
    points, triangles, _ = triangulated(marks.outline, float(np.sqrt(area / (0.866 * vertices))))
    flat = to_local(points, marks)
    places = np.concatenate((flat, np.zeros((len(flat), 1))), axis=1)
    fins = tuple(
        None if mark is None else bound_fin(mark, marks, 1.0, places, triangles)
        for mark in marks.fins
    )
    return Target(
        name=name,
        vertices=places,
        triangles=triangles,
        uv=points - _RIM,
        texture=texture,
        controls=to_local(marks.controls, marks),
        fins=(fins[0], fins[1]),
    )


def read_picture(path: Path) -> Texture:
    """Return a picture file's red, green, blue and opacity. Raise ModelError."""
    try:
        content = np.frombuffer(path.read_bytes(), np.uint8)
    except OSError as error:
        raise ModelError(f"{path}: cannot be read: {error.strerror}") from None
    return decoded(content, str(path))


def decoded(content: "np.ndarray[tuple[int, ...], np.dtype[np.uint8]]", name: str) -> Texture:
    """Return red, green, blue and opacity of a picture's bytes. Raise ModelError."""
    found = cv2.imdecode(content, cv2.IMREAD_UNCHANGED) if len(content) else None
    if found is None:
        raise ModelError(
            f"{name}: this is no picture that can be read: PNG, JPEG, WebP or TIFF is expected"
        )
    image = np.asarray(found)
    if image.dtype != np.uint8:
        image = (
            np.asarray(image / (257.0 if image.dtype == np.uint16 else 1.0))
            .clip(0, 255)
            .astype(np.uint8)
        )
    if min(image.shape[:2]) < _SMALLEST:
        raise ModelError(
            f"{name}: {image.shape[1]}x{image.shape[0]} is too small: at least {_SMALLEST} pixels a side"
        )
    longest = max(image.shape[:2])
    if longest > _LARGEST:
        image = cv2.resize(
            image, None, fx=_LARGEST / longest, fy=_LARGEST / longest, interpolation=cv2.INTER_AREA
        )
    return _rgba(np.asarray(image, np.uint8))


def _rgba(image: Texture) -> Texture:
    channels = 1 if image.ndim == 2 else image.shape[2]
    codes = {1: cv2.COLOR_GRAY2RGBA, 3: cv2.COLOR_BGR2RGBA, 4: cv2.COLOR_BGRA2RGBA}
    if channels == 2:
        shown = cv2.cvtColor(np.ascontiguousarray(image[..., 0]), cv2.COLOR_GRAY2RGBA)
        shown[..., 3] = image[..., 1]
        return np.asarray(shown, np.uint8)
    return np.asarray(cv2.cvtColor(image, codes[channels]), np.uint8)


def silhouette(texture: Texture) -> Grey:
    """Return the mask of the model, 0 or 255, holes filled, with a rim of noughts. Raise ModelError."""
    opaque = np.asarray(texture[..., 3] > 127)
    if float((~opaque).mean()) >= _CLEAR:
        mask = _largest(_rimmed(opaque.astype(np.uint8) * np.uint8(255)))
    else:
        mask = _inside_edges(texture)
    covered = float(np.count_nonzero(mask)) / mask.size
    if not _FILLED[0] < covered < _FILLED[1]:
        raise ModelError(
            "no closed outline stands out from the ground: a plain ground or a transparent one is expected"
        )
    smooth = cv2.morphologyEx(mask, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    return _largest(np.asarray(smooth, np.uint8))


def _inside_edges(texture: Texture) -> Grey:
    """Return what Canny's edges enclose: the largest closed outline, filled."""
    soft = cv2.GaussianBlur(np.ascontiguousarray(texture[..., :3]), (0, 0), 1.2)
    high = _edge_threshold(np.asarray(soft, np.uint8))
    edges = _rimmed(np.asarray(cv2.Canny(soft, 0.4 * high, high, L2gradient=True), np.uint8))
    thick = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * _GAP + 1, 2 * _GAP + 1))
    closed = _largest(np.asarray(cv2.dilate(edges, thick), np.uint8))
    return np.asarray(cv2.erode(closed, thick), np.uint8)


def _edge_threshold(picture: Texture) -> float:
    """Return the gradient [grey levels a pixel] that parts edges from plain ground: Otsu's on the strong ones."""
    dx = cv2.Sobel(picture, cv2.CV_32F, 1, 0)
    dy = cv2.Sobel(picture, cv2.CV_32F, 0, 1)
    size = np.sqrt(dx**2 + dy**2).max(axis=2)
    strong = np.clip(size[size > 24.0] / 4.0, 0, 255).astype(np.uint8)
    if not len(strong):
        return 1e9
    gate, _ = cv2.threshold(strong.reshape(-1, 1), 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    return max(40.0, 0.6 * 4.0 * float(gate))


def _rimmed(mask: Grey) -> Grey:
    return np.asarray(
        cv2.copyMakeBorder(mask, _RIM, _RIM, _RIM, _RIM, cv2.BORDER_CONSTANT, value=0), np.uint8
    )


def _largest(mask: Grey) -> Grey:
    """Return the largest outer contour of a mask, filled; all noughts where there is none."""
    found, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    filled = np.zeros_like(mask)
    if found:
        cv2.drawContours(filled, [max(found, key=cv2.contourArea)], 0, 255, cv2.FILLED)
    return filled
