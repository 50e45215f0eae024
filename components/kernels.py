"""The two ways a kernel is compiled, and where compiled kernels are kept (FINDINGS 5, DESIGN 9).

numba notices an edit in a function but not in a function it calls, so the cache folder is named after the hash of all
kernel sources: any edit starts a fresh folder. A folder that cannot be written costs compile time, never correctness.
"""

import hashlib
import os
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
from platformdirs import user_cache_path

_Kernel = TypeVar("_Kernel", bound=Callable[..., Any])
_SOURCE_PACKAGES = ("components", "systems", "reefgame", "tools")


def sources_hash() -> str:
    """Return 16 hex digits that change with any Python source of the four packages that hold kernels."""
    digest = hashlib.blake2b(digest_size=8)
    for package in _SOURCE_PACKAGES:
        spec = find_spec(package)
        for folder in (spec.submodule_search_locations or []) if spec else []:
            for source in sorted(Path(folder).rglob("*.py")):
                text = source.read_bytes()
                if b"components.kernels" in text or b"njit" in text:
                    digest.update(source.name.encode() + b"\0" + text)
    return digest.hexdigest()


def _writable(folder: Path) -> bool:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe = folder / f".probe-{os.getpid()}"
        probe.write_bytes(b"")
        probe.unlink()
    except OSError:
        return False
    return True


def _choose_cache() -> bool:
    if os.environ.get("NUMBA_CACHE_DIR"):
        return _writable(Path(os.environ["NUMBA_CACHE_DIR"]))
    folder = user_cache_path("reefgame") / "kernels" / sources_hash()
    if not _writable(folder):
        return False
    numba.config.CACHE_DIR = str(folder)
    return True


CACHED = _choose_cache()
"""Whether compiled kernels are kept on disk: False where the user's cache folder cannot be written."""


def row(function: _Kernel) -> _Kernel:
    """Compile a serial function of one row or a serial loop; it may be called from other kernels.

    It must allocate nothing: reference counting is off (a NamedTuple of arrays costs as much as a pointer), and
    division follows IEEE 754 instead of raising.
    """
    compiled = numba.njit(cache=CACHED, error_model="numpy", _nrt=False)(function)
    return cast(_Kernel, compiled)


def serial(function: _Kernel) -> _Kernel:
    """Compile a serial loop that may allocate scratch of its own."""
    return cast(_Kernel, numba.njit(cache=CACHED, error_model="numpy")(function))


def loop(function: _Kernel) -> _Kernel:
    """Compile a parallel shell: it holds `numba.prange`, scratch and calls of `row` functions, no reductions.

    Never write `table.column[i] = value` straight inside prange through a NamedTuple: numba drops the store
    (FINDINGS 5); bind the column to a name first or call a `row` function.
    """
    return cast(_Kernel, numba.njit(cache=CACHED, error_model="numpy", parallel=True)(function))
