"""Bends fibres with OpenCL, eight to a work-item: papers/002's future work (section 6). No other file imports pyopencl.

The kernel stands in fibres.cl; systems/sea/fibres_numba.py is its twin. A driver may lie, abort or hang, so
systems/sea/choose.py runs `self_test` in a process of its own before anybody constructs a bender here.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final
from weakref import WeakKeyDictionary

import numpy as np
import pyopencl as cl

from components.arrays import AnyArray, Float32s, Int32s
from components.fault import FaultError
from components.fibre import PUSH, SKIN, Carriers, Tuft
from components.field import pack
from components.garden import Garden
from components.singularity import SingularityTable
from systems.sea.bend import NumbaBender, part_of, turns
from systems.sea.follow import follow
from systems.sea.gather import Lists, gather

LOCAL_SIZE: Final = 4
"""Work-items in a work-group: fixed, so that the kernel is built once; few, so that cores share evenly."""

LEAST_NODES: Final = 1_024
"""Nodes below which starting the device takes longer than numba's twin, which then serves: the bits are the same."""

_STEPS: Final = 20
_FRAME: Final = 1.0 / 60.0
_TOLERANCE: Final = 1e-4
_READ: Final = cl.mem_flags.READ_ONLY
_SHARED: Final = cl.mem_flags.USE_HOST_PTR


class DeviceError(FaultError):
    """The device cannot do what it was asked; the text says what."""


@contextmanager
def _faults() -> Iterator[None]:
    """Tell what the driver refuses in one line."""
    try:
        yield
    except (cl.Error, OSError) as error:
        raise DeviceError(" ".join(str(error).split())[:160]) from error


def _first_device() -> Any:
    for platform in cl.get_platforms():
        for device in platform.get_devices():
            return device
    raise DeviceError("no OpenCL platform has a device")


def _float(value: float) -> str:
    return f"{float(np.float32(value))!r}f"


def _options(device: Any) -> list[str]:
    options = [f"-DPUSH={_float(PUSH)}", f"-DINVERSE_SKIN={_float(1.0 / SKIN)}"]
    options.append(f"-DPUSH_GAIN={_float(PUSH / SKIN)}")
    if device.single_fp_config & cl.device_fp_config.CORRECTLY_ROUNDED_DIVIDE_SQRT:
        options.append("-cl-fp32-correctly-rounded-divide-sqrt")
    return options


def _whole(array: AnyArray) -> AnyArray:
    """Return the array, or one of a single zero where it is empty: no device has empty buffers."""
    return array if array.size else np.zeros(1, array.dtype)


class _Shared:
    """A garden's arrays as the device sees them.

    What bends stays mapped between steps, so that all may read it; a processor that works on our own memory needs none
    of that, which saves a tenth of a step.
    """

    def __init__(self, context: Any, queue: Any, garden: Garden) -> None:
        strands, rocks = garden.strands, garden.rocks
        self._queue = queue
        self._host = [_whole(plane) for plane in (*strands, *rocks)]
        flags = [_READ | _SHARED] * len(self._host)
        self._written = tuple(strands._fields.index(name) for name in ("direction", "position"))
        for at in (*self._written, strands._fields.index("root")):
            flags[at] = cl.mem_flags.READ_WRITE | _SHARED
        self.buffers = [
            cl.Buffer(context, flag, hostbuf=plane)
            for flag, plane in zip(flags, self._host, strict=True)
        ]
        self._mapped: list[Any] = []
        self._direct = False
        self.take_back()
        on_processor = bool(queue.device.type & cl.device_type.CPU)
        ours = [self._host[at].ctypes.data for at in self._written]
        direct = on_processor and ours == [mapped.ctypes.data for mapped in self._mapped]
        if direct:
            self.lend()
        self._direct = direct

    def lend(self) -> None:
        """Hand what bends to the device."""
        for mapped in self._mapped:
            mapped.base.release(self._queue)
        self._mapped = []

    def take_back(self) -> None:
        """Wait for the device, and let everybody read what it has bent."""
        flags: Any = cl.map_flags.READ | cl.map_flags.WRITE
        for at in () if self._direct else self._written:
            plane, buffer = self._host[at], self.buffers[at]
            mapped, _ = cl.enqueue_map_buffer(
                self._queue, buffer, flags, 0, plane.shape, plane.dtype, is_blocking=False
            )
            self._mapped.append(mapped)
        self._queue.finish()


