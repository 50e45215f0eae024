"""Become: the player turns into the fish before the bow, and back into the pilot (the submarine as a fish among
fishes, papers/000 section 8.2).

One fish at a time, and plain arithmetic without sums: every machine chooses the same one.
"""

from typing import Final

import numpy as np

from components.camera import VIEWFINDER_ASPECT, VIEWFINDER_SLOPE, camera_at
from components.clock import Clock
from components.command import CommandTable
from components.fish import Population
from components.mind import Courtship, Intention, Why
from components.possession import AvatarTable
from components.submarine import SubmarineTable
from components.terrain import Terrain, sees

WITHIN: Final = 15.0
"""[m] from the bow within which a fish can be reached."""
START: Final = 0.5
"""Speed setting with which the player takes over."""


class Become:
    """Reads commands, submarine, terrain and clock; writes who the player is and, of that fish, the mind."""

    def __init__(
        self,
        avatar: AvatarTable,
        commands: CommandTable,
        population: Population,
        submarine: SubmarineTable,
        terrain: Terrain,
        clock: Clock,
    ) -> None:
        self.avatar, self.commands, self.population = avatar, commands, population
        self.submarine, self.terrain, self.clock = submarine, terrain, clock

    def __call__(self) -> None:
        """Attach, let go, or find that the fish is no more."""
        avatar, now = self.avatar, self.clock.now
        identity = int(avatar.fish[0])
        if identity >= 0 and identity not in self.population:
            avatar.fish[0], avatar.since[0], avatar.lost_at[0] = -1, now, now
        elif not self.commands.pressed("become"):
            return
        elif identity >= 0:
            self._let_go(identity, now)
        else:
            self._attach(self.before_the_bow(), now)

    def before_the_bow(self) -> int:
        """Return the id of the fish nearest the middle of the viewfinder, near enough and in sight; -1 for none."""
        ship, fish = self.submarine, self.population.fish
        eye = ship.position[0]
        camera = camera_at(eye, float(ship.yaw[0]), float(ship.pitch[0]))
        x, y, z = (fish.live("position")[:, axis] - eye[axis] for axis in range(3))
        ahead, right, up = (
            axis[0] * x + axis[1] * y + axis[2] * z
            for axis in (camera.forward, camera.right, camera.up)
        )
        edge = VIEWFINDER_SLOPE * ahead
        inside = (np.abs(up) <= edge) & (np.abs(right) <= VIEWFINDER_ASPECT * edge)
        rows = np.flatnonzero(inside & (x * x + y * y + z * z < WITHIN * WITHIN) & (ahead > 0.0))
        aside = (right[rows] * right[rows] + up[rows] * up[rows]) / (ahead[rows] * ahead[rows])
        ids = fish.live("id")[rows]
        for at in np.lexsort((ids, aside)):
            free = self.population.mind.swallowed_by[rows[at]] < 0
            if free and sees(self.terrain, eye, fish.position[rows[at]]):
                return int(ids[at])
        return -1

    def _attach(self, identity: int, now: int) -> None:
        avatar = self.avatar
        if identity < 0:
            avatar.refused_at[0] = now
            return
        row = self.population.row(identity)
        mind, ahead = self.population.mind, self.population.fish.rotation[row, :, 0]
        avatar.fish[0], avatar.since[0] = identity, now
        avatar.setting[0], avatar.swing[0], avatar.climb[0] = START, 0.0, 0.0
        avatar.course[0] = avatar.gaze[0] = avatar.last_gaze[0] = ahead
        mind.intention[row], mind.why[row] = Intention.OBEY, Why.PLAYER
        mind.why_value[row], mind.since[row] = 0.0, now
        mind.focus[row], mind.memory[row], mind.gape[row] = -1, -1, 0.0
        mind.courtship[row], mind.courtship_since[row] = Courtship.NONE, now

    def _let_go(self, identity: int, now: int) -> None:
        self.avatar.fish[0], self.avatar.since[0] = -1, now
        mind, row = self.population.mind, self.population.row(identity)
        mind.intention[row], mind.since[row] = Intention.WANDER, now
        mind.focus[row], mind.gape[row], mind.wander_until[row] = -1, 0.0, now
        self.population.motor.throttle[row] = 1.0
