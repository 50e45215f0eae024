"""Writes films through PyAV: what the report shows, and clips with known truth for tests and benches."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any, Final

import av
import numpy as np

from tools.video.images import ClipError, Colour, Grey

PLAYABLE: Final = "libx264"
"""What browsers play."""
LOSSLESS: Final = "ffv1"
"""What gives every frame back as it was."""


def write_film(
    path: Path, frames: Iterable[Grey | Colour], rate: float, codec: str = PLAYABLE
) -> int:
    """Write pictures, all grey (height, width) or all colour (height, width, 3), to a film; return how many.

    Sides must be even for PLAYABLE. Raise ClipError where the film cannot be written; nothing of it stays.
    """
    fresh = path.with_name(f".{path.name}")
    count = 0
    try:
        with av.open(str(fresh), "w", format="mp4" if codec == PLAYABLE else "matroska") as film:
            stream: Any = None
            for picture in frames:
                stream = stream or _stream(film, picture, rate, codec)
                held = "gray" if picture.ndim == 2 else "rgb24"
                film.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format=held)))
                count += 1
            if stream is not None:
                film.mux(stream.encode(None))
        fresh.replace(path)
    except (av.FFmpegError, OSError) as error:
        raise ClipError(f"{path}: cannot be written: {error.strerror or error}") from None
    finally:
        fresh.unlink(missing_ok=True)
    return count


def _stream(film: Any, picture: Grey | Colour, rate: float, codec: str) -> Any:
    stream = film.add_stream(codec, rate=round(max(rate, 1.0)))
    stream.height, stream.width = picture.shape[:2]
    if codec == PLAYABLE:
        stream.pix_fmt = "yuv420p"
        stream.options = {"crf": "23", "preset": "veryfast"}
    else:
        stream.pix_fmt = "gray" if picture.ndim == 2 else "bgr0"
    return stream


def even(image: Colour) -> Colour:
    """Return the picture without its last row or column where their number is odd."""
    height, width = image.shape[:2]
    return np.ascontiguousarray(image[: height - height % 2, : width - width % 2])
