"""Reads a clip frame by frame, in bounded memory, as brightness at a working size (papers/003, section 7: 960x544).

PyAV decodes: it says what is wrong with a file, gives the plane of brightness as it is, and the frames' own times.
"""

from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import av
import cv2
import numpy as np

from tools.video.images import ClipError, Colour, Grey

WORKING_SIDE: Final = 1280
"""[px] of the longer side, beyond which frames are made smaller."""
REDUCED_SIDE: Final = 960
"""[px] of the longer side of frames made smaller, as the paper does."""
_PLANAR: Final = ("gray", "yuv4", "yuvj4", "nv12", "nv21")
_DEEP: Final = ("10", "12", "14", "16")
_STILL: Final = frozenset(("png", "bmp", "tiff", "webp", "pgm", "ppm", "jpegls", "jpeg2000", "psd"))


@dataclass(frozen=True)
class Frame:
    """One frame as the file gives it."""

    number: int
    "place in the clip, from 0"
    seconds: float
    "when it is shown [s], nan where the file does not say"
    grey: Grey | None
    "brightness at the working size, None where the frame is damaged"
    colour: Colour | None = None
    "the same in colour, where it was asked for"


class Clip:
    """A clip that opened; frames are read anew by every call of `frames`."""

    def __init__(self, path: Path) -> None:
        """Open the clip. Raise ClipError where it is none."""
        self.path = path
        with closing(self._open()) as container:
            stream = container.streams.video[0]
            self.codec = str(stream.codec_context.name)
            rate = stream.average_rate or stream.guessed_rate
            self.rate = float(rate) if rate else 0.0
            "frames a second by the header, 0 where it does not say"
            self.expected = int(stream.frames) or round(_duration(container) * self.rate)
            "frames that the header promises, 0 where it does not say"
        first = self._first()
        shown = _turned(first.to_ndarray(format="gray"), first.rotation)
        self.height, self.width = shown.shape
        "[px] as shown, upright"
        longer = max(self.height, self.width)
        self.scale = REDUCED_SIDE / longer if longer > WORKING_SIDE else 1.0
        "working pixels per pixel shown"
        self.working = (round(self.width * self.scale), round(self.height * self.scale))
        "width and height [px] that frames are given at"

    def frames(self, colour: bool = False) -> Iterator[Frame]:
        """Yield the frames in order; one that does not decode comes without a picture."""
        number = 0
        with closing(self._open()) as container:
            for picture in _decoded(container):
                if picture is None:
                    yield Frame(number, float("nan"), None)
                else:
                    yield self._frame(number, picture, colour)
                number += 1

    def _frame(self, number: int, picture: Any, colour: bool) -> Frame:
        seconds = float("nan") if picture.time is None else float(picture.time)
        shown = self._fitted(picture.to_ndarray(format="rgb24"), picture) if colour else None
        return Frame(number, seconds, self._fitted(_brightness(picture), picture), shown)

    def _fitted(self, image: Grey, picture: Any) -> Grey:
        """Return the picture upright and at the working size."""
        upright = _turned(image, picture.rotation)
        if (upright.shape[1], upright.shape[0]) == self.working:
            return upright
        return np.asarray(cv2.resize(upright, self.working, interpolation=cv2.INTER_AREA), np.uint8)

    def _open(self) -> Any:
        """Return the open container, its decoder ready. Raise ClipError, one line."""
        try:
            container = av.open(str(self.path))
        except FileNotFoundError:
            raise ClipError(f"{self.path}: there is no such file") from None
        except IsADirectoryError:
            raise ClipError(f"{self.path}: this is a folder, not a clip") from None
        except PermissionError:
            raise ClipError(f"{self.path}: cannot be read: permission denied") from None
        except (av.FFmpegError, OSError, ValueError):
            raise ClipError(f"{self.path}: this is no clip, or it is damaged") from None
        if not container.streams.video:
            container.close()
            raise ClipError(f"{self.path}: there are no pictures in this file")
        stream = container.streams.video[0]
        decoder: Any = getattr(stream, "codec_context", None)
        if decoder is None:
            container.close()
            raise ClipError(f"{self.path}: its codec is not known")
        if decoder.name in _STILL:
            container.close()
            raise ClipError(f"{self.path}: this is a still picture; a clip is expected")
        stream.thread_type = "AUTO"
        # Without it decoders hide damage behind what they make up.
        decoder.options = {"err_detect": "crccheck+bitstream+buffer+explode"}
        return container

    def _first(self) -> Any:
        """Return the first whole frame. Raise ClipError where there is none."""
        with closing(self._open()) as container:
            for picture in _decoded(container):
                if picture is not None:
                    return picture
        raise ClipError(f"{self.path}: 0 frames can be read, by codec {self.codec}")


def _duration(container: Any) -> float:
    """Return how long a file says that it is [s], 0 where it does not say."""
    return float(container.duration or 0) / av.time_base


def _decoded(container: Any) -> Iterator[Any]:
    """Yield each decoded picture, None for one that is damaged, or built on one that is."""
    packets = container.demux(container.streams.video[0])
    whole = True
    while True:
        try:
            packet = next(packets, None)
        except av.FFmpegError:
            return
        if packet is None:
            return
        try:
            for picture in packet.decode():
                whole = not picture.is_corrupt and (whole or picture.key_frame)
                yield picture if whole else None
        except av.FFmpegError:
            whole = False
            yield None


def _brightness(picture: Any) -> Grey:
    """Return the plane of brightness, 8 bits deep, without a conversion where the file holds it so."""
    name = picture.format.name
    deep = any(depth in name.removeprefix("yuv4").removeprefix("yuvj4") for depth in _DEEP)
    if not name.startswith(_PLANAR) or deep or name.endswith(("be", "le")):
        return np.asarray(picture.to_ndarray(format="gray"), np.uint8)
    plane = picture.planes[0]
    rows = np.frombuffer(plane, np.uint8).reshape(-1, plane.line_size)
    return np.ascontiguousarray(rows[: picture.height, : picture.width])


def _turned(image: Grey, degrees: int) -> Grey:
    """Return the picture turned anticlockwise, as a telephone held upright asks for."""
    quarter = round(degrees / 90) % 4
    return np.ascontiguousarray(np.rot90(image, quarter)) if quarter else image
