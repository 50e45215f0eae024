"""A small bare sea with sardines, barracudas and food, in which tests set up by hand who eats whom."""

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import pytest

from components.anemone import Cap
from components.arrays import Float64s
from components.mind import Intention
from reefgame.content import Content, load
from reefgame.world import World
from systems.play.feed import Feed
from systems.sea.drift import Drift

SEA = """
title: Pantry
world: {{radius_m: 20, depth_m: 12}}
seabed: {{seed: 1, relief_m: 0.5}}
submarine: {{at_m: [-15, 0, -5]}}
fishes: [{fishes}]
food: [{food}]
objective:
  photograph: {{species: sardine, count: 1, within_m: 6}}
"""
SCHOOL = "{species: sardine, count: 6, around_m: [4, 0, -5], within_m: 2, restock_s: 2}"
HUNTERS = "{species: barracuda, count: 2, around_m: [-4, 0, -5], within_m: 1}"
ONE_SARDINE = "{species: sardine, count: 1, around_m: [-15, 0, -3], within_m: 0.1}"
PLANKTON = (
    "{around_m: [0, 4, -5], within_m: 1, particles: 20, drift_m_per_s: [0.3, 0, 0.1], returns_s: 1}"
)

ANEMONE = Cap((0.0, 0.0, -9.0), 0.8, stings=True, holds=0.15)
"Its middle stands over the ground."

Sea = Callable[..., World]


class Table:
    """Drifting and feeding alone, of a world in which nobody else does anything."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.feed = next(system for system in world.systems if isinstance(system, Feed))
        self.drift = next(system for system in world.systems if isinstance(system, Drift))
        fish, mind = world.population.fish, world.population.mind
        fish.last_rotation[: fish.count] = fish.rotation[: fish.count] = np.array(
            [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]
        )
        mind.intention[: fish.count] = Intention.WANDER
        mind.gape[: fish.count] = 0.0

    def of(self, species: str) -> list[int]:
        """Return the ids of a species, rising."""
        kind = [one.name for one in self.world.species].index(species)
        fish = self.world.population.fish
        return sorted(fish.live("id")[fish.live("species") == kind].tolist())

    def row(self, identity: int) -> int:
        """Return the fish's row."""
        return self.world.population.row(identity)

    def put(self, identity: int, at: Float64s) -> None:
        """Let the fish be somewhere, at rest."""
        fish, i = self.world.population.fish, self.row(identity)
        fish.position[i] = fish.last_position[i] = at

    def nose(self, identity: int) -> Float64s:
        """Return where the fish's mouth is [m]."""
        fish, i = self.world.population.fish, self.row(identity)
        ahead = self.world.senses.nose[fish.species[i]] * fish.length[i]
        place: Float64s = fish.position[i] + ahead * fish.rotation[i, :, 0]
        return place

    def reach(self, identity: int) -> float:
        """Return how far from it the mouth sucks in [m]."""
        fish, i = self.world.population.fish, self.row(identity)
        return float(self.world.senses.mouth[fish.species[i]] * fish.length[i])

    def gape(self, identity: int, focus: int, gape: float = 1.0) -> None:
        """Let it be about to eat what it attends to."""
        mind, i = self.world.population.mind, self.row(identity)
        mind.intention[i], mind.focus[i], mind.gape[i] = Intention.EAT, focus, gape

    def tick(self, times: int = 1) -> None:
        """Let mouths work, and those who are due come; nobody swims."""
        fish = self.world.population.fish
        for _ in range(times):
            fish.last_position[: fish.count] = fish.position[: fish.count]
            self.drift()
            self.feed()
            self.world.spawn()
            self.world.clock.tick[0] += 1


@pytest.fixture(scope="session")
def sea(tmp_path_factory: pytest.TempPathFactory) -> Sea:
    """Build the world of a sea with certain fishes and food."""

    def build(
        fishes: str = f"{SCHOOL}, {HUNTERS}",
        food: str = PLANKTON,
        seed: int = 3,
        mods: Sequence[Path] = (),
    ) -> World:
        path = tmp_path_factory.mktemp("sea") / "pantry.yaml"
        path.write_text(SEA.format(fishes=fishes, food=food), encoding="utf-8")
        return World.build(load(path, mods), seed)

    return build


@pytest.fixture
def table(sea: Sea) -> Table:
    """Six sardines, two barracudas, twenty particles of food."""
    return Table(sea())


@pytest.fixture(scope="session")
def garden(sea: Sea) -> Callable[..., World]:
    """Build the world of the sea with certain fishes and no food; one anemone stands on its ground, or those given."""

    contents: dict[str, Content] = {}

    def build(fishes: str, caps: Sequence[Cap] = (ANEMONE,), seed: int = 3) -> World:
        if fishes not in contents:
            contents[fishes] = sea(f"{fishes}, {ONE_SARDINE}", "").content
        return World.build(contents[fishes], seed, caps=caps)

    return build
