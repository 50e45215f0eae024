"""The file of a motion, `.motion`: npz without pickle, the same bytes for the same motion.

Arrays, for n frames with u and l axis points ahead of and behind the centre; units stand in tools/video/motion.py:

    version        int32 ()          1
    rate           float64 ()        frames a second
    first          int32 ()          the clip's frame that is the motion's first
    size           int32 (2,)        of the clip [px]
    centre         float64 (n, 2)
    direction      float64 (n,)
    head_angle, tail_angle           float64 (n,)
    up_angle, low_angle, fin_angle   float64 (n, u), (n, l), (n, 2)
    head_length, tail_length         float64 (n,)
    up_length, low_length, fin_length  float64 (n, u), (n, l), (n, 2)
    junction       float64 (n, 4, 2)
    folded         int8 (n, 2)
    axis           float32 (n, 41, 2)
    half_width     float32 (n, 41)
    confidence     float64 (n,)
    fault          int8 (n,)
    provenance     uint8 (B,)        JSON object of strings, UTF-8

A reader trusts nothing: names, types, shapes, sizes and ranges are checked before an array is made.
"""

import json
from pathlib import Path
from typing import Any, Final

import numpy as np

from components.arrays import AnyArray
from components.fault import FaultError
from components.plain_npz import Kinds, UnfitError, packed, read_strings, unpacked
from components.whole_file import write_whole
from tools.video.faults import Fault
from tools.video.midline import STATIONS
from tools.video.motion import Motion

VERSION: Final = 1
SIZE_LIMIT: Final = 256 << 20
"""[bytes] beyond which no file is read: what the longest clip gives."""
MOST_POINTS: Final = 64
"""u and l at most."""
_FASTEST: Final = 100_000.0
_FARTHEST: Final = 1e6

_ARRAYS: Final[Kinds] = {
    "version": ("<i4", ()),
    "rate": ("<f8", ()),
    "first": ("<i4", ()),
    "size": ("<i4", (2,)),
    "centre": ("<f8", ("n", 2)),
    "direction": ("<f8", ("n",)),
    "head_angle": ("<f8", ("n",)),
    "tail_angle": ("<f8", ("n",)),
    "up_angle": ("<f8", ("n", "u")),
    "low_angle": ("<f8", ("n", "l")),
    "fin_angle": ("<f8", ("n", 2)),
    "head_length": ("<f8", ("n",)),
    "tail_length": ("<f8", ("n",)),
    "up_length": ("<f8", ("n", "u")),
    "low_length": ("<f8", ("n", "l")),
    "fin_length": ("<f8", ("n", 2)),
    "junction": ("<f8", ("n", 4, 2)),
    "folded": ("|i1", ("n", 2)),
    "axis": ("<f4", ("n", STATIONS, 2)),
    "half_width": ("<f4", ("n", STATIONS)),
    "confidence": ("<f8", ("n",)),
    "fault": ("|i1", ("n",)),
    "provenance": ("|u1", ("bytes",)),
}


class MotionError(FaultError):
    """A motion file cannot be used: one line that names the file and what is wrong."""


def save(path: Path, motion: Motion) -> None:
    """Write a motion to `path`, whole or not at all. Raise OSError where the folder cannot be written."""
    note = json.dumps(motion.provenance, sort_keys=True).encode()
    held: dict[str, Any] = {name: getattr(motion, name, None) for name in _ARRAYS}
    held["version"], held["provenance"] = VERSION, np.frombuffer(note, np.uint8)
    write_whole(path, packed(held, _ARRAYS))


def load(path: Path) -> Motion:
    """Return the motion in the file `path`. Raise MotionError, one clear line, where there is none."""
    try:
        if path.stat().st_size > SIZE_LIMIT:
            raise MotionError(f"{path}: larger than {SIZE_LIMIT >> 20} MiB, no motion is")
        content = path.read_bytes()
    except OSError as error:
        raise MotionError(f"{path}: cannot be read: {error.strerror or error}") from None
    try:
        return _motion(_checked(unpacked(content, _ARRAYS)))
    except UnfitError as error:
        raise MotionError(f"{path}: no motion: {error}") from None


def _motion(held: dict[str, AnyArray]) -> Motion:
    fields = {name: held[name] for name in _ARRAYS if name not in ("version", "provenance")}
    scalars: dict[str, Any] = {
        "rate": float(held["rate"]),
        "first": int(held["first"]),
        "size": tuple(int(side) for side in held["size"]),
        "folded": held["folded"] != 0,
        "provenance": read_strings(held["provenance"].tobytes()),
    }
    return Motion(**{**fields, **scalars})


def _checked(held: dict[str, AnyArray]) -> dict[str, AnyArray]:
    """Return all arrays, of the ranges that a motion's have."""
    if int(held["version"]) != VERSION:
        raise UnfitError(f"version {VERSION} is expected, not {int(held['version'])}")
    for name, array in held.items():
        if array.dtype.kind == "f" and not (np.abs(array) < _FARTHEST).all():
            raise UnfitError(f"{name} holds a number that is not finite, or far too large")
    (frames, ahead), behind = held["up_angle"].shape, held["low_angle"].shape[1]
    if frames < 1 or not 1 <= ahead <= MOST_POINTS or not 1 <= behind <= MOST_POINTS:
        raise UnfitError(f"{frames} frames of {ahead} and {behind} points are no motion")
    if not 0.0 < float(held["rate"]) <= _FASTEST:
        raise UnfitError(f"rate {float(held['rate']):g} is not from 0 to {_FASTEST:g}")
    if int(held["first"]) < 0 or held["size"].min() < 1:
        raise UnfitError("first or size is below what can be")
    _check_ranges(held)
    return held


def _check_ranges(held: dict[str, AnyArray]) -> None:
    known = {int(fault) for fault in Fault}
    if not set(np.unique(held["fault"]).tolist()) <= known:
        raise UnfitError(f"fault holds a number that is not from 0 to {max(known)}")
    if not (held["fault"] == 0).any():
        raise UnfitError("no frame is good")
    if not set(np.unique(held["folded"]).tolist()) <= {0, 1}:
        raise UnfitError("folded holds a number that is neither 0 nor 1")
    confidence = held["confidence"]
    if confidence.min() < 0.0 or confidence.max() > 1.0:
        raise UnfitError("confidence is not from 0 to 1")
    for name in (
        "head_length",
        "tail_length",
        "up_length",
        "low_length",
        "fin_length",
        "half_width",
    ):
        if held[name].min() < 0.0:
            raise UnfitError(f"{name} is negative")
