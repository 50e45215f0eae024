"""What scenes say is checked before anything swims, and measures measure what they say."""

import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from reefgame.content import ContentError
from reefgame.testing import MEASURES, Observation, observe, read_scene
from reefgame.testing.bodies import overlapping
from reefgame.testing.picture import panel, place, sheet

SCENE = """
title: Two sardines
seconds: 1
fishes:
  - {species: sardine, count: 2, around_m: [0, 0, -6], hunger: 0.5, sexes: both, heading_deg: 90}
expect:
  - {measure: polarisation, of: sardine, at_least: 0.9}
"""


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> Observation:
    """Two sardines seen for a second."""
    path = tmp_path_factory.mktemp("scenes") / "pair.yaml"
    path.write_text(SCENE, encoding="utf-8")
    return observe(read_scene(path), seed=3)


@pytest.mark.parametrize(
    ("old", "new", "where"),
    [
        ("of: sardine", "of: sardin", ":7:33: there is no group 'sardin'; did you mean 'sardine'?"),
        ("measure: polarisation", "measure: polarization", ":7:15: there is no measure"),
        ("species: sardine", "species: sardin", ":5:15: there is no species 'sardin'"),
        ("at_least: 0.9", "after_s: 1", ":7:5: nothing is expected"),
        ("at_least: 0.9", "rises_by: 2", "needs `vary`"),
        ("hunger: 0.5", "hungry: 0.5", ":5:56: "),
        ("hunger: 0.5", "hunger: 5", ":5:64: '5' is out of range"),
        ("[0, 0, -6]", "[0, 0, 6]", "this lies out of the water"),
        ("seconds: 1", "seconds: 0", ":3:10: '0' is out of range"),
        ("fishes:", "fishes: []\nrocks:", ":4:9: there must be at least one"),
        ("heading_deg: 90", "led_at: nobody", "there is no group 'nobody'"),
    ],
)
def test_a_bad_scene_is_named_with_its_place(
    tmp_path: Path, old: str, new: str, where: str
) -> None:
    path = tmp_path / "bad.yaml"
    path.write_text(SCENE.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(ContentError) as caught:
        read_scene(path)
    assert where in str(caught.value)


def test_the_mood_is_what_the_scene_says(pair: Observation) -> None:
    np.testing.assert_allclose(pair.hunger[0], 0.5, atol=0.01)
    assert (pair.rotation[0, :, 1, 0] > 0.95).all()
    assert pair.of("sardine").tolist() == [0, 1]


def test_boxes_overlap_where_bodies_do(pair: Observation) -> None:
    first, second = np.array([0]), np.array([1])
    upright = np.broadcast_to(np.eye(3), pair.rotation.shape).copy()
    turned = upright.copy()
    turned[:, 1] = np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])
    reach = pair.box[:, 0].sum()
    wide = pair.box[:, 2].sum()
    aside = pair.box[0, 2] + pair.box[1, 0]
    for rotation, axis, room in ((upright, 0, reach), (upright, 2, wide), (turned, 2, aside)):
        for share, expected in ((0.98, True), (1.02, False)):
            middle = pair.middle[:, None] * rotation[0, :, :, 0]
            place = -middle
            place[1, axis] += share * room
            position = np.broadcast_to(place, pair.position.shape)
            o = replace(pair, position=position, rotation=rotation)
            assert overlapping(o, 0, first, second).tolist() == [expected]


def test_neighbours_and_courses_are_measured(pair: Observation) -> None:
    position, rotation = pair.position.copy(), pair.rotation.copy()
    position[:, 1] = position[:, 0] + np.array([0.3, 0.0, 0.4])
    rotation[:] = np.eye(3)
    o = replace(pair, position=position, rotation=rotation, length=np.array([0.25, 0.25]))
    assert MEASURES["nearest_neighbour_bl"](o, "sardine", None) == pytest.approx(2.0)
    assert MEASURES["polarisation"](o, "sardine", None) == pytest.approx(1.0)
    assert MEASURES["largest_part"](o, "sardine", None) == 1.0
    rotation[:, 1, :, 0] *= -1.0
    assert MEASURES["polarisation"](o, "sardine", None) == pytest.approx(0.0)
    position[:, 1] += 2.0
    assert MEASURES["largest_part"](o, "sardine", None) == 0.5


def test_a_hunt_that_was_not_is_no_number(pair: Observation) -> None:
    assert np.isnan(MEASURES["hunted_share"](pair, "sardine", "sardine"))
    assert MEASURES["fed_share"](pair, "sardine", None) == 0.0
    assert MEASURES["phases_danced"](pair, "sardine", None) == 0.0


def test_a_picture_shows_every_fish_and_its_way(pair: Observation) -> None:
    centre = pair.position[-1].mean(axis=0)
    text = sheet([panel(pair, 9, centre, 3.0, "now", place(0), tail=5)], "Two sardines")
    paths = ET.fromstring(text).findall(".//{http://www.w3.org/2000/svg}path")
    assert [path.get("d", "").endswith("Z") for path in paths] == [False, True, False, True, False]
    assert paths[0].get("d", "").count("L") == 5
