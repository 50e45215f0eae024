"""The report: its figures are the capture's own, its marks are honest, its page is whole and the same each time."""

import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from components.body import Body, Swim
from components.repertoire import Pattern, Repertoire
from components.segment import heading_change
from components.trigonometry import DEGREE
from reefgame.cli import main
from tools.capture.report import ranges
from tools.capture.report.measures import SWIMS, SwimMeasures, measure_swim, measure_turn
from tools.capture.report.page import page
from tools.capture.report.replayed import replay
from tools.capture.report.silhouette import silhouette_of
from tools.capture.report.subject import Subject
from tools.capture.report.svg import Drawing, number
from tools.capture.report.tables import Cell, swim_rows, turn_rows


@pytest.fixture
def subject(name: str, body: Body, shipped: Repertoire) -> Subject:
    """A shipped species."""
    return Subject(name, name.replace("_", " "), 0.2, body, shipped)


def measured(subject: Subject, pattern: Pattern) -> SwimMeasures:
    """Return a swim's figures, which are there."""
    found = measure_swim(subject, silhouette_of(subject.body), pattern)
    assert found is not None
    return found


def row(subject: Subject, name: str) -> tuple[Cell, ...]:
    """Return the cells of a row of the swims' table."""
    gears = [measured(subject, pattern) for pattern in SWIMS]
    return next(r.cells for r in swim_rows(subject.length, gears) if r.name == name)


@pytest.mark.parametrize("pattern", SWIMS)
def test_figures_read_from_entries_are_those_the_capture_noted(
    subject: Subject, pattern: Pattern
) -> None:
    found = measured(subject, pattern)
    assert found.speed == pytest.approx(subject.noted(pattern, "speed"), abs=6e-4)
    assert found.strouhal == pytest.approx(subject.noted(pattern, "Strouhal"), abs=1.5e-3)
    assert found.sweep == pytest.approx(subject.noted(pattern, "sweep"), abs=1e-3)
    assert found.head * found.sweep == pytest.approx(subject.noted(pattern, "head"), abs=1e-3)
    assert found.closure == subject.noted(pattern, "closure")
    assert found.stride == pytest.approx(found.speed / found.frequency)


def test_a_swim_is_played_along_its_course(subject: Subject) -> None:
    segment = subject.segment(Pattern.SWIM_MEDIUM)
    assert segment is not None
    run = replay(segment, 5)
    assert run.origin[-1, 0] == pytest.approx(
        5 * measured(subject, Pattern.SWIM_MEDIUM).stride, 0.02
    )
    assert abs(run.origin[-1, 1]) < 1e-6
    nose, tail = run.nodes[:, 0], run.nodes[:, 21:].mean(axis=1)
    assert (nose[:, 0] > tail[:, 0] + 0.9).all()
    assert (run.nodes[:, 21, 2] > run.nodes[:, 22, 2]).all()


def test_a_wave_that_runs_forwards_is_marked(subject: Subject) -> None:
    backwards = subject.segment(Pattern.SWIM_MEDIUM)
    assert backwards is not None
    reversed_ = replace(backwards, shape=backwards.shape[::-1].copy())
    segments = tuple(
        reversed_ if s.pattern == Pattern.SWIM_MEDIUM else s for s in subject.repertoire.segments
    )
    turned = replace(subject, repertoire=replace(subject.repertoire, segments=segments))
    assert [cell.fits for cell in row(subject, "wave runs")] == [True, True, True]
    assert [cell.fits for cell in row(turned, "wave runs")] == [True, False, True]
    assert row(turned, "wave runs")[1].text == "forwards"


def test_figures_outside_of_what_living_fishes_do_are_marked_out(subject: Subject) -> None:
    shy = [replace(measured(subject, p), sweep=0.11, strouhal=0.41, head=0.49) for p in SWIMS]
    rows = {r.name: [cell.fits for cell in r.cells] for r in swim_rows(0.2, shy)}
    assert rows["sweep of the tail, BL"] == [False] * 3
    assert rows["Strouhal number"] == [False] * 3
    assert rows["head's sweep over the tail's"] == [True] * 3
    assert rows["frequency, Hz"] == [None] * 3


def test_a_cruise_is_held_against_fishes_of_its_size(subject: Subject) -> None:
    gears = [replace(measured(subject, p), speed=0.9) for p in SWIMS]
    marks = {length: swim_rows(length, gears)[0].cells[1].fits for length in (0.2, 0.8, 1.5)}
    assert marks == {0.2: False, 0.8: None, 1.5: False}
    slower = [replace(gear, speed=0.5) for gear in gears]
    assert swim_rows(1.5, slower)[0].cells[1].fits is True


def test_the_first_stroke_of_a_fast_start_is_held_against_a_living_one(subject: Subject) -> None:
    start = measure_turn(subject, Pattern.FAST_START_LEFT)
    assert start is not None
    rows = {r.name: r.cells for r in turn_rows(0.2, [(Pattern.FAST_START_LEFT, start)])}
    assert rows["net turn, degrees"][0].fits is True
    assert rows["first stroke takes, ms"][0].fits is (start.first_stroke[0] <= 0.04)
    quick = replace(start, first_stroke=(0.03, 80.0), net=70.0)
    rows = {r.name: r.cells for r in turn_rows(0.2, [(Pattern.FAST_START_LEFT, quick)])}
    assert rows["first stroke takes, ms"] == (Cell("30", True),)
    assert rows["net turn, degrees"] == (Cell("70", False),)


