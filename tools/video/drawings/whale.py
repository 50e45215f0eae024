"""The whale: a closed mesh with flippers and flukes, swept from sections, as a .glb (papers/003, fig. 7).

Its axes are glTF's: y up, the head towards +z. Grooves and spots are painted into a small picture inside the file.
"""

import json
import struct
from typing import Final

import cv2
import numpy as np

from components.arrays import Float64s, Int64s
from tools.video.retarget.target import Texture

_PROFILE: Final = (
    # along from the head [BL], half width, half height, middle's height
    (0.000, 0.012, 0.010, 0.000),
    (0.015, 0.050, 0.034, 0.000),
    (0.050, 0.086, 0.066, 0.002),
    (0.120, 0.112, 0.098, 0.004),
    (0.220, 0.124, 0.116, 0.004),
    (0.320, 0.122, 0.116, 0.004),
    (0.450, 0.104, 0.100, 0.006),
    (0.600, 0.074, 0.076, 0.010),
    (0.740, 0.044, 0.050, 0.012),
    (0.860, 0.022, 0.030, 0.012),
    (0.940, 0.012, 0.020, 0.010),
)  # fmt: skip
_FLIPPER: Final = (
    (0.100, 0.250, 0.060),
    (0.170, 0.275, 0.058),
    (0.240, 0.320, 0.046),
    (0.300, 0.372, 0.026),
    (0.330, 0.404, 0.008),
)
"""Right flipper: to the right, along, half its chord [BL]."""
_FLUKE: Final = (
    (0.004, 0.945, 0.040),
    (0.060, 0.950, 0.036),
    (0.130, 0.968, 0.026),
    (0.190, 0.990, 0.010),
    (0.205, 1.000, 0.003),
)
_FIN: Final = ((0.085, 0.600, 0.034), (0.110, 0.622, 0.022), (0.132, 0.650, 0.006))
"""Dorsal fin: up, along, half its chord [BL]."""
_AROUND: Final = 40
_RINGS: Final = 96
_BLADE_AROUND: Final = 12
_BLADE_RINGS: Final = 18


def _tube(rings: Float64s) -> tuple[Float64s, Int64s]:
    """Return a closed surface through rings (r, n, 3), with a point at each end."""
    r, n = rings.shape[:2]
    points = np.concatenate((rings.reshape(-1, 3), rings[:1].mean(axis=1), rings[-1:].mean(axis=1)))
    i, j = np.meshgrid(np.arange(r - 1), np.arange(n), indexing="ij")
    a, b = (i * n + j).ravel(), (i * n + (j + 1) % n).ravel()
    sides = np.concatenate((np.stack((a, b, a + n), 1), np.stack((b, b + n, a + n), 1)))
    k = np.arange(n)
    first = np.stack((np.full(n, r * n), (k + 1) % n, k), 1)
    last = np.stack((np.full(n, r * n + 1), (r - 1) * n + k, (r - 1) * n + (k + 1) % n), 1)
    return points, np.concatenate((sides, first, last)).astype(np.int64)


def _even(table: tuple[tuple[float, ...], ...], count: int) -> Float64s:
    rows = np.array(table)
    at = np.linspace(0.0, len(rows) - 1.0, count)
    return np.stack([_smooth(rows[:, c], at) for c in range(rows.shape[1])], axis=1)


def _smooth(values: Float64s, at: Float64s) -> Float64s:
    """Return a cubic through values at 0, 1, 2 ... (Catmull-Rom)."""
    padded = np.concatenate((2 * values[:1] - values[1:2], values, 2 * values[-1:] - values[-2:-1]))
    k = np.minimum(at.astype(int), len(values) - 2)
    t = at - k
    a, b, c, d = (padded[k + i] for i in range(4))
    return np.asarray(
        0.5
        * (
            2 * b
            + (c - a) * t
            + (2 * a - 5 * b + 4 * c - d) * t**2
            + (3 * b - a - 3 * c + d) * t**3
        )
    )


def _body() -> tuple[Float64s, Int64s]:
    turn = np.linspace(0.0, 2.0 * np.pi, _AROUND, endpoint=False)
    rows = _even(_PROFILE, _RINGS)
    x = rows[:, 1:2] * np.sin(turn)
    y = rows[:, 3:4] + rows[:, 2:3] * np.cos(turn)
    z = np.broadcast_to(-rows[:, :1], x.shape)
    return _tube(np.stack((x, y, z), axis=-1))


