"""The bed of bed.py for every test of fibres, and a pool of water that flows."""

import importlib.util
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

from reefgame.content import load
from reefgame.world import World

BED = Path(__file__).with_name("bed.py")


@pytest.fixture(scope="session")
def bed() -> ModuleType:
    """The module bed.py, imported once."""
    spec = importlib.util.spec_from_file_location("bed", BED)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["bed"] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session")
def bed_script() -> Path:
    """The path of bed.py, to run in a process of its own."""
    return BED


POOL = """
title: Pool
world: {{radius_m: 20, depth_m: 12}}
seabed: {{seed: 1, relief_m: 0.5}}
rocks:
  - {{at_m: [6, 0], radii_m: [2, 1.5, 2.5], yaw_deg: 30}}
submarine: {{at_m: [-15, 0, -5]}}
fishes: [{fishes}]
food: [{food}]
flow: [{flow}]
objective:
  photograph: {{species: sardine, count: 1, within_m: 6}}
"""
SARDINES = "{species: sardine, count: 8, around_m: [0, 0, -6], within_m: 1}"
PLANKTON = "{around_m: [0, 0, -6], within_m: 1.5, particles: 200}"


@pytest.fixture(scope="session")
def pool(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., World]:
    """Build the world of a pool with a certain flow: a piece of YAML in braces."""

    def build(flow: str = "", fishes: str = SARDINES, food: str = PLANKTON, seed: int = 3) -> World:
        path = tmp_path_factory.mktemp("pool") / "pool.yaml"
        path.write_text(POOL.format(flow=flow, fishes=fishes, food=food), encoding="utf-8")
        return World.build(load(path), seed)

    return build
