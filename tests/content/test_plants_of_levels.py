"""`plants:` of a level: where they stand, that they keep apart, and what is refused with its place."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from components.ground import ground_height, rock_distance
from reefgame.content import Content, load
from reefgame.content.level_checks import terrain_of
from reefgame.content.planting import planting, surface
from reefgame.world import World

Write = Callable[[str, str | bytes], Path]
Checked = Callable[..., list[str]]
LEVEL = """\
title: Bed
world: {radius_m: 16, depth_m: 9}
seabed: {seed: 3, relief_m: 1.0, feature_m: 8}
rocks:
  - {at_m: [4, 0], radii_m: [2.0, 1.6, 1.2], yaw_deg: 30}
  - {at_m: [5, 2], radii_m: [1.5, 1.5, 1.0]}
submarine: {at_m: [-9, 0, -5]}
fishes:
  - {species: sardine, count: 4, around_m: [-3, 0, -5], within_m: 1}
objective:
  photograph: {species: sardine, count: 2, within_m: 6}
plants:
"""


@pytest.fixture
def planted(write: Write) -> Callable[..., Content]:
    """Load a level with two rocks around (4, 0) and these plants."""

    def loader(*plants: str) -> Content:
        lines = "".join(f"  - {{{plant}}}\n" for plant in plants)
        return load(write("levels/bed.yaml", LEVEL + lines))

    return loader


Planted = Callable[..., Content]


def test_one_plant_stands_on_the_rock_that_is_there(planted: Planted) -> None:
    content = planted(
        "flora: actinia, at_m: [4.4, 0.2], yaw_deg: 90, scale: 0.8", "flora: kelp, at_m: [-4, 1]"
    )
    terrain = terrain_of(content.level)
    anemone, kelp = World(content, 0).plants
    x, y, z = anemone.position
    assert (anemone.flora, x, y, anemone.yaw, anemone.scale) == ("actinia", 4.4, 0.2, 90, 0.8)
    assert abs(min(rock_distance(terrain, rock, x, y, z) for rock in (0, 1))) < 1e-9
    assert z > ground_height(terrain.height, terrain.extent, terrain.cell, x, y) + 0.5
    assert anemone.up[0] > 0.0
    assert np.linalg.norm(anemone.up) == pytest.approx(1.0)
    height = ground_height(terrain.height, terrain.extent, terrain.cell, -4, 1)
    assert kelp.position == (-4, 1, height)


def test_chance_plants_where_flora_or_level_says(planted: Planted) -> None:
    content = planted(
        "flora: seagrass, count: 20, around_m: [3, 0], within_m: 5",
        "flora: stomphia, count: 5, around_m: [4, 1], within_m: 3, stands: rock, scale: [0.5, 0.7]",
        "flora: stomphia, count: 5, around_m: [2, 1], within_m: 6, stands: sand",
    )
    terrain = terrain_of(content.level)
    plants = World(content, 0).plants
    rocks = [surface(terrain, *plant.position[:2]).rock for plant in plants]
    assert max(rocks[:20]) == -1
    assert min(rocks[20:25]) >= 0
    assert max(rocks[25:]) == -1
    assert {0.5 <= plant.scale <= 0.7 for plant in plants[20:25]} == {True}
    assert len({plant.seed for plant in plants}) == len(plants)


def test_scattered_plants_keep_apart_and_within(planted: Planted) -> None:
    content = planted(
        "flora: actinia, at_m: [4, 0]",
        "flora: anthopleura, count: 6, around_m: [2, 1], within_m: 7, stands: any",
        "flora: seagrass, count: 60, around_m: [0, 0], within_m: 7",
    )
    plants = World(content, 0).plants
    place = np.array([plant.position for plant in plants])
    room = np.array([content.floras[plant.flora].room * plant.scale for plant in plants])
    apart = np.linalg.norm(place[:, None] - place[None], axis=2)
    np.fill_diagonal(apart, np.inf)
    assert (apart >= room[:, None] + room[None] - 1e-9).all()
    assert (np.hypot(place[7:, 0], place[7:, 1]) <= 7.0).all()


def test_a_level_has_the_same_plants_in_every_dive(planted: Planted) -> None:
    text = "flora: seagrass, count: 9, around_m: [-3, 0], within_m: 4, scale: [0.5, 1.5]"
    content = planted(text)
    assert World(content, 1).plants == World(content, 2).plants
    assert content.hash == planted(text).hash
    assert content.hash != planted(text.replace("9", "8")).hash
    terrain = terrain_of(content.level)
    assert planting(content.level, content.floras, terrain).found == (9,)


def test_a_level_without_plants_has_none(write: Write) -> None:
    content = load(write("levels/bed.yaml", LEVEL.removesuffix("plants:\n")))
    assert content.floras == {}
    assert World(content, 0).plants == ()


BAD = [
    ("flora: actinea, at_m: [0, 0]", "13:13: there is no flora 'actinea'; did you mean 'actinia'?"),
    ("flora: sardine, at_m: [0, 0]", "13:13: there is no flora 'sardine'"),
    ("flora: actinia", "13:5: a plant stands `at_m`, or several are scattered `around_m`"),
    ("flora: actinia, at_m: [0, 0], around_m: [1, 1]", "13:5: a plant stands `at_m`, or several"),
    ("flora: actinia, at_m: [0, 0], count: 2", "13:5: `count` goes with `around_m`"),
    ("flora: actinia, around_m: [0, 0], yaw_deg: 2", "13:5: `yaw_deg` goes with `at_m`"),
    ("flora: actinia, at_m: [0, 0], scale: [1, 2]", "13:5: the scale of one plant `at_m` is one"),
    ("flora: actinia, around_m: [0, 0], scale: [2, 1]", "13:5: scale: the smallest comes first"),
    ("flora: actinia, at_m: [0, 0], scale: 0", "13:43: '0' is out of range: must be at least 0.1"),
    ("flora: actinia, at_m: [0, 0], scale: big", "13:43: must be a number, such as 1.5, or the smallest"),
    ("flora: actinia, at_m: [0, 17]", "13:28: this lies outside of the world: 17.0 m"),
    ("flora: kelp, around_m: [0, 17], count: 3", "13:29: this lies outside of the world: 17.0 m"),
    (
        "flora: actinia, around_m: [-5, 0], count: 30, within_m: 2, stands: sand",
        "13:5: only 11 of 30 find room on sand here: a larger within_m, fewer or smaller ones",
    ),
    (
        "flora: actinia, around_m: [-5, 0], count: 3",
        "13:5: only 0 of 3 find room on rock here: a larger within_m, fewer or smaller ones",
    ),
    (
        "flora: actinia, around_m: [0, 0], count: 300",
        "13:3: the plants have too many nodes: 479400, at most 250000; 300 of 'actinia' alone have",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("plant", "message"), BAD, ids=[plant for plant, _ in BAD])
def test_bad_plants_are_told_with_their_place(
    plant: str, message: str, write: Write, checked: Checked
) -> None:
    (line,) = checked(write("levels/bed.yaml", f"{LEVEL}  - {{{plant}}}\n"))
    assert line.startswith(f"levels/bed.yaml:{message}")


def test_plants_set_into_each_other_are_refused(write: Write, checked: Checked) -> None:
    plants = "  - {flora: actinia, at_m: [-2, 0]}\n  - {flora: kelp, at_m: [-2.2, 0]}\n"
    assert checked(write("levels/bed.yaml", LEVEL + plants)) == [
        "levels/bed.yaml:14:25: this stands in plants[0] in line 13: set them further apart"
    ]


def test_a_rock_that_leaves_the_water_bears_no_plant(write: Write, checked: Checked) -> None:
    text = LEVEL.replace("[2.0, 1.6, 1.2]", "[2.0, 1.6, 9.0]")
    (line,) = checked(write("levels/bed.yaml", text + "  - {flora: actinia, at_m: [4, 0]}\n"))
    assert line.endswith("this rock rises out of the water: no plant can stand on it")


def test_the_anemone_garden_holds_what_its_issue_asks_for() -> None:
    content = load("anemone_garden")
    plants = World(content, 0).plants
    forms = [type(content.floras[plant.flora].form).__name__ for plant in plants]
    assert forms.count("Anemone") >= 36
    assert {"Seagrass", "Kelp", "Coral"} < set(forms)
    assert content.level.objective.photograph.species == "clownfish"
    hosts = [plant for plant in plants if plant.flora == "magnificent_anemone"]
    homes = [home.at_m for home in content.level.homes if home.species == "clownfish"]
    assert [plant.position[:2] for plant in hosts] == homes
