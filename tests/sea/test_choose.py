"""The choice of what bends: OpenCL where it proves itself, else numba and one line that says why."""

import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from components.garden import Garden
from systems.sea.bend import NumbaBender
from systems.sea.choose import ProvenBender, choose
from systems.sea.fibres_opencl import LEAST_NODES

REPORT = "from systems.sea.choose import choose; bender = choose('opencl'); print(bender.name, bender.note)"

NO_PLATFORM = """
import pyopencl

def _none():
    raise pyopencl.LogicError("clGetPlatformIDs failed: PLATFORM_NOT_FOUND_KHR")

pyopencl.get_platforms = _none
"""


def test_numba_is_taken_at_once() -> None:
    bender = choose("numba")
    assert (bender.name, bender.note) == ("numba", "")


def test_opencl_serves_where_it_passes_its_test(bed: ModuleType) -> None:
    bender = choose("opencl")
    assert (bender.name, bender.note) == ("opencl", "")
    own, twin = (Garden(bed.anemone(fibres), bed.ROCKS) for fibres in (500, 500))
    assert own.strands.length.size > LEAST_NODES
    bed.bend(own, bender, bed.water(), 30)
    bed.bend(twin, NumbaBender(parallel=False), bed.water(), 30)
    assert np.array_equal(own.position, twin.position)


def test_numba_serves_while_the_test_runs(bed: ModuleType) -> None:
    bender = ProvenBender(program="import time; time.sleep(600)")
    garden, twin = Garden(bed.anemone()), Garden(bed.anemone())
    bed.bend(garden, bender, bed.water(), 3)
    assert (bender.name, bender.note) == ("numba", "")
    bed.bend(twin, NumbaBender(parallel=False), bed.water(), 3)
    assert np.array_equal(garden.position, twin.position)


@pytest.mark.parametrize(
    ("program", "says"),
    [
        ("raise SystemExit('the driver is a teapot')", "the driver is a teapot"),
        ("import os; os.abort()", "its driver ends with"),
        ("import no_such_module", "no_such_module"),
    ],
)
def test_a_child_that_fails_leaves_numba_and_one_line(
    bed: ModuleType, program: str, says: str
) -> None:
    bender = ProvenBender(program=program)
    bender.settle()
    garden = Garden(bed.anemone())
    bed.bend(garden, bender, bed.water(), 2)
    assert bender.name == "numba"
    assert says in bender.note
    assert "\n" not in bender.note


def test_the_change_to_opencl_moves_nothing(bed: ModuleType) -> None:
    bender = ProvenBender()
    garden, twin = (Garden(bed.anemone(fibres)) for fibres in (500, 500))
    bed.bend(garden, bender, bed.water(), 5)
    bender.settle()
    bed.bend(garden, bender, bed.water(), 5)
    for _ in range(2):
        bed.bend(twin, NumbaBender(parallel=False), bed.water(), 5)
    assert np.array_equal(garden.position, twin.position)


def test_a_child_that_hangs_is_given_up(bed: ModuleType) -> None:
    for wait in (True, False):
        bender = ProvenBender(patience=0.0, program="import time; time.sleep(600)")
        if wait:
            bender.settle()
        bed.bend(Garden(bed.anemone()), bender, bed.water(), 1)
        assert bender.name == "numba"
        assert "does not answer" in bender.note


@pytest.mark.parametrize("broken", ["platform", "cache"])
def test_without_a_platform_or_a_cache_numba_serves(
    tmp_path: Path, installed: Path, broken: str
) -> None:
    """No driver installed, or PoCL's cache in a plain file: each is told in one line, and nothing else is."""
    if broken == "platform":
        (tmp_path / "sitecustomize.py").write_text(NO_PLATFORM)
    (tmp_path / "file").write_text("")
    cache = {"POCL_CACHE_DIR": str(tmp_path / "file" / "inside")} if broken == "cache" else {}
    path = os.pathsep.join((str(tmp_path), str(installed)))
    run = subprocess.run(
        [sys.executable, "-c", REPORT],
        env={**os.environ, **cache, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=True,
    )
    name, _, note = run.stdout.strip().partition(" ")
    assert name == "numba"
    assert note.startswith("fibres bend with numba: OpenCL fails its self-test (")
    assert run.stdout.count("\n") == 1
