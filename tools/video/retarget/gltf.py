"""Reads glTF 2.0 meshes, .glb or .gltf: nodes, triangles, base colours and their pictures. No skins, no compression."""

import base64
import binascii
import json
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np

from components.arrays import AnyArray, Float64s, Int64s
from tools.video.retarget.atlas import joined, placed, plain, tinted
from tools.video.retarget.mesh import Mesh
from tools.video.retarget.picture import decoded
from tools.video.retarget.target import ModelError, Texture

_MAGIC: Final = b"glTF"
_JSON, _BINARY = 0x4E4F534A, 0x004E4942
_TYPES: Final = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
_TRIANGLES: Final = 4
_DEEPEST: Final = 64


@dataclass(frozen=True)
class _Part:
    """One primitive in the scene."""

    vertices: Float64s
    triangles: Int64s
    uv: Float64s
    picture: Texture


def read_gltf(path: Path) -> Mesh:
    """Return all meshes of a glTF file's scene as one; up is +y. Raise ModelError, one line."""
    try:
        content = path.read_bytes()
    except OSError as error:
        raise ModelError(f"{path}: cannot be read: {error.strerror}") from None
    try:
        parts = _File(path, content).parts()
    except ModelError as error:
        raise ModelError(f"{path}: {error}") from None
    except (
        AttributeError,
        IndexError,
        KeyError,
        RecursionError,
        TypeError,
        ValueError,
        struct.error,
    ) as error:
        raise ModelError(
            f"{path}: this is no sound glTF 2.0 file: {type(error).__name__}: {error}"
        ) from None
    if not parts:
        raise ModelError(f"{path}: there is no mesh of triangles in it")
    return _joined(parts)


