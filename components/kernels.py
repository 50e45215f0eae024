"""The five ways a kernel is compiled, and where compiled kernels are kept (FINDINGS 5, DESIGN 9).

numba's own cache misses an edit in a function that a kernel calls, unpickles whatever bytes it
finds and may mix up two processes that write at once. This one stamps each compiled kernel with the
hash of its module and of every first-party module that it stands on, replaces files whole and reads
none whose checksum is wrong. What cannot be read or written costs time, never correctness.
"""

import contextlib
import hashlib
import os
import pickle
import re
import sys
import uuid
from collections.abc import Callable
from functools import cache, partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final, Generic, TypeVar, TypeVarTuple, cast

import numba
import numpy as np
from numba.core.caching import FunctionCache
from numba.core.serialize import dumps
from platformdirs import user_cache_path

from components.kernel_dispatch import CalleeCacheImpl, Kernel, entry

_Kernel = TypeVar("_Kernel", bound=Callable[..., Any])
_Told = TypeVarTuple("_Told")
_Given = TypeVar("_Given")
_FIRST_PARTY: Final = rb"(?:components|systems|reefgame|tools)"
_IMPORT: Final = re.compile(
    rb"^[ \t]*(?:from[ \t]+(" + _FIRST_PARTY + rb"[\w.]*)[ \t]+import[ \t]+(\([^)]*\)|[^\n]*)"
    rb"|import[ \t]+(" + _FIRST_PARTY + rb"[\w.]*))",
    re.MULTILINE,
)
_CHECKSUM_BYTES: Final = 16


@cache
def _package_folders(package: str) -> tuple[Path, ...]:
    spec = find_spec(package)
    return tuple(map(Path, (spec.submodule_search_locations if spec else None) or ()))


@cache
def _file_of(module: str) -> Path | None:
    """Return the file of a first-party module, found without importing it."""
    package, *rest = module.split(".")
    for folder in _package_folders(package):
        base = folder.joinpath(*rest)
        for path in (base.with_suffix(".py"), base / "__init__.py"):
            if path.is_file():
                return path
    return None


@cache
def _text(path: Path) -> bytes:
    return path.read_bytes()


@cache
def _imported(path: Path) -> frozenset[Path]:
    """Return the files of the first-party modules that the file imports, itself included."""
    modules = set()
    for parent, names, plain in _IMPORT.findall(_text(path)):
        name = (parent or plain).decode()
        modules.add(name)
        modules.update(f"{name}.{member.decode()}" for member in re.findall(rb"\w+", names))
    return frozenset({path, *filter(None, map(_file_of, modules))})


@cache
def sources_hash(source: Path) -> str:
    """Return 32 hex digits that change with the file and every first-party file it stands on."""
    reached: frozenset[Path] = frozenset()
    front = frozenset({source})
    while front:
        reached |= front
        front = frozenset().union(*map(_imported, front)) - reached
    digest = hashlib.blake2b(f"{sys.version} {numba.__version__}".encode(), digest_size=16)
    for path in sorted(reached):
        digest.update(hashlib.blake2b(_text(path)).digest())
    return digest.hexdigest()


def _writable(folder: Path) -> bool:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe = folder / f".probe-{uuid.uuid4().hex}"
        probe.write_bytes(b"")
        probe.unlink()
    except OSError:
        return False
    return True


def _choose_cache() -> bool:
    if os.environ.get("NUMBA_CACHE_DIR"):
        return _writable(Path(os.environ["NUMBA_CACHE_DIR"]))
    folder = user_cache_path("reefgame") / "kernels"
    if not _writable(folder):
        return False
    numba.config.CACHE_DIR = str(folder)
    return True


CACHED: Final = _choose_cache()
"""Whether compiled kernels are kept on disk: False where the cache folder cannot be written."""


class _KernelFiles:
    """One file for each compiled signature of one kernel: checksum, then the pickled (key, data).

    The checksum starts from the stamp, so what other sources left is never unpickled.
    """

    def __init__(self, folder: Path, stem: str, stamp: str) -> None:
        self._folder = folder
        self._stem = stem
        self._stamp = stamp.encode()

    def _path(self, key: tuple[Any, ...]) -> Path:
        name = hashlib.blake2b(repr(key[:2]).encode(), digest_size=8).hexdigest()
        return self._folder / f"{self._stem}.{name}.kernel"

    def _checksum(self, payload: bytes) -> bytes:
        return hashlib.blake2b(self._stamp + payload, digest_size=_CHECKSUM_BYTES).digest()

    def load(self, key: tuple[Any, ...]) -> Any:
        """Return what was saved under `key`; None where it is absent, damaged or stale."""
        try:
            content = self._path(key).read_bytes()
        except OSError:
            return None
        payload = content[_CHECKSUM_BYTES:]
        if content[:_CHECKSUM_BYTES] != self._checksum(payload):
            return None
        saved_key, data = pickle.loads(payload)  # noqa: S301 (ours: its checksum is right)
        return data if saved_key == key else None

    def save(self, key: tuple[Any, ...], data: Any) -> None:
        """Keep `data` under `key`. A folder that is full or gone is no error."""
        payload = dumps((key, data))
        path = self._path(key)
        fresh = path.with_name(f"{path.name}.{uuid.uuid4().hex[:12]}")
        try:
            fresh.write_bytes(self._checksum(payload) + payload)
            fresh.replace(path)
        except OSError:
            with contextlib.suppress(OSError):
                fresh.unlink()

    def flush(self) -> None:
        """Forget what was saved."""
        for path in self._folder.glob(f"{self._stem}.*.kernel"):
            path.unlink(missing_ok=True)


