"""Spawn: brings in the level's groups when they arrive, takes them out when they leave, and replaces the eaten.

The only place where fishes are added and removed. Positions, headings, sizes and what stands in their stomachs come
from chance named by the fish's id, so they do not depend on what else happens in the tick. Who replaces an eaten fish
appears where its group did, out of the submarine's sight; where all is in sight it waits a while.
"""

from math import sqrt
from typing import Final

import numpy as np

from components import chance
from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND, Clock
from components.cohort import AT_RANDOM, NEVER, CohortTable, RestockTable, Roster
from components.entities import Entities
from components.fish import Population
from components.kernels import row
from components.repertoire import Pattern, RepertoireLibrary
from components.scatter import place
from components.species import Species
from components.submarine import SubmarineTable
from components.terrain import Terrain, confine, sees
from components.trigonometry import cosine, sine

_TURN: Final = 6.283185307179586
_SCHOOL_FAN: Final = 0.5
"""[rad] spread of a school's first headings."""
_LEAST_FED: Final = 0.6
"""Appetites in the stomach of who comes with the least there; the most is one more."""
_LONGEST_AGO: Final = 0.35
"""Digestions since the last bite of who ate the longest ago."""
_LONGEST_CHASTE: Final = 0.14
"""Breeding times since the last mating of who mated the longest ago: some are ready where a mate is near."""
_HIDING_PLACES: Final = 8
_NEAR: Final = 2.5
"""[m] round the submarine in which nobody appears."""
_EDGE: Final = 0.5
"""Cosine of half the angle that the submarine's windows show."""
_RETRY: Final = TICKS_PER_SECOND
_PATIENCE: Final = 30 * TICKS_PER_SECOND
"""[ticks] for which who is due waits for a place out of sight."""


@row
def face(yaw: float, rotation: Float64s) -> None:
    """Set a fish's axes (3, 3) upright and level, heading along `yaw` [rad] from +x towards +y."""
    c, s = cosine(yaw), sine(yaw)
    rotation[0, 0], rotation[1, 0], rotation[2, 0] = c, s, 0.0
    rotation[0, 1], rotation[1, 1], rotation[2, 1] = 0.0, 0.0, 1.0
    rotation[0, 2], rotation[1, 2], rotation[2, 2] = s, -c, 0.0


@row
def in_sight(terrain: Terrain, eye: Float64s, ahead: Float64s, far: float, at: Float64s) -> bool:
    """Say whether a submarine at `eye` that looks along `ahead`, unit, sees a place `at`, at most `far` [m] away."""
    x, y, z = at[0] - eye[0], at[1] - eye[1], at[2] - eye[2]
    distance = sqrt(x * x + y * y + z * z)
    if distance < _NEAR or distance > far:
        return distance < _NEAR
    along = x * ahead[0] + y * ahead[1] + z * ahead[2]
    return bool(along > _EDGE * distance and sees(terrain, eye, at))


