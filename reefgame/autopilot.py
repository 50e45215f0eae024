"""Scripted pilots: closed loops that look at the world and give commands, for demonstrations, tests
and golden replays.

They see the whole world, not a picture, and use numpy freely: what they decide is recorded as
commands, so a replay never asks them again.
"""

from collections.abc import Callable
from typing import Final, TypeAlias

import numpy as np

from components.arrays import Float64s
from components.clock import TICKS_PER_SECOND
from components.command import FULL, Command
from components.submarine import HULL_RADIUS
from components.terrain import clearance
from components.trigonometry import DEGREE
from reefgame.world import World
from systems.play.judge import viewfinder

_LOOK_AHEAD: Final = np.array([0.0, 1.0, 2.0, 3.0, 4.5])
"""[m] along the way at which a pilot looks for obstacles."""
_BERTH: Final = HULL_RADIUS + 0.6
"""[m] kept from them."""

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
    """Goes ahead of the school that the objective asks for, lets it pass by, and photographs it from the side.

    It waits until `earliest` [s] of the dive have passed and the frame was good for `patience` [ticks].
    """

    def __init__(self, earliest: float = 0.0, patience: int = 30, pace: float = 1.0) -> None:
        self.earliest = earliest
        self.patience = patience
        self.pace = pace
        self._waited = 0
        self._watching = False

    def __call__(self, world: World) -> Command:
        """Return the command of the tick."""
        goal = world.goals[0]
        fish = world.population.fish
        chosen = fish.species[: fish.count] == goal.species
        if not chosen.any():
            return Command(stop=1)
        heart, heading = densest(
            fish.position[: fish.count][chosen],
            fish.rotation[: fish.count, :, 0][chosen],
            goal.within * 0.5,
        )
        command = self._follow(world, heart, heading, goal.within)
        return command._replace(photograph=int(self._ready(world, goal.count)))

    def _follow(self, world: World, heart: Float64s, heading: Float64s, within: float) -> Command:
        """Go to a station before the school and beside its course; from there, turn to watch it pass."""
        here = world.submarine.position[0]
        aside = np.array([-heading[1], heading[0], 0.0])
        aside *= np.copysign(0.4 * within, aside @ (here - heart)) / max(
            np.linalg.norm(aside), 1e-6
        )
        station = heart + 0.5 * within * heading + aside
        if self._watching:
            self._watching = bool(np.linalg.norm(heart - here) < 0.8 * within)
        else:
            self._watching = bool(np.linalg.norm(station - here) < 0.25 * within)
        if self._watching:
            return steer(world, heart, 0.0)
        away = float(np.linalg.norm(station - here))
        return steer(world, station, self.pace * min(1.0, 0.15 + away / 8.0))

    def _ready(self, world: World, wanted: int) -> bool:
        good = world.objective.framed[0] >= wanted and not world.objective.done[0]
        self._waited = self._waited + 1 if good else 0
        late = world.clock.now >= self.earliest * TICKS_PER_SECOND
        return late and self._waited >= self.patience


def densest(points: Float64s, headings: Float64s, radius: float) -> tuple[Float64s, Float64s]:
    """Return the middle of the densest group and its mean heading; points [m] and headings are (n, 3).

    The group is who stands within `radius` [m] of the point that has most others so near.
    """
    apart = np.linalg.norm(points[:, None] - points[None], axis=2) < radius
    group = apart[int(np.argmax(apart.sum(axis=1)))]
    heading = headings[group].mean(axis=0)
    return points[group].mean(axis=0), heading / max(float(np.linalg.norm(heading)), 1e-6)


def steer(world: World, target: Float64s, speed: float) -> Command:
    """Return the command that turns to `target` [m] and holds `speed` as a throttle setting, 0 to 1.

    What stands in the way is passed above.
    """
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
        rise=_axis(_lift(world, away)),
    )


def _lift(world: World, away: Float64s) -> float:
    """Return how urgently to rise, 0 to 1: something lies between here and the way `away` [m]."""
    distance = max(float(np.linalg.norm(away)), 1e-6)
    reach = np.minimum(_LOOK_AHEAD, distance)
    points = world.submarine.position[0] + np.outer(reach, away / distance)
    near = min(clearance(world.terrain, *map(float, point))[0] for point in points)
    return min(max((_BERTH - near) / 0.5, 0.0), 1.0) if points[:, 2].max() < -_BERTH else 0.0


def _axis(value: float) -> int:
    return round(FULL * min(max(float(value), -1.0), 1.0))
