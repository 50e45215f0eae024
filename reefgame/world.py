"""The world of one dive: all tables, the static content and the systems that advance them.

`World.build` makes it from content and a seed; `tick` advances it by 1/60 s; `snapshot` and
`restore` serve saves, scrubbing and desync hunting: restored anywhere, the checksums that follow
are equal.
"""

from collections.abc import Sequence

from components.anemone import AnemoneTable, Cap, anemone_table
from components.clock import Clock
from components.cohort import RestockTable, Roster
from components.command import Command, CommandTable
from components.entities import Entities
from components.fish import Population
from components.flora import Plant
from components.habitat import Habitat
from components.live import MOST_LIVE, LiveTable
from components.objective import ObjectiveTable, Photograph
from components.possession import AvatarTable
from components.repertoire import RepertoireLibrary, pack
from components.senses import SenseTable, sense_table
from components.species import Species
from components.submarine import SubmarineTable
from components.table import Table
from components.terrain import Terrain
from components.trigonometry import DEGREE
from reefgame.checksum import table_checksum
from reefgame.content import Content
from reefgame.content.level_checks import terrain_of
from reefgame.content.planting import planting
from reefgame.content.schema.level import Level
from reefgame.flow_tables import singularities_of
from reefgame.level_tables import caps_of, cohorts_of, food_of, habitat_of, patches_of, shelters_of
from reefgame.schedule import schedule, spawner, stirrer
from reefgame.snapshot import Snapshot
from systems.motor.live import Live


class World:
    """One dive. Build it with `World.build(content, seed)`."""

    def __init__(
        self, content: Content, seed: int, live: int = 0, caps: Sequence[Cap] = ()
    ) -> None:
        if not 0 <= live <= MOST_LIVE:
            raise ValueError(f"{live} fishes in live physics: 0 to {MOST_LIVE} there may be")
        self.content = content
        self.live_fishes = live
        self.live = LiveTable(count=2 * live)
        self.level: Level = content.level
        self.species: tuple[Species, ...] = content.species
        self.library: RepertoireLibrary = pack(
            [s.repertoire for s in content.species], spare=2 * self.live.count
        )
        self.terrain: Terrain = terrain_of(content.level)
        self.floras = content.floras
        self.plants: tuple[Plant, ...] = planting(
            content.level, content.floras, self.terrain
        ).plants
        caps = [*caps_of(self.plants, self.floras), *caps]
        self.anemones: AnemoneTable = anemone_table(caps)
        self.terrain = _with_homes(self.terrain, content, caps)
        self.clock = Clock(seed)
        self.roster = Roster()
        names = [species.name for species in content.species]
        self.cohorts = cohorts_of(content.level, names)
        self.restocks = RestockTable()
        self.population = Population()
        self.entities = Entities()
        self.patches = patches_of(content.level)
        self.food = food_of(content.level, self.patches, self.terrain, seed)
        self.habitat: Habitat = habitat_of(content.level)
        self.senses: SenseTable = sense_table(self.species, self.library)
        self.submarine = _submarine(content.level)
        self.singularities, self.key_frames = singularities_of(content.level, names, self.terrain)
        self.commands = CommandTable()
        self.avatar = AvatarTable()
        self.goals = _goals(content)
        self.objective = ObjectiveTable(count=len(self.goals))
        self.spawn = spawner(self)
        self.stir = stirrer(self)
        self.systems = schedule(self)

    @classmethod
    def build(
        cls, content: Content, seed: int = 0, live: int = 0, caps: Sequence[Cap] = ()
    ) -> "World":
        """Return the world of the content's level before its first tick, the first groups in it.

        The `live` fishes nearest the submarine run the muscle model, 0 to 50; raise ValueError for other numbers.
        `caps` are anemones besides those that the level plants.
        """
        world = cls(content, seed, live, caps)
        world.spawn()
        world.stir()
        return world

    def tick(self, command: Command = Command()) -> None:  # noqa: B008 (an immutable tuple)
        """Advance everything by 1/60 s under the pilot's command."""
        self.commands.give(command)
        for system in self.systems:
            system()
        self.clock.tick[0] += 1

    @property
    def tables(self) -> dict[str, Table]:
        """Every table that holds state, by name, in the order of their checksums; none for what is not there at all."""
        seldom = {"live": self.live, "anemones": self.anemones}
        return self._tables | {name: table for name, table in seldom.items() if table.count}

    @property
    def _tables(self) -> dict[str, Table]:
        return {
            "clock": self.clock,
            "commands": self.commands,
            "submarine": self.submarine,
            "singularities": self.singularities,
            "avatar": self.avatar,
            "roster": self.roster,
            "cohorts": self.cohorts,
            "restocks": self.restocks,
            "fish": self.population.fish,
            "mind": self.population.mind,
            "motor": self.population.motor,
            "food": self.food,
            "objective": self.objective,
        }

    def checksums(self) -> dict[str, int]:
        """Return the 64-bit checksum of every table, by name."""
        return {name: table_checksum(table) for name, table in self.tables.items()}

    def snapshot(self) -> Snapshot:
        """Return a copy of all state."""
        return Snapshot.of(self.tables)

    def restore(self, snapshot: Snapshot) -> None:
        """Make all state equal to the snapshot, of this level."""
        snapshot.into(self.tables)
        self.population.reindex()
        fish = self.population.fish
        self.entities.sync(fish.id[: fish.count].tolist())
        for system in self.systems:
            if isinstance(system, Live):
                system.restored()


def _with_homes(terrain: Terrain, content: Content, caps: Sequence[Cap]) -> Terrain:
    names = [species.name for species in content.species]
    homes: list[tuple[tuple[float, ...], int]] = [
        (home.at_m, names.index(home.species)) for home in content.level.homes
    ]
    return terrain.with_homes([*homes, *shelters_of(caps, content.species)])


def _submarine(level: Level) -> SubmarineTable:
    table = SubmarineTable(count=1)
    table.position[0] = table.last_position[0] = level.submarine.at_m
    table.yaw[0] = table.last_yaw[0] = level.submarine.heading_deg * DEGREE
    return table


def _goals(content: Content) -> tuple[Photograph, ...]:
    wanted = content.level.objective.photograph
    names = [species.name for species in content.species]
    return (Photograph(names.index(wanted.species), wanted.count, wanted.within_m),)
