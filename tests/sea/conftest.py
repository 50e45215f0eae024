"""The bed of bed.py for every test of fibres."""

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

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
