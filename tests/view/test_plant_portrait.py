"""`reefgame shot --flora`: the plant stands in the middle of its portrait, whatever its size."""

import numpy as np
import pytest

from reefgame.content import load_species, read_flora
from reefgame.plant_portrait import plant_portrait
from systems.view.target import UInt8s


def _portrait(name: str) -> UInt8s:
    return plant_portrait(read_flora(name), load_species("clownfish"), 120, 80)


@pytest.mark.parametrize(("name", "channel", "least"), [("actinia", 0, 40), ("anthopleura", 1, 40)])
def test_a_plant_stands_in_the_middle_of_its_portrait(name: str, channel: int, least: int) -> None:
    picture = _portrait(name).astype(np.int16)
    others = np.delete(picture, channel, axis=2).max(axis=2)
    away = picture[..., channel] - others > least
    rows, columns = np.nonzero(away)
    assert away.sum() > 200
    assert abs(np.median(rows) - 40) < 14
    assert abs(np.median(columns) - 60) < 10
