"""A scene put on stage: its world before the first tick, every fish in the mood that the file says, and models led.

A model is a predator without a will of its own, as ethologists use it: it swims straight at the middle of a group,
through it, and on the same way.
"""

from typing import Final

import numpy as np

from components.arrays import Float64s
from components.mind import Intention
from components.trigonometry import DEGREE
from reefgame.testing.scene import Scene
from reefgame.testing.scene_file import SceneGroup
from reefgame.world import World
from systems.mind.seek import is_male
from systems.play.spawn import face

_PASSED: Final = 1.0
"""[m] from the middle of the group from which a model goes straight on."""
_MOST_DRAWS: Final = 100


def stage(scene: Scene, seed: int, variant: int = 0) -> World:
    """Return the world of a scene before its first tick, which a `Director` then directs."""
    world = World.build(scene.contents[variant], seed)
    if scene.file.submarine is None:
        world.submarine.count = 0
    return world


def _have_both_sexes(world: World, index: int) -> None:
    """Let others come in the place of the group's last until both sexes are there."""
    cohorts, fish = world.cohorts, world.population.fish
    for _ in range(_MOST_DRAWS):
        ids = fish.live("id")[fish.live("cohort") == index]
        males = [bool(is_male(int(world.clock.seed[0]), one)) for one in ids.tolist()]
        if any(males) and not all(males):
            return
        world.spawn.remove(int(ids.max()))
        kind, within = int(cohorts.species[index]), float(cohorts.within[index])
        world.spawn.add(kind, 1, cohorts.around[index], within, index)


def _set_mood(world: World, row: int, group: SceneGroup) -> None:
    population, kind = world.population, int(world.population.fish.species[row])
    senses, mind = world.senses, world.population.mind
    mind.eaten[row] = (1.0 - group.hunger) * senses.appetite[kind]
    mind.ate_at[row] = world.clock.now
    mind.mated_at[row] = world.clock.now - int(group.libido * senses.breeding[kind])
    if group.heading_deg is not None:
        fish = population.fish
        face(group.heading_deg * DEGREE, fish.rotation[row])
        fish.last_rotation[row] = fish.rotation[row]
        population.motor.heading[row] = mind.wander[row] = fish.rotation[row, :, 0]


class Director:
    """Sets the mood of who arrives and leads the models, tick by tick, before the world ticks."""

    def __init__(self, scene: Scene) -> None:
        self.groups, names = scene.file.fishes, scene.groups
        self.aims = [None if g.led_at is None else names.index(g.led_at) for g in self.groups]
        self._here: set[int] = set()
        self._on: dict[int, Float64s] = {}

    def __call__(self, world: World) -> None:
        """Order what is to be done before the next tick."""
        for index, (group, aim) in enumerate(zip(self.groups, self.aims, strict=True)):
            if index not in self._here and world.cohorts.present[index]:
                self._here.add(index)
                self._welcome(world, index, group)
            if aim is not None:
                self._lead(world, _rows(world, index), _rows(world, aim))

    def _welcome(self, world: World, index: int, group: SceneGroup) -> None:
        if group.sexes == "both":
            _have_both_sexes(world, index)
        for row in _rows(world, index):
            _set_mood(world, row, group)

    def _lead(self, world: World, models: list[int], aim: list[int]) -> None:
        fish, mind, motor = world.population.fish, world.population.mind, world.population.motor
        for row in models:
            way = self._way(int(fish.id[row]), fish.position[row], fish.position[aim])
            mind.intention[row] = Intention.OBEY
            motor.gear[row], motor.urgency[row], motor.throttle[row] = 1, 0.3, 1.0
            if way is not None:
                motor.heading[row] = way

    def _way(self, identity: int, here: Float64s, there: Float64s) -> Float64s | None:
        """Return the unit way of a model, level once it has passed the middle; None for as it was."""
        if identity in self._on:
            return self._on[identity]
        if len(there) == 0:
            return None
        way: Float64s = there.mean(axis=0) - here
        far = float(np.linalg.norm(way))
        way = way / max(far, 1e-9)
        if far < _PASSED:
            way[2] = 0.0
            self._on[identity] = way / max(float(np.linalg.norm(way)), 1e-9)
        return way


def _rows(world: World, group: int) -> list[int]:
    rows: list[int] = np.flatnonzero(world.population.fish.live("cohort") == group).tolist()
    return rows