class OpenCLBender:
    """Bends with OpenCL; reads and writes a garden's `strands` and `followers`."""

    name = "opencl"
    note = ""

    def __init__(
        self, local_size: int = LOCAL_SIZE, culled: bool = True, least_nodes: int = LEAST_NODES
    ) -> None:
        """Build the kernel on the first device. Raise DeviceError where there is none or it does not build."""
        source = Path(__file__).with_name("fibres.cl").read_text(encoding="utf-8")
        with _faults():
            device = _first_device()
            self._context = cl.Context([device])
            self._queue = cl.CommandQueue(self._context)
            program: Any = cl.Program(self._context, source)
            program.build(_options(device), cache_dir=False)
            self._kernel = cl.Kernel(program, "bend")
            # Without their types each of these takes 10 us to set.
            numbers = (np.int32, np.int32, np.float32)
            others = self._kernel.num_args - len(numbers)
            self._kernel.set_scalar_arg_dtypes([*numbers, *[None] * others])
        self._local_size = local_size
        self._culled = culled
        self._least_nodes = least_nodes
        self._twin = NumbaBender(culled=culled)
        self._lists: Lists | None = None
        self._shared: WeakKeyDictionary[Garden, _Shared] = WeakKeyDictionary()

    def step(
        self, garden: Garden, packed: Float32s, seconds: float, seen: AnyArray | None = None
    ) -> None:
        """Bend the garden's fibres, those of the clumps that are `seen`; see `Bender`. Raise DeviceError."""
        if garden.strands.length.size < self._least_nodes:
            self._twin.step(garden, packed, seconds, seen)
            return
        due = [bundles for bundles in turns(garden, seen) if len(bundles)]
        if due:
            with _faults():
                self._bend(garden, packed, part_of(seconds), due)
        follow(garden)

    def _bend(self, garden: Garden, packed: Float32s, part: float, due: list[Int32s]) -> None:
        self._lists = lists = gather(garden.clump_sphere, packed, self._lists, self._culled)
        if garden not in self._shared:
            self._shared[garden] = _Shared(self._context, self._queue, garden)
        shared = self._shared[garden]
        shared.lend()
        copied = (packed, lists.first, lists.member[: lists.first[-1]], np.concatenate(due))
        flags = _READ | cl.mem_flags.COPY_HOST_PTR
        *seen, order = [cl.Buffer(self._context, flags, hostbuf=_whole(plane)) for plane in copied]
        strands = len(garden.strands)
        arguments = (order, *shared.buffers[:strands], *seen, *shared.buffers[strands:])
        end = 0
        for bundles in due:
            begin, end = end, end + len(bundles)
            groups = -(-len(bundles) // self._local_size)
            size = (groups * self._local_size,), (self._local_size,)
            self._kernel(self._queue, *size, begin, end, part, *arguments)
        shared.take_back()


def _sample() -> tuple[Garden, Float32s]:
    """Return a garden and a flow that lead through every branch of the kernel."""
    along = 0.1 * np.arange(6.0)
    stems = np.zeros((9, 6, 3))
    stems[:, :, 0], stems[:, :, 2] = 0.1 * np.arange(9)[:, None] + along**2, along
    every = np.arange(9, dtype=np.int32)
    riding = Carriers(0, every, every * 0 + 5)
    stem = Tuft(stems, np.full(6, 0.03), ground=(0.0, 0.0, 1.0, 0.0))
    blades = Tuft(stems + stems[:, -1:], np.full(6, 0.01), carriers=riding)
    rocks = np.array([[0.2, 0.1, 0.2]]), np.array([[0.1, 0.2, 0.1]]), np.array([[0.6, 0.8]])
    table = SingularityTable(4)
    table.kind[:4] = (0, 1, 2, 3)
    table.position[:4] = ((0.0, 0.0, 0.3), (0.5, 0.1, 0.4), (0.2, 0.1, 0.2), (0.0, 0.0, 0.0))
    table.axis[:4, 1], table.intensity[:4], table.softening[:4] = 1.0, 0.5, 0.05
    table.reach[:3], table.amplitude[:4], table.wave_number[:4] = 1.0, 0.5, 1.0
    return Garden([stem, blades], rocks), pack(table, 0)


def self_test() -> None:
    """Build the kernel, run it and hold it against the twin. Raise SystemExit with a reason where it fails."""
    (own, packed), (other, _) = _sample(), _sample()
    try:
        device, twin = OpenCLBender(least_nodes=0), NumbaBender(parallel=False)
        for _ in range(_STEPS):
            device.step(own, packed, _FRAME)
            twin.step(other, packed, _FRAME)
    except DeviceError as fault:
        raise SystemExit(str(fault)) from fault
    if not np.abs(own.position - other.position).max() < _TOLERANCE:
        raise SystemExit("the device does not compute what its twin does")
