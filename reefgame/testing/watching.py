"""`watch`: a scene played with a seed, and whether what was expected of it came true."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from components.clock import TICKS_PER_SECOND
from reefgame.testing.measures import MEASURES
from reefgame.testing.observation import Observation, Observer
from reefgame.testing.scene import Scene
from reefgame.testing.scene_file import Expectation
from reefgame.testing.stage import Director, stage


@dataclass(frozen=True)
class Outcome:
    """What came of a scene with one seed."""

    seed: int
    values: tuple[tuple[float, ...], ...]
    "what was measured: one entry an expectation, with a value for each variant of the scene"
    met: tuple[bool, ...]
    "which expectations came true"

    @property
    def passed(self) -> bool:
        """Whether all came true."""
        return all(self.met)


def observe(scene: Scene, seed: int, variant: int = 0, seconds: float | None = None) -> Observation:
    """Play the scene and return what was seen of it, for `seconds` where it is not for its whole time."""
    world = stage(scene, seed, variant)
    direct, observer = Director(scene), Observer(world, scene.groups)
    lasts = scene.file.seconds if seconds is None else min(seconds, scene.file.seconds)
    for _ in range(round(lasts * TICKS_PER_SECOND)):
        direct(world)
        world.tick()
        observer()
    return observer.observation()


def watch(scene: Scene, seed: int, seconds: float | None = None) -> Outcome:
    """Play the scene with a seed and measure what it expects."""
    seen = [observe(scene, seed, variant, seconds) for variant in range(len(scene.contents))]
    values = tuple(
        tuple(MEASURES[one.measure](o.after(one.after_s), one.of, one.to) for o in seen)
        for one in scene.file.expect
    )
    met = tuple(_meets(one, value) for one, value in zip(scene.file.expect, values, strict=True))
    return Outcome(seed, values, met)


def _meets(one: Expectation, values: tuple[float, ...]) -> bool:
    """Return whether all values, NaN meeting nothing, are as expected."""
    met = bool(np.isfinite(values).all())
    if one.at_least is not None:
        met = met and min(values) >= one.at_least
    if one.at_most is not None:
        met = met and max(values) <= one.at_most
    if one.rises_by is not None:
        met = met and all(b >= one.rises_by * a for a, b in pairwise(values))
    return met
