"""The fish's surface: linear in at most 12 nodes, true to the stations, smooth, alike at every level of detail."""

import dataclasses
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from components.arrays import Float32s, Float64s
from components.body import NODES, Body, Fin, rest_nodes
from components.species import Species
from systems.view.bspline import basis, greville, slope
from systems.view.fish_fins import CLOSE, fins_of
from systems.view.fish_lattice import lattice_of
from systems.view.fish_levels import COUNT_STEP, Level, levels_of
from systems.view.fish_surface import AROUND, HELD, body_side, control_points

Bend = Callable[[Body], Float64s]
MIRROR = np.array([0] + [4 * r + 1 + s for r in range(5) for s in (1, 0, 3, 2)] + [21, 22])


def dense(table: Float32s, column: int) -> Float64s:
    """Return one column of a level's table as weights of all nodes, (n, 23)."""
    first = table[:, 0, 3].astype(int) % COUNT_STEP
    weight = np.zeros((len(table), NODES))
    np.put_along_axis(weight, first[:, None] + np.arange(12), table[:, :, column], axis=1)
    return weight


def places(level: Level, nodes: Float64s) -> Float64s:
    return dense(level.table, 0) @ nodes


@st.composite
def bodies(draw: st.DrawFn) -> Body:
    gaps = draw(st.lists(st.floats(0.06, 0.3), min_size=6, max_size=6))
    station = np.cumsum(gaps)[:5] / np.sum(gaps)
    sizes = st.tuples(*[st.floats(0.01, 0.3)] * 5)
    start = draw(st.floats(0.1, 0.6))
    fin = Fin(start, start + draw(st.floats(0.05, 0.39)), draw(st.floats(0.01, 0.2)), 0.08)
    return Body(
        tuple(station.tolist()), draw(sizes), draw(sizes), draw(st.floats(0.03, 0.3)), dorsal=fin
    )


@settings(max_examples=15, deadline=None)
@given(bodies())
def test_any_body_binds_every_vertex_to_at_most_12_consecutive_nodes(body: Body) -> None:
    for level in levels_of(body):
        count = level.table[:, 0, 3].astype(int) // COUNT_STEP
        assert count.min() >= 1
        assert count.max() <= 12
        kind = level.table[:, 3, 3]
        assert np.allclose(dense(level.table, 0).sum(axis=1), 1.0, atol=1e-5)
        steps = level.table[kind < 2, :, 1:3].sum(axis=1)
        assert np.abs(steps).max() < 1e-3


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_a_basis_sums_to_one_and_its_slope_is_its_derivative(degree: int) -> None:
    at = np.linspace(0.03, 0.97, 40)
    assert np.allclose(basis(at, 9, degree).sum(axis=1), 1.0)
    step = 1e-6
    numeric = (basis(at + step, 9, degree) - basis(at - step, 9, degree)) / (2 * step)
    smooth = np.abs(numeric - slope(at, 9, degree)).max(axis=1)
    assert np.median(smooth) < 1e-6
    assert (basis(at, 9, degree) > 1e-12).sum(axis=1).max() <= degree + 1


def test_the_straight_surface_follows_the_stations(sample: Species) -> None:
    body = sample.body
    places_at_rest = places(levels_of(body)[0], rest_nodes(body))[: 37 * 13]
    x = -places_at_rest[:, 0]
    for at, half_width, half_height in zip(
        body.station, body.half_width, body.half_height, strict=True
    ):
        near = np.abs(x - at) < 0.02
        assert places_at_rest[near, 2].max() == pytest.approx(half_width, rel=0.12)
        tall = places_at_rest[near, 1].max() - places_at_rest[near, 1].min()
        assert tall == pytest.approx(2 * half_height, rel=0.15)
    assert x.min() == pytest.approx(0.0, abs=1e-6)


def test_the_body_has_the_papers_number_of_control_points(sample: Species) -> None:
    lattice = lattice_of(sample.body)
    points = control_points(lattice.outline, lattice.row)
    assert points.shape == (21, 9, 3)
    assert np.allclose(points[:, (0, -1), 2], 0.0)
    assert (points[..., 2] > -1e-9).all()


def test_left_and_right_are_mirror_images(sample: Species) -> None:
    lattice = lattice_of(sample.body)
    along, around = np.linspace(0, 1, 9), np.linspace(0, 1, 5)
    right, left = (body_side(lattice, along, around, side) for side in (1, -1))
    assert np.allclose(right.weight, left.weight[:, MIRROR])
    assert np.array_equal(right.texture, left.texture)
    fins = {
        (p.kind, side): p
        for p, side in zip(fins_of(lattice, CLOSE)[3:], (1, 1, -1, -1), strict=True)
    }
    for kind in (2, 3):
        assert np.allclose(fins[kind, 1].weight, fins[kind, -1].weight[:, MIRROR])
        assert np.allclose(fins[kind, 1].along_v, fins[kind, -1].along_v[:, MIRROR])


def test_normals_agree_with_differences_of_the_bent_surface(sample: Species, bent: Bend) -> None:
    lattice = lattice_of(sample.body)
    nodes = bent(sample.body)
    along, around = np.linspace(0.1, 0.93, 8), np.linspace(0.1, 0.9, 5)
    for side in (1, -1):
        patch = body_side(lattice, along, around, side)
        normal = np.cross(patch.along_u @ nodes, patch.along_v @ nodes)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        step = 1e-5
        ahead, behind = (
            body_side(lattice, along + d, around, side).weight @ nodes for d in (step, -step)
        )
        below, above = (
            body_side(lattice, along, around + d, side).weight @ nodes for d in (step, -step)
        )
        numeric = -side * np.cross(below - above, ahead - behind)
        numeric /= np.linalg.norm(numeric, axis=1)[:, None]
        assert (normal * numeric).sum(axis=1).min() > 0.99999


