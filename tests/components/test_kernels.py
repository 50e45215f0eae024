"""The cache of compiled kernels: whatever befalls its files costs time, never correctness."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

MODULE = '''"""Two kernels, one calling the other."""

from components.kernels import row


@row
def inner(x):
    return x + {plus}.0


@row
def outer(x):
    return 2.0 * inner(x)


@row
def scaled(x, times):
    return x * times


if __name__ == "__main__":
    print("import the module instead")
'''

PROGRAM = """
import sys
sys.path.insert(0, sys.argv[1])
from kernels_of_a_test import outer, scaled
print(outer(1.5), scaled(2.0, 3), scaled(2, 3))
hits = [sum(k.stats.cache_hits.values()) for k in (outer, scaled)]
print(*hits)
"""


LOOPS = '''"""A parallel loop that two kernels call."""

import numba

from components.kernels import loop, row


@loop
def fill(values):
    for k in numba.prange(len(values)):
        values[k] = k


@row
def one(values):
    fill(values)
    return values[-1]


@row
def other(values):
    fill(values)
    return values[1]
'''

CALLS = """
import sys
import numpy as np
sys.path.insert(0, sys.argv[1])
import loops_of_a_test
kernel = getattr(loops_of_a_test, sys.argv[2])
print(int(kernel(np.zeros(1000))), sum(kernel.stats.cache_hits.values()))
"""


def _run(folder: Path, cache: Path | None, **environment: str) -> list[str]:
    """Call the kernels in a process of their own; return the answers and the hits of the cache."""
    variables = {**os.environ, **environment}
    variables.pop("NUMBA_CACHE_DIR", None)
    if cache is not None:
        variables["NUMBA_CACHE_DIR"] = str(cache)
    result = subprocess.run(
        [sys.executable, "-c", PROGRAM, str(folder)],
        env=variables,
        capture_output=True,
        text=True,
        check=True,
    )
    return result.stdout.splitlines()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder that holds a module of kernels."""
    there = tmp_path / "sources"
    there.mkdir()
    (there / "kernels_of_a_test.py").write_text(MODULE.format(plus=1))
    return there


def _files(cache: Path) -> list[Path]:
    return sorted(path for path in cache.rglob("*") if path.is_file())


def test_a_second_process_finds_what_the_first_compiled(folder: Path, tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    assert _run(folder, cache) == ["5.0 6.0 6", "0 0"]
    assert _run(folder, cache) == ["5.0 6.0 6", "1 2"]
    assert all(path.suffix == ".kernel" for path in _files(cache))


def test_damaged_files_are_compiled_anew_and_replaced(folder: Path, tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    _run(folder, cache)
    files = _files(cache)
    assert len(files) == 4
    for path, damage in zip(files, ("empty", "cut", "garbled", "pickle"), strict=True):
        content = path.read_bytes()
        half = len(content) // 2
        path.write_bytes(
            {
                "empty": b"",
                "cut": content[:half],
                "garbled": content[:half] + bytes([content[half] ^ 1]) + content[half + 1 :],
                "pickle": b"cos\nsystem\n(S'exit 1'\ntR.",
            }[damage]
        )
    assert _run(folder, cache) == ["5.0 6.0 6", "0 0"]
    assert _run(folder, cache) == ["5.0 6.0 6", "1 2"]


def test_folders_in_the_place_of_files_are_let_be(folder: Path, tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    _run(folder, cache)
    for path in _files(cache):
        path.unlink()
        path.mkdir()
    assert _run(folder, cache) == ["5.0 6.0 6", "0 0"]
    assert _files(cache) == []


def test_files_of_two_kernels_exchanged_are_compiled_anew(folder: Path, tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    _run(folder, cache)
    one, other = (p for p in _files(cache) if p.name.startswith("kernels_of_a_test.scaled"))
    first, second = one.read_bytes(), other.read_bytes()
    one.write_bytes(second)
    other.write_bytes(first)
    assert _run(folder, cache) == ["5.0 6.0 6", "1 0"]


def test_an_edit_in_what_a_kernel_calls_is_noticed(folder: Path, tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    _run(folder, cache)
    (folder / "kernels_of_a_test.py").write_text(MODULE.format(plus=2))
    assert _run(folder, cache)[0] == "7.0 6.0 6"


def test_a_cache_that_cannot_be_written_only_costs_time(folder: Path, tmp_path: Path) -> None:
    blocked = tmp_path / "blocked"
    blocked.write_text("a file where a folder should be")
    assert _run(folder, blocked) == ["5.0 6.0 6", "0 0"]
    home = {name: str(blocked) for name in ("HOME", "XDG_CACHE_HOME", "LOCALAPPDATA")}
    assert _run(folder, None, **home) == ["5.0 6.0 6", "0 0"]
    assert blocked.read_text() == "a file where a folder should be"


def test_processes_that_compile_at_once_leave_whole_files(folder: Path, tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(cache)}
    running = [
        subprocess.Popen(
            [sys.executable, "-c", PROGRAM, str(folder)],
            env=environment,
            stdout=subprocess.PIPE,
            text=True,
        )
        for _ in range(3)
    ]
    answers = [process.communicate()[0].splitlines()[0] for process in running]
    assert answers == ["5.0 6.0 6"] * 3
    assert _run(folder, cache)[1] == "1 2"
    assert all(path.suffix == ".kernel" for path in _files(cache))


def test_the_user_s_cache_folder_holds_the_kernels(folder: Path, tmp_path: Path) -> None:
    home = {"XDG_CACHE_HOME": str(tmp_path), "HOME": str(tmp_path), "LOCALAPPDATA": str(tmp_path)}
    assert _run(folder, None, **home)[0] == "5.0 6.0 6"
    assert [p for p in _files(tmp_path) if p.name.startswith("kernels_of_a_test.outer.row")]


def test_a_kernel_from_the_cache_starts_the_threads_of_a_loop_that_it_calls(tmp_path: Path) -> None:
    (tmp_path / "loops_of_a_test.py").write_text(LOOPS)
    told = []
    for kernel in ("one", "other", "other"):
        result = subprocess.run(
            [sys.executable, "-c", CALLS, str(tmp_path), kernel],
            env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / "cache")},
            capture_output=True,
            text=True,
            check=True,
        )
        told.append(result.stdout.strip())
    assert told == ["999 0", "1 0", "1 1"]
