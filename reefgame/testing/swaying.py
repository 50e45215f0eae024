"""What is seen of a scene's plants: where every tip is, ten times a second, bent as the game draws them (papers/002).

Arrays hold T samples of F fibres; feet of anemones are left out, since nobody sees their tips.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from components.arrays import AnyArray, Float64s, Int64s
from components.clock import TICKS_PER_SECOND
from components.field import pack
from components.garden import Garden
from reefgame.testing.observation import SAMPLE_EVERY, Observation, Observer
from reefgame.testing.scene import Scene
from reefgame.testing.stage import Director, stage
from reefgame.world import World
from systems.sea.bend import NumbaBender
from systems.sea.pass_by import PassBy
from tools.grow.plants import grow

_REST_S: Final = 10.0
"""[s] in which fibres come to rest where nothing flows, clear of ground and rocks."""


@dataclass(frozen=True)
class Sway:
    """Plants that were watched."""

    rest: Float64s
    "[m] tips where nothing flows, (F, 3)"
    tip: Float64s
    "[m], (T, F, 3)"
    plant: Int64s
    "index of each fibre's plant, (F,)"
    flora: AnyArray
    "name of each fibre's flora, without its mod, (F,)"
    follows: AnyArray
    "whether a fibre is interpolated from others, (F,)"
    flow: Float64s
    "[m] where the scene's own singularities are, in the order of its `flow`, (T, S, 3)"
    axis: Float64s
    "their directions in the last sample, (S, 3)"
    stretch: float
    "[m] by which any segment was ever longer or shorter than at rest"
    fishes: Observation
    "who swam there meanwhile, in the same samples"

    def of(self, flora: str) -> Int64s:
        """Return the fibres of a flora."""
        return np.flatnonzero(self.flora == flora.rpartition(":")[2])

    @property
    def moved(self) -> Float64s:
        """Return how far tips are from where they rest [m], (T, F, 3)."""
        away: Float64s = self.tip - self.rest
        return away


class _Bed:
    """The plants of a world, bent at every sample of an `Observer`."""

    def __init__(self, world: World) -> None:
        terrain = world.terrain
        growth = grow(world.plants, world.floras, terrain)
        rocks = (terrain.rock_centre, terrain.rock_radii, terrain.rock_axes)
        self.world, self.garden, self.bender = world, Garden(growth.tufts, rocks), NumbaBender()
        self._passers = PassBy(
            world.population, world.species, self.garden.clump_sphere, terrain.radius
        )
        many = [tuft.fibres for tuft in growth.tufts]
        seen = [growth.looks[tuft.look].kind != "foot" for tuft in growth.tufts]
        self._fibres = np.flatnonzero(np.repeat(seen, many))
        self.plant = np.repeat([tuft.plant for tuft in growth.tufts], many)[self._fibres]
        follows = [tuft.guides is not None for tuft in growth.tufts]
        self.follows = np.repeat(follows, many)[self._fibres]
        still = np.zeros((0, 16), np.float32)
        for _ in range(round(10.0 * _REST_S)):
            self.bender.step(self.garden, still, 0.1)
        self.rest, self._length = self.tips(), self._lengths()

    def tips(self) -> Float64s:
        """Return where tips are [m], (F, 3)."""
        garden, fibres = self.garden, self._fibres
        rows = garden.first_row[fibres] + garden.nodes[fibres] - 1
        return garden.position[rows, :, garden.lane[fibres]].astype(np.float64)

    def bend(self) -> None:
        """Let the fibres follow what has flowed since the last sample."""
        world = self.world
        flow = np.concatenate([pack(world.singularities, world.clock.now), self._passers()])
        self.bender.step(self.garden, flow, SAMPLE_EVERY / TICKS_PER_SECOND)

    def stretch(self) -> float:
        """Return by how much [m] any segment is longer or shorter than at rest."""
        return float(np.abs(self._lengths() - self._length).max(initial=0.0))

    def _lengths(self) -> Float64s:
        garden = self.garden
        rows = np.concatenate(
            [
                first + np.arange(1, n)
                for first, n in zip(garden.first_row, garden.nodes, strict=True)
            ]
        )
        lanes = np.repeat(garden.lane, garden.nodes - 1)
        nodes = garden.position.astype(np.float64)
        lengths: Float64s = np.linalg.norm(
            nodes[rows, :, lanes] - nodes[rows - 1, :, lanes], axis=1
        )
        return lengths


def sway(scene: Scene, seed: int = 0) -> Sway:
    """Play the scene and return what was seen of its plants; the scene has some."""
    world = stage(scene, seed)
    direct, observer, bed = Director(scene), Observer(world, scene.groups), _Bed(world)
    own, tips, flow, stretch = len(scene.file.flow), [], [], 0.0
    for _ in range(round(scene.file.seconds * TICKS_PER_SECOND)):
        direct(world)
        world.tick()
        observer()
        if world.clock.now % SAMPLE_EVERY == 0:
            bed.bend()
            tips.append(bed.tips())
            flow.append(world.singularities.position[:own].copy())
            stretch = max(stretch, bed.stretch())
    names = np.array([plant.flora.rpartition(":")[2] for plant in world.plants])
    return Sway(
        rest=bed.rest,
        tip=np.array(tips),
        plant=bed.plant,
        flora=names[bed.plant],
        follows=bed.follows,
        flow=np.array(flow),
        axis=world.singularities.axis[:own].copy(),
        stretch=stretch,
        fishes=observer.observation(),
    )
