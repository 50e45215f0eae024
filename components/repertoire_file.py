"""The file of a repertoire: npz without pickle, the same bytes for the same motion (DESIGN 4).

Entries are stored, not deflated, with a fixed date, so that bytes do not depend on a library's version. Arrays, for S
segments of E entries in all:

    version      int32 ()          1
    pattern      int8 (S,)         `Pattern`
    loops        int8 (S,)         1 for a cycle
    length       int32 (S,)        entries of each segment
    rotation     float64 (E, 3, 3) M
    translation  float64 (E, 3)    t [BL]
    shape        float32 (E, 23, 3) d [BL]
    provenance   uint8 (B,)        JSON object of strings, UTF-8
    control      float32 (E, 378, 3) s [BL], only where control points are recorded

A reader trusts nothing: names, types, shapes, sizes and ranges are checked before an array is made.
"""

import io
import json
import math
import zipfile
from pathlib import Path
from typing import Any, Final

import numpy as np

from components.arrays import AnyArray
from components.body import NODES
from components.fault import FaultError
from components.segment import CONTROL_POINTS, REQUIRED, Pattern, Repertoire, Segment
from components.whole_file import write_whole

VERSION: Final = 1
SIZE_LIMIT: Final = 16 << 20
"""[bytes] beyond which no file is read: a hundred times what a species takes."""

_ARRAYS: Final[dict[str, tuple[str, tuple[int, ...]]]] = {
    "version": ("<i4", ()),
    "pattern": ("|i1", (-1,)),
    "loops": ("|i1", (-1,)),
    "length": ("<i4", (-1,)),
    "rotation": ("<f8", (-1, 3, 3)),
    "translation": ("<f8", (-1, 3)),
    "shape": ("<f4", (-1, NODES, 3)),
    "provenance": ("|u1", (-1,)),
}
_OPTIONAL: Final[dict[str, tuple[str, tuple[int, ...]]]] = {
    "control": ("<f4", (-1, CONTROL_POINTS, 3)),
}
_ENTRIES: Final = ("rotation", "translation", "shape", "control")
"""Arrays with a row for each entry."""
_REACH: Final = 3.0
"""[BL] farther than any node of a body lies from its origin."""


class RepertoireError(FaultError):
    """A repertoire file cannot be used: one line that names the file and what is wrong."""


def save(path: Path, repertoire: Repertoire) -> None:
    """Write `repertoire` to `path`, whole or not at all.

    Raise OSError where the folder cannot be written, ValueError where only some segments have control points.
    """
    write_whole(path, _bytes(repertoire))


def load(path: Path) -> Repertoire:
    """Return the repertoire in the file `path`. Raise RepertoireError, one clear line, where there is none."""
    try:
        if path.stat().st_size > SIZE_LIMIT:
            raise RepertoireError(f"{path}: larger than {SIZE_LIMIT >> 20} MiB, no repertoire is")
        content = path.read_bytes()
    except OSError as error:
        raise RepertoireError(f"{path}: cannot be read: {error.strerror or error}") from None
    try:
        return _repertoire(content)
    except _UnfitError as error:
        raise RepertoireError(f"{path}: not a usable repertoire: {error}") from None


class _UnfitError(Exception):
    """What is wrong with a file's content, without its name."""


def _bytes(repertoire: Repertoire) -> bytes:
    segments = repertoire.segments
    note = json.dumps(repertoire.provenance, sort_keys=True, ensure_ascii=True).encode()
    values: dict[str, Any] = {
        "version": VERSION,
        "pattern": [s.pattern for s in segments],
        "loops": [s.loops for s in segments],
        "length": [len(s.translation) for s in segments],
        "rotation": np.concatenate([s.rotation for s in segments]),
        "translation": np.concatenate([s.translation for s in segments]),
        "shape": np.concatenate([s.shape for s in segments]),
        "provenance": np.frombuffer(note, np.uint8),
    }
    controls = [s.control for s in segments if s.control is not None]
    if controls:
        if len(controls) != len(segments):
            raise ValueError("some segments have control points, some have none")
        values["control"] = np.concatenate(controls)
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as archive:
        for name in values:
            dtype, _ = (_ARRAYS | _OPTIONAL)[name]
            entry = zipfile.ZipInfo(f"{name}.npy")
            entry.create_system = 3  # "Unix" on every system
            entry.external_attr = 0o644 << 16
            array = io.BytesIO()
            np.lib.format.write_array(
                array, np.ascontiguousarray(values[name], dtype).reshape(np.shape(values[name])),
                version=(1, 0), allow_pickle=False,
            )  # fmt: skip
            archive.writestr(entry, array.getvalue())
    return out.getvalue()


