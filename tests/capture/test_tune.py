"""Tuning: bodies alone end with usable repertoires, the same bits on any farm, and nothing computed is lost."""

import random
from collections.abc import Iterator
from dataclasses import replace
from math import inf, nan
from pathlib import Path

import numpy as np
import pytest

from components.body import Body
from components.repertoire import Pattern, Repertoire
from tools.capture import evolve, tune
from tools.capture.capture import fingerprint
from tools.capture.evolve import POPULATION, Search
from tools.capture.farm import Farm, local
from tools.capture.record import BlewUpError
from tools.capture.search import FAILED, START, Aim, Candidate, aim_of, candidate, cost, costs
from tools.capture.tune import Subject, Tuned
from tools.capture.usable import unusable


def random_subject(seed: int) -> Subject:
    """Return a fish-like body and length: slender to disc-shaped, 5 cm to 2 m."""
    draw = random.Random(seed).uniform
    first, last = draw(0.10, 0.17), draw(0.75, 0.85)
    steps = (0.0, *(draw(-0.1, 0.1) for _ in range(3)), 0.0)
    station = [first + (last - first) * (k + step) / 4 for k, step in enumerate(steps)]
    depth, width = draw(0.06, 0.27), draw(0.04, 0.08)
    heights = (draw(0.4, 0.65), draw(0.85, 1.0), 1.0, draw(0.65, 0.85), draw(0.2, 0.4))
    widths = (draw(0.6, 0.75), 1.0, draw(0.88, 1.0), draw(0.58, 0.7), draw(0.22, 0.33))
    body = Body(
        tuple(round(x, 3) for x in station),  # type: ignore[arg-type]
        tuple(round(width * w, 3) for w in widths),  # type: ignore[arg-type]
        tuple(round(depth * h, 3) for h in heights),  # type: ignore[arg-type]
        round(draw(0.09, 0.15), 3),
    )
    return Subject(f"fish {seed}", body, round(0.05 * 40 ** draw(0.0, 1.0), 3))


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Searches of two generations, of which the best alone is captured."""
    monkeypatch.setattr(evolve, "GENERATIONS", 2)
    monkeypatch.setattr(tune, "SHORTLIST", 1)
    monkeypatch.setattr(tune, "ATTEMPTS", 1)


@pytest.fixture
def subject(body: Body) -> Subject:
    return Subject("Fish", body, 0.2)


def not_tried(aim: Aim, found: Candidate) -> tuple[Candidate, None, tuple[str, ...]]:
    """Stand in for the capture of a candidate."""
    return found, None, ("not tried",)


class CountingFarm(Farm):
    """A farm of this process that counts what it is given."""

    def __init__(self) -> None:
        here = local(1)
        super().__init__(here._opener, 1)
        self.given: list[object] = []

    def submit(self, name: object, function: object, *arguments: object) -> None:
        self.given.append(function)
        super().submit(name, function, *arguments)  # type: ignore[arg-type]


def outcome(
    subject: Subject, farm: Farm, folder: Path | None = None, seed: int = 0
) -> tuple[Tuned, Repertoire]:
    """Return what tuning one subject came to."""
    with farm:
        (tuned,) = tune.tune([subject], seed, farm, folder)
    assert tuned.repertoire is not None
    return tuned, tuned.repertoire


def same(one: Repertoire, other: Repertoire) -> bool:
    """Return whether two repertoires hold the same bits."""
    return one.provenance == other.provenance and all(
        np.array_equal(a.shape, b.shape) and np.array_equal(a.rotation, b.rotation)
        for a, b in zip(one.segments, other.segments, strict=True)
    )


def usable_of(seeds: range) -> Iterator[tuple[int, Tuned]]:
    """Tune random bodies in two processes and yield what each came to."""
    with local(2) as farm:
        for tuned in tune.tune([random_subject(seed) for seed in seeds], 0, farm):
            yield seeds[tuned.number], tuned


def test_three_random_bodies_end_with_usable_repertoires() -> None:
    found = dict(usable_of(range(3)))
    assert sorted(found) == [0, 1, 2]
    for seed, tuned in found.items():
        assert tuned.faults == ()
        assert tuned.repertoire is not None
        assert unusable(tuned.repertoire) == []
        body = replace(random_subject(seed).body, stiffness=tuned.found.stiffness)
        assert tuned.repertoire.provenance["fingerprint"] == fingerprint(body, tuned.found.swim)


@pytest.mark.prove
@pytest.mark.timeout(3600)
def test_at_least_48_of_50_random_bodies_end_with_usable_repertoires() -> None:
    found = dict(usable_of(range(50)))
    failed = {seed: tuned.faults for seed, tuned in found.items() if tuned.faults}
    print(f"{50 - len(failed)} of 50 bodies are usable; {failed}")
    assert len(found) == 50
    assert len(failed) <= 2
    assert all(fault for faults in failed.values() for fault in faults)


@pytest.mark.parametrize("name", ["blue_tang"])
@pytest.mark.usefixtures("short")
def test_any_number_of_processes_finds_the_same_bits(subject: Subject, tmp_path: Path) -> None:
    one, made = outcome(subject, local(1), tmp_path / "one")
    two, again = outcome(subject, local(2), tmp_path / "two")
    assert two.found == one.found
    assert same(made, again)
    (kept,), (other,) = (list((tmp_path / place).iterdir()) for place in ("one", "two"))
    assert kept.name == other.name
    assert kept.read_bytes() == other.read_bytes()


@pytest.mark.parametrize("name", ["sardine"])
@pytest.mark.usefixtures("short")
def test_a_run_that_was_interrupted_goes_on(subject: Subject, tmp_path: Path) -> None:
    def interrupt(done: float, what: str) -> None:
        raise KeyboardInterrupt

    with CountingFarm() as farm, pytest.raises(KeyboardInterrupt):
        list(tune.tune([subject], 0, farm, tmp_path, interrupt))
    going_on, anew = CountingFarm(), CountingFarm()
    resumed, made = outcome(subject, going_on, tmp_path)
    fresh, other = outcome(subject, anew)
    assert going_on.given.count(costs) == 1
    assert anew.given.count(costs) == 2
    assert resumed.found == fresh.found
    assert same(made, other)


@pytest.mark.parametrize("name", ["sardine"])
@pytest.mark.parametrize(
    "damage", [b"", b"{", b"[]", b'{"costs": [[[1.0]]]}', b'{"costs": [[[NaN]]]}', b"\xff"]
)
@pytest.mark.usefixtures("short")
def test_damaged_state_counts_for_nothing(
    subject: Subject, tmp_path: Path, damage: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tune, "captured", not_tried)
    with local(1) as farm:
        (before,) = tune.tune([subject], 0, farm, tmp_path)
    (kept,) = tmp_path.iterdir()
    whole = kept.read_bytes()
    kept.write_bytes(damage)
    counting = CountingFarm()
    (after,) = tune.tune([subject], 0, counting, tmp_path)
    assert counting.given.count(costs) == 2
    assert after == before
    assert kept.read_bytes() == whole


@pytest.mark.parametrize("name", ["sardine"])
@pytest.mark.usefixtures("short")
def test_state_that_cannot_be_kept_changes_nothing(
    subject: Subject, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tune, "captured", not_tried)
    (tmp_path / "file").write_text("a file, not a folder", encoding="ascii")
    with local(1) as farm:
        (unkept,) = tune.tune([subject], 0, farm, tmp_path / "file" / "tuning")
        (kept,) = tune.tune([subject], 0, farm, tmp_path / "tuning")
    assert unkept == kept


def test_a_search_follows_from_its_seed_and_leaves_numpys_chance_alone() -> None:
    np.random.seed(5)  # noqa: NPY002 (that it is not touched)
    before = np.random.random()  # noqa: NPY002
    np.random.seed(5)  # noqa: NPY002
    one, other, third = Search(1), Search(1), Search(2)
    for search in (one, other, third):
        search.tell([float(sum(place)) for place in search.places])
    assert np.random.random() == before  # noqa: NPY002
    assert one.places == other.places
    assert one.places != third.places
    assert Search(1, attempt=1).places != Search(1).places


def test_a_search_ends_and_lists_its_best_apart_from_each_other() -> None:
    search = Search(3)
    while not search.done:
        search.tell([float(sum((u - 0.3) ** 2 for u in place)) for place in search.places])
    assert 5 < len(search.history) <= evolve.GENERATIONS
    listed = search.shortlist(3)
    assert len(listed) == 3
    assert sum((u - 0.3) ** 2 for u in listed[0]) == search.cost
    assert max(abs(a - b) for a, b in zip(listed[0], listed[1], strict=True)) > 0.05


def test_a_search_where_nothing_swims_ends_soon() -> None:
    search = Search(3)
    while not search.done:
        search.tell([FAILED] * POPULATION)
    assert len(search.history) == 5
    with pytest.raises(ValueError, match="1 costs of 10 places"):
        search.tell([0.0])


def test_small_fishes_aim_at_one_to_three_lengths_a_second_and_large_ones_at_less(
    body: Body,
) -> None:
    speeds = [aim_of(body, length).speed for length in (0.05, 0.1, 0.2, 0.4, 1.0, 2.0)]
    assert speeds == sorted(speeds, reverse=True)
    assert 1.0 <= speeds[3] <= speeds[0] <= 3.0
    assert 0.6 <= speeds[-1] < 1.0


def test_a_lifelike_swim_costs_less_than_a_limp_or_a_wild_one(body: Body) -> None:
    aim = aim_of(body, 0.2)
    middle = candidate(aim, START)
    wild = middle._replace(
        swim=replace(middle.swim, contraction_middle=0.6, contraction_rear=0.7, lag_deg=60.0)
    )
    limp = middle._replace(swim=replace(middle.swim, contraction_middle=0.05, contraction_rear=0.1))
    assert cost(aim, middle) < 1.0
    assert cost(aim, wild) > 2.0
    assert cost(aim, limp) > 2.0


@pytest.mark.parametrize(
    ("change", "wrong"),
    [
        ({"station": (0.5, 0.4, 0.3, 0.2, 0.1)}, "stations must rise"),
        ({"half_width": (0.03, 1000.0, 0.03, 0.03, 0.03)}, "half_width 2 is 1000"),
        ({"half_height": (0.03, 0.03, inf, 0.03, 0.03)}, "half_height 3 is inf"),
        ({"tail_span": nan}, "tail_span is nan"),
    ],
)
def test_a_body_that_cannot_be_costs_most_and_says_why(
    body: Body, change: dict[str, tuple[float, ...]], wrong: str
) -> None:
    aim = aim_of(replace(body, **change), 0.2)  # type: ignore[arg-type]
    tried = candidate(aim, START)
    assert cost(aim, tried) == FAILED
    _, repertoire, (reason,) = tune.captured(aim, tried)
    assert repertoire is None
    assert wrong in reason


def test_a_simulation_that_blows_up_costs_most_and_says_when(
    body: Body, monkeypatch: pytest.MonkeyPatch
) -> None:
    def blow_up(*_: object) -> None:
        raise BlewUpError(5)

    monkeypatch.setattr("tools.capture.search.record", blow_up)
    monkeypatch.setattr("tools.capture.capture.record", blow_up)
    aim = aim_of(body, 0.2)
    tried = candidate(aim, START)
    assert cost(aim, tried) == FAILED
    _, repertoire, (reason,) = tune.captured(aim, tried)
    assert repertoire is None
    assert reason.startswith("the simulation blows up at frame 5: ")


def test_a_body_of_no_width_is_given_up_with_a_reason(body: Body) -> None:
    subject = Subject("Sheet", replace(body, half_width=(0.0,) * 5), 0.2)
    with local(1) as farm:
        (tuned,) = tune.tune([subject], 0, farm)
    assert tuned.repertoire is None
    assert tuned.faults


def test_a_shipped_repertoire_is_usable_and_a_poor_one_is_not(shipped: Repertoire) -> None:
    assert unusable(shipped) == []
    slow = {**shipped.provenance, "warnings": "swim_slow: sweep; turn_left: turns 3 degrees"}
    assert unusable(replace(shipped, provenance=slow)) == ["turn_left: turns 3 degrees"]
    without = [s for s in shipped.segments if s.pattern is not Pattern.FAST_START_LEFT]
    assert unusable(replace(shipped, segments=tuple(without))) == [
        "fast_start_left: could not be captured"
    ]
    cruise = shipped.segments[Pattern.SWIM_MEDIUM]
    still = replace(cruise, translation=0.1 * cruise.translation)
    (fault,) = unusable(replace(shipped, segments=(still, *shipped.segments[3:])))
    assert fault.startswith("swim_medium: only 0.")
