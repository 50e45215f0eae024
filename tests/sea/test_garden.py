"""The garden's layout: every fibre stands where it was put, and what makes no garden is refused."""

from types import ModuleType

import numpy as np
import pytest

from components.fibre import LANES, Carriers, Tuft
from components.garden import Garden
from systems.sea.bend import NumbaBender
from systems.sea.follow import follow

CHANCE = np.random.default_rng(5)


def _tuft(fibres: int, nodes: int, **wanted: object) -> Tuft:
    points = np.cumsum(CHANCE.uniform(0.1, 1.0, (fibres, nodes, 3)), axis=1)
    return Tuft(points, CHANCE.uniform(0.01, 0.1, (fibres, nodes)), **wanted)  # type: ignore[arg-type]


def test_every_fibre_stands_where_it_was_put() -> None:
    tufts = [_tuft(*shape) for shape in ((1, 4), (1, 4), (19, 7), (0, 3), (5, 4), (8, 1), (3, 4))]
    garden = Garden(tufts)
    rest = [(points, radii) for t in tufts for points, radii in zip(t.points, t.radii, strict=True)]
    assert garden.fibres == len(rest) == 37
    for fibre, (points, radii) in enumerate(rest):
        assert np.array_equal(garden.points(fibre), points.astype(np.float32))
        rows = slice(garden.first_row[fibre], garden.first_row[fibre] + garden.nodes[fibre])
        assert np.array_equal(garden.radius[rows, garden.lane[fibre]], radii.astype(np.float32))
    places = {(int(r), int(lane)) for r, lane in zip(garden.first_row, garden.lane, strict=True)}
    assert len(places) == garden.fibres
    assert garden.fibre(2, 3) == 5
    assert (np.abs(garden.position[..., : 2 * LANES]).max(axis=1) > 0.0).all()


def test_small_tufts_share_a_bundle() -> None:
    apart, together = Garden([_tuft(8, 5)] * 2), Garden([_tuft(1, 5)] * 16)
    assert len(apart.strands.bundle) == len(together.strands.bundle) == 2


def test_feet_are_bent_before_what_they_carry() -> None:
    zero = np.zeros(2, np.int32)
    tufts = [_tuft(1, 4), _tuft(2, 4, carriers=Carriers(0, zero, zero)), _tuft(1, 4)]
    garden = Garden(tufts)
    assert garden.depths == (0, 1, 2)
    assert garden.strands.bundle[:, 3].tolist() == [0, 1]


def test_a_garden_begins_at_a_cache_line() -> None:
    garden = Garden([_tuft(3, 5)])
    assert garden.position.ctypes.data % 64 == 0
    assert garden.strands.position.base is not None
    assert np.shares_memory(garden.strands.position, garden.position)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"points": np.zeros((2, 3))}, "shape"),
        ({"points": np.zeros((2, 0, 3))}, "shape"),
        ({"points": np.zeros((2, 4, 3))}, "a segment has no length"),
        ({"points": np.full((2, 4, 3), np.nan)}, "within"),
        ({"points": np.full((2, 4, 3), 1e9)}, "within"),
        ({"radii": np.full(4, -1.0)}, "radii are numbers >= 0"),
        ({"radii": np.full(4, np.nan)}, "radii are numbers >= 0"),
        ({"radii": np.ones(3)}, "one number a node"),
        ({"modulus": -1.0}, "K >= 0"),
        ({"modulus": np.nan}, "K >= 0"),
        ({"exponent": np.inf}, "n from"),
    ],
)
def test_what_is_no_fibre_is_refused(change: dict[str, object], says: str) -> None:
    good: dict[str, object] = {
        "points": np.cumsum(np.ones((2, 4, 3)), axis=1),
        "radii": np.ones(4),
    }
    Tuft(**good)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=says):
        Tuft(**{**good, **change})  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("wanted", "says"),
    [
        ({"carriers": Carriers(1, np.zeros(2, np.int32), np.zeros(2, np.int32))}, "before it"),
        ({"carriers": Carriers(0, np.full(2, 9, np.int32), np.zeros(2, np.int32))}, "fibres of"),
        ({"carriers": Carriers(0, np.zeros(2, np.int32), np.full(2, 9, np.int32))}, "nodes of"),
        ({"carriers": Carriers(0, np.full(2, -1, np.int32), np.zeros(2, np.int32))}, "fibres of"),
        ({"guides": 1}, "before it"),
        ({"guides": -1}, "before it"),
    ],
)
def test_what_leans_on_nothing_is_refused(wanted: dict[str, object], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        Garden([_tuft(3, 4), _tuft(2, 4, **wanted)])


def test_followers_need_guides_of_as_many_nodes() -> None:
    with pytest.raises(ValueError, match="as many nodes"):
        Garden([_tuft(3, 5), _tuft(2, 4, guides=0)])


def test_followers_stand_between_their_guides(bed: ModuleType) -> None:
    """papers/002, section 5.4: a few guides bend, thousands follow, as long as they were."""
    tufts = bed.anemone(fibres=20)
    garden = Garden(tufts)
    bed.bend(garden, NumbaBender(parallel=False), bed.water(), 60)
    guides = np.stack([garden.points(garden.fibre(1, f)) for f in range(20)]).astype(float)
    for fibre in range(20):
        own = garden.points(garden.fibre(2, fibre)).astype(float)
        size = np.linalg.norm(np.diff(own, axis=0), axis=1)
        rest = np.linalg.norm(np.diff(tufts[2].points[fibre], axis=0), axis=1)
        assert np.abs(size - rest).max() < 1e-6
        near = np.argsort(np.linalg.norm(tufts[1].points[:, 0] - tufts[2].points[fibre, 0], axis=1))
        shapes = guides[near[:3]] - guides[near[:3], :1]
        shape = own - own[0]
        assert (shape > shapes.min(0) - 0.05).all()
        assert (shape < shapes.max(0) + 0.05).all()


def test_a_follower_on_its_guide_is_its_guide(bed: ModuleType) -> None:
    guide = bed.anemone(fibres=1)[1]
    guide = Tuft(guide.points, guide.radii)
    garden = Garden([guide, Tuft(guide.points, guide.radii, guides=0)])
    bed.bend(garden, NumbaBender(parallel=False), bed.water(), 60)
    assert np.abs(garden.points(1) - garden.points(0)).max() < 1e-6
    assert np.abs(garden.points(0) - guide.points[0]).max() > 0.01


def test_followers_of_guides_that_disagree_take_the_nearest() -> None:
    points = np.zeros((2, 3, 3))
    points[1, :, 0] = 1.0
    points[0, :, 2], points[1, :, 2] = (0.0, 1.0, 2.0), (0.0, -1.0, -2.0)
    between = points[:1] + np.array([0.45, 0.0, 0.0])
    garden = Garden([Tuft(points, np.ones(3)), Tuft(between, np.ones(3), guides=0)])
    follow(garden)
    assert np.abs(garden.points(2) - between[0]).max() < 1e-6
