"""Entities: every fish has an esper entity whose component is its handle (DESIGN 2).

esper keeps worlds by name in its module; each dive has a name of its own, so that dives in one
process stay apart. The tables are the truth: `sync` makes the handles follow them after a snapshot
was restored.
"""

from collections.abc import Iterable
from itertools import count

import esper
import numpy as np

from components.fish import Fish

_NAMES = count()

_NONE = 0
"""No entity: esper counts from 1."""


class Entities:
    """The handles of one dive's fishes, by stable id."""

    def __init__(self) -> None:
        self.context = f"dive-{next(_NAMES)}"
        self._number = 0
        # By id, from which ids never come back: a dictionary would take twenty times as much of a large world's memory.
        self._entity = np.full(16, _NONE, np.int32)

    def enter(self) -> None:
        """Make this dive's entities the ones that esper's functions speak of."""
        esper.switch_world(self.context)

    def add(self, ids: Iterable[int]) -> None:
        """Create the handle of each new id."""
        self.enter()
        for identity in ids:
            if identity >= len(self._entity):
                room = np.full(2 * identity, _NONE, np.int32)
                room[: len(self._entity)] = self._entity
                self._entity = room
            self._entity[identity] = esper.create_entity(Fish(identity))
            self._number += 1

    def remove(self, identity: int) -> None:
        """Delete the handle of `identity`. Raise KeyError where there is none."""
        entity = int(self._entity[identity]) if 0 <= identity < len(self._entity) else _NONE
        if entity == _NONE:
            raise KeyError(identity)
        self.enter()
        esper.delete_entity(entity, immediate=True)
        self._entity[identity] = _NONE
        self._number -= 1

    def sync(self, ids: Iterable[int]) -> None:
        """Make the handles those of `ids` and no others."""
        wanted, held = set(ids), set(np.flatnonzero(self._entity != _NONE).tolist())
        for identity in held - wanted:
            self.remove(identity)
        self.add(sorted(wanted - held))

    def __len__(self) -> int:
        return self._number
