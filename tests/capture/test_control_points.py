"""Recorded control points: what nodes would give, in the world, in a file, mirrored; and no trace where unasked."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from components.arrays import Float64s
from components.body import Body, rest_nodes
from components.control_points import restored
from components.repertoire import (
    Pattern,
    Repertoire,
    RepertoireError,
    Segment,
    load,
    mirrored,
    save,
)
from components.segment import CONTROL_POINTS
from reefgame.cli import main
from systems.view.bspline import basis
from systems.view.fish_lattice import ROWS, lattice_of
from systems.view.fish_surface import AROUND, body_side
from tools.capture.control_points import control_weights, memory, with_control_points


@pytest.fixture
def recorded(shipped: Repertoire, body: Body) -> Repertoire:
    """A shipped repertoire with control points."""
    return with_control_points(shipped, body)


def from_nodes(segment: Segment, weights: Float64s, start: Float64s, size: float) -> Float64s:
    """Return the world's control points after each entry, evaluated from the nodes of eq. 12."""
    origin, rotation, found = np.array([3.0, -2.0, -5.0]), start, []
    for m, t, d in zip(segment.rotation, segment.translation, segment.shape, strict=True):
        origin, rotation = origin + rotation @ (size * t), rotation @ m
        found.append(weights @ (origin + size * d.astype(np.float64) @ rotation.T))
    return np.array(found)


@pytest.mark.parametrize("pattern", [Pattern.SWIM_MEDIUM, Pattern.TURN_SHARP_LEFT])
def test_restored_control_points_are_those_that_the_nodes_give(
    recorded: Repertoire, body: Body, pattern: Pattern
) -> None:
    segment = next(s for s in recorded.segments if s.pattern == pattern)
    start = np.array([[0.6, 0.0, 0.8], [0.0, 1.0, 0.0], [-0.8, 0.0, 0.6]])
    placed = restored(segment, np.array([3.0, -2.0, -5.0]), start, 0.23)
    expected = from_nodes(segment, control_weights(body), start, 0.23)
    assert placed.dtype == np.float32
    assert placed.shape == (len(segment.shape), CONTROL_POINTS, 3)
    assert np.abs(placed - expected).max() < 1e-6
    assert start[0, 0] == 0.6


def test_control_points_span_the_skin_that_is_drawn(body: Body) -> None:
    lattice, weights = lattice_of(body), control_weights(body)
    assert weights.sum(axis=1) == pytest.approx(1.0)
    along, around = np.linspace(0.0, 1.0, 9), np.linspace(0.0, 1.0, 5)
    net = (weights @ rest_nodes(body)).reshape(2, ROWS, AROUND, 3)
    for side, sign in ((0, 1), (1, -1)):
        drawn = body_side(lattice, along, around, sign).weight @ rest_nodes(body)
        spline = np.einsum("mj,jkc,nk->mnc", basis(along, ROWS), net[side], basis(around, AROUND))
        # In the straight body rows of control points are upright, so the surface is the product of the bases.
        assert np.abs(spline.reshape(-1, 3) - drawn).max() < 0.02
        assert (sign * net[side][..., 2] >= -1e-12).all()


def test_a_file_with_control_points_is_read_as_it_was_written(
    recorded: Repertoire, shipped: Repertoire, shipped_file: Path, tmp_path: Path
) -> None:
    save(tmp_path / "with.npz", recorded)
    again = load(tmp_path / "with.npz")
    for one, other in zip(again.segments, recorded.segments, strict=True):
        assert one.control is not None
        assert other.control is not None
        assert np.array_equal(one.control, other.control)
    plain = Repertoire(tuple(replace(s, control=None) for s in again.segments), again.provenance)
    save(tmp_path / "without.npz", plain)
    assert (tmp_path / "without.npz").read_bytes() == shipped_file.read_bytes()
    without, control = memory(recorded)
    assert memory(shipped) == (without, 0)
    assert control == sum(len(s.shape) for s in shipped.segments) * CONTROL_POINTS * 12
    larger = (tmp_path / "with.npz").stat().st_size - shipped_file.stat().st_size
    assert 0 < larger - control < 1000


def test_wrong_control_points_are_told(recorded: Repertoire, tmp_path: Path) -> None:
    first, *others = recorded.segments
    assert first.control is not None
    far = replace(first, control=first.control + np.float32(9.0))
    save(tmp_path / "far.npz", replace(recorded, segments=(far, *others)))
    with pytest.raises(RepertoireError, match="control holds a number beyond 3"):
        load(tmp_path / "far.npz")
    short = replace(first, control=first.control[1:])
    save(tmp_path / "short.npz", replace(recorded, segments=(short, *others)))
    with pytest.raises(RepertoireError, match="does not add up"):
        load(tmp_path / "short.npz")
    none = replace(first, control=None)
    with pytest.raises(ValueError, match="some have none"):
        save(tmp_path / "none.npz", replace(recorded, segments=(none, *others)))
    assert not (tmp_path / "none.npz").exists()
    with pytest.raises(ValueError, match="swim_slow holds no control points"):
        restored(none, np.zeros(3), np.eye(3))


def test_mirrored_control_points_are_those_of_the_mirrored_nodes(
    recorded: Repertoire, body: Body
) -> None:
    turn = next(s for s in recorded.segments if s.pattern == Pattern.TURN_SHARP_LEFT)
    right = mirrored(turn, Pattern.TURN_SHARP_RIGHT)
    assert right.control is not None
    expected = np.einsum("pn,enc->epc", control_weights(body), right.shape.astype(np.float64))
    assert np.abs(right.control - expected).max() < 1e-6
    assert mirrored(replace(turn, control=None), Pattern.TURN_SHARP_RIGHT).control is None


@pytest.mark.parametrize("name", ["sardine"])
def test_the_switch_records_and_tells_what_it_costs(
    shipped: Repertoire,
    installed: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("tools.capture.capture.capture", lambda *_: shipped)
    species = str(installed / "assets" / "species" / "sardine.yaml")
    assert main(["capture", species, "-o", str(tmp_path), "--control-points"]) == 0
    plain, _ = memory(shipped)
    found = load(tmp_path / "sardine.npz")
    said = capsys.readouterr().out.splitlines()
    assert found.segments[0].control is not None
    assert f"Sardine: {sum(memory(found)):,} bytes with control points, {plain:,} without" in said
