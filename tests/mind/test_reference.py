"""The kernels decide as the slow reference does, fish by fish: intention, reason, what decided, focus and memory."""

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from reefgame.content import load
from reefgame.world import World
from systems.mind.think import Think


@pytest.fixture(scope="module")
def reference() -> ModuleType:
    spec = importlib.util.spec_from_file_location(
        "reference", Path(__file__).with_name("reference.py")
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["reference"] = module
    spec.loader.exec_module(module)
    return module


def crowded(fishes: int) -> World:
    """Return nine_species with more of each, some hungry, some in the mood."""
    world = World.build(load("nine_species"), 3)
    each = (fishes - world.population.count) // len(world.species)
    for kind in range(len(world.species)):
        many = each if kind else fishes - world.population.count - each * (len(world.species) - 1)
        angle = 0.7 * kind
        around = np.array([10.0 * np.cos(angle), 10.0 * np.sin(angle), -8.0])
        world.spawn.add(kind, many, around, 3.0)
    return world


@pytest.mark.parametrize(
    ("fishes", "ticks"), [(120, 60), pytest.param(200, 600, marks=pytest.mark.prove)]
)
def test_intentions_are_those_of_the_reference(
    reference: ModuleType, fishes: int, ticks: int
) -> None:
    world = crowded(fishes)
    assert world.population.count == fishes
    think = next(system for system in world.systems if isinstance(system, Think))
    slow, seen, thoughts = reference.Reference(world, think), set(), 0
    for _ in range(ticks):
        for system in world.systems:
            if system is think:
                slow.look()
            system()
            if system is think:
                mind = world.population.mind
                for identity, expected in slow.decide().items():
                    i = world.population.row(identity)
                    found = (
                        mind.intention[i], mind.why[i], mind.memory[i], mind.focus[i], mind.since[i],
                        mind.wary_of[i],
                    )  # fmt: skip
                    assert found == (
                        expected.intention, expected.why, expected.memory, expected.focus,
                        expected.since, expected.wary_of,
                    ), (world.clock.now, identity, expected)  # fmt: skip
                    assert mind.fear[i] == pytest.approx(expected.fear, abs=1e-9)
                    assert mind.why_value[i] == pytest.approx(expected.value, rel=1e-5, abs=1e-6)
                    seen.add((expected.intention, expected.why))
                    thoughts += 1
        world.clock.tick[0] += 1
    assert thoughts >= fishes * ticks // 5
    assert len(seen) >= 8
