"""Framebuffers of our own and PNG files."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pyglet import gl

from systems.view.context import PACKAGES
from systems.view.target import (
    MOST_PIXELS,
    Target,
    TargetError,
    decode_png,
    encode_png,
    largest_size,
    write_png,
)


@pytest.mark.parametrize("samples", [0, 4])
def test_the_first_row_read_is_the_top_of_the_picture(samples: int) -> None:
    with Target(40, 20, samples) as target:
        gl.glClearColor(0.0, 0.0, 1.0, 1.0)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glEnable(gl.GL_SCISSOR_TEST)
        gl.glScissor(0, 15, 10, 5)
        gl.glClearColor(1.0, 0.0, 0.0, 1.0)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glDisable(gl.GL_SCISSOR_TEST)
        picture = target.read()
    assert picture.shape == (20, 40, 3)
    assert (picture[:5, :10] == (255, 0, 0)).all()
    assert (picture[5:] == (0, 0, 255)).all()
    assert (picture[:, 10:] == (0, 0, 255)).all()


@pytest.mark.parametrize("size", [(0, 0), (0, 10), (10, -1), (1_000_000, 10)])
def test_a_size_that_cannot_be_drawn_is_refused_in_one_line(size: tuple[int, int]) -> None:
    with pytest.raises(TargetError) as caught:
        Target(*size)
    widest, highest = largest_size()
    assert str(caught.value) == (
        f"size {size[0]}x{size[1]}: from 1x1 to {widest}x{highest} can be drawn here"
    )


def test_a_picture_that_would_fill_the_memory_is_refused() -> None:
    side = min(largest_size())
    if side * side <= MOST_PIXELS:
        side = MOST_PIXELS
    with pytest.raises(TargetError, match=f"size {side}x{side}: "):
        Target(side, side)


def test_a_deleted_target_gives_its_framebuffer_back() -> None:
    names = []
    for _ in range(3):
        with Target(8, 8, 4) as target:
            target.read()
            names.append(gl.glIsFramebuffer(target._drawn))
            frame = target._drawn
        names.append(gl.glIsFramebuffer(frame))
    assert names == [1, 0] * 3
    assert gl.glGetError() == gl.GL_NO_ERROR


def test_a_picture_comes_back_from_its_png(tmp_path: Path) -> None:
    picture = np.random.default_rng(1).integers(0, 256, (7, 5, 3), np.uint8)
    write_png(tmp_path / "picture.png", picture)
    assert (decode_png((tmp_path / "picture.png").read_bytes()) == picture).all()


def test_other_programs_read_our_png(tmp_path: Path) -> None:
    from pyglet.image.codecs.png import PNGImageDecoder

    decoder: Any = PNGImageDecoder()
    picture = np.random.default_rng(2).integers(0, 256, (6, 9, 3), np.uint8)
    write_png(tmp_path / "picture.png", picture)
    with (tmp_path / "picture.png").open("rb") as file:
        image = decoder.decode("picture.png", file)
    rows = np.frombuffer(image.get_data("RGB", -27), np.uint8).reshape(6, 9, 3)
    assert (rows == picture).all()


@pytest.mark.parametrize("data", [b"", b"GIF89a", encode_png(np.zeros((2, 2, 3), np.uint8))[:40]])
def test_bytes_that_are_no_png_are_refused(data: bytes) -> None:
    with pytest.raises(TargetError, match="not a PNG"):
        decode_png(data)


def test_a_picture_that_cannot_be_written_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "picture.png").mkdir()
    (tmp_path / "picture.png" / "in_the_way").touch()
    with pytest.raises(OSError, match=r"picture\.png"):
        write_png(tmp_path / "picture.png", np.zeros((2, 2, 3), np.uint8))
    assert [path.name for path in tmp_path.iterdir()] == ["picture.png"]


def test_no_opengl_is_said_in_one_line_with_the_packages_to_install() -> None:
    program = (
        "from systems.view.context import ensure_context, NoOpenGLError\n"
        "try:\n    ensure_context()\nexcept NoOpenGLError as error:\n    print(error)"
    )
    nowhere = {**os.environ, "__EGL_VENDOR_LIBRARY_DIRS": os.devnull, "PYTHONWARNINGS": "ignore"}
    done = subprocess.run(
        [sys.executable, "-c", program], env=nowhere, capture_output=True, text=True, check=False
    )
    assert done.stdout.startswith("no OpenGL 3.3: ")
    assert done.stdout.endswith(f"; on Debian: apt-get install {PACKAGES}\n")
    assert (done.stdout.count("\n"), done.stderr, done.returncode) == (1, "", 0)
