"""Ethology as tests: every scene of this folder comes true, and its control does not.

Three seeds by default, with long scenes cut short; `make prove` plays twenty in full, prints each scene's rate, and
holds the table of docs/minds.md to it. `python -m pytest tests/scenes -m prove --bless` writes the table anew.
"""

from pathlib import Path

import numpy as np
import pytest

from reefgame.testing import Outcome, Scene, read_scene, watch

HERE = Path(__file__).parent
PAGE = HERE.parents[1] / "docs" / "minds.md"
SCENES = sorted(path.stem for path in HERE.glob("*.yaml"))
SEEDS = range(20)
LEAST = 18
SHORT_S = 60.0


@pytest.fixture(scope="module", params=SCENES)
def scene(request: pytest.FixtureRequest) -> Scene:
    """Each scene, read once."""
    return read_scene(HERE / f"{request.param}.yaml")


def test_a_scene_comes_true(scene: Scene) -> None:
    """Of twenty seeds two may miss, so of three one may."""
    outcomes = [watch(scene, seed, SHORT_S) for seed in range(3)]
    assert sum(outcome.passed for outcome in outcomes) >= 2, outcomes


def test_a_control_does_not_come_true(scene: Scene) -> None:
    assert scene.control is not None
    assert not watch(scene.control, 0, SHORT_S).passed


@pytest.mark.prove
@pytest.mark.timeout(3600)
def test_a_scene_comes_true_eighteen_times_of_twenty(
    scene: Scene, bless: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    assert scene.control is not None
    outcomes = [watch(scene, seed) for seed in SEEDS]
    failed = sum(not watch(scene.control, seed, SHORT_S).passed for seed in SEEDS)
    line = row(scene, outcomes, failed)
    with capsys.disabled():
        print("\n" + line)
    assert sum(outcome.passed for outcome in outcomes) >= LEAST
    assert failed >= LEAST
    page = PAGE.read_text(encoding="utf-8")
    if bless:
        begin = page.index(f"| [{scene.name}]")
        PAGE.write_text(page[:begin] + line + page[page.index("\n", begin) :], encoding="utf-8")
    else:
        assert line in page


def row(scene: Scene, outcomes: list[Outcome], failed: int) -> str:
    """Return the scene's row of the table: claim, rates, and the median of what was measured, by group or variant."""
    measured: dict[str, list[str]] = {}
    for index, one in enumerate(scene.file.expect):
        values = np.array([outcome.values[index] for outcome in outcomes])
        middle = [f"{value:.2g}" for value in np.median(values, axis=0) + 0.0]
        measured.setdefault(one.measure, []).extend(middle)
    words = "; ".join(f"{name} {', '.join(middle)}" for name, middle in measured.items())
    passed = sum(outcome.passed for outcome in outcomes)
    name = f"[{scene.name}](../tests/scenes/{scene.name}.yaml)"
    many = len(outcomes)
    claim = f"| {name} | {scene.file.title} | {passed} of {many} | {failed} of {many} |"
    return f"{claim} {words} |"
