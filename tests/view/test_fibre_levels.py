"""Which tufts are drawn, and how finely: within the triangles allowed, finer where they are larger."""

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from components.camera import camera_towards
from systems.view.cull import View, view_of
from systems.view.fibre_levels import (
    CAPS,
    FLAT,
    LEVELS,
    MOST_RINGS,
    SIDES,
    TRIANGLES,
    WIDE,
    Tufts,
    choose_levels,
    plants_seen,
    triangles_of,
    tufts_seen,
    widening,
)
from systems.view.fibre_mesh import fibre_mesh


def view(height: float = 720.0) -> View:
    """Return the view of an eye in the origin that looks along x."""
    camera = camera_towards(np.zeros(3), np.array([1.0, 0.0, 0.0]), 0.4663)
    return view_of(camera, height, 16.0 / 9.0, 22.0)


def tufts(places: list[tuple[float, float, float]], shape: int = 0, fibres: int = 100) -> Tufts:
    """Return tufts of half a metre at places [m], each a plant of its own."""
    n = len(places)
    spheres = np.column_stack((np.reshape(places, (n, 3)), np.full(n, 0.5)))
    return Tufts(
        sphere=spheres,
        shape=np.full(n, shape),
        thickness=np.full(n, 0.4 if shape == WIDE else 0.025),
        length=np.full(n, 0.3),
        nodes=np.full(n, 10),
        fibres=np.full(n, fibres),
        plant=np.arange(n),
    )


def test_what_is_behind_aside_or_hidden_by_water_is_not_drawn() -> None:
    chosen = choose_levels(
        tufts([(4, 0, 0), (-4, 0, 0), (4, 9, 0), (4, 0, -6), (80, 0, 0)]), view()
    )
    assert chosen.tuft.tolist() == [0]


def test_a_tuft_that_reaches_into_the_picture_is_drawn() -> None:
    edge = 4.0 * 0.4663 * 16.0 / 9.0
    seen = tufts_seen(tufts([(4.0, edge + 0.4, 0), (4.0, edge + 1.0, 0), (-0.3, 0, 0)]), view())
    assert seen.tolist() == [True, False, True]


def test_all_parts_of_a_plant_are_seen_with_one() -> None:
    parts = tufts([(4, 0, 0), (-4, 0, 0), (-4, 1, 0)])._replace(plant=np.array([0, 0, 1]))
    assert plants_seen(parts, tufts_seen(parts, view())).tolist() == [True, True, False]


@pytest.mark.parametrize("shape", [0, FLAT, WIDE])
def test_levels_grow_coarser_with_distance(shape: int) -> None:
    places = [(float(x), 0.0, 0.0) for x in np.geomspace(0.6, 60.0, 40)]
    chosen = choose_levels(tufts(places, shape, 1), view())
    each = triangles_of(np.full(40, shape), chosen.level, chosen.rings)
    assert (np.diff(chosen.level) >= 0).all()
    assert (np.diff(each) <= 0).all()
    assert chosen.level[0] < 2
    assert chosen.level[-1] == LEVELS - 1


def test_a_lower_picture_is_drawn_coarser() -> None:
    field = tufts([(float(x), 0.0, 0.0) for x in range(1, 12)])
    high, low = choose_levels(field, view(720.0)), choose_levels(field, view(160.0))
    assert low.triangles(field) < 0.5 * high.triangles(field)


@given(
    st.lists(st.tuples(st.floats(-5, 30), st.floats(-9, 9), st.floats(-5, 5)), max_size=60),
    st.integers(0, 2),
    st.integers(0, 400),
    st.sampled_from([5_000, 20_000, TRIANGLES]),
)
@example([(0.0, 0.0, 0.0)] * 8, 0, 261, 5_000)
def test_a_picture_never_takes_more_triangles_than_allowed_and_leaves_nothing_out(
    places: list[tuple[float, float, float]], shape: int, fibres: int, most: int
) -> None:
    field = tufts(places, shape, fibres)
    chosen = choose_levels(field, view(1080.0), most)
    # At the coarsest half of the fibres are left, two triangles each.
    least = len(chosen.tuft) * (fibres // 2 + 1) * (2 if shape != WIDE else 6)
    assert chosen.triangles(field) <= max(most, least)
    assert ((chosen.rings >= 2) & (chosen.rings <= MOST_RINGS)).all()
    if fibres:
        assert chosen.tuft.tolist() == np.flatnonzero(tufts_seen(field, view(1080.0))).tolist()
        assert (chosen.fibres >= 1).all()
    else:
        assert len(chosen.tuft) == 0


def test_fewer_fibres_are_as_much_wider() -> None:
    field = tufts([(50.0, 0.0, 0.0)])
    chosen = choose_levels(field, view())
    assert chosen.level.tolist() == [LEVELS - 1]
    assert chosen.fibres * widening(chosen.level) == pytest.approx(field.fibres)


@pytest.mark.parametrize("level", range(LEVELS))
@pytest.mark.parametrize("shape", [0, FLAT, WIDE])
def test_meshes_have_the_triangles_that_are_counted(shape: int, level: int) -> None:
    corners, indices, head = fibre_mesh(shape, level)
    band = (len(indices) - head) // (MOST_RINGS - 1)
    for rings in (2, 7, MOST_RINGS):
        count = head + (rings - 1) * band
        used = corners[indices[:count]]
        counted = triangles_of(np.array([shape]), np.array([level]), np.array([rings]))
        assert [count // 3] == counted.tolist()
        assert used[:, 0].max() == rings - 1
    assert SIDES[shape][level] >= 2
    assert (corners[:, 3] < 1.0).any() == (CAPS[shape][level] > 0)


def test_tubes_are_seen_from_outside() -> None:
    corners, indices, _ = fibre_mesh(0, 0)
    angle = 2.0 * np.pi * corners[:, 1]
    # The tip is up: ring k lies k below it.
    points = np.stack(
        (
            corners[:, 3] * np.cos(angle),
            corners[:, 3] * np.sin(angle),
            corners[:, 2] - corners[:, 0],
        ),
        axis=1,
    )
    a, b, c = (points[indices.reshape(-1, 3)[:, k]] for k in range(3))
    outwards = np.cross(b - a, c - a)
    middle = (a + b + c) / 3.0
    assert (np.einsum("ij,ij->i", outwards[:, :2], middle[:, :2]) > 0.0).all()