def _repertoire(content: bytes) -> Repertoire:
    held = {name: _array(name, data) for name, data in _members(content).items()}
    if int(held["version"]) != VERSION:
        raise _UnfitError(f"version {int(held['version'])}, this game reads {VERSION}")
    lengths = held["length"].tolist()
    _check_lengths(held, lengths)
    for name in (name for name in _ENTRIES if name in held):
        if not np.isfinite(held[name]).all():
            raise _UnfitError(f"{name} holds a number that is not finite")
        if not (np.abs(held[name]) <= _REACH).all():
            raise _UnfitError(f"{name} holds a number beyond {_REACH:g}")
    _check_rotations(held["rotation"])
    ends = np.cumsum(lengths).tolist()
    rows = [slice(end - length, end) for end, length in zip(ends, lengths, strict=True)]
    segments = tuple(
        Segment(
            Pattern(pattern),
            bool(loops),
            held["rotation"][span].astype(np.float64),
            held["translation"][span].astype(np.float64),
            held["shape"][span].astype(np.float32),
            held["control"][span].astype(np.float32) if "control" in held else None,
        )
        for pattern, loops, span in zip(
            held["pattern"].tolist(), held["loops"].tolist(), rows, strict=True
        )
    )
    return Repertoire(segments, _provenance(held["provenance"].tobytes()))


def _members(content: bytes) -> dict[str, bytes]:
    """Return the bytes of the archive's arrays by name. Raise _UnfitError for anything but our own kind of archive."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            entries = {entry.filename.removesuffix(".npy"): entry for entry in archive.infolist()}
            missing, odd = set(_ARRAYS) - set(entries), set(entries) - set(_ARRAYS | _OPTIONAL)
            if missing or odd or len(archive.infolist()) != len(entries):
                raise _UnfitError(f"holds {sorted(entries)[:12]}, not {sorted(_ARRAYS)}")
            for name, entry in entries.items():
                if entry.compress_type != zipfile.ZIP_STORED or entry.file_size > len(content):
                    raise _UnfitError(f"{name} is compressed or truncated")
            return {name: archive.read(entry) for name, entry in entries.items()}
    except (
        zipfile.BadZipFile, ValueError, OSError, EOFError, KeyError, IndexError, RuntimeError,
        OverflowError,
    ):  # fmt: skip
        raise _UnfitError("no npz archive, or damaged") from None


def _array(name: str, data: bytes) -> AnyArray:
    """Return the array in an npy file's bytes, of the type and shape that `_ARRAYS` or `_OPTIONAL` says."""
    dtype, dims = (_ARRAYS | _OPTIONAL)[name]
    file = io.BytesIO(data)
    try:
        if np.lib.format.read_magic(file) != (1, 0):
            raise _UnfitError(f"{name} is no npy array of version 1.0")
        shape, fortran, found = np.lib.format.read_array_header_1_0(file)
    except (ValueError, EOFError, OSError, MemoryError, RecursionError, TypeError, SyntaxError):
        raise _UnfitError(f"{name} is damaged") from None
    if found.hasobject:
        raise _UnfitError(f"{name} holds pickled objects, which are never loaded")
    if found != np.dtype(dtype) or fortran:
        raise _UnfitError(f"{name} holds {found.str}, not {dtype} in C order")
    if len(shape) != len(dims) or any(d not in (-1, n) for d, n in zip(dims, shape, strict=True)):
        raise _UnfitError(f"{name} has shape {shape}")
    rest = file.read()
    if min(shape, default=0) < 0 or len(rest) != math.prod(shape) * found.itemsize:
        raise _UnfitError(f"{name} is truncated")
    return np.frombuffer(rest, found).reshape(shape)


def _check_lengths(held: dict[str, AnyArray], lengths: list[int]) -> None:
    patterns, loops = held["pattern"].tolist(), held["loops"].tolist()
    if not len(patterns) == len(loops) == len(lengths):
        raise _UnfitError("pattern, loops and length differ in number")
    if not set(patterns) <= set(Pattern) or len(set(patterns)) != len(patterns):
        raise _UnfitError(
            f"patterns {patterns} are not of 0 to {len(Pattern) - 1}, each at most once"
        )
    missing = sorted(REQUIRED - set(patterns))
    if missing:
        raise _UnfitError(f"has no {', '.join(Pattern(p).name.lower() for p in missing)}")
    if not set(loops) <= {0, 1}:
        raise _UnfitError("loops holds a number that is neither 0 nor 1")
    entries = {len(held[name]) for name in _ENTRIES if name in held}
    if min(lengths) < 1 or entries != {sum(lengths)}:
        raise _UnfitError("length does not add up to the entries")


def _check_rotations(rotation: AnyArray) -> None:
    """Raise _UnfitError where a matrix is no rotation to 1e-9, right-handed."""
    m = rotation.astype(np.float64)
    product = np.einsum("kji,kjl->kil", m, m)
    if not (np.abs(product - np.eye(3)) < 1e-9).all() or not (np.linalg.det(m) > 0).all():
        raise _UnfitError("rotation holds a matrix that is no rotation")


def _provenance(data: bytes) -> dict[str, str]:
    try:
        note = json.loads(data.decode())
    except (ValueError, RecursionError):
        raise _UnfitError("provenance is damaged") from None
    if not isinstance(note, dict) or not all(isinstance(v, str) for v in note.values()):
        raise _UnfitError("provenance is not an object of strings")
    return note
