"""Obey: the fish that the player is swims, turns, eats and hides as ordered (papers/000, section 6: mind over motor).

The orders take the place of the behaviour routines: they become a direction, a gear, an urgency and a throttle, which
the secondary controller turns into segments as it does for every fish. A tap of the helm steers, holding it turns in
earnest, and at full speed it is a fast start.
"""

from math import sqrt
from typing import Final

import numpy as np

from components.arrays import Float64s
from components.clock import TICK_SECONDS, Clock
from components.command import FULL, CommandTable
from components.fish import Population
from components.food import FoodTable
from components.mind import FOOD
from components.possession import AvatarTable
from components.senses import SWALLOWED, SenseTable
from components.terrain import Terrain, ground_height
from components.trigonometry import cosine, sine

SETTING_RATE: Final = 1.1
"""Speed setting per second at a full order."""
ASTERN: Final = -0.5
CLIMB_RATE: Final = 0.9
"""Sine of the climb per second at a full order."""
STEEPEST: Final = 0.62
_RISE: Final = 0.6
_TAP: Final = 0.45
_HOLD: Final = 1.1
"""[rad] that the direction leads the head by: at once, and after holding the helm for a while."""
_TAU_SWING: Final = 0.4
_TAU_GAZE: Final = 0.18
_CARRY: Final = 6.0
"""[ticks] of its present turn that a fish still makes when the helm comes back."""
_BITE: Final = (6.0, 1.0)
"""[BL], [m]: how far before the nose the player's fish goes for food, the larger of the two."""
_BEFORE: Final = 0.3
"""Cosine of the angle from the nose within which it does."""
_SHELTER_WITHIN: Final = 25.0
_ARRIVED: Final = 0.5


def engine(setting: float) -> tuple[int, float]:
    """Return gear and throttle for a speed setting from -1 to 1: it brakes at 0 and backs up below."""
    if setting < 0.0:
        return 0, 0.4 * setting
    if setting < 0.05:
        return 0, 0.0
    if setting < 0.4:
        return 0, 0.4 + 1.5 * setting
    if setting < 0.75:
        return 1, 0.75 + (setting - 0.4)
    return 2, 0.8 + 1.6 * (setting - 0.75)


def _level(x: float, y: float, climb: float) -> tuple[float, float, float]:
    """Return the unit vector along the bearing of (x, y) that climbs by the sine `climb`."""
    size = sqrt(x * x + y * y) + 1e-12
    rest = sqrt(1.0 - climb * climb)
    return rest * x / size, rest * y / size, climb


