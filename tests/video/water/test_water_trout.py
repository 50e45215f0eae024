"""The trout of the clip becomes a species (issue 6, Done when; FINDINGS 4: sweep .167 BL, wavelength .87 BL)."""

import os
from pathlib import Path

import pytest

from components.repertoire import Pattern, load, mean_speed
from reefgame.content import check
from reefgame.filmed import write_species
from tools.video.follow import Choices, follow
from tools.video.water.beats import bouts
from tools.video.water.cycle import cycle
from tools.video.water.film import Film, film_of


@pytest.fixture(scope="module")
def trout(checkout: Path) -> Path:
    """The clip."""
    folder = Path(os.environ.get("REEFGAME_CLIPS") or checkout.parent / "shared" / "clips")
    if not (folder / "trout.avi").is_file():
        pytest.skip("the clips of living fishes are not there: REEFGAME_CLIPS names their folder")
    return folder / "trout.avi"


@pytest.fixture(scope="module")
def swum(trout: Path) -> Film:
    """What the trout does, taken to beat its tail four times a second."""
    return film_of(follow(trout, Choices(beats=4.0)).assembled.motion)


def test_its_beat_is_a_trouts(swum: Film) -> None:
    found = cycle(swum, bouts(swum)[0])
    assert found.frequency == pytest.approx(4.0, rel=0.01)
    assert 0.15 < found.sweep() < 0.2
    assert found.head_sweep() < 0.05
    assert found.wavelength() == pytest.approx(0.9, abs=0.1)
    assert found.assumed
    assert found.residual < 0.05


@pytest.mark.prove
def test_it_becomes_a_species(trout: Path, tmp_path: Path) -> None:
    motion = follow(trout, Choices(beats=4.0)).assembled.motion
    mod = write_species(motion, trout, "trout", 30.0, tmp_path)
    assert check([mod]) == []
    made = load(mod / "repertoires" / "trout.npz")
    speed = {s.pattern: mean_speed(s) for s in made.segments}
    assert speed[Pattern.SWIM_SLOW] < speed[Pattern.SWIM_MEDIUM] < speed[Pattern.SWIM_FAST]
    assert made.provenance["warnings"] == ""
    assert "none to see" in (mod / "species" / "trout.yaml").read_text()
