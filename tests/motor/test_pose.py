"""Pose: eq. 12, interpolation between ticks, and the kernels that benches time."""

from collections.abc import Callable

import numpy as np
import pytest

from components.body import NODES
from components.clock import Clock
from components.fish import Population
from components.repertoire import Pattern, RepertoireLibrary
from components.terrain import Terrain
from systems.motor.columns import bodies, motors
from systems.motor.move import Move
from systems.motor.pose import pose, reconstruct, replay
from systems.motor.track import track

School = Callable[[int, RepertoireLibrary], Population]


def _moved(school: School, library: RepertoireLibrary, sea: Terrain, ticks: int) -> Population:
    """Return eight swimmers that have just left their swim for eight segments."""
    fish = school(8, library)
    fish.fish.length[:8] = np.linspace(0.1, 1.5, 8)
    fish.motor.steer[:8, 2] = np.linspace(-0.03, 0.03, 8)
    fish.motor.wanted[:8] = np.arange(8) % 5
    move = Move(fish, library, sea, Clock())
    for _ in range(ticks):
        move()
    return fish


def test_nodes_stand_where_equation_12_puts_them(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish = _moved(school, captured, sea, 3)
    f, m, d = fish.fish, fish.motor, captured.shape
    w = m.warp_weight[:8, None, None]
    shape = d[m.shape_row[:8]] + w * (d[m.warp_from[:8]] - d[m.warp_to[:8]])
    turned = np.einsum("nij,nkj->nki", f.rotation[:8], shape)
    nodes = f.position[:8, None] + f.length[:8, None, None] * turned
    np.testing.assert_allclose(pose(fish, captured), nodes, atol=3e-6)
    assert (w > 0.1).any()
    np.testing.assert_allclose(pose(fish, captured, body=True), shape, atol=1e-6)


def test_a_tick_begins_where_the_last_one_ended(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish = _moved(school, captured, sea, 5)
    move = Move(fish, captured, sea, Clock())
    before = pose(fish, captured)
    move()
    np.testing.assert_allclose(pose(fish, captured, alpha=0.0), before, atol=3e-6)
    assert np.abs(pose(fish, captured) - before).max() > 1e-3


@pytest.mark.parametrize("alpha", [0.25, 0.5, 0.75])
def test_between_ticks_a_fish_keeps_its_size_and_its_way(
    school: School, captured: RepertoireLibrary, sea: Terrain, alpha: float
) -> None:
    fish = _moved(school, captured, sea, 4)
    middle = pose(fish, captured, alpha=alpha)
    ends = (1 - alpha) * pose(fish, captured, alpha=0.0) + alpha * pose(fish, captured)
    size = fish.fish.length[:8, None, None]
    assert np.abs((middle - ends) / size).max() < 2e-3
    body = pose(fish, captured, alpha=alpha, body=True)
    for shown, own, length in zip(middle, body, fish.fish.length, strict=False):
        across = np.linalg.norm(shown[1] - shown[20])
        assert across == pytest.approx(length * np.linalg.norm(own[1] - own[20]), rel=1e-4)


def test_chosen_rows_are_posed_in_their_order(
    school: School, library: RepertoireLibrary, sea: Terrain
) -> None:
    fish = _moved(school, library, sea, 2)
    rows = np.array([5, 0, 5])
    np.testing.assert_array_equal(pose(fish, library, rows), pose(fish, library)[rows])
    assert pose(fish, library, np.array([], np.int64)).shape == (0, NODES, 3)


def test_the_fast_kernel_gives_the_reference_s_nodes(
    school: School, captured: RepertoireLibrary, sea: Terrain
) -> None:
    fish = _moved(school, captured, sea, 3)
    nodes = np.empty((8, 3, NODES + 1), np.float32)
    played = track(captured)
    reconstruct(8, bodies(fish.fish), motors(fish.motor), played.shape, played.after, nodes)
    planes = pose(fish, captured).transpose(0, 2, 1)
    np.testing.assert_allclose(nodes[:, :, :NODES], planes, atol=2e-6)
    assert fish.motor.warp_weight[:8].max() > 0.0


def test_bare_replay_computes_equations_10_to_12(library: RepertoireLibrary) -> None:
    segment = int(library.segment[0, Pattern.SWIM_MEDIUM])
    first, length = int(library.start[segment]), int(library.length[segment])
    frame, size = np.array([3, 14], np.int32), np.array([1.0, 0.3])
    R, o = np.repeat(np.eye(3)[None], 2, axis=0), np.zeros((2, 3))
    nodes = np.empty((2, 3, NODES + 1), np.float32)
    for _ in range(20):
        replay(first, length, frame, size, track(library), R, o, nodes)
    for fish, start in enumerate((3, 14)):
        rotation, origin = np.eye(3), np.zeros(3)
        for k in range(20):
            entry = first + (start + k) % length
            origin += rotation @ (size[fish] * library.translation[entry])
            rotation = rotation @ library.rotation[entry]
        expected = origin + size[fish] * library.shape[entry] @ rotation.T
        np.testing.assert_allclose(nodes[fish, :, :NODES].T, expected, atol=1e-6)
        assert frame[fish] == (start + 20) % length
