"""docs/motion.md tells the truth: its tables and pictures are those of the shipped repertoires.

`make bless`, or `python -m pytest tests/docs/test_motion_page.py --bless`, makes them anew.
"""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from components.repertoire import Repertoire
from reefgame.content import load_species
from tools.capture.report.documents import pictures, rewritten, tables
from tools.capture.report.subject import Subject

DOCS = Path(__file__).resolve().parents[2] / "docs"
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
NEAR = 0.3
"""[px] that a machine's own rounding may move a line of a picture."""

NINE = (
    "sardine", "clownfish", "blue_tang", "butterflyfish", "parrotfish", "angelfish", "anthias",
    "barracuda", "reef_shark",
)  # fmt: skip


@pytest.fixture
def subjects() -> list[Subject]:
    """The nine shipped species."""
    found = [(name, load_species(name)) for name in NINE]
    return [Subject(name, s.title, s.length, s.body, s.repertoire) for name, s in found]


@pytest.mark.golden
def test_the_tables_are_those_of_the_shipped_repertoires(
    subjects: list[Subject], bless: bool
) -> None:
    page = DOCS / "motion.md"
    made = rewritten(page.read_text(encoding="utf-8"), tables(subjects))
    if bless:
        page.write_text(made, encoding="utf-8", newline="\n")
    assert page.read_text(encoding="utf-8") == made


@pytest.mark.golden
def test_the_pictures_are_those_of_the_shipped_repertoires(
    subjects: list[Subject], bless: bool
) -> None:
    folder = DOCS / "pictures"
    drawn = pictures(subjects)
    if bless:
        for name, picture in drawn.items():
            (folder / name).write_text(picture, encoding="utf-8", newline="\n")
    assert sorted(path.name for path in folder.glob("motion_*")) == sorted(drawn)
    for name, picture in drawn.items():
        kept = (folder / name).read_text(encoding="utf-8")
        assert NUMBER.sub("#", kept) == NUMBER.sub("#", picture), name
        pairs = zip(NUMBER.findall(kept), NUMBER.findall(picture), strict=True)
        assert max(abs(float(a) - float(b)) for a, b in pairs) < NEAR, name


def test_the_page_shows_every_picture_of_motion(subjects: list[Subject]) -> None:
    text = (DOCS / "motion.md").read_text(encoding="utf-8")
    shown = re.findall(r"!\[[^\]]+\]\(pictures/(motion_\w+\.svg)\)", text)
    assert sorted(shown) == sorted(pictures(subjects))


def test_a_figure_outside_of_what_living_fishes_do_is_bold_and_named(
    subjects: list[Subject],
) -> None:
    sardine = subjects[0]
    halved = tuple(replace(s, shape=np.float32(0.5) * s.shape) for s in sardine.repertoire.segments)
    shy = replace(sardine, title="Shy", repertoire=Repertoire(halved, {}), length=3.0)
    made = tables([sardine, shy])
    row = next(line for line in made["swims"].splitlines() if line.startswith("| Shy"))
    assert row.count("**") >= 2 * 4
    outside = {line.split(" | ")[0]: line.split(" | ")[-1] for line in made["living"].splitlines()}
    assert outside["| sweep of the tail, BL"] == "shy |"
    assert outside["| Strouhal number"] == "shy |"
    assert outside["| cruise of reef sharks, m/s"] == "all |"
    assert outside["| cruise of small fishes, BL/s"] == "none |"


def test_a_page_without_a_place_for_a_table_is_refused() -> None:
    with pytest.raises(ValueError, match="0 places for the table swims"):
        rewritten("# Motion\n", {"swims": "| |"})
    text = rewritten("a\n<!-- swims -->\nold\n<!-- end -->\nb", {"swims": "| new |"})
    assert text == "a\n<!-- swims -->\n\n| new |\n\n<!-- end -->\nb"
