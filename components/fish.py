"""The fishes: who is where, how big and which way up (DESIGN 2).

`Fish` is the esper component, a handle that holds a stable id and nothing else. `Population` keeps
the three tables of the fishes in step, row for row, and knows the row of an id. Rows move (removal,
sorting into grid order); ids never do.
"""

from dataclasses import dataclass, field

import numpy as np

from components.arrays import Float64s, Int32s, Int64s
from components.index import RowIndex, rows_of
from components.mind import MindTable
from components.motor import MotorTable
from components.table import Table, column


@dataclass(frozen=True, slots=True)
class Fish:
    """Handle of one fish: the id by which everything else refers to it across ticks."""

    id: int


class FishTable(Table):
    """Where each fish is, one row each."""

    id: Int64s = column(np.int64, fill=-1)
    "stable id, never used again, (capacity,)"
    species: Int32s = column(np.int32)
    "row in `SpeciesTable`, (capacity,)"
    cohort: Int32s = column(np.int32)
    "which of the level's groups spawned it, below 0 for groups of no level; a cohort roams together, (capacity,)"
    length: Float64s = column(np.float64, fill=1)
    "[m] nose to tail tip; alpha of papers/000 eq. 12, (capacity,)"
    position: Float64s = column(np.float64, 3)
    "[m] origin o of the body axes, world axes, z = 0 at the surface, (capacity, 3)"
    rotation: Float64s = column(np.float64, 3, 3)
    "R: columns are the body's x anterior, y dorsal, z right in world axes, (capacity, 3, 3)"
    last_position: Float64s = column(np.float64, 3)
    "[m] position a tick ago, for interpolation, (capacity, 3)"
    last_rotation: Float64s = column(np.float64, 3, 3)
    "rotation a tick ago, for interpolation, (capacity, 3, 3)"


@dataclass
class Population:
    """All fishes: three tables whose rows stand in step, and the map from id to row."""

    fish: FishTable = field(default_factory=FishTable)
    mind: MindTable = field(default_factory=MindTable)
    motor: MotorTable = field(default_factory=MotorTable)

    def __post_init__(self) -> None:
        self.changes = 0
        "how often fishes came, left or were restored: else there are as many of each species"
        self.index = RowIndex()
        self.reindex()

    @property
    def count(self) -> int:
        """How many fishes live."""
        return self.fish.count

    def append(self, ids: Int64s) -> slice:
        """Add a row for each new id to all three tables; return the rows."""
        self.changes += 1
        rows = self.fish.append(len(ids))
        self.mind.append(len(ids))
        self.motor.append(len(ids))
        self.fish.id[rows] = ids
        if not self.index.add(ids, rows.start):
            self._reindex()
        return rows

    def remove(self, identity: int) -> None:
        """Forget the fish `identity`; the last row takes its place. Raise KeyError where there is none."""
        self.changes += 1
        row, last = self.row(identity), self.fish.count - 1
        self.index.move(int(self.fish.id[last]), row)
        self.index.move(identity, -1)
        for table in (self.fish, self.mind, self.motor):
            table.remove(row)

    def reorder(self, order: Int64s) -> None:
        """Put the fish of row order[i] into row i."""
        for table in (self.fish, self.mind, self.motor):
            table.reorder(order)
        self._reindex()

    def reindex(self) -> None:
        """Rebuild the map from id to row after rows were moved or restored."""
        self.changes += 1
        self._reindex()

    def _reindex(self) -> None:
        self.index.rebuild(self.fish.id[: self.fish.count])

    def row(self, identity: int) -> int:
        """Return the row of the fish `identity`. Raise KeyError where there is none."""
        row = self.index.row(identity)
        if row < 0:
            raise KeyError(identity)
        return row

    def rows(self, ids: Int64s) -> Int64s:
        """Return the rows of the fishes `ids`, -1 for those that do not live and for ids below 0; (n,) each."""
        return rows_of(self.index.places, ids)

    def __contains__(self, identity: int) -> bool:
        return self.index.row(identity) >= 0
