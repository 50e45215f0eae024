"""Films of replays: H.264 through PyAV, the [film] extra (DESIGN 10).

The encoder works in a thread of its own behind a short queue, so that memory stays bounded whatever the film's length.
The file is written under another name and renamed when it is whole.
"""

import os
from pathlib import Path
from queue import Queue
from threading import Thread
from typing import Final

import numpy as np
from numpy.typing import NDArray

FRAMES_PER_SECOND: Final = 30
_QUEUE: Final = 8


class NoFilmError(RuntimeError):
    """The film cannot be written; the message is one line that says why."""


class Film:
    """Takes pictures (height, width, 3) of uint8, top row first, and writes them to an mp4."""

    def __init__(self, path: Path, width: int, height: int) -> None:
        if width % 2 or height % 2:
            raise NoFilmError(f"a film's width and height must be even, not {width}x{height}")
        try:
            import av
        except ImportError:
            raise NoFilmError("films need PyAV: pip install 'reefgame[film]'") from None
        self.path = path
        self._fresh = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            self._container = av.open(str(self._fresh), "w", format="mp4")
        except OSError as error:
            raise NoFilmError(f"{path}: cannot be written: {error.strerror}") from None
        self._stream = self._container.add_stream("libx264", rate=FRAMES_PER_SECOND)
        self._stream.width, self._stream.height = width, height
        self._stream.pix_fmt = "yuv420p"
        self._stream.options = {"crf": "20", "preset": "veryfast"}
        self._frame = av.VideoFrame.from_ndarray
        self._queue: Queue[NDArray[np.uint8] | None] = Queue(_QUEUE)
        self._failure: Exception | None = None
        self._thread = Thread(target=self._encode, daemon=True)
        self._thread.start()

    def add(self, picture: NDArray[np.uint8]) -> None:
        """Append a picture of (height, width, 3) uint8. Raise NoFilmError where the disk is full."""
        if self._failure is not None:
            raise NoFilmError(f"{self.path}: {self._failure}")
        self._queue.put(np.ascontiguousarray(picture))

    def close(self) -> None:
        """Finish the film and give it its name. Raise NoFilmError where it could not be written."""
        self._queue.put(None)
        self._thread.join()
        if self._failure is None:
            self._container.close()
            self._fresh.replace(self.path)
        self.discard()
        if self._failure is not None:
            raise NoFilmError(f"{self.path}: {self._failure}")

    def discard(self) -> None:
        """Remove what was written of an unfinished film."""
        self._fresh.unlink(missing_ok=True)

    def _encode(self) -> None:
        while (picture := self._queue.get()) is not None:
            if self._failure is None:
                try:
                    self._container.mux(self._stream.encode(self._frame(picture, format="rgb24")))
                except OSError as error:
                    self._failure = error
        if self._failure is None:
            try:
                self._container.mux(self._stream.encode())
            except OSError as error:
                self._failure = error
