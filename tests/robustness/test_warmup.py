"""The first launch shows that it compiles, with a bar that moves; later ones do nothing."""

import sys
from collections.abc import Callable
from pathlib import Path

import numba
import pytest

from components import kernels
from reefgame import opening, warmup
from reefgame.content import ContentError
from reefgame.warmup import DOING, counting_kernels, stamp, warm_up

Reports = list[tuple[float, str]]


@pytest.fixture
def reports(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Reports:
    """What a first launch tells; its stamp lies in a folder of its own, the kernels where they are."""
    place = tmp_path / "stamp"
    monkeypatch.setattr(warmup, "stamp", lambda _=False: place)
    return []


@pytest.fixture
def tell(reports: Reports) -> Callable[[float, str], None]:
    return lambda done, what: reports.append((done, what))


def test_the_second_launch_does_nothing(
    reports: Reports, tell: Callable[[float, str], None], tmp_path: Path
) -> None:
    warm_up(tell)
    assert (reports[0], reports[-1]) == ((0.0, DOING), (1.0, DOING))
    assert (tmp_path / "stamp").is_file()
    reports.clear()
    warm_up(tell)
    assert reports == []


def test_without_a_place_for_the_stamp_each_launch_warms_up(
    reports: Reports, tell: Callable[[float, str], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(warmup, "CACHED", False)
    warm_up(tell)
    warm_up(tell)
    assert [done for done, _ in reports].count(1.0) == 2


def test_a_folder_that_cannot_be_written_costs_the_stamp_alone(
    tell: Callable[[float, str], None], reports: Reports, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(warmup, "stamp", lambda _=False: Path("/dev/null/stamp"))
    warm_up(tell)
    assert reports[-1] == (1.0, DOING)


def test_without_a_terminal_there_is_nothing_to_show(
    reports: Reports, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(warmup, "_compile_all", lambda bar, _: reports.append(bar))
    warm_up()
    assert reports == []
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    warm_up()
    assert len(reports) == 1


def test_every_kernel_compiled_moves_the_bar(
    tell: Callable[[float, str], None], reports: Reports
) -> None:
    inner = numba.njit(lambda x: x + 1)
    outer = numba.njit(lambda x: inner(x) * 2)
    with counting_kernels(tell, 4):
        assert outer(1.0) == 4.0
    assert reports == [(0.25, DOING), (0.5, DOING)]
    assert outer(1) == 4
    assert len(reports) == 2


def test_the_bar_never_passes_its_end(tell: Callable[[float, str], None], reports: Reports) -> None:
    kernel = numba.njit(lambda x: x)
    with counting_kernels(tell, 1):
        assert (kernel(1), kernel(1.0)) == (1, 1.0)
    assert reports == [(1.0, DOING), (1.0, DOING)]


def test_the_stamp_lies_with_the_kernels_and_follows_their_sources(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    before = stamp()
    assert before.parent == Path(str(numba.config.CACHE_DIR))
    assert kernels.sources_hash(Path(str(warmup.__file__)))
    monkeypatch.setattr(warmup, "sources_hash", lambda _: "edited")
    assert stamp() != before


def test_a_level_that_is_not_there_is_told_before_the_long_work(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(opening, "is_warm", lambda _: False)
    monkeypatch.setattr(opening, "warm_up", lambda **_: pytest.fail("kernels were compiled"))
    with pytest.raises(ContentError, match="there is no level 'frist_dive'"):
        opening.open_level("frist_dive", [])


def test_kernels_are_compiled_once_as_a_level_opens(monkeypatch: pytest.MonkeyPatch) -> None:
    warmed: list[str] = []
    monkeypatch.setattr(opening, "is_warm", lambda _: bool(warmed))
    monkeypatch.setattr(opening, "warm_up", lambda **_: warmed.append("compiled"))
    assert opening.open_level("visitors", [], compiled=False).level.name == "visitors"
    assert warmed == []
    opening.open_level("visitors", [])
    opening.open_level("visitors", [])
    assert warmed == ["compiled"]