def test_normals_of_the_straight_body_point_outwards(sample: Species) -> None:
    level = levels_of(sample.body)[0]
    nodes = rest_nodes(sample.body)
    flank = level.table[:, 3, 3] == 0
    along_u, along_v = (dense(level.table, c)[flank] @ nodes for c in (1, 2))
    normal = np.cross(along_u, along_v)
    side = places(level, nodes)[flank, 2]
    wide = np.abs(side) > 0.02
    assert (normal[wide, 2] * side[wide] > 0).all()


def test_triangles_of_the_body_turn_anticlockwise_seen_from_outside(sample: Species) -> None:
    nodes = rest_nodes(sample.body)
    for level in levels_of(sample.body)[:2]:
        corner = places(level, nodes)[level.body]
        normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
        side = corner[..., 2].mean(axis=1)
        wide = np.abs(side) > 0.02
        assert (normal[wide, 2] * side[wide] > 0).mean() == 1.0


def test_the_far_level_lies_on_the_close_surface(sample: Species, bent: Bend) -> None:
    lattice = lattice_of(sample.body)
    nodes = bent(sample.body)
    far = body_side(lattice, greville(21), greville(AROUND), 1).weight @ nodes
    fine = body_side(lattice, np.linspace(0, 1, 241), np.linspace(0, 1, 97), 1).weight @ nodes
    gap = np.sqrt(((far[:, None] - fine[None]) ** 2).sum(axis=2).min(axis=1))
    assert gap.max() < 0.005


def test_a_body_moved_and_turned_carries_its_skin_along(sample: Species, bent: Bend) -> None:
    nodes = bent(sample.body)
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    level = levels_of(sample.body)[2]
    moved = places(level, nodes @ turn.T + [0.3, -0.2, 0.5])
    assert np.allclose(moved, places(level, nodes) @ turn.T + [0.3, -0.2, 0.5], atol=1e-5)


def test_every_species_has_the_same_topology(sample: Species) -> None:
    plain = Body((0.1, 0.3, 0.5, 0.65, 0.8), (0.05,) * 5, (0.08,) * 5, 0.1)
    for one, other in zip(levels_of(sample.body), levels_of(plain), strict=True):
        assert one.table.shape == other.table.shape
        assert np.array_equal(one.body, other.body)
        assert np.array_equal(one.fins, other.fins)


def test_a_fork_draws_the_middle_of_the_tail_in(sample: Species) -> None:
    from systems.view.fish_fins import caudal

    lattice = lattice_of(sample.body)
    fin = (caudal(lattice, 3, 3).weight @ rest_nodes(sample.body)).reshape(3, 3, 3)
    assert fin[-1, 1, 0] - fin[-1, 0, 0] == pytest.approx(sample.body.tail_fork, abs=1e-6)
    assert fin[-1, 2, 1] == pytest.approx(sample.body.tail_span, rel=0.01)


def test_a_shark_s_tail_has_a_long_upper_lobe_and_leaves_the_motion_alone(sample: Species) -> None:
    from systems.view.fish_fins import caudal
    from tools.capture.capture import fingerprint

    body = dataclasses.replace(sample.body, tail_upper=1.4, tail_lower=0.6, tail_slender=0.3)
    fin = (caudal(lattice_of(body), 3, 3).weight @ rest_nodes(body)).reshape(3, 3, 3)
    lower, upper = fin[-1, 0], fin[-1, 2]
    assert upper[1] == pytest.approx(1.4 * body.tail_span, rel=0.02)
    assert lower[1] == pytest.approx(-0.6 * body.tail_span, rel=0.02)
    assert lower[0] > upper[0] + 0.03
    assert fingerprint(body, sample.swim) == fingerprint(sample.body, sample.swim)


def test_a_pointed_snout_is_lower_ahead_of_the_first_station_only(sample: Species) -> None:
    blunt, pointed = (
        lattice_of(dataclasses.replace(sample.body, snout=snout)).outline for snout in (0.5, 1.0)
    )
    ahead = np.array([0.25, 0.5]) * sample.body.station[0]
    assert (pointed.half_height(ahead) < 0.85 * blunt.half_height(ahead)).all()
    stations = np.array(sample.body.station)
    assert np.allclose(pointed.half_height(stations), blunt.half_height(stations))


def test_fins_held_out_are_wings_that_taper(sample: Species) -> None:
    body = dataclasses.replace(
        sample.body, pectoral_held=True, pectoral_length=0.2, pelvic_at=0.5, pelvic_length=0.05
    )
    fins = fins_of(lattice_of(body), CLOSE)[3:]
    assert [fin.kind for fin in fins] == [HELD] * 4
    nodes = rest_nodes(body)
    for fin, length, at in zip(fins[:2], (0.2, 0.05), (body.pectoral_at, 0.5), strict=True):
        base = (fin.weight @ nodes).reshape(5, 4, 3)
        chord = np.ptp(base[..., 0], axis=1)
        assert chord[0] > 2 * chord[-1]
        assert np.linalg.norm(fin.along_v[-1] @ nodes) == pytest.approx(length, rel=0.05)
        assert -base[0, :, 0].mean() == pytest.approx(at, abs=0.02)
