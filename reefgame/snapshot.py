"""A copy of all simulation state: for saves, scrubbing, desync hunting and tests (DESIGN 2)."""

from collections.abc import Mapping
from dataclasses import dataclass

from components.arrays import AnyArray
from components.table import Table


@dataclass(frozen=True)
class Snapshot:
    """Copies of every table's living rows, by table and column."""

    tables: Mapping[str, Mapping[str, AnyArray]]

    @classmethod
    def of(cls, tables: Mapping[str, Table]) -> "Snapshot":
        """Copy the tables."""
        return cls({name: table.snapshot() for name, table in tables.items()})

    def into(self, tables: Mapping[str, Table]) -> None:
        """Make the tables equal to the copies. Raise KeyError where a table is missing."""
        for name, table in tables.items():
            table.restore(dict(self.tables[name]))
