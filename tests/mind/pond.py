"""A small world for tests of minds: fishes, senses, terrain and a mover that turns and swims plainly.

Run as a script it prints the hash of what some hundred fishes are after a while, for tests that compare processes.
"""

import hashlib
import sys
from math import sqrt

import numpy as np

from components.arrays import Float64s, Int8s, Int32s, Int64s
from components.clock import Clock
from components.fish import Population
from components.kernels import row
from components.senses import SenseTable
from components.submarine import SubmarineTable
from components.terrain import Rock, Terrain, build_terrain, confine, rock_on_ground
from systems.mind.think import Think
from systems.motor.bound import Bound

SARDINE, TANG = 0, 1


def make_senses() -> SenseTable:
    """Return the columns of a schooling prey and of a pacifist that keeps to itself."""
    return SenseTable(
        role=np.array([0, 2], np.int8),
        schooling=np.array([1, 0], np.int8),
        length=np.array([0.2, 0.25]),
        sight=np.array([4.0, 5.0]),
        spacing=np.array([0.8, 2.0]),
        shallow=np.array([-1.5, -3.0]),
        deep=np.array([-9.0, -13.0]),
        girth=np.array([0.11, 0.19]),
        speed=np.array([[1.0, 2.1, 3.0], [0.8, 1.5, 2.1]]),
        eats=np.zeros((2, 2), np.int8),
        hunts=np.zeros(2, np.int8),
        hunted=np.zeros(2, np.int8),
        grazes=np.ones(2, np.int8),
        meal=np.ones(2),
        appetite=np.full(2, 4.0),
        digestion=np.full(2, 90_000.0),
        breeding=np.full(2, 24_000.0),
        wariness=np.full(2, 1.5),
        curiosity=np.full(2, 0.3),
        bright=np.zeros(2, np.int8),
        warm=np.zeros(2, np.int8),
        mouth=np.full(2, 0.35),
        nose=np.full(2, 0.28),
        at_home=np.zeros(2, np.int8),
    )


def make_terrain(seed: int, radius: float = 40.0, depth: float = 14.0, rocks: int = 20) -> Terrain:
    """Return a reef with rocks strewn by a seed."""
    bare = build_terrain(radius, depth, 1.5, 14.0, seed)
    rng = np.random.default_rng(seed)
    strewn: list[Rock] = []
    for _ in range(rocks):
        x, y = rng.uniform(-0.6 * radius, 0.6 * radius, 2).tolist()
        a, b, c = rng.uniform(0.5, 0.2 * depth, 3).tolist()
        strewn.append(rock_on_ground(bare, (x, y), (a, b, c), rng.uniform(0, 180), 0.3))
    return bare.with_rocks(strewn)


@row
def _swim(
    number: int,
    identity: Int64s,
    species: Int32s,
    length: Float64s,
    position: Float64s,
    last: Float64s,
    rotation: Float64s,
    heading: Float64s,
    gear: Int8s,
    urgency: Float64s,
    cruise: Float64s,
    speed: Float64s,
    terrain: Terrain,
) -> int:
    """Turn each fish towards its heading, at most so fast, and swim; return how many were confined."""
    confined = 0
    for i in range(number):
        x, y, z = rotation[i, 0, 0], rotation[i, 1, 0], rotation[i, 2, 0]
        along = x * heading[i, 0] + y * heading[i, 1] + z * heading[i, 2]
        u, v, w = heading[i, 0] - along * x, heading[i, 1] - along * y, heading[i, 2] - along * z
        aside = sqrt(u * u + v * v + w * w)
        if aside < 1e-6 and along < 0.0:
            u, v, w, aside = -y, x, 0.0, sqrt(x * x + y * y)
        if aside > 1e-9:
            most = (1.2 + 2.5 * urgency[i]) / 60.0
            turn = (min(most, aside) if along > 0.0 else most) / aside
            x, y, z = x + turn * u, y + turn * v, z + turn * w
            size = sqrt(x * x + y * y + z * z)
            x, y, z = x / size, y / size, z / size
        level = sqrt(x * x + y * y) + 1e-12
        rx, ry = y / level, -x / level
        rotation[i, 0, 0], rotation[i, 1, 0], rotation[i, 2, 0] = x, y, z
        rotation[i, 0, 2], rotation[i, 1, 2], rotation[i, 2, 2] = rx, ry, 0.0
        rotation[i, 0, 1], rotation[i, 1, 1] = ry * z, -rx * z
        rotation[i, 2, 1] = rx * y - ry * x
        k = identity[i]
        speed[k] += 0.05 * (cruise[species[i], gear[i]] * length[i] - speed[k])
        for axis in range(3):
            last[i, axis] = position[i, axis]
            position[i, axis] += rotation[i, axis, 0] * speed[k] / 60.0
        if confine(terrain, position, i, 0.5 * length[i]):
            confined += 1
    return confined