class Obey:
    """Reads who the player is, commands, fishes, food, senses, terrain and clock; writes the course, and that
    fish's demands on its motor system, focus and gape."""

    def __init__(
        self,
        avatar: AvatarTable,
        commands: CommandTable,
        population: Population,
        food: FoodTable,
        senses: SenseTable,
        terrain: Terrain,
        clock: Clock,
    ) -> None:
        self.avatar, self.commands, self.population = avatar, commands, population
        self.food, self.senses, self.terrain, self.clock = food, senses, terrain, clock

    def __call__(self) -> None:
        """Steer the fish by one tick."""
        avatar = self.avatar
        if not avatar.attached:
            return
        row = self.population.row(int(avatar.fish[0]))
        if self.commands.pressed("view"):
            avatar.behind[0] = 1 - avatar.behind[0]
        self._look(row)
        self._turn(row)
        self._climb()
        self._set_speed()
        x, y = float(avatar.course[0, 0]), float(avatar.course[0, 1])
        climb = float(avatar.climb[0]) + _RISE * self._axis("rise")
        avatar.course[0] = _level(x, y, max(-STEEPEST, min(STEEPEST, climb)))
        gear, throttle = engine(float(avatar.setting[0]))
        urgency = 0.3 + 0.35 * abs(self._axis("turn"))
        urgency += 0.75 * max(float(avatar.setting[0]) - 0.6, 0.0)
        self._demand(row, avatar.course[0], gear, min(urgency, 0.95), throttle)
        self._feed(row)
        if self.commands.order("hide"):
            self._hide(row)

    def _axis(self, name: str) -> float:
        return self.commands.order(name) / FULL

    def _demand(
        self,
        row: int,
        heading: Float64s | tuple[float, float, float],
        gear: int,
        urgency: float,
        throttle: float,
    ) -> None:
        motor = self.population.motor
        motor.heading[row], motor.gear[row] = heading, gear
        motor.urgency[row], motor.throttle[row] = urgency, throttle

    def _look(self, row: int) -> None:
        """Let the gaze follow the head."""
        avatar, ahead = self.avatar, self.population.fish.rotation[row, :, 0]
        avatar.last_gaze[0] = avatar.gaze[0]
        x, y, z = (
            float(g + (a - g) * (TICK_SECONDS / _TAU_GAZE))
            for g, a in zip(avatar.gaze[0], ahead, strict=True)
        )
        size = sqrt(x * x + y * y + z * z) + 1e-12
        avatar.gaze[0] = x / size, y / size, z / size

    def _turn(self, row: int) -> None:
        """Bring the course to where the helm points; when the helm comes back, to where the fish will have turned."""
        avatar, fish, order = self.avatar, self.population.fish, self._axis("turn")
        swing = float(avatar.swing[0])
        turning = self.commands.before[0, 1] != 0
        avatar.swing[0] = swing + (order - swing) * (TICK_SECONDS / _TAU_SWING) if order else 0.0
        x, y = float(fish.rotation[row, 0, 0]), float(fish.rotation[row, 1, 0])
        if order:
            angle = _TAP * order + _HOLD * float(avatar.swing[0])
            c, s = cosine(angle), sine(angle)
            x, y = c * x - s * y, s * x + c * y
        elif turning:
            x += _CARRY * (x - float(fish.last_rotation[row, 0, 0]))
            y += _CARRY * (y - float(fish.last_rotation[row, 1, 0]))
        else:
            return
        avatar.course[0, 0], avatar.course[0, 1] = x, y

    def _climb(self) -> None:
        climb = float(self.avatar.climb[0]) + self._axis("pitch") * CLIMB_RATE * TICK_SECONDS
        self.avatar.climb[0] = max(-STEEPEST, min(STEEPEST, climb))

    def _set_speed(self) -> None:
        setting = (
            float(self.avatar.setting[0]) + self._axis("throttle") * SETTING_RATE * TICK_SECONDS
        )
        stop = self.commands.order("stop")
        self.avatar.setting[0] = 0.0 if stop else max(ASTERN, min(1.0, setting))

    def _feed(self, row: int) -> None:
        """Open the mouth where that is ordered, and go for the nearest morsel before it."""
        mind, fish = self.population.mind, self.population.fish
        eating = self.commands.order("eat")
        mind.gape[row], mind.focus[row] = float(eating), -1
        if not eating:
            return
        kind, length = int(fish.species[row]), float(fish.length[row])
        ahead = fish.rotation[row, :, 0]
        nose = fish.position[row] + self.senses.nose[kind] * length * ahead
        focus, x, y, z = self._morsel(row, kind, length, nose)
        mind.focus[row] = focus
        if focus == -1:
            return
        size = sqrt(x * x + y * y + z * z) + 1e-12
        before = (x * float(ahead[0]) + y * float(ahead[1]) + z * float(ahead[2])) / size
        course = _level(x, y, max(-STEEPEST, min(STEEPEST, z / size)))
        hurry = before > 0.7 and size > length
        self._demand(row, course, 2 if hurry else 1, 0.8, 1.0 if before > 0.5 else 0.3)

    def _morsel(
        self, row: int, kind: int, length: float, nose: Float64s
    ) -> tuple[int, float, float, float]:
        """Return the focus on the nearest food or prey before the nose [m], -1 for none, and the way there [m]."""
        fish, food, senses = self.population.fish, self.food, self.senses
        reach = max(_BITE[0] * length, _BITE[1])
        best = (-1, 0.0, 0.0, 0.0)
        fishes, particles = slice(fish.count), slice(food.count)
        prey = senses.eats[kind, fish.species[fishes]] != 0
        prey &= fish.length[fishes] <= SWALLOWED * length
        prey &= fish.id[fishes] != fish.id[row]
        there = (food.returns[particles] <= self.clock.now) & bool(senses.grazes[kind])
        for place, edible, is_prey in (
            (fish.position[fishes], prey, True),
            (food.position[particles], there, False),
        ):
            x, y, z = (place[:, axis] - nose[axis] for axis in range(3))
            far = np.sqrt(x * x + y * y + z * z) + 1e-12
            ahead = fish.rotation[row, :, 0]
            before = x * ahead[0] + y * ahead[1] + z * ahead[2]
            rows = np.flatnonzero(edible & (far < reach) & (before > _BEFORE * far))
            if not len(rows):
                continue
            names = fish.id[rows] if is_prey else rows
            at = rows[np.lexsort((names, far[rows]))[0]]
            reach = float(far[at])
            focus = int(fish.id[at]) if is_prey else FOOD - int(at)
            best = (focus, float(x[at]), float(y[at]), float(z[at]))
        return best

    def _hide(self, row: int) -> None:
        """Swim for the nearest home of its kind, else for the foot of the nearest rock, and stay there."""
        fish = self.population.fish
        x, y, z = (float(v) for v in fish.position[row])
        home = self._shelter(int(fish.species[row]), float(fish.length[row]), x, y, z)
        if home is None:
            return
        dx, dy, dz = home[0] - x, home[1] - y, home[2] - z
        far = sqrt(dx * dx + dy * dy + dz * dz) + 1e-12
        course = _level(dx, dy, max(-STEEPEST, min(STEEPEST, dz / far)))
        if far < _ARRIVED + float(fish.length[row]):
            self._demand(row, course, 0, 0.3, 0.0)
        else:
            self._demand(row, course, 2 if far > 2.0 else 1, 0.7, 1.0)

    def _shelter(
        self, kind: int, length: float, x: float, y: float, z: float
    ) -> tuple[float, float, float] | None:
        terrain, best, found = self.terrain, _SHELTER_WITHIN, None
        for place, lives in zip(terrain.home, terrain.home_species, strict=True):
            dx, dy, dz = float(place[0]) - x, float(place[1]) - y, float(place[2]) - z
            far = sqrt(dx * dx + dy * dy + dz * dz)
            if lives == kind and far < best:
                best, found = far, (float(place[0]), float(place[1]), float(place[2]))
        if found is not None:
            return found
        for centre, radii in zip(terrain.rock_centre, terrain.rock_radii, strict=True):
            dx, dy = x - float(centre[0]), y - float(centre[1])
            far = sqrt(dx * dx + dy * dy) + 1e-12
            beside = max(float(radii[0]), float(radii[1])) + length
            if abs(far - beside) < best:
                u, v = float(centre[0]) + dx * beside / far, float(centre[1]) + dy * beside / far
                floor = ground_height(terrain.height, terrain.extent, terrain.cell, u, v)
                best, found = abs(far - beside), (u, v, floor + 0.8 * length + 0.15)
        return found
