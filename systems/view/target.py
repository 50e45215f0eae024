"""A framebuffer of our own, reading it back, and PNG files.

A headless window cannot be resized (FINDINGS 8), so pictures are never drawn into one. A PNG is
written whole or not at all: into a temporary file beside it, then renamed.
"""

import struct
import zlib
from ctypes import byref, c_int, c_uint
from pathlib import Path
from types import TracebackType
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from components.fault import FaultError
from components.whole_file import write_whole
from systems.view.context import ensure_context

UInt8s: TypeAlias = NDArray[np.uint8]
PNG_SIGNATURE: Final = b"\x89PNG\r\n\x1a\n"
_FILTER_UP: Final = 2
MOST_PIXELS: Final = 1 << 26
"""Pixels of the largest picture: half a gigabyte of colour and depth."""
MOST_SMOOTHED: Final = 1 << 23
"""Pixels of the largest picture that holds several samples a pixel."""


class TargetError(FaultError):
    """A picture of this size cannot be drawn here, or a file is no PNG of ours."""


def largest_size() -> tuple[int, int]:
    """Return the largest width and height [px] that this OpenGL can draw."""
    ensure_context()
    from pyglet import gl

    side, viewport = c_int(), (c_int * 2)()
    gl.glGetIntegerv(gl.GL_MAX_RENDERBUFFER_SIZE, byref(side))
    gl.glGetIntegerv(gl.GL_MAX_VIEWPORT_DIMS, viewport)
    return min(side.value, viewport[0]), min(side.value, viewport[1])


def _most_samples() -> int:
    from pyglet import gl

    samples = c_int()
    gl.glGetIntegerv(gl.GL_MAX_SAMPLES, byref(samples))
    return samples.value


class Target:
    """An RGBA8 framebuffer with depth, of `samples` samples a pixel (0: none),
    or as many as there can be.

    Raise TargetError for a size that is not from 1x1 to what this OpenGL allows.
    """

    def __init__(self, width: int, height: int, samples: int = 0) -> None:
        most = largest_size()
        if not (1 <= width <= most[0] and 1 <= height <= most[1]):
            raise TargetError(
                f"size {width}x{height}: from 1x1 to {most[0]}x{most[1]} can be drawn here"
            )
        if width * height > MOST_PIXELS:
            raise TargetError(f"size {width}x{height}: at most {MOST_PIXELS} pixels are drawn")
        self.width, self.height = width, height
        self._buffers: list[c_uint] = []
        self._frames: list[c_uint] = []
        samples = min(samples, _most_samples()) if width * height <= MOST_SMOOTHED else 0
        self._drawn = self._frame(samples)
        self._resolved = self._frame(0) if samples else self._drawn

    def bind(self) -> None:
        """Draw into this target from now on, over the whole of it."""
        from pyglet import gl

        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, self._drawn)
        gl.glViewport(0, 0, self.width, self.height)

    def read(self) -> UInt8s:
        """Return the picture as (height, width, 3) uint8, the top row first."""
        from pyglet import gl

        self.resolve()
        rows = np.empty((self.height, self.width, 4), np.uint8)
        gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
        gl.glReadPixels(
            0, 0, self.width, self.height, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, rows.ctypes.data
        )
        return np.ascontiguousarray(rows[::-1, :, :3])

    def resolve(self) -> None:
        """Average the samples, and bind the framebuffer that holds one a pixel for reading."""
        from pyglet import gl

        if self._resolved is not self._drawn:
            size = (0, 0, self.width, self.height)
            gl.glBindFramebuffer(gl.GL_READ_FRAMEBUFFER, self._drawn)
            gl.glBindFramebuffer(gl.GL_DRAW_FRAMEBUFFER, self._resolved)
            gl.glBlitFramebuffer(*size, *size, gl.GL_COLOR_BUFFER_BIT, gl.GL_NEAREST)
            gl.glBindFramebuffer(gl.GL_DRAW_FRAMEBUFFER, self._drawn)
        gl.glBindFramebuffer(gl.GL_READ_FRAMEBUFFER, self._resolved)

    def show(self, framebuffer: int, width: int, height: int) -> None:
        """Copy the picture, stretched, over width x height pixels of another framebuffer."""
        from pyglet import gl

        self.resolve()
        gl.glBindFramebuffer(gl.GL_DRAW_FRAMEBUFFER, framebuffer)
        gl.glBlitFramebuffer(
            *(0, 0, self.width, self.height, 0, 0, width, height),
            gl.GL_COLOR_BUFFER_BIT,
            gl.GL_LINEAR,
        )
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, framebuffer)

    def delete(self) -> None:
        """Free what the target holds; it cannot be used again."""
        from pyglet import gl

        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, 0)
        for frame in self._frames:
            gl.glDeleteFramebuffers(1, byref(frame))
        for buffer in self._buffers:
            gl.glDeleteRenderbuffers(1, byref(buffer))
        self._frames, self._buffers = [], []

    def __enter__(self) -> "Target":
        self.bind()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.delete()

    def _frame(self, samples: int) -> c_uint:
        from pyglet import gl

        frame = c_uint()
        gl.glGenFramebuffers(1, byref(frame))
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, frame)
        self._frames.append(frame)
        self._attach(gl.GL_RGBA8, gl.GL_COLOR_ATTACHMENT0, samples)
        self._attach(gl.GL_DEPTH_COMPONENT24, gl.GL_DEPTH_ATTACHMENT, samples)
        if gl.glCheckFramebufferStatus(gl.GL_FRAMEBUFFER) != gl.GL_FRAMEBUFFER_COMPLETE:
            self.delete()
            raise TargetError(f"size {self.width}x{self.height}: OpenGL has no room to draw it")
        return frame

    def _attach(self, layout: int, point: int, samples: int) -> None:
        from pyglet import gl

        buffer = c_uint()
        gl.glGenRenderbuffers(1, byref(buffer))
        gl.glBindRenderbuffer(gl.GL_RENDERBUFFER, buffer)
        gl.glRenderbufferStorageMultisample(
            gl.GL_RENDERBUFFER, samples, layout, self.width, self.height
        )
        gl.glFramebufferRenderbuffer(gl.GL_FRAMEBUFFER, point, gl.GL_RENDERBUFFER, buffer)
        self._buffers.append(buffer)


