"""A small seabed to draw, a camera over it, and golden frames: pictures compared with a tolerance."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from components.camera import Camera, camera_towards
from components.terrain import Rock, Terrain, build_terrain
from systems.view.context import ensure_context
from systems.view.target import Target, UInt8s, decode_png, start_drawing, write_png

# Before any test module imports pyglet.gl: pyglet decides then whether it wants a display.
ensure_context()

MEAN_TOLERANCE = 1.5
"""Largest mean difference of a golden frame, of 255: drivers round differently."""
FAR_OFF = 32
"""A pixel differs visibly from here on, of 255, in any channel."""
MOST_FAR_OFF = 0.01
"""Largest share of such pixels."""


def differs(picture: UInt8s, golden: UInt8s) -> bool:
    """Return whether two pictures are not the same within the tolerance."""
    if picture.shape != golden.shape:
        return True
    away = np.abs(picture.astype(np.int16) - golden)
    return bool(away.mean() > MEAN_TOLERANCE or (away.max(axis=2) > FAR_OFF).mean() > MOST_FAR_OFF)


@pytest.fixture
def same_frame(checkout: Path, artifacts: Path, bless: bool) -> Callable[[str, UInt8s], bool]:
    """Compare a picture with tests/frames/NAME.png; where they differ, keep both differences."""

    def compare(name: str, picture: UInt8s) -> bool:
        path = checkout / "tests" / "frames" / f"{name}.png"
        if bless:
            write_png(path, picture)
            return True
        golden = decode_png(path.read_bytes())
        if not differs(picture, golden):
            return True
        write_png(artifacts / f"{name}.png", picture)
        if picture.shape == golden.shape:
            away = np.abs(picture.astype(np.int16) - golden)
            write_png(artifacts / f"{name}.difference.png", np.minimum(4 * away, 255).astype("u1"))
        return False

    return compare


@pytest.fixture(scope="session")
def seabed() -> Terrain:
    """A small world: dunes 8 m down, one rock ahead of the origin and to the right."""
    bare = build_terrain(16.0, 8.0, 0.6, 8.0, seed=1)
    low = float(bare.height[len(bare.height) // 2, len(bare.height) // 2])
    return bare.with_rocks([Rock((5.0, -2.0, low + 0.3), (1.0, 0.8, 0.9), 30.0)])


@pytest.fixture(scope="session")
def level_camera() -> Camera:
    """An eye at mid water that looks along x, level."""
    return camera_towards(np.array([0.0, 0.0, -5.5]), np.array([10.0, 0.0, -5.5]))


@pytest.fixture
def target() -> Iterator[Target]:
    """A framebuffer of 160 x 90 pixels, cleared to black."""
    with Target(160, 90) as framebuffer:
        start_drawing(160, 90)
        yield framebuffer
