"""Spawn: brings in the level's groups when they arrive and takes them out when they leave.

The only place where fishes are added and removed. Positions, headings and sizes come from chance
named by the fish's id, so they do not depend on what else happens in the tick.
"""

from components import chance
from components.arrays import Float64s
from components.clock import Clock
from components.cohort import CohortTable, Roster
from components.entities import Entities
from components.fish import Population
from components.kernels import row
from components.repertoire import Pattern, RepertoireLibrary
from components.species import Species
from components.terrain import Terrain, confine
from components.trigonometry import cosine, sine

_TURN = 6.283185307179586
_SCHOOL_FAN = 0.5
"""[rad] spread of a school's first headings."""


@row
def place(seed: int, identity: int, around: Float64s, within: float, position: Float64s) -> None:
    """Draw a position [m] in the ball of radius `within` around `around`, both in world axes, into (3,)."""
    for attempt in range(64):
        x = 2.0 * chance.uniform(seed, chance.PLACE, 3 * attempt, identity) - 1.0
        y = 2.0 * chance.uniform(seed, chance.PLACE, 3 * attempt + 1, identity) - 1.0
        z = 2.0 * chance.uniform(seed, chance.PLACE, 3 * attempt + 2, identity) - 1.0
        if x * x + y * y + z * z <= 1.0:
            break
    position[0] = around[0] + within * x
    position[1] = around[1] + within * y
    position[2] = around[2] + within * z


@row
def face(yaw: float, rotation: Float64s) -> None:
    """Set a fish's axes (3, 3) upright and level, heading along `yaw` [rad] from +x towards +y."""
    c, s = cosine(yaw), sine(yaw)
    rotation[0, 0], rotation[1, 0], rotation[2, 0] = c, s, 0.0
    rotation[0, 1], rotation[1, 1], rotation[2, 1] = 0.0, 0.0, 1.0
    rotation[0, 2], rotation[1, 2], rotation[2, 2] = s, -c, 0.0


class Spawn:
    """Reads clock, species, library and terrain; writes cohorts, roster, population and entities."""

    def __init__(
        self,
        cohorts: CohortTable,
        roster: Roster,
        population: Population,
        entities: Entities,
        species: tuple[Species, ...],
        library: RepertoireLibrary,
        terrain: Terrain,
        clock: Clock,
    ) -> None:
        self.cohorts = cohorts
        self.roster = roster
        self.population = population
        self.entities = entities
        self.species = species
        self.library = library
        self.terrain = terrain
        self.clock = clock

    def __call__(self) -> None:
        """Let the groups whose tick has come arrive or leave."""
        now, cohorts = self.clock.now, self.cohorts
        for group in range(cohorts.count):
            if cohorts.present[group]:
                if now >= cohorts.leaves[group]:
                    self._leave(group)
            elif cohorts.arrives[group] <= now < cohorts.leaves[group]:
                self._arrive(group)

    def add(
        self, species: int, number: int, around: Float64s, within: float, cohort: int = -1
    ) -> list[int]:
        """Add `number` fishes of the species row in the ball around `around` [m]; return their ids."""
        fresh = self.roster.take(number)
        ids: list[int] = fresh.tolist()
        rows = self.population.append(fresh)
        seed = int(self.clock.seed[0])
        kind, fish = self.species[species], self.population.fish
        fish.species[rows] = species
        fish.cohort[rows] = cohort
        leader = ids[0] if number else 0
        school_yaw = _TURN * chance.uniform(seed, chance.HEADING, 0, leader)
        for at, identity in zip(range(rows.start, rows.stop), ids, strict=True):
            place(seed, identity, around, within, fish.position[at])
            confine(self.terrain, fish.position, at, 0.5 * kind.length)
            u = chance.uniform(seed, chance.HEADING, 1, identity)
            yaw = school_yaw + _SCHOOL_FAN * (u - 0.5) if kind.schooling else _TURN * u
            face(yaw, fish.rotation[at])
            v = 2.0 * chance.uniform(seed, chance.SIZE, 0, identity) - 1.0
            fish.length[at] = kind.length * (1.0 + kind.length_spread * v)
            self._set_moving(at, identity, species)
        fish.last_position[rows] = fish.position[rows]
        fish.last_rotation[rows] = fish.rotation[rows]
        self.entities.add(ids)
        return ids

    def remove(self, identity: int) -> None:
        """Take the fish out of the world. Raise KeyError where there is none."""
        self.population.remove(identity)
        self.entities.remove(identity)

    def _set_moving(self, at: int, identity: int, species: int) -> None:
        motor, mind, library = self.population.motor, self.population.mind, self.library
        segment = int(library.segment[species, Pattern.SWIM_MEDIUM])
        length = int(library.length[segment])
        draw = chance.uniform(int(self.clock.seed[0]), chance.SEGMENT, 0, identity)
        frame = int(draw * length)
        motor.segment[at] = motor.wanted[at] = segment
        motor.frame[at] = frame
        shown = int(library.start[segment]) + (frame - 1) % length
        motor.shape_row[at] = motor.last_shape_row[at] = shown
        motor.warp_from[at] = motor.warp_to[at] = shown
        motor.heading[at] = self.population.fish.rotation[at, :, 0]
        mind.wander[at] = motor.heading[at]

    def _arrive(self, group: int) -> None:
        cohorts = self.cohorts
        cohorts.present[group] = 1
        self.add(
            int(cohorts.species[group]),
            int(cohorts.number[group]),
            cohorts.around[group],
            float(cohorts.within[group]),
            group,
        )

    def _leave(self, group: int) -> None:
        self.cohorts.present[group] = 0
        fish = self.population.fish
        leaving = fish.id[: fish.count][fish.cohort[: fish.count] == group]
        for identity in sorted(leaving.tolist()):
            self.remove(identity)