class Spawn:
    """Reads clock, species, library, terrain and submarine; writes cohorts, restocks, roster, population and entities.

    `visibility` [m] is how far the submarine sees.
    """

    def __init__(
        self,
        cohorts: CohortTable,
        restocks: RestockTable,
        roster: Roster,
        population: Population,
        entities: Entities,
        species: tuple[Species, ...],
        library: RepertoireLibrary,
        terrain: Terrain,
        submarine: SubmarineTable,
        visibility: float,
        clock: Clock,
    ) -> None:
        self.cohorts = cohorts
        self.restocks = restocks
        self.roster = roster
        self.population = population
        self.entities = entities
        self.species = species
        self.library = library
        self.terrain = terrain
        self.submarine = submarine
        self.visibility = visibility
        self.clock = clock

    def __call__(self) -> None:
        """Let the groups whose tick has come arrive or leave, and others come for who was eaten."""
        now, cohorts = self.clock.now, self.cohorts
        for group in range(cohorts.count):
            if cohorts.present[group]:
                if now >= cohorts.leaves[group]:
                    self._leave(group)
            elif cohorts.arrives[group] <= now < cohorts.leaves[group]:
                self._arrive(group)
        for at in reversed(range(self.restocks.count)):
            if now >= self.restocks.due[at]:
                self._replace(at)

    def add(
        self, species: int, number: int, around: Float64s, within: float, cohort: int = -1
    ) -> list[int]:
        """Add `number` fishes of the species row in the ball around `around` [m]; return their ids.

        `cohort`: the row of the level's group, or below 0 for a group of no level, whose fishes nobody replaces.
        """
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
            place(seed, chance.PLACE, 0, identity, around, within, fish.position[at])
            confine(self.terrain, fish.position, at, 0.5 * kind.length)
            u = chance.uniform(seed, chance.HEADING, 1, identity)
            yaw = school_yaw + _SCHOOL_FAN * (u - 0.5) if kind.schooling else _TURN * u
            face(yaw, fish.rotation[at])
            v = 2.0 * chance.uniform(seed, chance.SIZE, 0, identity) - 1.0
            fish.length[at] = kind.length * (1.0 + kind.length_spread * v)
            self._set_moving(at, identity, species)
            self._set_appetite(at, identity, kind)
            if cohort >= 0:
                self._set_hunger(at, float(self.cohorts.hunger[cohort]), kind)
        fish.last_position[rows] = fish.position[rows]
        fish.last_rotation[rows] = fish.rotation[rows]
        self.entities.add(ids)
        return ids

    def remove(self, identity: int) -> None:
        """Take the fish out of the world. Raise KeyError where there is none."""
        self.population.remove(identity)
        self.entities.remove(identity)

    def lose(self, identity: int) -> None:
        """Take out a fish that was eaten; another comes later if its group says so. Raise KeyError as `remove` does."""
        cohort = int(self.population.fish.cohort[self.population.row(identity)])
        if cohort >= 0 and self.cohorts.restock[cohort] != NEVER:
            rows = self.restocks.append(1)
            self.restocks.cohort[rows] = cohort
            self.restocks.due[rows] = self.clock.now + self.cohorts.restock[cohort]
        self.remove(identity)

    def _set_appetite(self, at: int, identity: int, kind: Species) -> None:
        """Let it have eaten its fill, more or less, and mated, some time ago: three in ten come hungry."""
        seed, now, mind = int(self.clock.seed[0]), self.clock.now, self.population.mind
        ate, mated, fed = (
            chance.uniform(seed, stream, draw, identity)
            for stream, draw in ((chance.EATEN, 0), (chance.MATED, 0), (chance.EATEN, 1))
        )
        mind.eaten[at] = (_LEAST_FED + fed) * kind.temper.appetite
        mind.ate_at[at] = now - int(_LONGEST_AGO * ate * kind.temper.digestion * TICKS_PER_SECOND)
        mind.mated_at[at] = now - int(
            _LONGEST_CHASTE * mated * kind.temper.breeding * TICKS_PER_SECOND
        )

    def _set_hunger(self, at: int, hunger: float, kind: Species) -> None:
        """Let it come as hungry as its group says, `AT_RANDOM` where it says nothing."""
        if hunger != AT_RANDOM:
            mind = self.population.mind
            mind.eaten[at], mind.ate_at[at] = (1.0 - hunger) * kind.temper.appetite, self.clock.now

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

    def _replace(self, at: int) -> None:
        """Let a fish come for the row `at` of the restocks, or wait where the submarine would see it appear."""
        restocks, now = self.restocks, self.clock.now
        group = int(restocks.cohort[at])
        late = now - int(restocks.due[at])
        if late % _RETRY:
            return
        spot = self._hidden_place(group)
        if spot is None and late < _PATIENCE:
            return
        restocks.remove(at)
        species, within = int(self.cohorts.species[group]), float(self.cohorts.within[group])
        if spot is None:
            self.add(species, 1, self.cohorts.around[group], within, group)
        else:
            self.add(species, 1, spot, 0.0, group)

    def _hidden_place(self, group: int) -> Float64s | None:
        """Return a place [m] of the group's, (3,), that the submarine does not see, farther out try by try; or None."""
        seed, identity = int(self.clock.seed[0]), int(self.roster.next_id[0])
        around, within = self.cohorts.around[group], float(self.cohorts.within[group])
        spot: Float64s = np.zeros((1, 3))
        for draw in range(_HIDING_PLACES):
            wide = within * (1.0 + draw)
            place(seed, chance.RESTOCK, draw, identity, around, wide, spot[0])
            confine(self.terrain, spot, 0, 0.3)
            if not self._watched(spot[0]):
                return spot.reshape(3)
        return None

    def _watched(self, spot: Float64s) -> bool:
        for ship in range(self.submarine.count):
            eye = self.submarine.position[ship]
            yaw, pitch = float(self.submarine.yaw[ship]), float(self.submarine.pitch[ship])
            level = cosine(pitch)
            ahead = np.array((level * cosine(yaw), level * sine(yaw), sine(pitch)))
            if in_sight(self.terrain, eye, ahead, self.visibility, spot):
                return True
        return False

    def _leave(self, group: int) -> None:
        self.cohorts.present[group] = 0
        for at in reversed(range(self.restocks.count)):
            if self.restocks.cohort[at] == group:
                self.restocks.remove(at)
        fish = self.population.fish
        leaving = fish.id[: fish.count][fish.cohort[: fish.count] == group]
        for identity in sorted(leaving.tolist()):
            self.remove(identity)
