"""Films of replays: H.264 through PyAV, the [film] extra (DESIGN 10).

The encoder works in a thread of its own behind a short queue, so that memory stays bounded whatever the film's length.
The file is written under another name and renamed when it is whole.
"""

import os
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from queue import Queue
from threading import Thread
from typing import Final

import numpy as np
from numpy.typing import NDArray

from components.fault import FaultError

FRAMES_PER_SECOND: Final = 30
_QUEUE: Final = 8


class NoFilmError(FaultError):
    """The film cannot be written; the message is one line that says why."""


class Film:
    """Takes pictures (height, width, 3) of uint8, top row first, and writes them to an mp4."""

    def __init__(self, path: Path, width: int, height: int) -> None:
        """Begin the film. Raise NoFilmError where size, PyAV or the place are not fit."""
        check_film(width, height)
        import av

        self.path = path
        self._fresh = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
        try:
            # libav opens the file with the first frame, too late to say that there is no place.
            self._fresh.touch()
            self._container = av.open(str(self._fresh), "w", format="mp4")
        except OSError as error:
            raise NoFilmError(f"{path}: cannot be written: {error.strerror}") from None
        self._stream = self._container.add_stream("libx264", rate=FRAMES_PER_SECOND)
        self._stream.width, self._stream.height = width, height
        self._stream.pix_fmt = "yuv420p"
        self._stream.options = {"crf": "20", "preset": "veryfast"}
        self._frame = av.VideoFrame.from_ndarray
        self._refusals = (av.FFmpegError, OSError)
        self._queue: Queue[NDArray[np.uint8] | None] = Queue(_QUEUE)
        self._failure: str | None = None
        self._thread = Thread(target=self._encode, daemon=True)
        self._thread.start()

    def add(self, picture: NDArray[np.uint8]) -> None:
        """Append a picture of (height, width, 3) uint8. Raise NoFilmError where the disk is full."""
        self._check()
        self._queue.put(np.ascontiguousarray(picture))

    def close(self) -> None:
        """Finish the film and give it its name. Raise NoFilmError where it could not be written."""
        self._queue.put(None)
        self._thread.join()
        try:
            self._check()
            self._container.close()
            self._fresh.replace(self.path)
        except self._refusals as error:
            raise NoFilmError(_refusal(self.path, error)) from None
        finally:
            self._remove()

    def discard(self) -> None:
        """Give up an unfinished film: nothing of it stays."""
        self._failure = self._failure or "given up"
        self._queue.put(None)
        self._thread.join()
        self._remove()

    def _remove(self) -> None:
        """Close and remove the file under its first name, where it still has that."""
        with suppress(*self._refusals):
            self._container.close()
        with suppress(OSError):
            self._fresh.unlink()

    def _check(self) -> None:
        if self._failure is not None:
            raise NoFilmError(self._failure)

    def _encode(self) -> None:
        """Encode what comes through the queue, to the None at its end; after a failure, only empty it."""
        ended = False
        while not ended:
            picture = self._queue.get()
            ended = picture is None
            if self._failure is None:
                self._write(picture)

    def _write(self, picture: NDArray[np.uint8] | None) -> None:
        try:
            frame = None if picture is None else self._frame(picture, format="rgb24")
            self._container.mux(self._stream.encode(frame))
        except self._refusals as error:
            self._failure = _refusal(self.path, error)


def check_film(width: int, height: int) -> None:
    """Raise NoFilmError where there can be no film of this size [px], or none at all."""
    if width % 2 or height % 2:
        raise NoFilmError(f"a film's width and height must be even, not {width}x{height}")
    try:
        import_module("av")
    except ImportError:
        raise NoFilmError("films need PyAV: pip install 'reefgame[film]'") from None


def _refusal(path: Path, error: Exception) -> str:
    return f"{path}: cannot be written: {getattr(error, 'strerror', None) or error}"
