"""`reefgame capture --tune`: from a body alone to a file that says how it swims, and the motion beside it."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from components.repertoire_file import load
from reefgame import captures, tuning
from reefgame.content import load_species
from tools.capture import evolve, tune

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def bare(installed: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A sardine in a mod that nobody tuned: a body, and no swim."""
    monkeypatch.setattr(tuning, "state_folder", lambda: tmp_path / "state")
    text = (installed / "assets" / "species" / "sardine.yaml").read_text(encoding="utf-8")
    begin, end = text.index("swim:"), text.index("# Layers are")
    path = tmp_path / "mine" / "species" / "bare.yaml"
    path.parent.mkdir(parents=True)
    path.write_text(text[:begin] + text[end:], encoding="utf-8")
    (path.parents[1] / "mod.yaml").write_text('id: mine\ntitle: M\nversion: "1"\n')
    level = (installed / "levels" / "first_dive.yaml").read_text(encoding="utf-8")
    (path.parents[1] / "levels").mkdir()
    (path.parents[1] / "levels" / "dive.yaml").write_text(level.replace("sardine", "bare"))
    return path


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Searches of two generations, of which the first candidate is taken as it is."""
    monkeypatch.setattr(evolve, "GENERATIONS", 2)
    monkeypatch.setattr(tune, "SHORTLIST", 1)
    monkeypatch.setattr(tune, "ATTEMPTS", 1)
    monkeypatch.setattr(tune, "unusable", lambda _: [])


@pytest.mark.usefixtures("quick")
def test_a_body_alone_gets_a_swim_and_its_motion(reefgame: Run, bare: Path) -> None:
    before = bare.read_text(encoding="utf-8")
    status, out, err = reefgame("capture", bare, "--tune", "--seed", 7, "--jobs", 1)
    assert (status, [line for line in err.splitlines() if "warning" not in line]) == (0, [])
    assert "frequency_hz none -> " in out
    assert "Strouhal" in out
    after = bare.read_text(encoding="utf-8").splitlines()
    changed = [line.split(":")[0].strip() for line in before.splitlines() if line not in after]
    assert changed in ([], ["stiffness"])
    species = load_species(bare)
    made = load(bare.parents[1] / "repertoires" / "bare.npz")
    assert species.repertoire.provenance == made.provenance
    assert f"frequency_hz none -> {species.swim.frequency_hz:g}" in out
    assert species.swim.frequency_hz == pytest.approx(
        60 / round(60 / species.swim.frequency_hz), abs=1e-3
    )


def test_a_species_without_swim_names_the_tuner_wherever_it_is_needed(
    reefgame: Run, bare: Path
) -> None:
    wanted = "has no `swim` yet, find it with: reefgame capture --tune"
    for arguments in (
        ("check", bare),
        ("check", bare.parents[1]),
        ("check", bare.parents[1] / "levels" / "dive.yaml"),
        ("capture", bare),
        ("soak", bare.parents[1] / "levels" / "dive.yaml", "--ticks", 1),
    ):
        status, _, err = reefgame(*arguments)
        (line,) = err.splitlines()
        assert status == 1
        assert wanted in line
        assert f"{bare.name}:1:1: " in line or f"{bare.name}:7:1: " in line
        assert line.endswith("bare.yaml")
    assert not (bare.parents[1] / "repertoires").exists()


def test_a_body_that_cannot_be_tuned_is_told_and_stays_as_it_is(
    reefgame: Run, bare: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(evolve, "GENERATIONS", 1)
    monkeypatch.setattr(
        tune, "captured", lambda aim, found: (found, None, (f"sinks at {aim.speed:g}",))
    )
    before = bare.read_bytes()
    status, out, err = reefgame("capture", bare, "--tune", "--jobs", 1)
    assert (status, out) == (1, "")
    (line,) = err.splitlines()
    assert line.startswith(f"{bare}: not tuned, no usable way to swim was found: sinks at ")
    assert bare.read_bytes() == before
    assert list((bare.parents[1] / "repertoires").iterdir()) == []


def test_faults_are_told_before_the_work_begins(
    reefgame: Run, bare: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(*_: object) -> None:
        raise AssertionError("the work began")

    monkeypatch.setattr(tune, "tune", never)
    bare.chmod(0o444)
    assert reefgame("capture", bare, "--tune") == (
        1,
        "",
        f"{bare}: cannot be written: the file is read-only\n",
    )
    bare.chmod(0o644)
    for arguments, reason in (
        (("--tune", "--jobs", 0), "number of jobs '0': a whole number from 1"),
        (("--tune", "--jobs", -1), "number of jobs '-1': a whole number"),
        (("--jobs", 2), "--jobs and --scheduler need --tune"),
        (("--tune", "--scheduler", "nowhere"), "nowhere: no Dask scheduler answers"),
    ):
        status, out, err = reefgame("capture", bare, *arguments)
        assert (status, out) == (1, "")
        assert err.count("\n") == 1
        assert err.startswith(reason)


def test_shipped_species_are_captured_as_before(
    reefgame: Run, installed: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shipped = load(installed / "assets" / "repertoires" / "sardine.npz")
    kept = replace(shipped, provenance={**shipped.provenance, "warnings": ""})
    monkeypatch.setattr("tools.capture.capture.capture", lambda *_: kept)
    sardine = installed / "assets" / "species" / "sardine.yaml"
    before = sardine.read_bytes()
    assert captures.capture_files([sardine], tmp_path) == 0
    assert load(tmp_path / "sardine.npz").provenance == kept.provenance
    assert sardine.read_bytes() == before
