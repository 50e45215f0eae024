"""Where the jobs of many captures run: in this process, in some of its own, or on a Dask cluster.

A job is a module-level function and its arguments, and gives the same result wherever it runs. One whose worker is
lost runs again elsewhere, a few times; results come as they are ready, by the name that each job was given.
"""

import asyncio
import logging
import signal
from collections.abc import Callable, Hashable, Iterator
from concurrent.futures import (
    FIRST_COMPLETED,
    CancelledError,
    Executor,
    Future,
    ProcessPoolExecutor,
    wait,
)
from concurrent.futures.process import BrokenProcessPool
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from typing import Any, Final, NamedTuple

from components.fault import FaultError
from components.kernels import sources_hash

TRIES: Final = 4
"""How often a job is begun before its workers' ends are taken for its own fault."""

_LOOK_SECONDS: Final = 5.0
"""Between two looks whether anybody is left to do the work."""


class FarmError(FaultError):
    """The work cannot go on: nobody is there to do it, or it kills who does it. One line."""


class Job(NamedTuple):
    """Work that was handed in."""

    name: Hashable
    function: Callable[..., Any]
    arguments: tuple[Any, ...]
    tries: int


class Farm:
    """Runs jobs on an executor; opens another where that one breaks. Close it after use: it is a context manager."""

    def __init__(
        self,
        opener: Callable[[], Executor],
        width: int,
        lost: tuple[type[BaseException], ...] = (),
        hopeless: tuple[type[BaseException], ...] = (),
        look: Callable[[], None] = lambda: None,
    ) -> None:
        """`lost` are the exceptions that mean a lost worker, `hopeless` those that mean several of the same job.

        `look` raises FarmError where all workers are gone.
        """
        self.width = width
        "how many jobs run at once"
        self._opener, self._lost, self._hopeless, self._look = opener, lost, hopeless, look
        self._executor = opener()
        self._jobs: dict[Future[Any], Job] = {}

    def __enter__(self) -> "Farm":
        return self

    def __exit__(self, *_: object) -> None:
        self._executor.shutdown(wait=False, cancel_futures=True)

    def submit(self, name: Hashable, function: Callable[..., Any], *arguments: Any) -> None:
        """Hand in a job; its result will come under `name`."""
        self._begin(Job(name, function, arguments, 1))

    def results(self) -> Iterator[tuple[Hashable, Any]]:
        """Yield (name, result) of each job as it is ready, until none is left; more may be handed in meanwhile.

        Raise FarmError where nobody can do the work, and what a job raised.
        """
        while self._jobs:
            ready, _ = wait(self._jobs, timeout=_LOOK_SECONDS, return_when=FIRST_COMPLETED)
            if not ready:
                self._look()
            for future in ready:
                job = self._jobs.pop(future)
                try:
                    result = future.result()
                except self._hopeless as error:
                    raise _deadly(error) from None
                except self._lost as error:
                    self._again(job, error)
                    continue
                yield job.name, result

    def _begin(self, job: Job) -> None:
        try:
            future = self._executor.submit(job.function, *job.arguments)
        except BrokenProcessPool:
            self._executor.shutdown(wait=False)
            self._executor = self._opener()
            future = self._executor.submit(job.function, *job.arguments)
        self._jobs[future] = job

    def _again(self, job: Job, error: BaseException) -> None:
        self._look()
        if job.tries == TRIES:
            raise _deadly(error)
        self._begin(job._replace(tries=job.tries + 1))


def _deadly(error: BaseException) -> FarmError:
    reason = str(error).strip().partition("\n")[0] or type(error).__name__
    return FarmError(f"workers were lost again and again at the same work: {reason}")


class _Here(Executor):
    """Runs each job at once, in this process."""

    def submit(self, function: Callable[..., Any], /, *arguments: Any, **named: Any) -> Future[Any]:
        """Return the finished job. Raise what it raises."""
        future: Future[Any] = Future()
        future.set_result(function(*arguments, **named))
        return future


def local(jobs: int) -> Farm:
    """Return a farm of so many processes of this machine; with one, the work is done in this process."""
    if jobs == 1:
        return Farm(_Here, 1)
    return Farm(partial(_processes, jobs), jobs, (BrokenProcessPool,))


def _processes(jobs: int) -> Executor:
    # Spawned, never forked: numba's threads do not survive a fork.
    return ProcessPoolExecutor(jobs, get_context("spawn"), initializer=_leave_interrupts)


def _leave_interrupts() -> None:
    """Let Ctrl-C end the process that waits for the work, quietly, not each of those that do it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def cluster(address: str, patience: float = 10.0) -> Farm:
    """Return the farm of the Dask scheduler at `address`; it and one worker must answer within `patience` [s].

    Raise FarmError where they do not, or where distributed is not installed.
    """
    try:
        from distributed import Client
        from distributed.comm.core import connect
        from distributed.scheduler import KilledWorker
    except ImportError:
        raise FarmError("--scheduler needs Dask: pip install 'reefgame[farm]'") from None
    for name in ("distributed", "distributed.client"):
        logging.getLogger(name).setLevel(logging.CRITICAL)  # what matters is raised
    try:
        # A client that nobody answers leaves threads behind that end with a traceback.
        asyncio.run(_knock(connect, address, patience))
        opener: Any = Client
        client = opener(address, timeout=patience, set_as_default=False)
    except (OSError, ValueError) as error:
        reason = str(error).strip().partition("\n")[0] or "no answer"
        raise FarmError(f"{address}: no Dask scheduler answers: {reason}") from None
    try:
        client.wait_for_workers(1, timeout=patience)
    except OSError:
        client.close()
        raise FarmError(f"{address}: the Dask scheduler has no worker") from None
    return _DaskFarm(client, address, patience, (KilledWorker,))


async def _knock(connect: Any, address: str, patience: float) -> None:
    """Raise OSError or ValueError where no scheduler answers."""
    await (await connect(address, timeout=patience)).close()


class _DaskFarm(Farm):
    """A farm whose jobs run on a cluster, each checked to be of this very version of the game."""

    def __init__(
        self, client: Any, address: str, patience: float, killed: tuple[type[BaseException], ...]
    ) -> None:
        self._client, self._address, self._patience = client, address, patience
        width = sum(client.nthreads().values())
        opener = partial(client.get_executor, pure=False)
        super().__init__(opener, width, (CancelledError,), killed, self._inhabited)

    def __exit__(self, *_: object) -> None:
        self._executor.shutdown(wait=False)
        self._client.close()

    def submit(self, name: Hashable, function: Callable[..., Any], *arguments: Any) -> None:
        super().submit(name, same_version, _version(), function, *arguments)

    def _inhabited(self) -> None:
        """Raise FarmError where scheduler or workers are gone and do not come back."""
        try:
            self._client.wait_for_workers(1, timeout=self._patience)
        except (OSError, ValueError) as error:
            gone = "all workers are" if self._client.status == "running" else "the scheduler is"
            raise FarmError(f"{self._address}: {gone} gone: {error}") from None


def _version() -> str:
    return sources_hash(Path(__file__).with_name("tune.py"))


def same_version(version: str, function: Callable[..., Any], *arguments: Any) -> Any:
    """Return the function's result. Raise FarmError where this process runs another version than who asks."""
    if version != _version():
        raise FarmError("a worker runs another version of the game, of Python or of numba")
    return function(*arguments)