class _KernelCache(FunctionCache):  # type: ignore[misc]  # numba is untyped
    """numba's cache of one function over our own files; `kind` is the decorator's name."""

    def __init__(self, function: Callable[..., Any], kind: str) -> None:
        super().__init__(function)
        stem = f"{function.__module__.rpartition('.')[2]}.{function.__qualname__}.{kind}"
        stem = re.sub(r"[^\w.]", "", stem)
        stamp = sources_hash(Path(function.__code__.co_filename))
        self._cache_file = _KernelFiles(Path(self.cache_path), stem, stamp)


class _CalleeCache(_KernelCache):
    """The same of one function as other kernels call it."""

    _impl_class = CalleeCacheImpl


def _compile(function: _Kernel, kind: str, **options: Any) -> _Kernel:
    if numba.config.DISABLE_JIT:
        return function
    # Nobody calls a kernel from C: its wrapper would cost a tenth of the compile time.
    numbas = {"nopython": True, "error_model": "numpy", "no_cfunc_wrapper": True}
    compiled = Kernel(function, numbas | options)
    if CACHED and Path(function.__code__.co_filename).is_file():
        compiled.caches = (
            partial(_KernelCache, function, kind),
            partial(_CalleeCache, function, f"{kind}.callee"),
        )
    return cast(_Kernel, compiled)


class Launch(Generic[*_Told, _Given]):
    """A kernel as a system calls it, always with arguments of the same types: numba looks at them once.

    It looks at every array of every call else: 50 us for the hundred that minds read, while other threads wait. So
    arrays and tuples should be the same objects from call to call; the last are kept alive.
    """

    def __init__(self, kernel: Callable[[*_Told], _Given]) -> None:
        self._kernel = kernel
        self._entry: Callable[..., _Given] | None = None
        self._kept: tuple[list[Any], ...] = ()

    def __call__(self, *args: *_Told) -> _Given:
        """Run the kernel."""
        if self._entry is None:
            self._entry = self._find(args)
        return self._entry(*args, *self._kept)

    def _find(self, args: tuple[Any, ...]) -> Callable[..., _Given]:
        """Return what runs the kernel, and have words of memory for it."""
        if not isinstance(self._kernel, Kernel):
            return self._kernel
        code, words = entry(self._kernel, args)
        self._words = np.zeros(words, np.int64)
        self._kept = ([self._words.ctypes.data, *[None] * words],)
        return code


def row(function: _Kernel) -> _Kernel:
    """Compile a serial function of one row or a serial loop; it may be called from other kernels.

    It must allocate nothing: reference counting is off (a NamedTuple of arrays costs as much as a
    pointer), and division follows IEEE 754 instead of raising. What returns arrays serves kernels
    alone: Python would count references to them that nobody holds.
    """
    return _compile(function, "row", _nrt=False)


def inlined(function: _Kernel) -> _Kernel:
    """Compile as `row` does, and put it into its callers whole: for what runs once a fish.

    A call hands over every array as seven words: 20 ns with a few arrays, which inlining saves.
    """
    return _compile(function, "inlined", _nrt=False, forceinline=True)


def merged(function: _Kernel) -> _Kernel:
    """Let the one kernel that calls it take the function's text in before it is compiled.

    For long steps of one loop that share hundreds of arrays: compiled by itself each would cost seconds.
    """
    return cast(_Kernel, numba.njit(error_model="numpy", _nrt=False, inline="always")(function))


def serial(function: _Kernel) -> _Kernel:
    """Compile a serial loop that may allocate scratch of its own."""
    return _compile(function, "serial")


def loop(function: _Kernel) -> _Kernel:
    """Compile a parallel shell: it holds `numba.prange`, scratch and calls of `row` functions, no
    reductions.

    Never write `table.column[i] = value` straight inside prange through a NamedTuple: numba drops
    the store (FINDINGS 5); bind the column to a name first or call a `row` function.
    """
    return _compile(function, "loop", parallel=True)
