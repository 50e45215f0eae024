"""Arrays that take long to make and never change are kept in the user's cache folder (DESIGN 9).

A file is named by the hash of what the arrays are made from and of the sources that make them, and opens with its
own checksum. One that is absent, damaged or cannot be written costs time, never correctness.
"""

import contextlib
import hashlib
import io
import uuid
from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Final

import numpy as np
from platformdirs import user_cache_path

from components.arrays import AnyArray
from components.kernels import sources_hash

MOST: Final = 48
"""Files kept; the ones unused for longest go first."""
_CHECKSUM_BYTES: Final = 16


def named(source: str, *content: object) -> str:
    """Return a name for what the module file `source` makes of `content`: arrays, tuples, dataclasses, plain values."""
    digest = hashlib.blake2b(sources_hash(Path(source)).encode(), digest_size=16)
    digest.update(np.__version__.encode())
    _add(digest, content)
    return f"{Path(source).stem}.{digest.hexdigest()}"


def _add(digest: "hashlib.blake2b", thing: object) -> None:
    if isinstance(thing, np.ndarray):
        digest.update(f"{thing.dtype}{thing.shape}".encode())
        digest.update(np.ascontiguousarray(thing).tobytes())
    elif isinstance(thing, tuple | list):
        digest.update(f"({len(thing)}".encode())
        for part in thing:
            _add(digest, part)
    elif is_dataclass(thing):
        _add(digest, (type(thing).__name__, *(getattr(thing, f.name) for f in fields(thing))))
    else:
        digest.update(f"{type(thing).__name__} {thing!r};".encode())


def kept(name: str, make: Callable[[], Sequence[AnyArray]]) -> list[AnyArray]:
    """Return the arrays kept under `name`, or those that `make` makes, kept for the next time."""
    path = user_cache_path("reefgame") / "view" / name
    found = _read(path)
    if found is not None:
        return found
    arrays = list(make())
    _write(path, arrays)
    return arrays


def _read(path: Path) -> list[AnyArray] | None:
    try:
        content = path.read_bytes()
    except OSError:
        return None
    payload = memoryview(content)[_CHECKSUM_BYTES:]
    if content[:_CHECKSUM_BYTES] != _checksum(payload):
        return None
    with contextlib.suppress(OSError):
        path.touch()
    stream = io.BytesIO(payload)
    count = int(np.load(stream, allow_pickle=False))
    return [np.load(stream, allow_pickle=False) for _ in range(count)]


def _write(path: Path, arrays: list[AnyArray]) -> None:
    stream = io.BytesIO()
    for values in (np.array(len(arrays)), *arrays):
        np.save(stream, values, allow_pickle=False)
    payload = stream.getbuffer()
    fresh = path.with_name(f"{path.name}.{uuid.uuid4().hex[:12]}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        fresh.write_bytes(_checksum(payload) + payload)
        fresh.replace(path)
        _forget_oldest(path.parent)
    except OSError:
        with contextlib.suppress(OSError):
            fresh.unlink()


def _forget_oldest(folder: Path) -> None:
    by_age = sorted(folder.iterdir(), key=lambda path: path.stat().st_mtime)
    for path in by_age[:-MOST]:
        path.unlink(missing_ok=True)


def _checksum(payload: memoryview) -> bytes:
    return hashlib.blake2b(payload, digest_size=_CHECKSUM_BYTES).digest()
