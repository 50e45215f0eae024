"""A tank without walls for tests of one behaviour at a time: a few fishes, each with a brain, and a plain swimmer.

A brain is called fifteen times a second with the tank and the fish's number; it writes the wanted direction into
`tank.out` and returns gear, urgency and throttle. The swimmer turns no faster than `systems.motor.control` lets it.
"""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from components.arrays import Float64s, Int64s
from systems.mind.crowd import Crowd, make_crowd

STEEPEST = 0.64
EVERY = 4

Brain: TypeAlias = "Callable[[Tank, int], tuple[int, float, float]]"


class Tank:
    """Fishes in the open sea; `speeds`: of each in its gears [BL/s], (N, 3)."""

    def __init__(
        self, place: Float64s, way: Float64s, length: Float64s, speeds: Float64s, seed: int = 1
    ) -> None:
        number = len(place)
        self.place, self.length, self.speeds = place.astype(float), length, speeds
        self.way = way / np.linalg.norm(way, axis=1, keepdims=True)
        self.wanted, self.speed = self.way.copy(), speeds[:, 0] * length
        self.gear, self.urgency = np.ones(number, int), np.zeros(number)
        self.throttle = np.ones(number)
        self.crowd: Crowd = make_crowd(number, 1, 1, 1)
        self.crowd.id[:], self.crowd.length[:] = np.arange(number), length
        self.now, self.seed, self.out = 0, seed, np.zeros(3)
        self.copy()

    def copy(self) -> None:
        """Let minds see where everybody is."""
        crowd = self.crowd
        crowd.x[:], crowd.y[:], crowd.z[:] = self.place.T
        crowd.hx[:], crowd.hy[:], crowd.hz[:] = self.way.T
        crowd.speed[:] = np.abs(self.speed)

    def nearest(self, me: int, among: Int64s, most: int = 8) -> tuple[Int64s, Float64s]:
        """Return the nearest others and their squared distances [m^2], nearest first."""
        square = ((self.place[among] - self.place[me]) ** 2).sum(axis=1)
        order = [k for k in np.argsort(square, kind="stable") if among[k] != me][:most]
        near, distance = np.zeros(8, np.int64), np.zeros(8)
        near[: len(order)], distance[: len(order)] = among[order], square[order]
        return near, distance

    def tick(self, brains: dict[int, Brain], times: int = 1) -> None:
        """Let those with a brain think and all swim; the others swim on."""
        for _ in range(times):
            if self.now % EVERY == 0:
                self.copy()
                for me, brain in brains.items():
                    self.gear[me], self.urgency[me], self.throttle[me] = brain(self, me)
                    size = np.linalg.norm(self.out)
                    if size > 1e-9:
                        self.wanted[me] = self.out / size
            self._swim()
            self.now += 1

    def _swim(self) -> None:
        cruise = self.speeds[np.arange(len(self.gear)), self.gear] * self.length * self.throttle
        self.speed = self.speed + 0.06 * (cruise - self.speed)
        yaw = np.arctan2(self.way[:, 1], self.way[:, 0])
        aside = np.arctan2(self.wanted[:, 1], self.wanted[:, 0]) - yaw
        aside = (aside + np.pi) % (2 * np.pi) - np.pi
        most = (0.8 + 1.7 * self.urgency) / 60.0
        yaw = yaw + np.clip((1.8 + 2.2 * self.urgency) / 60.0 * aside, -most, most)
        up = np.clip(self.wanted[:, 2], -STEEPEST, STEEPEST)
        climb = self.way[:, 2] + np.clip(0.05 * (up - self.way[:, 2]), -0.02, 0.02)
        level = np.sqrt(1.0 - climb**2)
        self.way = np.stack([level * np.cos(yaw), level * np.sin(yaw), climb], axis=1)
        self.place = self.place + self.way * self.speed[:, None] / 60.0
