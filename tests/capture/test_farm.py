"""The farm: work goes on when a worker is lost, on processes and on a Dask cluster, and ends clearly when it cannot."""

import os
import signal
import sys
from concurrent.futures import Executor, Future
from pathlib import Path
from typing import Any

import pytest
from distributed import LocalCluster as UntypedLocalCluster
from distributed.scheduler import KilledWorker

from components.body import Body
from tools.capture import evolve, farm, tune
from tools.capture.farm import Farm, FarmError, cluster, local, same_version
from tools.capture.tune import Subject

LocalCluster: Any = UntypedLocalCluster
DIE_ONCE = (
    "__import__('os').path.exists({0!r}) and 7 or (open({0!r}, 'x'), __import__('os')._exit(1))"
)


class Troubled(Executor):
    """Fails each job so many times."""

    def __init__(self, failures: int, error: Exception) -> None:
        self.failures, self.error = failures, error

    def submit(self, function: Any, /, *arguments: Any, **named: Any) -> Future[Any]:
        future: Future[Any] = Future()
        if self.failures:
            self.failures -= 1
            future.set_exception(self.error)
        else:
            future.set_result(function(*arguments))
        return future


def test_results_come_by_name_and_work_may_be_added_meanwhile() -> None:
    found = {}
    with local(1) as here:
        here.submit("a", max, 1, 2)
        for name, result in here.results():
            found[name] = result
            if name == "a":
                here.submit("b", max, 3, 4)
    assert found == {"a": 2, "b": 4}


def test_work_whose_process_died_is_done_by_another(tmp_path: Path) -> None:
    with local(2) as two:
        two.submit("dies", eval, DIE_ONCE.format(str(tmp_path / "died")))
        two.submit("lives", max, 1, 2)
        assert dict(two.results()) == {"dies": 7, "lives": 2}
    assert (tmp_path / "died").exists()


def test_work_that_kills_every_process_ends_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(farm, "TRIES", 2)
    with local(2) as two:
        two.submit("dies", os._exit, 1)
        with pytest.raises(FarmError, match="lost again and again at the same work"):
            list(two.results())


def test_lost_work_is_begun_again_so_often_and_no_more() -> None:
    lost = ConnectionError("gone")
    patient = Farm(lambda: Troubled(farm.TRIES - 1, lost), 1, (ConnectionError,))
    patient.submit("a", max, 1, 2)
    assert dict(patient.results()) == {"a": 2}
    weary = Farm(lambda: Troubled(farm.TRIES, lost), 1, (ConnectionError,))
    weary.submit("a", max, 1, 2)
    with pytest.raises(FarmError, match="gone"):
        list(weary.results())


def test_work_that_the_cluster_gave_up_is_not_begun_again() -> None:
    killed = ValueError("killed workers")
    executor = Troubled(1, killed)
    once = Farm(lambda: executor, 1, (), (ValueError,))
    once.submit("a", max, 1, 2)
    with pytest.raises(FarmError, match="killed workers"):
        list(once.results())
    assert issubclass(KilledWorker, Exception)


def test_a_worker_of_another_version_is_refused() -> None:
    assert same_version(farm._version(), max, 1, 2) == 2
    with pytest.raises(FarmError, match="another version"):
        same_version("other", max, 1, 2)


@pytest.mark.parametrize("name", ["sardine"])
def test_a_cluster_that_loses_a_worker_finds_what_one_process_does(
    body: Body, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(evolve, "GENERATIONS", 2)
    monkeypatch.setattr(tune, "SHORTLIST", 1)
    monkeypatch.setattr(tune, "ATTEMPTS", 1)
    subject = Subject("Fish", body, 0.2)
    with local(1) as here:
        (alone,) = tune.tune([subject], 0, here)
    killed: list[int] = []

    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as two:

        def kill_one(done: float, what: str) -> None:
            if not killed:
                killed.append(two.workers[0].pid)
                os.kill(killed[0], signal.SIGKILL)

        with cluster(two.scheduler_address) as there:
            assert there.width == 2
            (together,) = tune.tune([subject], 0, there, None, kill_one)
    assert killed
    assert together.found == alone.found
    assert together.repertoire is not None
    assert alone.repertoire is not None
    assert together.repertoire.provenance == alone.repertoire.provenance


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "nowhere", "", "foo://a:1"])
def test_an_absent_scheduler_is_one_line(address: str) -> None:
    with pytest.raises(FarmError, match="no Dask scheduler answers") as raised:
        cluster(address, patience=0.5)
    assert "\n" not in str(raised.value)


def test_a_scheduler_without_workers_is_one_line() -> None:
    with (
        LocalCluster(n_workers=0, dashboard_address=None) as empty,
        pytest.raises(FarmError, match="the Dask scheduler has no worker"),
    ):
        cluster(empty.scheduler_address, patience=0.5)


def test_missing_packages_are_named_with_their_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(FarmError, match=r"pip install 'reefgame\[farm\]'"):
        cluster("tcp://127.0.0.1:1")
    monkeypatch.setitem(sys.modules, "cma", None)
    with pytest.raises(evolve.MissingError, match=r"pip install 'reefgame\[capture\]'"):
        evolve.Search(0)
