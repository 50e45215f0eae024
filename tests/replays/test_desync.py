"""A planted desync of one unit in the last place is caught, and named by table and tick."""

from pathlib import Path

import numpy as np
import pytest

from reefgame.autopilot import tour
from reefgame.content import load
from reefgame.replay import Desync, read_replay, verify
from reefgame.testing import play
from reefgame.world import World


class Spoiled(World):
    """A world in which one number is off by one ulp after a given tick."""

    spoil_at = 0
    table = "fish"
    column = "position"

    def tick(self, *command: object) -> None:
        super().tick(*command)  # type: ignore[arg-type]
        if self.clock.now - 1 == self.spoil_at:
            values = getattr(self.tables[self.table], self.column)
            values[0, 0] = np.nextafter(values[0, 0], np.inf)


def desync(tmp_path: Path, every: int, spoil_at: int, table: str, column: str) -> Desync | None:
    path = tmp_path / "a.replay"
    dive = play("first_dive", tour, seconds=3.0, seed=5, checksum_every=every)
    path.write_text(dive.replay, encoding="ascii")
    world = Spoiled.build(load("first_dive"), 5)
    assert isinstance(world, Spoiled)
    world.spoil_at, world.table, world.column = spoil_at, table, column
    return verify(read_replay(path), world)


@pytest.mark.parametrize(("table", "column"), [("fish", "position"), ("submarine", "velocity")])
def test_with_a_checksum_each_tick_the_desync_names_table_and_tick(
    tmp_path: Path, table: str, column: str
) -> None:
    found = desync(tmp_path, 1, 100, table, column)
    assert found is not None
    assert (found.tick, found.since) == (100, 99)
    assert found.tables == (table,)
    assert str(found) == f"desync in {table} at tick 100"


def test_with_a_checksum_each_second_the_desync_names_the_window(tmp_path: Path) -> None:
    found = desync(tmp_path, 60, 100, "fish", "position")
    assert found is not None
    assert (found.tick, found.since) == (119, 59)
    assert "fish" in found.tables
    assert str(found).endswith("between ticks 60 and 119")


def test_an_unspoiled_world_shows_no_desync(tmp_path: Path) -> None:
    assert desync(tmp_path, 1, -1, "fish", "position") is None
