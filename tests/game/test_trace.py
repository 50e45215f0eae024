"""Traces: every sample says of every fish, by id, what the tables held."""

from pathlib import Path

import numpy as np

from reefgame.content import load
from reefgame.soak import Trace
from reefgame.world import World


def test_samples_are_aligned_by_id_though_fishes_leave_and_rows_move(tmp_path: Path) -> None:
    world = World.build(load("visitors"), 2)
    people, path = world.population, tmp_path / "t.npz"
    gone, stays = int(people.fish.id[0]), int(people.fish.id[people.count - 1])
    with Trace(path) as trace:
        expected = []
        for _ in range(3):
            trace.sample(world)
            row = people.row(stays)
            expected.append((people.fish.position[row].copy(), float(people.mind.hunger[row])))
            if gone in people:
                world.spawn.remove(gone)
            for _ in range(20):
                world.tick()
        trace.save()
    assert [file.name for file in tmp_path.iterdir()] == ["t.npz"]
    with np.load(path, allow_pickle=False) as data:
        at = list(data["id"]).index(stays)
        for sample, (place, hunger) in enumerate(expected):
            assert (data["position"][sample, at] == place).all()
            assert data["hunger"][sample, at] == np.float32(hunger)
        left = list(data["id"]).index(gone)
        assert data["why"][0, left] >= 0
        assert (data["why"][1:, left] == -1).all()
        assert np.isnan(data["fear"][1:, left]).all()
        assert (data["swallowed"] == -1).all()
        assert list(data["tick"]) == [0, 20, 40]
