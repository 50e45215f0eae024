"""Rings along fibres: through the nodes, evenly spaced, with frames that do not twist."""

import numpy as np
import pytest

from components.arrays import Float32s, Float64s
from components.fibre import Tuft
from components.garden import Garden
from systems.view.fibre_strips import RING, fibres_of, write_strips

NODES = 9


def bent(turn: float) -> Float64s:
    """Return the nodes [m] of a fibre that bends by `turn` [rad] in all, in a plane, (1, NODES, 3)."""
    angle = np.linspace(0.0, turn, NODES - 1)
    steps = 0.1 * np.stack((np.sin(angle), 0.0 * angle, np.cos(angle)), axis=1)
    return np.concatenate((np.zeros((1, 3)), np.cumsum(steps, axis=0)))[None]


def rings(points: Float64s, number: int) -> Float32s:
    """Return the rings of the first of these fibres, (number, RING)."""
    garden = Garden([Tuft(points, np.linspace(0.04, 0.01, NODES))])
    fibres = fibres_of(garden)
    out = np.zeros((number, RING), np.float32)
    one = np.zeros(1, np.int32)
    write_strips(fibres, one, one + number, one, np.zeros(RING), out)
    return out


@pytest.mark.parametrize("turn", [0.0, 1.4, 3.0])
def test_rings_as_many_as_nodes_lie_on_them(turn: float) -> None:
    points = bent(turn)
    found = rings(points, NODES)
    assert found[:, :3] == pytest.approx(points[0], abs=1e-6)
    assert found[:, 3] == pytest.approx(np.linspace(0.04, 0.01, NODES), abs=1e-6)
    assert found[-1, 7] == pytest.approx(0.8, abs=1e-5)


@pytest.mark.parametrize("number", [2, 3, 5, 17, 33])
def test_frames_are_square_and_do_not_twist(number: int) -> None:
    found = rings(bent(2.5), number).astype(np.float64)
    side, ahead = found[:, 4:7], found[:, 8:11]
    assert np.linalg.norm(side, axis=1) == pytest.approx(1.0, abs=1e-5)
    assert np.linalg.norm(ahead, axis=1) == pytest.approx(1.0, abs=1e-5)
    assert np.abs((side * ahead).sum(axis=1)).max() < 1e-5
    # The fibre bends in the plane y = 0: what stands out of it goes on standing out of it as far.
    assert side[:, 1] == pytest.approx(side[0, 1], abs=1e-4)


def test_between_nodes_a_fibre_is_round() -> None:
    turn = 2.5
    found = rings(bent(turn), 4 * (NODES - 1) + 1)
    ahead = found[:, 8:11].astype(np.float64)
    corner = np.arccos(np.clip((ahead[1:] * ahead[:-1]).sum(axis=1), -1.0, 1.0))
    assert corner.max() < 0.5 * turn / (NODES - 2)
    assert corner.sum() == pytest.approx(turn, rel=0.2)


def test_a_slope_says_how_fast_a_fibre_tapers() -> None:
    found = rings(bent(0.0), 17)
    assert found[:, 11] == pytest.approx(-0.03 / 0.8, rel=1e-3)


def test_a_folded_fibre_has_finite_rings() -> None:
    points = bent(0.0)
    points[0, 5:] = points[0, 4:0:-1] + (1e-4, 0.0, 0.0)
    found = rings(points, 20)
    assert np.isfinite(found).all()
    assert np.linalg.norm(found[:, 4:7], axis=1) == pytest.approx(1.0, abs=1e-3)


def test_upright_fibres_are_turned_each_its_own_way() -> None:
    roots = np.zeros((5, 1, 3)) + np.arange(5.0)[:, None, None] * (1.0, 0.0, 0.0)
    garden = Garden([Tuft(roots + bent(0.0), np.full(NODES, 0.01))])
    side = fibres_of(garden).side
    assert np.linalg.norm(side, axis=1) == pytest.approx(1.0, abs=1e-5)
    assert np.abs(side @ side.T - np.eye(5)).max() < 0.999
    assert side[:, 2] == pytest.approx(0.0, abs=1e-6)
