"""`reefgame video --species`: the mod that a filmed fish becomes, and how it comes into first_dive (issue 6)."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import reefgame.content.repertoires
from components.repertoire import Pattern, Repertoire, load, mean_speed
from reefgame.captures import capture_files
from reefgame.cli import main
from reefgame.console import InputError
from reefgame.content import ContentError, check, load_species
from reefgame.content import load as load_level
from reefgame.filmed import write_species
from reefgame.world import World
from tools.video.motion import Motion
from tools.video.motion_file import save
from tools.video.water.film import Film
from tools.video.water.joining import is_filmed
from tools.video.water.truth import centre_lines

FilmOf = Callable[..., Film]
MotionOf = Callable[[Film], Motion]
MOD = 'id: {0}\ntitle: {0}\nversion: "1.0"\n'


@pytest.fixture(scope="module")
def mine(tmp_path_factory: pytest.TempPathFactory, film: FilmOf, motion: MotionOf) -> Path:
    """The mod of a filmed sardine."""
    folder = tmp_path_factory.mktemp("mods")
    return write_species(motion(film("sardine", rate=50.0)), None, "mine", 18.0, folder)


@pytest.fixture
def never_captured(monkeypatch: pytest.MonkeyPatch) -> None:
    """Fail where content loading would run the muscle model."""

    def refuse(*arguments: object) -> Repertoire:
        raise AssertionError("this was captured anew")

    monkeypatch.setattr(reefgame.content.repertoires, "_captured", refuse)


def test_the_mod_is_without_fault(mine: Path) -> None:
    assert check([mine]) == []
    assert sorted(p.relative_to(mine).as_posix() for p in mine.rglob("*") if p.is_file()) == [
        "levels/first_dive.yaml", "mod.yaml", "repertoires/mine.npz", "species/mine.yaml",
    ]  # fmt: skip


@pytest.mark.usefixtures("never_captured")
def test_the_fish_swims_as_it_was_filmed(mine: Path) -> None:
    species = load_species("mine:mine", [mine])
    cruise = {s.pattern: s for s in species.repertoire.segments}[Pattern.SWIM_MEDIUM]
    line = centre_lines(species.body, cruise, 60)
    assert len(cruise.shape) == 15
    assert np.ptp(line[:, -1, 1]) == pytest.approx(0.163, rel=0.05)
    assert mean_speed(cruise) == pytest.approx(2.34, rel=0.03)
    assert species.swim.frequency_hz == pytest.approx(4.0, rel=0.01)
    assert species.length == pytest.approx(0.18)


@pytest.mark.usefixtures("never_captured")
def test_a_group_of_it_stands_in_first_dive_beside_all_others(mine: Path) -> None:
    content, base = load_level("first_dive", [mine]), load_level("first_dive")
    (group,) = content.level.fishes[len(base.level.fishes) :]
    assert (group.species, group.count) == ("mine:mine", 8)
    assert "mine:mine" in [species.name for species in content.species]
    assert content.level.fishes[:-1] == base.level.fishes
    assert content.level.objective == base.level.objective
    away = np.array(group.around_m) - np.array(base.level.submarine.at_m)
    assert 2.0 < away[0] < 6.0
    assert np.abs(away[1:]).max() < 1.0


@pytest.mark.prove
def test_it_swims_ahead_of_the_submarine(mine: Path) -> None:
    world = World.build(load_level("first_dive", [mine]), seed=3)
    for _ in range(90):
        world.tick()
    fish = world.population.fish
    ours = fish.live("species") == [s.name for s in world.species].index("mine:mine")
    away = fish.live("position")[ours] - np.array([-24.3, -0.8, -9.6])
    assert ours.sum() == 8
    assert (np.linalg.norm(away, axis=1) < 8.0).all()
    assert (away[:, 0] > 0.0).all()


def test_it_is_not_stale_when_kernels_change(
    mine: Path, monkeypatch: pytest.MonkeyPatch, never_captured: None
) -> None:
    monkeypatch.setattr("tools.capture.capture.fingerprint", lambda *_: "0" * 32)
    assert is_filmed(load_species("mine:mine", [mine]).repertoire)


def test_a_changed_body_wears_the_filmed_motion(
    mine: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = load_species("mine:mine", [mine]).repertoire
    monkeypatch.setattr(
        reefgame.content.repertoires,
        "_captured",
        lambda *_: before,
    )
    kin = tmp_path / "kin"
    (kin / "species").mkdir(parents=True)
    (kin / "mod.yaml").write_text(MOD.format("kin") + "requires: [mine]\n")
    (kin / "species" / "deep.yaml").write_text(
        "like: mine\ntitle: Deep\nfins: {tail: {half_span_bl: 0.2}}\n"
    )
    found = load_species("kin:deep", [mine, kin]).repertoire
    old, new = (
        {s.pattern: s for s in one.segments}[Pattern.SWIM_MEDIUM] for one in (before, found)
    )
    np.testing.assert_allclose(new.shape[:, 21, 1], 0.2, rtol=1e-6)
    np.testing.assert_allclose(new.shape[:, 0], old.shape[:, 0])


def test_a_capture_does_not_replace_it(mine: Path) -> None:
    before = (mine / "repertoires" / "mine.npz").read_bytes()
    with pytest.raises(InputError, match="holds motion from a clip"):
        capture_files([mine / "species" / "mine.yaml"], None)
    assert (mine / "repertoires" / "mine.npz").read_bytes() == before


def test_what_was_filmed_and_what_not_is_noted(mine: Path) -> None:
    notes = load(mine / "repertoires" / "mine.npz").provenance
    assert notes["filmed"] == "swim_medium"
    assert "4.00 Hz" in notes["swim_medium"]
    text = (mine / "species" / "mine.yaml").read_text()
    assert text.count("assumed") >= 3
    assert str(mine.parent) not in text + str(notes)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("mine", "already there"),
        ("Mine", "not allowed"),
        ("reefgame", "base game's own"),
        ("con", "keep it"),
    ],
)
def test_names_that_cannot_be_are_refused_before_any_work(
    mine: Path,
    name: str,
    message: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(mine.parent)
    assert main(["video", "there_is_no_such.avi", "--species", name]) == 1
    error = capsys.readouterr().err
    assert message in error
    assert error.count("\n") == 1


def test_a_fish_that_does_not_beat_leaves_nothing_behind(
    tmp_path: Path, film: FilmOf, motion: MotionOf
) -> None:
    shown = film("sardine", frames=30)
    still = replace(shown, axis=np.repeat(shown.axis[:1], 30, axis=0))
    with pytest.raises(InputError, match="still: no species: the fish hardly bends"):
        write_species(motion(still), None, "still", 20.0, tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_motion_file_serves_in_place_of_a_clip(
    tmp_path: Path,
    film: FilmOf,
    motion: MotionOf,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    shown = film("sardine", frames=30)
    save(Path("still.motion"), motion(replace(shown, axis=np.repeat(shown.axis[:1], 30, axis=0))))
    assert main(["video", "still.motion", "--species", "still"]) == 1
    assert "hardly bends" in capsys.readouterr().err
    assert main(["video", "still.motion", "--species", "still", "--fps", "50"]) == 1
    assert "need a clip" in capsys.readouterr().err


@pytest.mark.parametrize("length", ["0", "-3", "3000", "long"])
def test_lengths_are_checked(length: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["video", "x.avi", "--species", "x", f"--length-cm={length}"]) == 1
    assert "centimetres from 1 to 2000" in capsys.readouterr().err


def _adding(folder: Path, name: str, group: str) -> Path:
    mod = folder / name
    (mod / "levels").mkdir(parents=True)
    (mod / "mod.yaml").write_text(MOD.format(name))
    (mod / "levels" / "more.yaml").write_text(f"overrides: first_dive\nmore_fishes:\n  - {group}\n")
    return mod


def test_two_mods_both_add_their_fishes(tmp_path: Path) -> None:
    group = "{{species: anthias, count: {}, around_m: [-20, 0, -9], within_m: 0.5}}"
    mods = [_adding(tmp_path, name, group.format(count)) for name, count in (("a", 2), ("b", 3))]
    base, both = load_level("first_dive"), load_level("first_dive", mods)
    added = both.level.fishes[len(base.level.fishes) :]
    assert [(g.species, g.count) for g in added] == [("anthias", 2), ("anthias", 3)]
    assert both.level.more_fishes == ()
    assert both.hash != base.hash


def test_a_faulty_group_is_told_where_it_stands(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    mod = _adding(Path(), "a", "{species: anthia, count: 0, around_m: [-20, 0, -9], within_m: 0.5}")
    with pytest.raises(ContentError) as error:
        load_level("first_dive", [mod])
    assert all(str(p).startswith("a/levels/more.yaml:3:") for p in error.value.problems)
    (mod / "levels" / "more.yaml").write_text("overrides: first_dive\nmore_fishes: 3\n")
    with pytest.raises(ContentError, match=r"a/levels/more\.yaml:2:14"):
        load_level("first_dive", [mod])