def _blade(
    table: tuple[tuple[float, ...], ...], side: float, height: float, droop: float
) -> tuple[Float64s, Int64s]:
    """Return a flat blade whose sections are ellipses; out to `side`, or up where `side` is 0."""
    turn = np.linspace(0.0, 2.0 * np.pi, _BLADE_AROUND, endpoint=False)
    rows = _even(table, _BLADE_RINGS)
    out = np.broadcast_to(rows[:, :1], (len(rows), _BLADE_AROUND))
    along = -(rows[:, 1:2] + np.abs(rows[:, 2:3]) * np.cos(turn))
    thick = 0.16 * np.abs(rows[:, 2:3]) * np.sin(turn)
    if side == 0.0:
        return _tube(np.stack((thick, out, along), axis=-1))
    return _tube(np.stack((side * out, height - droop * out + thick, along), axis=-1))


def whale_mesh() -> tuple[Float64s, Int64s]:
    """Return the whale's vertices [BL] and triangles: six closed parts that run into each other."""
    parts = [_body(), _blade(_FIN, 0.0, 0.0, 0.0)]
    for side in (1.0, -1.0):
        parts += [_blade(_FLIPPER, side, -0.02, 0.18), _blade(_FLUKE, side, 0.010, 0.0)]
    first = np.cumsum([0, *(len(points) for points, _ in parts)])
    return (
        np.concatenate([points for points, _ in parts]),
        np.concatenate(
            [triangles + n for (_, triangles), n in zip(parts, first[:-1], strict=True)]
        ),
    )


def whale_skin() -> Texture:
    """Return the picture that is wrapped round it: the back in the middle, the throat's grooves at the edges."""
    width, height = 256, 256
    side = np.abs(np.linspace(-1.0, 1.0, width))[None, :]
    along = np.linspace(0.0, 1.0, height)[:, None]
    belly = np.clip((side - 0.58) / 0.2, 0.0, 1.0)[..., None]
    across = np.array((62.0, 92.0, 122.0)) * (1.0 - belly) + np.array((214.0, 222.0, 226.0)) * belly
    colour = np.repeat(across, height, axis=0)
    groove = (np.sin(side * 110.0) > 0.3) & (side > 0.66) & (along < 0.45)
    colour[groove] *= 0.8
    chance = np.random.default_rng(5)
    for x, y, size in zip(
        chance.integers(0, width, 90),
        chance.integers(0, height, 90),
        chance.uniform(0.8, 2.4, 90),
        strict=True,
    ):
        cv2.circle(colour, (int(x), int(y)), max(1, int(size)), (126, 152, 176), -1, cv2.LINE_AA)
    for x in (72, 184):
        cv2.circle(colour, (x, 26), 3, (250, 250, 250), -1, cv2.LINE_AA)
        cv2.circle(colour, (x, 26), 2, (16, 16, 22), -1, cv2.LINE_AA)
    return np.concatenate((colour, np.full((height, width, 1), 255.0)), axis=2).astype(np.uint8)


def whale() -> bytes:
    """Return the whale as a .glb file."""
    points, triangles = whale_mesh()
    flat = np.stack((points[:, 0], points[:, 1]), axis=1)
    u = 0.5 + np.arctan2(flat[:, 0], flat[:, 1] + 1e-9) / (2.0 * np.pi)
    uv = np.stack((u, -points[:, 2].clip(-1.0, 0.0)), axis=1)
    _, picture = cv2.imencode(
        ".png",
        cv2.cvtColor(whale_skin()[..., :3], cv2.COLOR_RGB2BGR),
        [cv2.IMWRITE_PNG_COMPRESSION, 9],
    )
    blocks = [
        points.astype("<f4").tobytes(),
        uv.astype("<f4").tobytes(),
        triangles.astype("<u2").tobytes(),
        picture.tobytes(),
    ]
    return _glb(blocks, len(points), triangles.size, points)


def _glb(blocks: list[bytes], vertices: int, corners: int, points: Float64s) -> bytes:
    views, binary = [], b""
    for block in blocks:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(block)})
        binary += block + b"\0" * (-len(block) % 4)
    low, high = points.astype("<f4").min(axis=0), points.astype("<f4").max(axis=0)
    text = {
        "asset": {"version": "2.0", "generator": "reefgame"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "whale"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0.0}}],
        "textures": [{"source": 0}],
        "images": [{"bufferView": 3, "mimeType": "image/png"}],
        "accessors": [
            {
                "bufferView": 0, "componentType": 5126, "count": vertices, "type": "VEC3",
                "min": low.tolist(), "max": high.tolist(),
            },
            {"bufferView": 1, "componentType": 5126, "count": vertices, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": corners, "type": "SCALAR"},
        ],
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }  # fmt: skip
    head = json.dumps(text, separators=(",", ":")).encode()
    head += b" " * (-len(head) % 4)
    total = 12 + 8 + len(head) + 8 + len(binary)
    chunks = (
        struct.pack("<II", len(head), 0x4E4F534A)
        + head
        + struct.pack("<II", len(binary), 0x004E4942)
        + binary
    )
    return struct.pack("<4sII", b"glTF", 2, total) + chunks
