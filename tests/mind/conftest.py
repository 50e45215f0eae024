"""The pond of pond.py and the tank of tank.py for every test of minds."""

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

POND = Path(__file__).with_name("pond.py")
TANK = Path(__file__).with_name("tank.py")


def _load(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session")
def pond() -> ModuleType:
    """The module pond.py, imported once."""
    return _load(POND)


@pytest.fixture(scope="session")
def tank() -> ModuleType:
    """The module tank.py, imported once."""
    return _load(TANK)


@pytest.fixture(scope="session")
def pond_script() -> Path:
    """The path of pond.py, to run in a process of its own."""
    return POND