def test_a_turn_without_notes_is_measured_from_its_entries(subject: Subject) -> None:
    bare = replace(subject, repertoire=replace(subject.repertoire, provenance={}))
    segment = bare.segment(Pattern.TURN_LEFT)
    found = measure_turn(bare, Pattern.TURN_LEFT)
    assert segment is not None
    assert found is not None
    assert found.net == pytest.approx(heading_change(segment) / DEGREE)
    assert measured(bare, Pattern.SWIM_SLOW).closure is None
    assert bare.warnings() == []


def test_the_body_of_the_living_sweeps_least_behind_the_head() -> None:
    along = np.linspace(0.0, 1.0, 101)
    half = [ranges.envelope(s) for s in along.tolist()]
    assert half[0] == pytest.approx(0.02)
    assert half[-1] == pytest.approx(0.1)
    assert 0.2 < along[int(np.argmin(half))] < 0.3


def test_the_silhouette_follows_nodes_and_is_even_left_and_right(subject: Subject) -> None:
    drawn = silhouette_of(subject.body)
    for weights in (drawn.above, drawn.beside, drawn.middle, drawn.tail_beside, *drawn.fins_above):
        assert weights.sum(axis=1) == pytest.approx(1.0)
    segment = subject.segment(Pattern.SWIM_MEDIUM)
    assert segment is not None
    straight = segment.shape.astype(np.float64).mean(axis=0)
    edge = drawn.above @ straight
    assert edge[:, 2].min() == pytest.approx(-edge[:, 2].max(), abs=0.004)
    assert edge[:, 2].max() == pytest.approx(max(subject.body.half_width), abs=0.006)


def test_the_page_is_whole_and_the_same_each_time(subject: Subject) -> None:
    text = page([subject])
    assert text == page([subject])
    assert re.findall(r"(?:src|href)='(?!#)", text) == []
    assert "url(" not in text
    assert set(re.findall(r"https?://[^'\" ]+", text)) == {"http://www.w3.org/2000/svg"}
    pictures = re.findall(r"<svg.*?</svg>", text, re.DOTALL)
    assert text.count("<figure>") == 1 + len(subject.repertoire.segments)
    assert len(pictures) >= 2 + 3 + 3 * 2 + 3 * 4
    for picture in pictures:
        assert ET.fromstring(picture).tag.endswith("svg")
        assert "nan" not in picture
    for heading in (
        "Slow swim",
        "Medium swim",
        "Fast swim",
        "Gradual turn",
        "Sharp turn",
        "Fast start",
    ):
        assert f"<h4>{heading}" in text


def test_a_species_without_sharp_turns_has_a_page_and_its_warnings(subject: Subject) -> None:
    notes = {**subject.repertoire.provenance, "warnings": "swim_slow: <odd>"}
    poor = Repertoire(subject.repertoire.segments[:4], notes)
    text = page([replace(subject, repertoire=poor, title="Tom & Jerry")])
    assert "<li>swim_slow: &lt;odd&gt;</li>" in text
    assert "Tom &amp; Jerry" in text
    assert "<h4>Sharp turn" not in text


def test_numbers_are_short_and_never_minus_nought() -> None:
    assert [number(v) for v in (-0.04, 12.0, 3.26, -1.5)] == ["0", "12", "3.3", "-1.5"]
    sheet = Drawing(10, 20)
    sheet.text(1, 2, "a < b")
    assert "a &lt; b" in sheet.svg("it's")
    assert ET.fromstring(sheet.svg("it's")).attrib["aria-label"] == "it's"


@pytest.fixture
def sardine(installed: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A species whose capture takes no time: what is shipped is what is captured."""
    from components.repertoire import load

    shipped = load(installed / "assets" / "repertoires" / "sardine.npz")

    def shown(body: Body, swim: Swim, *_: object) -> Repertoire:
        return shipped

    monkeypatch.setattr("tools.capture.capture.capture", shown)
    return installed / "assets" / "species" / "sardine.yaml"


def test_capture_writes_a_report_of_what_it_captured(
    sardine: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "deep" / "report"
    status = main(["capture", str(sardine), "-o", str(tmp_path), "--report", str(folder)])
    assert (status, capsys.readouterr().out.splitlines()[-1]) == (0, str(folder / "index.html"))
    assert [path.name for path in folder.iterdir()] == ["index.html"]
    text = (folder / "index.html").read_text(encoding="utf-8")
    assert "<h2>Sardine</h2>" in text
    assert str(tmp_path) not in text


def test_a_report_into_a_file_is_refused_before_the_capture(
    sardine: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("tools.capture.capture.capture", lambda *_: pytest.fail("it began"))
    (tmp_path / "file").write_text("mine")
    status = main(["capture", str(sardine), "-o", str(tmp_path), "--report", f"{tmp_path}/file"])
    said = capsys.readouterr().err
    assert status == 1
    assert said.startswith(f"{tmp_path / 'file' / 'index.html'}: cannot be written: ")
    assert said.count("\n") == 1
    assert (tmp_path / "file").read_text() == "mine"


def test_a_report_on_a_full_disk_leaves_the_old_page(
    sardine: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("reefgame.motion_report.write_whole", full)
    page_ = tmp_path / "report" / "index.html"
    page_.parent.mkdir()
    page_.write_text("old")
    status = main(["capture", str(sardine), "-o", str(tmp_path), "--report", str(page_.parent)])
    assert (status, capsys.readouterr().err) == (
        1,
        f"{page_}: cannot be written: No space left on device\n",
    )
    assert page_.read_text() == "old"
    assert list(page_.parent.iterdir()) == [page_]
