"""Reads Wavefront OBJ meshes: places, texture places, faces of any number of corners, plain colours and pictures."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Final

import numpy as np

from tools.video.retarget.atlas import joined, placed, plain
from tools.video.retarget.mesh import Mesh
from tools.video.retarget.picture import read_picture
from tools.video.retarget.target import ModelError, Texture

_GREY: Final = (0.72, 0.74, 0.76, 1.0)
_MOST: Final = 2_000_000
"""Lines of a file, at most."""


@dataclass
class _Read:
    """What has been read of a file so far."""

    places: list[tuple[float, ...]] = field(default_factory=list)
    textures: list[tuple[float, ...]] = field(default_factory=list)
    pictures: dict[str, Texture] = field(default_factory=dict)
    corners: dict[tuple[int, int, str], int] = field(default_factory=dict)
    "index of the vertex that a place, a texture place and a material make"
    triangles: list[tuple[int, int, int]] = field(default_factory=list)
    material: str = ""


def read_obj(path: Path) -> Mesh:
    """Return the mesh of an OBJ file; up is +y. Raise ModelError, `file:line: what is wrong`."""
    read = _Read(pictures={"": plain(_GREY)})
    for number, words in _lines(path):
        try:
            _take(read, words, path)
        except (ValueError, IndexError) as error:
            raise ModelError(f"{path}:{number}: '{' '.join(words)[:60]}': {error}") from None
    if not read.triangles:
        raise ModelError(f"{path}: there are no faces in it")
    return _mesh(read)


def _lines(path: Path) -> Iterator[tuple[int, list[str]]]:
    try:
        text = path.read_text(encoding="utf-8-sig", errors="replace")
    except OSError as error:
        raise ModelError(f"{path}: cannot be read: {error.strerror}") from None
    lines = text.replace("\\\n", " ").splitlines()
    if len(lines) > _MOST:
        raise ModelError(f"{path}: {len(lines)} lines, at most {_MOST} are read")
    for number, line in enumerate(lines, 1):
        words = line.split("#", 1)[0].split()
        if words:
            yield number, words


def _take(read: _Read, words: list[str], path: Path) -> None:
    if words[0] == "v":
        read.places.append(_numbers(words[1:4], 3))
    elif words[0] == "vt":
        read.textures.append(_numbers(words[1:3], 2))
    elif words[0] == "usemtl":
        read.material = words[1] if len(words) > 1 and words[1] in read.pictures else ""
    elif words[0] == "mtllib":
        _take_materials(read, path.parent / " ".join(words[1:]))
    elif words[0] == "f":
        if len(words) < 4:
            raise ValueError("a face has at least three corners")
        corner = [_corner(read, word) for word in words[1:]]
        read.triangles.extend((corner[0], b, c) for b, c in pairwise(corner[1:]))


def _numbers(words: list[str], count: int) -> tuple[float, ...]:
    if len(words) != count:
        raise ValueError(f"{count} numbers are expected")
    return tuple(float(word) for word in words)


def _corner(read: _Read, word: str) -> int:
    """Return the vertex of a face's corner, `place` or `place/texture place` or more."""
    parts = [*word.split("/"), ""]
    place = _index(parts[0], len(read.places))
    texture = _index(parts[1], len(read.textures)) if parts[1] else -1
    return read.corners.setdefault((place, texture, read.material), len(read.corners))


def _index(word: str, count: int) -> int:
    number = int(word)
    index = number - 1 if number > 0 else count + number
    if number == 0 or not 0 <= index < count:
        raise ValueError(f"there is no number {number} of {count}")
    return index


def _take_materials(read: _Read, path: Path) -> None:
    """Add the materials of an MTL file that is there; a mesh without its file is grey."""
    if not path.is_file():
        return
    name = ""
    for number, words in _lines(path):
        if words[0] == "newmtl" and len(words) > 1:
            name = words[1]
            read.pictures[name] = plain(_GREY)
        elif words[0] == "Kd" and name:
            try:
                read.pictures[name] = plain((*_numbers(words[1:4], 3), 1.0))
            except ValueError as error:
                raise ModelError(f"{path}:{number}: {error}") from None
        elif words[0] == "map_Kd" and name:
            read.pictures[name] = read_picture(path.parent / words[-1])


def _mesh(read: _Read) -> Mesh:
    texture, starts = joined(list(read.pictures.values()))
    begins = dict(zip(read.pictures, starts, strict=True))
    vertices = np.array([read.places[place] for place, _, _ in read.corners], np.float64)
    uv = np.empty((len(read.corners), 2))
    for row, (_, at, material) in enumerate(read.corners):
        u, v = read.textures[at] if at >= 0 else (0.5, 0.5)
        uv[row] = placed(np.array([[u, 1.0 - v]]), read.pictures[material], begins[material])[0]
    return Mesh(
        vertices, np.array(read.triangles, np.int64), uv, texture, np.array([0.0, 1.0, 0.0])
    )
