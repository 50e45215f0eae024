"""The pond of pond.py for every test of minds."""

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

POND = Path(__file__).with_name("pond.py")


@pytest.fixture(scope="session")
def pond() -> ModuleType:
    """The module pond.py, imported once."""
    spec = importlib.util.spec_from_file_location("pond", POND)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["pond"] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session")
def pond_script() -> Path:
    """The path of pond.py, to run in a process of its own."""
    return POND
