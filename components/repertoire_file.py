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

import json
from pathlib import Path
from typing import Any, Final

import numpy as np

from components.arrays import AnyArray
from components.body import NODES
from components.fault import FaultError
from components.plain_npz import Kinds, UnfitError, packed, read_strings, unpacked
from components.segment import CONTROL_POINTS, REQUIRED, Pattern, Repertoire, Segment
from components.whole_file import write_whole

VERSION: Final = 1
SIZE_LIMIT: Final = 16 << 20
"""[bytes] beyond which no file is read: a hundred times what a species takes."""

_ARRAYS: Final[Kinds] = {
    "version": ("<i4", ()),
    "pattern": ("|i1", ("patterns",)),
    "loops": ("|i1", ("loops",)),
    "length": ("<i4", ("lengths",)),
    "rotation": ("<f8", ("rotations", 3, 3)),
    "translation": ("<f8", ("translations", 3)),
    "shape": ("<f4", ("shapes", NODES, 3)),
    "provenance": ("|u1", ("bytes",)),
}
_OPTIONAL: Final[Kinds] = {
    "control": ("<f4", ("controls", CONTROL_POINTS, 3)),
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
    except UnfitError as error:
        raise RepertoireError(f"{path}: not a usable repertoire: {error}") from None


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
    return packed(values, {**_ARRAYS, **_OPTIONAL})


def _repertoire(content: bytes) -> Repertoire:
    held = unpacked(content, _ARRAYS, _OPTIONAL)
    if int(held["version"]) != VERSION:
        raise UnfitError(f"version {int(held['version'])}, this game reads {VERSION}")
    lengths = held["length"].tolist()
    _check_lengths(held, lengths)
    for name in (name for name in _ENTRIES if name in held):
        if not np.isfinite(held[name]).all():
            raise UnfitError(f"{name} holds a number that is not finite")
        if not (np.abs(held[name]) <= _REACH).all():
            raise UnfitError(f"{name} holds a number beyond {_REACH:g}")
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
    return Repertoire(segments, read_strings(held["provenance"].tobytes()))


def _check_lengths(held: dict[str, AnyArray], lengths: list[int]) -> None:
    patterns, loops = held["pattern"].tolist(), held["loops"].tolist()
    if not len(patterns) == len(loops) == len(lengths):
        raise UnfitError("pattern, loops and length differ in number")
    if not set(patterns) <= set(Pattern) or len(set(patterns)) != len(patterns):
        raise UnfitError(
            f"patterns {patterns} are not of 0 to {len(Pattern) - 1}, each at most once"
        )
    missing = sorted(REQUIRED - set(patterns))
    if missing:
        raise UnfitError(f"has no {', '.join(Pattern(p).name.lower() for p in missing)}")
    if not set(loops) <= {0, 1}:
        raise UnfitError("loops holds a number that is neither 0 nor 1")
    entries = {len(held[name]) for name in _ENTRIES if name in held}
    if min(lengths) < 1 or entries != {sum(lengths)}:
        raise UnfitError("length does not add up to the entries")


def _check_rotations(rotation: AnyArray) -> None:
    """Raise UnfitError where a matrix is no rotation to 1e-9, right-handed."""
    m = rotation.astype(np.float64)
    product = np.einsum("kji,kjl->kil", m, m)
    if not (np.abs(product - np.eye(3)) < 1e-9).all() or not (np.linalg.det(m) > 0).all():
        raise UnfitError("rotation holds a matrix that is no rotation")