def start_drawing(width: int, height: int) -> None:
    """Clear the bound framebuffer, width x height [px], for solid things with depth."""
    from pyglet import gl

    gl.glViewport(0, 0, width, height)
    gl.glDisable(gl.GL_SCISSOR_TEST)
    gl.glDisable(gl.GL_BLEND)
    gl.glDisable(gl.GL_CULL_FACE)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glDepthFunc(gl.GL_LESS)
    gl.glDepthMask(True)
    gl.glClearColor(0.0, 0.0, 0.0, 1.0)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)


def stop_drawing() -> None:
    """Leave OpenGL as pyglet's labels and sprites expect it."""
    from pyglet import gl

    gl.glDisable(gl.GL_DEPTH_TEST)
    gl.glBindVertexArray(0)
    gl.glUseProgram(0)


def encode_png(picture: UInt8s) -> bytes:
    """Return `picture`, (height, width, 3) uint8 with the top row first, as the bytes of a PNG."""
    height, width, _ = picture.shape
    rows = picture.reshape(height, width * 3)
    above = np.concatenate((np.zeros_like(rows[:1]), rows[:-1]))
    filtered = np.full((height, width * 3 + 1), _FILTER_UP, np.uint8)
    filtered[:, 1:] = rows - above
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(filtered.tobytes(), 6)), (b"IEND", b""))
    return PNG_SIGNATURE + b"".join(_chunk(kind, data) for kind, data in chunks)


def decode_png(data: bytes) -> UInt8s:
    """Return the picture, (height, width, 3) uint8, of a PNG that `encode_png` made.

    Raise TargetError for any other bytes.
    """
    if data[:8] != PNG_SIGNATURE or data[12:16] != b"IHDR" or len(data) < 57:
        raise TargetError("not a PNG")
    width, height = struct.unpack(">II", data[16:24])
    (size,) = struct.unpack(">I", data[33:37])
    rows = np.frombuffer(zlib.decompress(data[41 : 41 + size]), np.uint8)
    if rows.size != height * (width * 3 + 1) or data[24:26] != b"\x08\x02":
        raise TargetError("not a PNG of three channels in one piece")
    rows = rows.reshape(height, width * 3 + 1)
    if (rows[:, 0] != _FILTER_UP).any():
        raise TargetError("a PNG with filters other than `up`")
    picture: UInt8s = np.add.accumulate(rows[:, 1:], axis=0, dtype=np.uint8)
    return picture.reshape(height, width, 3)


def write_png(path: Path, picture: UInt8s) -> None:
    """Write `picture` as a PNG, whole or not at all. Raise OSError where it cannot be written."""
    write_whole(path, encode_png(picture))


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
