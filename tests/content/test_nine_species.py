"""The nine species of the base game: what they are, that they swim like fishes, and the dive that shows them all."""

from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest

from components.mind import Role
from components.repertoire import Pattern
from components.species import Species
from reefgame.autopilot import Photographer
from reefgame.content import list_species, load, load_species
from reefgame.testing import play

WriteMod = Callable[..., Path]

REAL = {
    "angelfish": (Role.PACIFIST, 0.35, (0.25, 0.40)),
    "anthias": (Role.PREY, 0.11, (0.07, 0.15)),
    "barracuda": (Role.PREDATOR, 1.10, (0.60, 1.40)),
    "blue_tang": (Role.PACIFIST, 0.25, (0.15, 0.31)),
    "butterflyfish": (Role.PACIFIST, 0.16, (0.12, 0.20)),
    "clownfish": (Role.PACIFIST, 0.09, (0.07, 0.11)),
    "parrotfish": (Role.PACIFIST, 0.40, (0.30, 0.50)),
    "reef_shark": (Role.PREDATOR, 1.50, (1.20, 1.80)),
    "sardine": (Role.PREY, 0.20, (0.15, 0.25)),
}
"""Role, length [m], and the lengths [m] that adults have."""


@pytest.fixture(scope="module", params=list(REAL))
def species(request: pytest.FixtureRequest) -> Species:
    return load_species(request.param)


def test_the_base_game_has_nine_species() -> None:
    assert [line.name for line in list_species()] == list(REAL)


def test_a_species_has_its_role_and_real_sizes(species: Species) -> None:
    role, length, (least, most) = REAL[species.name]
    assert species.role == role
    assert species.length == pytest.approx(length)
    assert species.length * (1.0 - species.length_spread) >= least
    assert species.length * (1.0 + species.length_spread) <= most
    assert species.schooling == (role is Role.PREY)


def test_each_species_medium_swim_warns_of_nothing(species: Species) -> None:
    notes = species.repertoire.provenance
    assert "swim_medium" not in notes["warnings"]
    assert "swim_fast" not in notes["warnings"]
    assert {segment.pattern for segment in species.repertoire.segments} >= {
        Pattern.SWIM_SLOW,
        Pattern.SWIM_MEDIUM,
        Pattern.SWIM_FAST,
        Pattern.TURN_LEFT,
    }


def test_the_aquarium_shows_all_nine() -> None:
    content = load("nine_species")
    counts = Counter[str]()
    for group in content.level.fishes:
        counts[group.species] += group.count
    assert set(counts) == set(REAL)
    assert counts.total() == 82
    assert (content.level.world.radius_m, content.level.objective.photograph.species) == (
        35,
        "anthias",
    )
    hunters = sum(counts[name] for name, (role, *_) in REAL.items() if role is Role.PREDATOR)
    assert 0 < hunters < 6


def test_looks_leave_the_content_hash(write_mod: WriteMod) -> None:
    text = "overrides: sardine\n"
    plain = load("first_dive", [write_mod("one", species={"s": text})]).hash
    look = (
        "body: {snout: 0.9}\nfins: {pelvic: {at_bl: 0.5, length_bl: 0.1}, tail: {upper: 1.2}, "
        "dorsal: {profile: [0.2, 1, 0.5]}, pectoral: {held_out: true}}\n"
    )
    assert load("first_dive", [write_mod("two", species={"s": text + look})]).hash == plain
    longer = "fins: {dorsal: {height_bl: 0.09}}\n"
    assert load("first_dive", [write_mod("three", species={"s": text + longer})]).hash != plain


def test_the_aquarium_can_be_won() -> None:
    dive = play("nine_species", Photographer(), seconds=60, seed=2)
    assert dive.won
    assert dive.ticks > 240
