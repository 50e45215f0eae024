"""Entities: every fish has an esper entity whose component is its handle (DESIGN 2).

esper keeps worlds by name in its module; each dive has a name of its own, so that dives in one
process stay apart. The tables are the truth: `sync` makes the handles follow them after a snapshot
was restored.
"""

from collections.abc import Iterable
from itertools import count

import esper

from components.fish import Fish

_NAMES = count()


class Entities:
    """The handles of one dive's fishes, by stable id."""

    def __init__(self) -> None:
        self.context = f"dive-{next(_NAMES)}"
        self._entity: dict[int, int] = {}

    def enter(self) -> None:
        """Make this dive's entities the ones that esper's functions speak of."""
        esper.switch_world(self.context)

    def add(self, ids: Iterable[int]) -> None:
        """Create the handle of each new id."""
        self.enter()
        for identity in ids:
            self._entity[identity] = esper.create_entity(Fish(identity))

    def remove(self, identity: int) -> None:
        """Delete the handle of `identity`. Raise KeyError where there is none."""
        self.enter()
        esper.delete_entity(self._entity.pop(identity), immediate=True)

    def sync(self, ids: Iterable[int]) -> None:
        """Make the handles those of `ids` and no others."""
        wanted = set(ids)
        for identity in self._entity.keys() - wanted:
            self.remove(identity)
        self.add(sorted(wanted - self._entity.keys()))

    def __len__(self) -> int:
        return len(self._entity)
