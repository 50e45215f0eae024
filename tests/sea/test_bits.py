"""Equal bits: numba and OpenCL, any work-group size, any number of threads, culled or not (DESIGN 2)."""

import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from components.fibre import Tuft
from components.field import pack
from components.garden import Garden

PROGRAM = (
    "import runpy, sys; sys.argv = sys.argv[1:]; runpy.run_path(sys.argv[0], run_name='__main__')"
)


@pytest.fixture(scope="module")
def wanted(bed: ModuleType) -> str:
    """What numba makes of the bed, serial and culled."""
    return str(bed.bits_of("numba"))


@pytest.mark.parametrize(
    ("backend", "local_size", "culled"),
    [
        ("numba", 1, False),
        ("numba", 2, True),
        ("opencl", 1, True),
        ("opencl", 7, True),
        ("opencl", 64, False),
        ("opencl", 256, True),
    ],
)
def test_bits_are_equal_over_backends_work_groups_and_culling(
    bed: ModuleType, wanted: str, backend: str, local_size: int, culled: bool
) -> None:
    assert bed.bits_of(backend, local_size, culled) == wanted


@pytest.mark.parametrize("backend", ["numba", "opencl"])
def test_bits_are_equal_over_threads(
    bed_script: Path, installed: Path, wanted: str, backend: str
) -> None:
    threads = {"NUMBA_NUM_THREADS": "1", "POCL_MAX_PTHREAD_COUNT": "1"}
    run = subprocess.run(
        [sys.executable, "-c", PROGRAM, str(bed_script), backend, "2", "culled"],
        env={**os.environ, **threads, "PYTHONPATH": str(installed)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert run.stdout.strip() == wanted


def test_one_step_more_is_other_bits(bed: ModuleType, wanted: str) -> None:
    assert bed.bits_of("numba", steps=41) != wanted


@pytest.mark.parametrize("backend", ["numba", "opencl"])
def test_what_is_not_seen_is_not_bent(bed: ModuleType, backend: str) -> None:
    bender = bed.bender_of(backend, 2, True)
    garden, whole = (
        Garden([*bed.anemone(), Tuft(bed.straight(nodes=5), np.full(5, 0.5))]) for _ in range(2)
    )
    hidden = garden.fibre(3, 0)
    before = garden.points(hidden).copy()
    seen = np.ones(len(garden.clump_sphere), bool)
    seen[garden.clump[3]] = False
    for _ in range(5):
        bender.step(garden, pack(bed.water(), 0), bed.FRAME, seen)
        bender.step(whole, pack(bed.water(), 0), bed.FRAME)
    assert np.array_equal(garden.points(hidden), before)
    assert not np.array_equal(whole.points(hidden), garden.points(hidden))
    assert np.array_equal(whole.points(3), garden.points(3))
    bender.step(garden, pack(bed.water(), 0), bed.FRAME, np.zeros(len(seen), bool))
    assert np.array_equal(whole.points(3), garden.points(3))
