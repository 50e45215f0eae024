"""Scripted pilots: closed loops that look at the world and give commands, for demonstrations, tests
and golden replays.

They see the whole world, not a picture, and use numpy freely: what they decide is recorded as
commands, so a replay never asks them again.
"""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND
from components.command import FULL, Command
from components.trigonometry import DEGREE
from reefgame.world import World
from systems.play.judge import viewfinder

PilotScript: TypeAlias = Callable[[World], Command]
"""Called before each tick with the world; returns the tick's command."""


def idle(_: World) -> Command:
    """Order nothing: the submarine stays where it is."""
    return Command()


def tour(world: World) -> Command:
    """Circle the reef at half throttle, rising and sinking slowly, never taking a photograph."""
    position = world.submarine.position[0]
    outward = position[:2] / max(float(np.hypot(*position[:2])), 1e-6)
    around = np.array([-outward[1], outward[0]])
    wanted_radius = 0.55 * world.terrain.radius
    inward = (wanted_radius - float(np.hypot(*position[:2]))) / wanted_radius
    aim = around + 1.5 * inward * outward
    depth = -0.45 * world.terrain.depth
    target = position + 10.0 * np.array([*aim, (depth - position[2]) / 10.0])
    return steer(world, target, speed=0.5)


class Photographer:
    """Follows the school that the objective asks for and releases the shutter when enough fishes are framed.

    It waits until `earliest` [s] of the dive have passed and the frame was good for `patience` [ticks].
    """

    def __init__(self, earliest: float = 0.0, patience: int = 30, pace: float = 1.0) -> None:
        self.earliest = earliest
        self.patience = patience
        self.pace = pace
        self._waited = 0

    def __call__(self, world: World) -> Command:
        """Return the command of the tick."""
        goal = world.goals[0]
        fish = world.population.fish
        school = fish.position[: fish.count][fish.species[: fish.count] == goal.species]
        if not len(school):
            return Command(stop=1)
        heart = densest(school, goal.within * 0.5)
        away = float(np.linalg.norm(heart - world.submarine.position[0])) - 0.6 * goal.within
        command = steer(world, heart, speed=self.pace * min(1.0, max(0.0, away / 4.0)))
        return command._replace(photograph=int(self._ready(world, goal.count)))

    def _ready(self, world: World, wanted: int) -> bool:
        good = world.objective.framed[0] >= wanted and not world.objective.done[0]
        self._waited = self._waited + 1 if good else 0
        late = world.clock.now >= self.earliest * TICKS_PER_SECOND
        return late and self._waited >= self.patience


def densest(points: Float64s, radius: float) -> Float64s:
    """Return the mean of the points within `radius` [m] of the point that has most others so near; points (n, 3)."""
    apart = np.linalg.norm(points[:, None] - points[None], axis=2) < radius
    best = int(np.argmax(apart.sum(axis=1)))
    return np.asarray(points[apart[best]].mean(axis=0), np.float64)


def steer(world: World, target: Float64s, speed: float) -> Command:
    """Return the command that turns to `target` [m] and holds `speed` as a throttle setting, 0 to 1."""
    ship = world.submarine
    away = target - ship.position[0]
    camera = viewfinder(ship)
    ahead, right, up = (float(axis @ away) for axis in (camera.forward, camera.right, camera.up))
    yaw = np.arctan2(-right, ahead) - 0.25 * ship.yaw_rate[0]
    pitch = np.arctan2(up, np.hypot(ahead, right)) - 0.25 * ship.pitch_rate[0]
    engine = speed * max(0.0, np.cos(yaw)) - float(ship.throttle[0])
    return Command(
        throttle=_axis(engine * 4.0),
        turn=_axis(yaw / (25.0 * DEGREE)),
        pitch=_axis(pitch / (25.0 * DEGREE)),
    )


def _axis(value: float) -> int:
    return round(FULL * min(max(float(value), -1.0), 1.0))