class _File:
    """A glTF file's JSON and its binary parts."""

    def __init__(self, path: Path, content: bytes) -> None:
        self._folder = path.parent
        self._binary = b""
        text = content
        if content[:4] == _MAGIC:
            text = self._chunks(content)
        try:
            self._json: dict[str, Any] = json.loads(text)
        except (json.JSONDecodeError, UnicodeDecodeError):
            raise ModelError("this is no glTF file") from None
        if not isinstance(self._json, dict):
            raise ModelError("this is no glTF file")
        needed = self._json.get("extensionsRequired", [])
        if needed:
            raise ModelError(
                f"it needs {', '.join(map(str, needed))}, which is not read: export it without"
            )
        self._buffers = [self._buffer(entry) for entry in self._json.get("buffers", [])]

    def _chunks(self, content: bytes) -> bytes:
        text, at = b"", 12
        while at + 8 <= len(content):
            size, kind = struct.unpack_from("<II", content, at)
            part = content[at + 8 : at + 8 + size]
            text = part if kind == _JSON else text
            self._binary = part if kind == _BINARY else self._binary
            at += 8 + size
        return text

    def _buffer(self, entry: dict[str, Any]) -> bytes:
        return self._resource(entry["uri"]) if "uri" in entry else self._binary

    def _resource(self, uri: str) -> bytes:
        """Return what a data address or a file beside this one holds."""
        if uri.startswith("data:"):
            try:
                return base64.b64decode(uri.partition(",")[2], validate=True)
            except binascii.Error:
                raise ModelError("a data address in it is broken") from None
        found = (self._folder / uri).resolve()
        if not found.is_relative_to(self._folder.resolve()):
            raise ModelError(f"'{uri}' lies outside the mesh's folder")
        try:
            return found.read_bytes()
        except OSError as error:
            raise ModelError(f"{uri}: cannot be read: {error.strerror}") from None

    def _view(self, number: int) -> bytes:
        view = self._json["bufferViews"][number]
        start = view.get("byteOffset", 0)
        return bytes(self._buffers[view["buffer"]][start : start + view["byteLength"]])

    def _accessor(self, number: int) -> AnyArray:
        """Return an accessor's values, (count, width); whole numbers of texture places are brought to 0..1."""
        accessor = self._json["accessors"][number]
        if "sparse" in accessor or "bufferView" not in accessor:
            raise ModelError("it has sparse accessors, which are not read: export it without")
        kind = np.dtype(_TYPES[accessor["componentType"]])
        width, count = _WIDTHS[accessor["type"]], int(accessor["count"])
        content = self._view(accessor["bufferView"])[accessor.get("byteOffset", 0) :]
        row = width * kind.itemsize
        stride = self._json["bufferViews"][accessor["bufferView"]].get("byteStride", row)
        if count < 0 or stride < row or (count and len(content) < stride * (count - 1) + row):
            raise ModelError("an accessor reads beyond its buffer")
        values = np.ndarray((count, width), kind, content, 0, (stride, kind.itemsize))
        if accessor.get("normalized"):
            return np.asarray(values / float(np.iinfo(kind).max))
        return values

    def parts(self) -> list[_Part]:
        """Return the scene's primitives in world axes."""
        scenes = self._json.get("scenes")
        nodes = self._json.get("nodes", [])
        roots = scenes[self._json.get("scene", 0)].get("nodes", []) if scenes else range(len(nodes))
        found: list[_Part] = []
        for root in roots:
            self._walk(root, np.eye(4), found, 0)
        return found

    def _walk(self, number: int, above: Float64s, found: list[_Part], depth: int) -> None:
        if depth > _DEEPEST:
            raise ModelError(f"its nodes are nested deeper than {_DEEPEST}")
        node = self._json["nodes"][number]
        place = above @ _transform(node)
        if "mesh" in node:
            primitives = self._json["meshes"][node["mesh"]]["primitives"]
            solid = (p for p in primitives if p.get("mode", _TRIANGLES) == _TRIANGLES)
            found.extend(self._part(primitive, place) for primitive in solid)
        for child in node.get("children", []):
            self._walk(child, place, found, depth + 1)

    def _part(self, primitive: dict[str, Any], place: Float64s) -> _Part:
        attributes = primitive["attributes"]
        local = self._accessor(attributes["POSITION"]).astype(np.float64)
        vertices = local @ place[:3, :3].T + place[:3, 3]
        if "indices" in primitive:
            corners = self._accessor(primitive["indices"]).astype(np.int64).reshape(-1)
        else:
            corners = np.arange(len(local))
        triangles = corners[: len(corners) // 3 * 3].reshape(-1, 3)
        if len(triangles) and (triangles.max() >= len(local) or triangles.min() < 0):
            raise ModelError("a triangle names a vertex that is not there")
        picture = self._picture(primitive.get("material"))
        if "TEXCOORD_0" in attributes:
            uv = self._accessor(attributes["TEXCOORD_0"]).astype(np.float64)
        else:
            uv = np.full((len(local), 2), 0.5)
        return _Part(vertices, triangles, uv, picture)

    def _picture(self, material: int | None) -> Texture:
        look = (
            {}
            if material is None
            else self._json["materials"][material].get("pbrMetallicRoughness", {})
        )
        factor = look.get(
            "baseColorFactor", (1.0, 1.0, 1.0, 1.0) if look else (0.72, 0.74, 0.76, 1.0)
        )
        if "baseColorTexture" not in look:
            return plain(factor)
        source = self._json["textures"][look["baseColorTexture"]["index"]]["source"]
        image = self._json["images"][source]
        content = (
            self._view(image["bufferView"])
            if "bufferView" in image
            else self._resource(image["uri"])
        )
        return tinted(decoded(np.frombuffer(content, np.uint8), f"picture {source}"), factor)


def _transform(node: dict[str, Any]) -> Float64s:
    """Return a node's matrix, (4, 4)."""
    if "matrix" in node:
        return np.array(node["matrix"], np.float64).reshape(4, 4).T
    x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    matrix = np.eye(4)
    matrix[:3, :3] = turn * np.array(node.get("scale", (1.0, 1.0, 1.0)))
    matrix[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
    return matrix


def _joined(parts: list[_Part]) -> Mesh:
    texture, starts = joined([part.picture for part in parts])
    first = np.cumsum([0, *(len(part.vertices) for part in parts)])
    return Mesh(
        np.concatenate([part.vertices for part in parts]),
        np.concatenate([part.triangles + n for part, n in zip(parts, first[:-1], strict=True)]),
        np.concatenate([placed(p.uv, p.picture, s) for p, s in zip(parts, starts, strict=True)]),
        texture,
        np.array([0.0, 1.0, 0.0]),
    )
