"""What bends plants, as papers/002 shows it: every scene of sea/ comes true, and without the cause nothing moves.

`python -m pytest tests/scenes/test_sea_scenes.py -m prove` holds the table of docs/sea.md to the truth, with `--bless`
it writes the table anew. Golden frames of the same scenes: tests/view/test_sea_figures.py.
"""

from pathlib import Path

import numpy as np
import pytest

from reefgame.content import ContentError
from reefgame.testing import FIBRE_MEASURES, Scene, Sway, read_scene, sway

SEA = Path(__file__).parent / "sea"
PAGE = SEA.parents[2] / "docs" / "sea.md"
SCENES = sorted(path.stem for path in SEA.glob("*.yaml"))
AT_REST = 1e-5
"""[m] of float32 positions and their rounding, ten metres from the origin."""

Seen = tuple[Scene, Sway]


@pytest.fixture(scope="module", params=SCENES)
def seen(request: pytest.FixtureRequest) -> Seen:
    """Each scene, and what was seen of its plants."""
    scene = read_scene(SEA / f"{request.param}.yaml")
    return scene, sway(scene)


def measured(scene: Scene, seen: Sway) -> dict[str, float]:
    """Return what is measured, by measure and flora."""
    return {
        f"{one.measure} of {one.of}": FIBRE_MEASURES[one.measure](seen, one.of, one.to)
        for one in scene.file.fibres
    }


def meets(scene: Scene, values: dict[str, float]) -> list[bool]:
    """Return which expectations come true; NaN meets none."""
    bounds = [(one.at_least, one.at_most) for one in scene.file.fibres]
    return [
        (low is None or value >= low) and (high is None or value <= high) and value == value
        for value, (low, high) in zip(values.values(), bounds, strict=True)
    ]


def test_a_scene_comes_true(seen: Seen) -> None:
    scene, plants = seen
    values = measured(scene, plants)
    assert all(meets(scene, values)), values


def test_without_the_cause_nothing_moves(seen: Seen) -> None:
    control = seen[0].control
    assert control is not None
    still = sway(control)
    assert np.abs(still.moved).max() < AT_REST
    assert not all(meets(control, measured(control, still)))


def row(scene: Scene, values: dict[str, float]) -> str:
    """Return the scene's row of the table: claim, and what was measured, to a tenth of a millimetre."""
    words = "; ".join(f"{name} {round(value, 4) + 0.0:.2g}" for name, value in values.items())
    name = f"[{scene.name}](../tests/scenes/sea/{scene.name}.yaml)"
    return f"| {name} | {scene.file.title} | {words} |"


@pytest.mark.prove
def test_the_page_tells_what_is_measured(seen: Seen, bless: bool) -> None:
    scene, plants = seen
    line, page = row(scene, measured(scene, plants)), PAGE.read_text(encoding="utf-8")
    if bless:
        begin = page.index(f"| [{scene.name}]")
        PAGE.write_text(page[:begin] + line + page[page.index("\n", begin) :], encoding="utf-8")
    else:
        assert line in page


@pytest.mark.parametrize(
    ("old", "new", "where"),
    [
        ("to_flow_m, of: anthothoe", "to_flow, of: anthothoe", "there is no measure 'to_flow'; "),
        ("to_flow_m, of: anthothoe", "to_flow_m, of: kelp", "there is no flora among the plants"),
        (", at_most: -0.05", "", "nothing is expected: say `at_least` or `at_most`"),
        ("at_most: -0.05", "to: tang", "there is no group 'tang'"),
    ],
)
def test_what_fibres_cannot_do_is_named(tmp_path: Path, old: str, new: str, where: str) -> None:
    text = (SEA / "source.yaml").read_text(encoding="utf-8")
    if "to:" in new:
        new += ", at_most: 0"
    path = tmp_path / "bad.yaml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ContentError) as caught:
        read_scene(path)
    assert where in str(caught.value)


def test_a_scene_that_claims_nothing_is_refused(tmp_path: Path) -> None:
    text = (SEA / "source.yaml").read_text(encoding="utf-8")
    path = tmp_path / "bad.yaml"
    begin, end = text.index("fibres:"), text.index("picture:")
    path.write_text(text[:begin] + text[end:], encoding="utf-8")
    with pytest.raises(ContentError, match="nothing is claimed"):
        read_scene(path)


def test_the_page_s_own_scene_comes_true(tmp_path: Path) -> None:
    page = PAGE.read_text(encoding="utf-8")
    text = page[page.index("title: Seagrass") :]
    path = tmp_path / "own.yaml"
    path.write_text(text[: text.index("```")], encoding="utf-8")
    scene = read_scene(path)
    assert meets(scene, measured(scene, sway(scene))) == [True]
