"""Plants grow as their flora says: numbers, sizes, what carries what, alike for a seed, and never nonsense."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from components.flora import Anemone, Coral, Flora, Growth, Kelp, Limb, Look, Plant, Seagrass
from components.garden import Garden
from components.ground import Terrain
from tools.grow.plants import grow, nodes
from tools.grow.shape import lengths

Grown = Callable[..., Growth]
EVERY = pytest.mark.parametrize(
    "name",
    ["actinia", "anthopleura", "anthothoe", "stomphia", "magnificent_anemone",
     "seagrass", "kelp", "sea_fan", "soft_coral"],
)  # fmt: skip


def _arc(points: np.ndarray) -> np.ndarray:
    length: np.ndarray = np.linalg.norm(np.diff(points, axis=1), axis=2).sum(1)
    return length


@EVERY
def test_every_flora_makes_a_garden_of_the_nodes_it_announces(
    name: str, grown: Grown, floras: dict[str, Flora]
) -> None:
    growth = grown(name)
    assert sum(tuft.fibres * tuft.nodes for tuft in growth.tufts) == nodes(floras[name])
    assert nodes(floras[name]) < 3500
    garden = Garden(growth.tufts)
    assert np.isfinite(garden.position).all()
    assert {tuft.look for tuft in growth.tufts} <= set(range(len(growth.looks)))


@EVERY
def test_a_seed_grows_one_shape_and_another_seed_another(name: str, grown: Grown) -> None:
    one, same, other = grown(name, seed=5), grown(name, seed=5), grown(name, seed=6)
    for a, b in zip(one.tufts, same.tufts, strict=True):
        assert np.array_equal(a.points, b.points)
        assert np.array_equal(a.radii, b.radii)
    assert any(
        not np.array_equal(a.points, b.points) for a, b in zip(one.tufts, other.tufts, strict=True)
    )


@EVERY
def test_roots_stand_in_the_ground_and_nothing_below_them(name: str, grown: Grown) -> None:
    growth = grown(name)
    first = growth.tufts[0].points[:, 0, 2]
    assert np.allclose(first, -10.05)
    assert min(tuft.points[..., 2].min() for tuft in growth.tufts) >= -10.2


@pytest.mark.parametrize("name", ["actinia", "kelp", "soft_coral", "sea_fan"])
def test_twice_the_scale_is_twice_the_size_and_bends_alike(name: str, grown: Grown) -> None:
    one, two = grown(name), grown(name, scale=1.5)
    for a, b in zip(one.tufts, two.tufts, strict=True):
        if name != "kelp":  # which the water's depth cuts short
            assert np.allclose(1.5 * _arc(a.points), _arc(b.points))
        assert np.allclose(1.5 * a.radii, b.radii)
        # F / (k L) of papers/002 eq. 10, with F as r L and k as r^n K.
        assert np.isclose(a.radii.max() ** (1 - a.exponent) / a.modulus,
                          b.radii.max() ** (1 - b.exponent) / b.modulus)  # fmt: skip


def test_a_foot_carries_all_tentacles_on_its_last_node(grown: Grown) -> None:
    foot, tentacles = grown("actinia").tufts
    assert (foot.fibres, tentacles.fibres) == (1, 199)
    assert tentacles.carriers is not None
    assert tentacles.carriers.tuft == 0
    assert set(tentacles.carriers.node.tolist()) == {foot.nodes - 1}
    away = np.linalg.norm(tentacles.points[:, 0] - foot.points[0, -1], axis=1)
    assert away.max() < 0.25


@pytest.mark.parametrize("up", [(0.0, 0.0, 1.0), (0.6, 0.0, 0.8)])
def test_tentacles_stand_on_the_end_of_a_foot_that_leans(
    grown: Grown, up: tuple[float, float, float]
) -> None:
    foot, tentacles = (tuft.points for tuft in grown("stomphia", up=up).tufts)
    end = foot[0, -1] - foot[0, -2]
    end /= np.linalg.norm(end)
    mean = (tentacles[:, -1] - tentacles[:, 0]).mean(axis=0)
    assert foot[0, -1, 0] - foot[0, 0, 0] == pytest.approx(up[0] * 0.2, abs=0.08)
    assert mean @ end > 0.9 * np.linalg.norm(mean)


def test_tentacles_at_the_rim_splay_further_and_may_be_shorter(grown: Grown) -> None:
    tentacles = grown("actinia").tufts[1]
    out = np.linalg.norm(tentacles.points[:, 0, :2], axis=1)
    inner, outer = out < np.quantile(out, 0.2), out > np.quantile(out, 0.8)
    way = tentacles.points[:, 1] - tentacles.points[:, 0]
    rise = way[:, 2] / np.linalg.norm(way, axis=1)
    assert rise[inner].mean() > 0.85 > 0.5 > rise[outer].mean()
    assert _arc(tentacles.points)[inner].mean() > 1.1 * _arc(tentacles.points)[outer].mean()


def test_an_anemone_has_a_disc_on_its_foot(grown: Grown, floras: dict[str, Flora]) -> None:
    growth, form = grown("anthothoe", scale=2.0), floras["anthothoe"].form
    assert isinstance(form, Anemone)
    (disc,) = growth.discs
    assert (disc.tuft, disc.fibre) == (0, 0)
    assert (disc.radius, disc.mouth) == pytest.approx((2.0 * form.radius, 2.0 * form.mouth))
    assert growth.looks[disc.look].kind == "disc"
    assert not grown("kelp").discs


def test_most_blades_of_seagrass_are_interpolated(grown: Grown) -> None:
    guides, blades = grown("seagrass").tufts
    assert (guides.guides, blades.guides) == (None, 0)
    assert blades.fibres > 3 * guides.fibres
    assert guides.nodes == blades.nodes


def test_fronds_ride_along_their_stipe(grown: Grown, floras: dict[str, Flora]) -> None:
    stipes, fronds, bladders = grown("kelp").tufts
    form = floras["kelp"].form
    assert isinstance(form, Kelp)
    assert fronds.fibres == bladders.fibres == form.stipes * form.fronds
    assert fronds.carriers is not None
    assert len(set(fronds.carriers.node.tolist())) > 8
    at = stipes.points[fronds.carriers.fibre, fronds.carriers.node]
    segment = np.linalg.norm(np.diff(stipes.points, axis=1), axis=2).max()
    assert np.linalg.norm(fronds.points[:, 0] - at, axis=1).max() < 0.6 * segment


def test_kelp_stays_below_the_surface(seabed: Terrain, floras: dict[str, Flora]) -> None:
    for scale in (0.5, 1.0, 4.0):
        plant = Plant("kelp", (0.0, 0.0, -4.0), (0.0, 0.0, 1.0), 0.0, scale, 3)
        stipes = grow([plant], floras, seabed).tufts[0]
        assert stipes.points[..., 2].max() < 0.0
        assert _arc(stipes.points).max() > 1.5


def test_a_sea_fan_is_flat_and_a_soft_coral_is_not(grown: Grown) -> None:
    for name, flat in (("sea_fan", True), ("soft_coral", False)):
        tips = np.concatenate([tuft.points[:, -1] for tuft in grown(name).tufts])
        spread = tips.std(axis=0)
        assert (spread[1] < 0.25 * spread[0]) == flat


def test_polyps_bloom_at_the_ends_of_the_last_branches(grown: Grown) -> None:
    *branches, polyps = grown("soft_coral").tufts
    assert polyps.carriers is not None
    assert polyps.carriers.tuft == len(branches) - 1
    ends = branches[-1].points[polyps.carriers.fibre, -1]
    assert np.allclose(polyps.points[:, 0], ends)


def test_plants_keep_their_number_and_their_carriers_apart(
    seabed: Terrain, floras: dict[str, Flora]
) -> None:
    plants = [
        Plant(name, (2.0 * index, 0.0, -10.0), (0.0, 0.0, 1.0), 0.0, 1.0, index)
        for index, name in enumerate(("stomphia", "kelp", "stomphia"))
    ]
    growth = grow(plants, floras, seabed)
    assert [tuft.plant for tuft in growth.tufts] == [0, 0, 1, 1, 1, 2, 2]
    assert [t.carriers.tuft for t in growth.tufts if t.carriers] == [0, 2, 2, 5]
    assert [disc.tuft for disc in growth.discs] == [0, 5]
    # One set of looks a species, however many plants.
    assert len(growth.looks) == 6


def test_sand_keeps_fibres_out_and_rock_by_itself(
    seabed: Terrain, floras: dict[str, Flora]
) -> None:
    sand, rock = (
        grow([Plant("stomphia", (0.0, 0.0, z), (0.0, 0.0, 1.0), 0.0, 1.0, 1)], floras, seabed)
        for z in (-10.0, -9.0)
    )
    assert sand.tufts[0].ground == pytest.approx((0.0, 0.0, 1.0, -10.05))
    assert rock.tufts[0].ground is None


def limbs() -> st.SearchStrategy[Limb]:
    """Return fibres that a file may ask for."""
    size = st.floats(0.005, 20.0)
    radii = st.lists(st.floats(0.0005, 3.0), min_size=1, max_size=16).map(tuple)
    return st.builds(
        Limb,
        nodes=st.integers(2, 32),
        length=st.tuples(size, size),
        radii=radii,
        modulus=st.floats(1e-6, 1e9),
        exponent=st.floats(0.0, 20.0),
        curl=st.floats(-360.0, 360.0),
        variety=st.floats(0.0, 1.0),
    )


ANGLE = st.floats(0.0, 180.0)
FORMS = st.one_of(
    st.builds(
        Anemone,
        radius=st.just(1.0),
        mouth=st.floats(0.001, 0.99),
        base=st.floats(0.06, 1.0),
        dome=st.floats(-1.0, 1.0),
        foot=limbs(),
        tentacle=limbs(),
        splay=st.tuples(ANGLE, ANGLE),
    ),
    st.builds(
        Seagrass,
        blades=st.integers(1, 40),
        guides=st.integers(1, 50),
        across=st.floats(0.01, 10.0),
        blade=limbs(),
        lean=ANGLE,
    ),
    st.builds(
        Kelp,
        stipes=st.integers(1, 4),
        across=st.floats(0.0, 3.0),
        stipe=limbs(),
        fronds=st.integers(0, 20),
        frond=limbs(),
        rise=ANGLE,
        bladder=st.sampled_from([0.0, 0.001, 0.2]),
    ),
    st.builds(
        Coral,
        flat=st.booleans(),
        stem=limbs(),
        branches=st.integers(1, 4),
        orders=st.integers(0, 3),
        spread=ANGLE,
        shrink=st.floats(0.1, 1.0),
        polyps=st.integers(0, 5),
        polyp=limbs(),
    ),
)
LOOK = Look("branch", (0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (0.5, 0.5, 0.5))
LOOKS = dict.fromkeys(
    ("tentacle", "foot", "disc", "blade", "stipe", "frond", "bladder", "branch", "polyp"), LOOK
)


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    form=FORMS, scale=st.floats(0.1, 10.0), seed=st.integers(0, 2**31 - 1), yaw=st.floats(-360, 360)
)
def test_whatever_a_file_may_ask_for_grows(
    form: Anemone | Seagrass | Kelp | Coral, scale: float, seed: int, yaw: float, seabed: Terrain
) -> None:
    flora = Flora("any", "Any", form, LOOKS, 1.0, "any")
    plant = Plant("any", (1.0, 2.0, -9.5), (0.6, 0.0, 0.8), yaw, scale, seed)
    growth = grow([plant], {"any": flora}, seabed)
    assert sum(tuft.fibres * tuft.nodes for tuft in growth.tufts) == nodes(flora)
    for tuft in growth.tufts:
        assert np.isfinite(tuft.points).all()
        assert np.isfinite(tuft.modulus)
    assert np.isfinite(Garden(growth.tufts).position).all()


def test_variety_keeps_lengths_near_what_the_file_says() -> None:
    limb = Limb(4, (1.0, 2.0), (0.1,), 1.0, variety=0.5)
    found = lengths(limb, np.linspace(0.0, 1.0, 200), np.random.default_rng(1))
    assert found.min() > 0.75
    assert found.max() < 2.45
