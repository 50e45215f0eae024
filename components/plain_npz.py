"""Arrays in a file: npz without pickle, the same bytes for the same arrays; its reader trusts nothing (DESIGN 4).

Entries are stored, not deflated, with a fixed date, so that bytes do not depend on a library's version or a system.
Names, types, shapes and sizes are checked before an array is made.
"""

import io
import json
import math
import zipfile
from collections.abc import Mapping
from typing import Any, Final, TypeAlias

import numpy as np

from components.arrays import AnyArray

Kinds: TypeAlias = Mapping[str, tuple[str, tuple[int | str, ...]]]
"""Type and shape of each array by its name; a dimension is a size, or a name that has one size in all of a file."""

_READABLE: Final = 0o644 << 16
_UNIX: Final = 3


class UnfitError(Exception):
    """What is wrong with a file's content, without its name."""


def packed(values: Mapping[str, Any], kinds: Kinds) -> bytes:
    """Return the file of arrays, of the types that `kinds` says."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as archive:
        for name, value in values.items():
            entry = zipfile.ZipInfo(f"{name}.npy")
            entry.create_system, entry.external_attr = _UNIX, _READABLE
            array = np.ascontiguousarray(value, kinds[name][0]).reshape(np.shape(value))
            member = io.BytesIO()
            np.lib.format.write_array(member, array, version=(1, 0), allow_pickle=False)
            archive.writestr(entry, member.getvalue())
    return out.getvalue()


def unpacked(content: bytes, kinds: Kinds, optional: Kinds | None = None) -> dict[str, AnyArray]:
    """Return the arrays of a file that `packed` made, those of `optional` where they are there. Raise UnfitError."""
    members = _members(content, kinds, optional or {})
    sizes: dict[str, int] = {}
    known = {**kinds, **(optional or {})}
    return {name: _array(name, members[name], known[name], sizes) for name in members}


def read_strings(data: bytes) -> dict[str, str]:
    """Return the JSON object of strings in UTF-8. Raise UnfitError for anything else."""
    try:
        note = json.loads(data.decode())
    except (ValueError, RecursionError):
        raise UnfitError("provenance is damaged") from None
    if not isinstance(note, dict) or not all(isinstance(v, str) for v in note.values()):
        raise UnfitError("provenance is not an object of strings")
    return note


def _members(content: bytes, kinds: Kinds, optional: Kinds) -> dict[str, bytes]:
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            entries = {entry.filename.removesuffix(".npy"): entry for entry in archive.infolist()}
            missing, odd = set(kinds) - set(entries), set(entries) - {*kinds, *optional}
            if missing or odd or len(archive.infolist()) != len(entries):
                raise UnfitError(f"holds {sorted(entries)[:12]}, not {sorted(kinds)}")
            for name, entry in entries.items():
                if entry.compress_type != zipfile.ZIP_STORED or entry.file_size > len(content):
                    raise UnfitError(f"{name} is compressed or truncated")
            return {name: archive.read(entry) for name, entry in entries.items()}
    except (
        zipfile.BadZipFile, ValueError, OSError, EOFError, KeyError, IndexError, RuntimeError,
        OverflowError,
    ):  # fmt: skip
        raise UnfitError("no npz archive, or damaged") from None


def _array(
    name: str, data: bytes, kind: tuple[str, tuple[int | str, ...]], sizes: dict[str, int]
) -> AnyArray:
    """Return the array in an npy file's bytes; named sizes are kept in `sizes`."""
    dtype, wanted = kind
    file = io.BytesIO(data)
    try:
        if np.lib.format.read_magic(file) != (1, 0):
            raise UnfitError(f"{name} is no npy array of version 1.0")
        shape, fortran, found = np.lib.format.read_array_header_1_0(file)
    except (ValueError, EOFError, OSError, MemoryError, RecursionError, TypeError, SyntaxError):
        raise UnfitError(f"{name} is damaged") from None
    if found.hasobject:
        raise UnfitError(f"{name} holds pickled objects, which are never loaded")
    if found != np.dtype(dtype) or fortran:
        raise UnfitError(f"{name} holds {found.str}, not {dtype} in C order")
    fits = len(shape) == len(wanted) and min(shape, default=0) >= 0
    for size, dim in zip(shape, wanted, strict=False):
        fits = fits and size == (sizes.setdefault(dim, size) if isinstance(dim, str) else dim)
    if not fits:
        raise UnfitError(f"{name} has shape {shape}")
    rest = file.read()
    if len(rest) != math.prod(shape) * found.itemsize:
        raise UnfitError(f"{name} is truncated")
    return np.frombuffer(rest, found).reshape(shape)
