"""Chooses what bends the fibres: OpenCL where a driver proves itself in a child process, else numba.

OpenCL drivers abort, hang or lack a device where their cache cannot be written (FINDINGS 9), which no `except` catches.
So a process of its own builds the kernel, runs it and holds it against the twin; the game meanwhile plays on numba and
goes over when that has gone well. Both give the same bits, so nobody sees it.
"""

import subprocess
import sys
from time import monotonic
from typing import Final, Literal
from weakref import finalize

from components.arrays import AnyArray, Float32s
from components.fault import FaultError
from components.garden import Garden
from systems.sea.bend import Bender, NumbaBender

Backend = Literal["auto", "opencl", "numba"]

PATIENCE: Final = 30.0
"""[s] that the self-test may take."""

SELF_TEST: Final = "from systems.sea.fibres_opencl import self_test; self_test()"
"""What the child process runs: it ends well, or says why not in its last line."""


def choose(backend: Backend) -> Bender:
    """Return what bends the fibres: for `opencl` after its self-test, for `auto` at once, the test still running.

    `note` of what is returned says in one line why numba serves where OpenCL was to.
    """
    if backend == "numba":
        return NumbaBender()
    bender = ProvenBender()
    if backend == "opencl":
        bender.settle()
    return bender


class ProvenBender:
    """Bends with numba until a child process has proven OpenCL, then with that; writes what they do."""

    def __init__(self, patience: float = PATIENCE, program: str = SELF_TEST) -> None:
        self.note = ""
        self._bender: Bender = NumbaBender()
        self._deadline = monotonic() + patience
        self._child: subprocess.Popen[str] | None = subprocess.Popen(
            [sys.executable, "-c", program],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        self._end = finalize(self, _end, self._child)

    @property
    def name(self) -> str:
        """Return which of the two bends now."""
        return self._bender.name

    def step(
        self, garden: Garden, packed: Float32s, seconds: float, seen: AnyArray | None = None
    ) -> None:
        """Bend the garden's fibres, those of the clumps that are `seen`; see `Bender`."""
        if self._child is not None and self._child.poll() is not None:
            self._judge(self._child)
        elif self._child is not None and monotonic() > self._deadline:
            self._refuse("it does not answer")
        try:
            self._bender.step(garden, packed, seconds, seen)
        except FaultError as fault:
            self._refuse(str(fault))
            self._bender.step(garden, packed, seconds, seen)

    def settle(self) -> None:
        """Wait until it is known which of the two serves."""
        if self._child is not None:
            try:
                self._child.wait(max(self._deadline - monotonic(), 0.0))
            except subprocess.TimeoutExpired:
                self._refuse("it does not answer")
            else:
                self._judge(self._child)

    def _judge(self, child: "subprocess.Popen[str]") -> None:
        said = child.communicate()[1].strip().splitlines()
        if child.returncode != 0:
            self._refuse(said[-1] if said else f"its driver ends with {child.returncode}")
            return
        from systems.sea.fibres_opencl import OpenCLBender

        self._child = None
        try:
            self._bender = OpenCLBender()
        except FaultError as fault:
            self._refuse(str(fault))

    def _refuse(self, why: str) -> None:
        self._end()
        self._child, self._bender = None, NumbaBender()
        self.note = f"fibres bend with numba: OpenCL fails its self-test ({why})"


def _end(child: "subprocess.Popen[str]") -> None:
    """End a child that may have ended, and forget it."""
    child.kill()
    child.wait()
    if child.stderr is not None:
        child.stderr.close()