class Pond:
    """Fishes that think, are bounded and swim plainly."""

    def __init__(
        self, sardines: int, tangs: int = 0, seed: int = 1, spread: float = 2.0,
        terrain: Terrain | None = None, submarines: int = 0,
    ) -> None:  # fmt: skip
        self.terrain = make_terrain(seed) if terrain is None else terrain
        self.senses, self.population = make_senses(), Population()
        self.clock, self.submarine = Clock(seed), SubmarineTable(submarines)
        self.confined = 0
        number, rng = sardines + tangs, np.random.default_rng(seed)
        self.population.append(np.arange(number))
        fish, motor = self.population.fish, self.population.motor
        fish.species[:number] = fish.cohort[:number] = [SARDINE] * sardines + [TANG] * tangs
        fish.length[:number] = self.senses.length[fish.species[:number]]
        fish.length[:number] *= rng.uniform(0.9, 1.1, number)
        place = np.array((4.0, 0.0, -0.4 * self.terrain.depth))
        fish.position[:sardines] = place + rng.uniform(-spread, spread, (sardines, 3))
        wide = 0.5 * self.terrain.radius
        fish.position[sardines:number, :2] = rng.uniform(-wide, wide, (tangs, 2))
        fish.position[sardines:number, 2] = -0.6 * self.terrain.depth
        way = rng.normal(size=(number, 2))
        way /= np.sqrt((way**2).sum(axis=1, keepdims=True))
        fish.rotation[:number] = 0.0
        fish.rotation[:number, :2, 0] = motor.heading[:number, :2] = way
        for i in range(number):
            confine(self.terrain, fish.position, i, 0.5 * fish.length[i])
        fish.last_position[:number] = fish.position[:number]
        self.speed = np.zeros(max(number, 1))
        self.think = Think(self.population, self.senses, self.terrain, self.submarine, self.clock)
        self.bound = Bound(self.population, self.senses, self.terrain)

    def tick(self, times: int = 1) -> None:
        """Let the fishes live for some ticks."""
        for _ in range(times):
            self.think()
            self.bound()
            fish, motor = self.population.fish, self.population.motor
            self.confined += _swim(
                self.population.count, fish.id, fish.species, fish.length, fish.position,
                fish.last_position, fish.rotation, motor.heading, motor.gear, motor.urgency,
                self.senses.speed, self.speed, self.terrain,
            )  # fmt: skip
            self.clock.tick[0] += 1

    def by_id(self) -> dict[str, bytes]:
        """Return the bytes of every column of fishes, minds and motors in the order of ids."""
        order = np.argsort(self.population.fish.id[: self.population.count])
        tables = (self.population.fish, self.population.mind, self.population.motor)
        return {
            f"{type(table).__name__}.{name}": table.live(name)[order].tobytes()
            for table in tables
            for name in table.columns
        }

    def hash(self) -> str:
        """Return a hash of everything that lives."""
        digest = hashlib.blake2b(self.terrain.height.tobytes(), digest_size=16)
        for data in self.by_id().values():
            digest.update(data)
        return digest.hexdigest()


if __name__ == "__main__":
    pond = Pond(int(sys.argv[1]), int(sys.argv[2]), submarines=1)
    pond.tick(int(sys.argv[3]))
    sys.stdout.write(pond.hash())
